//! The files of the bodies' pictures: set-up and deformed bodies of the levels whose fields are kept.

use crate::error::ReportError;
use crate::{Folder, plot};
use signorini_study::fields::{Fields, page_level};
use signorini_study::record::StudyRecord;

/// Writes `mesh` and `deformed`, with the endings `png` and `svg`, of the level that the page shows, or removes them where there is none.
/// A level that was asked for has its own in `fields/level-<k>-mesh` and so on, and its contact pressure.
pub(crate) fn write(folder: &mut Folder, record: &StudyRecord, fields: &[Fields]) -> Result<(), ReportError> {
    let shown = page_level(fields).map(|k| &fields[k]);
    pair(folder, "mesh", shown.map(|f| plot::mesh(record, f)).as_ref())?;
    pair(folder, "deformed", shown.map(|f| plot::deformed(record, f)).as_ref())?;
    for level in fields.iter().filter(|f| f.asked) {
        let name = |what: &str| format!("fields/level-{}-{what}", level.level);
        pair(folder, &name("mesh"), Some(&plot::mesh(record, level)))?;
        pair(folder, &name("deformed"), Some(&plot::deformed(record, level)))?;
        if let Some(chart) = plot::pressure_of_level(record, level) {
            folder.write(&format!("{}.png", name("pressure")), &plot::zone_png(&chart)?)?;
            folder.write(&format!("{}.svg", name("pressure")), plot::zone_svg(&chart)?.as_bytes())?;
        }
    }
    Ok(())
}

fn pair(folder: &mut Folder, name: &str, chart: Option<&plot::BodyChart>) -> Result<(), ReportError> {
    let png = chart.map(plot::body_png).transpose()?;
    folder.write_or_remove(&format!("{name}.png"), png.as_deref())?;
    let svg = chart.map(plot::body_svg).transpose()?;
    folder.write_or_remove(&format!("{name}.svg"), svg.as_deref().map(str::as_bytes))
}
