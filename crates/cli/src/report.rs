//! `signorini report`: tables and plots again, from the records alone.

use crate::failure::Failure;
use signorini_report::summary_text;
use signorini_study::fields::store::read_fields;
use signorini_study::{store, verdict};
use std::path::Path;

/// Renders every record below `dir` and returns the exit status of the run that wrote them.
pub fn report(dir: &Path) -> Result<u8, Failure> {
    let hint = "run some studies first: `signorini run`, or name the folder that `--out` wrote";
    if !dir.is_dir() {
        return Err(Failure::new(format!("{} is no folder", dir.display()), hint));
    }
    let records = store::read_records(dir)?;
    if records.is_empty() {
        return Err(Failure::new(format!("{} holds no record", dir.display()), hint));
    }
    for record in &records {
        let folder = store::record_folder(dir, record)?;
        signorini_report::render_with(record, &read_fields(&folder)?, &folder)?;
    }
    signorini_report::render_summary(&records, dir)?;
    say!("{}", summary_text(&records));
    Ok(verdict::exit_status(&records))
}
