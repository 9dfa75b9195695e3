//! Speed against error: a [`BenchRecord`] as tables and pictures.
//!
//! ```text
//! bench.json   the record            work-precision.png   error against seconds, error against unknowns
//! bench.csv    a row for each run    scaling.png          seconds and bytes per unknown, with the floors
//! bench.md     tables for readers
//! ```
//!
//! Cases that differ in swept values share a section and `sweep.png`: work and seconds against the values.
//!
//! The pictures of the first study have these names, those of further ones end with the study's id, as in
//! `scaling-two-squares.png`.

mod data;
mod markdown;
mod pictures;
mod sweep;
#[cfg(test)]
mod tests;
mod words;

pub use data::table as bench_table;
pub use markdown::bench_text;
pub use pictures::{scaling, work_precision};

use crate::error::ReportError;
use crate::{Folder, plot};
use signorini_study::bench::BenchRecord;
use signorini_study::bench::record::BenchStudy;
use signorini_study::store::StoreError;
use std::path::{Path, PathBuf};
use sweep::Group;

/// Writes everything there is to read about a measurement into `dir`. Returns the files written.
///
/// # Errors
/// [`ReportError`] if a file cannot be written, a number is not finite, or a picture cannot be drawn.
pub fn render_bench(record: &BenchRecord, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let mut folder = Folder::new(dir);
    let path = dir.join("bench.json");
    let json = record.to_json().map_err(|source| StoreError::Content { path, source })?;
    let csv = data::table(record).to_csv()?;
    let mut pictures = Vec::new();
    let mut sweeps = 0;
    for group in sweep::groups(record) {
        match group {
            Group::One(k, study) => {
                let [precision, scaled] = picture_names(k, study);
                pictures.push((precision, plot::panel_png(&work_precision(record, study))?));
                pictures.push((scaled, plot::panel_png(&scaling(record, study))?));
            }
            Group::Sweep(sweep) => {
                if let Some(chart) = sweep.chart(record) {
                    pictures.push((sweep.picture_name(sweeps), plot::panel_png(&chart)?));
                }
                sweeps += 1;
            }
        }
    }
    folder.write("bench.json", json.as_bytes())?;
    folder.write("bench.csv", &csv)?;
    folder.write("bench.md", markdown::page(record).as_bytes())?;
    for (name, bytes) in pictures {
        folder.write(&name, &bytes)?;
    }
    Ok(folder.written)
}

/// Names of the two pictures of the study at a position.
fn picture_names(position: usize, study: &BenchStudy) -> [String; 2] {
    let end = if position == 0 { String::new() } else { format!("-{}", study.study) };
    ["work-precision", "scaling"].map(|name| format!("{name}{end}.png"))
}
