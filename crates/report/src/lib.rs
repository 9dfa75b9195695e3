//! From a [`StudyRecord`] to what people read: Markdown pages, LaTeX, CSV and JSON tables, pictures. Solves nothing.
//!
//! Every output is a pure function of the record: the same record gives the same bytes.
//!
//! ```no_run
//! use signorini_study::record::StudyRecord;
//! use std::path::Path;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let text = std::fs::read_to_string("reports/thm31/record.json")?;
//! let record: StudyRecord = serde_json::from_str(&text)?;
//! for file in signorini_report::render(&record, Path::new("reports/thm31"))? {
//!     println!("{}", file.display());
//! }
//! print!("{}", signorini_report::summary_text(&[record]));
//! # Ok(())
//! # }
//! ```
//!
//! Reading order: [`table`] (the one table model) · [`norm`] (what can be tabulated) · [`levels`], [`ledger`] (the tables
//! of a case) · [`markdown`] (its page) · [`plot`] (its pictures) · [`verdict`], [`summary`] (all
//! cases together), [`statements`] (the paper, statement by statement). Apart from records: [`mod@bench`] (speed against error).

pub mod annotations;
pub mod bench;
mod bodies;
mod borderline;
mod changed;
pub mod corner;
mod coverage;
mod drift;
pub mod error;
pub mod extrapolation;
mod falsify;
pub mod format;
pub mod formula;
pub mod hard;
pub mod junit;
pub mod latex;
pub mod ledger;
pub mod levels;
pub mod markdown;
pub mod norm;
mod page;
pub mod plot;
pub mod regularity;
mod splitting;
pub mod statements;
pub mod summary;
pub mod table;
pub mod verdict;

pub use bench::{bench_text, render_bench};
pub use coverage::coverage_markdown;
pub use drift::{CaseDrift, drift_text};
pub use error::ReportError;
pub use falsify::{falsify_markdown, falsify_text};
pub use statements::statements_markdown;
pub use summary::{summary_markdown, summary_text};

use signorini_study::fields::Fields;
use signorini_study::record::StudyRecord;
use signorini_study::store::{remove_if_present, write_atomic, write_summary};
use std::path::{Path, PathBuf};

/// Writes what there is to read about one case into its folder `dir`: `report.md`, `table.csv`, `table.json`,
/// `table.tex`, `rates.png`, `ledger.png`, `parts.png`, `pressure.png` and the pictures' twins of the ending `svg`.
///
/// A picture with nothing to show is not written, and one that an earlier run left is removed. Returns the files
/// written, in that order.
///
/// # Errors
/// [`ReportError`] if a file cannot be written, a number is not finite, or a picture cannot be drawn.
pub fn render(record: &StudyRecord, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    render_with(record, &[], dir)
}

/// The same, and `mesh` and `deformed` as PNG and SVG of the level among `fields` that
/// [`page_level`](signorini_study::fields::page_level) chooses; levels that were asked for have their own in `fields/`.
///
/// # Errors
/// As [`render`].
pub fn render_with(record: &StudyRecord, fields: &[Fields], dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let table = levels::all(record);
    let rates = plot::rates(record);
    let ledger = plot::ledger(record);
    let parts = plot::parts(record);
    let pressure = plot::pressure(record);
    let pictures = markdown::Pictures {
        rates: rates.is_some(),
        ledger: ledger.is_some(),
        parts: parts.is_some(),
        pressure: pressure.is_some(),
        bodies: !fields.is_empty(),
    };
    let mut folder = Folder::new(dir);
    folder.write("report.md", markdown::page(record, pictures).as_bytes())?;
    folder.write("table.csv", &table.to_csv()?)?;
    folder.write("table.json", &table::json_text(&table.to_json()?)?)?;
    folder.write_or_remove("table.tex", latex::case(record).as_deref().map(str::as_bytes))?;
    for (name, chart) in [("rates", &rates), ("ledger", &ledger), ("parts", &parts)] {
        let png = chart.as_ref().map(plot::png).transpose()?;
        folder.write_or_remove(&format!("{name}.png"), png.as_deref())?;
        let svg = chart.as_ref().map(plot::svg).transpose()?;
        folder.write_or_remove(&format!("{name}.svg"), svg.as_deref().map(str::as_bytes))?;
    }
    let png = pressure.as_ref().map(plot::zone_png).transpose()?;
    folder.write_or_remove("pressure.png", png.as_deref())?;
    let svg = pressure.as_ref().map(plot::zone_svg).transpose()?;
    folder.write_or_remove("pressure.svg", svg.as_deref().map(str::as_bytes))?;
    bodies::write(&mut folder, record, fields)?;
    Ok(folder.written)
}

/// Writes `summary.md`, `summary.tex`, `statements.md` (one row per statement of the paper), `hard.md` where there are hard cases, and
/// `summary.json` (one row per case, in the order of `records`) into `dir`, and `index.html`, which holds all of these, every report below `dir`
/// with its pictures, and the times that the run has left. Returns the files written.
///
/// # Errors
/// [`ReportError`] if a file cannot be written or a number is not finite.
pub fn render_summary(records: &[StudyRecord], dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let mut folder = Folder::new(dir);
    folder.write("summary.md", summary_markdown(records).as_bytes())?;
    folder.write("summary.tex", latex::summary(records).as_bytes())?;
    folder.write("statements.md", statements_markdown(records).as_bytes())?;
    let hard = hard::page(records);
    folder.write_or_remove("hard.md", hard.as_deref().map(str::as_bytes))?;
    folder.written.push(write_summary(dir, records)?);
    folder.write("index.html", page::page(records, dir)?.as_bytes())?;
    Ok(folder.written)
}

/// A folder and what was written into it.
struct Folder<'a> {
    dir: &'a Path,
    written: Vec<PathBuf>,
}

impl<'a> Folder<'a> {
    fn new(dir: &'a Path) -> Self {
        Self { dir, written: Vec::new() }
    }

    fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), ReportError> {
        let path = self.dir.join(name);
        write_atomic(&path, bytes)?;
        self.written.push(path);
        Ok(())
    }

    fn write_or_remove(&mut self, name: &str, bytes: Option<&[u8]>) -> Result<(), ReportError> {
        match bytes {
            Some(bytes) => self.write(name, bytes),
            None => Ok(remove_if_present(&self.dir.join(name))?),
        }
    }
}
