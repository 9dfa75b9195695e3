//! The files of the bodies' pictures: set-up and deformed bodies of the levels whose fields are kept.

use crate::error::ReportError;
use crate::{Folder, plot};
use signorini_study::fields::{Fields, page_level};
use signorini_study::record::StudyRecord;

/// The pictures' names, without ending.
const NAMES: [&str; 2] = ["mesh", "deformed"];

/// Writes `mesh` and `deformed`, each with the endings `png` and `svg`, of the level that the page shows, and those of the other levels as
/// `fields/level-<k>-mesh` and so on. Without fields the former are removed.
pub(crate) fn write(folder: &mut Folder, record: &StudyRecord, fields: &[Fields]) -> Result<(), ReportError> {
    let shown = page_level(fields);
    for (k, level) in fields.iter().enumerate() {
        let prefix = if Some(k) == shown { String::new() } else { format!("fields/level-{}-", level.level) };
        for (name, chart) in NAMES.into_iter().zip([plot::mesh(record, level), plot::deformed(record, level)]) {
            folder.write(&format!("{prefix}{name}.png"), &plot::body_png(&chart)?)?;
            folder.write(&format!("{prefix}{name}.svg"), plot::body_svg(&chart)?.as_bytes())?;
        }
    }
    if shown.is_none() {
        for file in NAMES.iter().flat_map(|name| ["png", "svg"].map(|ending| format!("{name}.{ending}"))) {
            folder.write_or_remove(&file, None)?;
        }
    }
    Ok(())
}
