//! Seconds and bytes of a case, from the file that the run keeps apart from the record.

use crate::format::significant;
use crate::table::{Cell, Column, Row, Table};
use serde::Deserialize;
use signorini_study::record::StudyRecord;
use signorini_study::run::timing::LevelTimes;
use std::path::Path;

#[derive(Deserialize)]
struct Timings {
    threads: usize,
    cases: Vec<CaseTimings>,
}

#[derive(Deserialize)]
struct CaseTimings {
    case: String,
    reference: Option<LevelTimes>,
    levels: Vec<LevelTimes>,
}

/// A table of the phases on every level; nothing where no times are kept.
pub(super) fn markdown(record: &StudyRecord, dir: &Path) -> String {
    let path = dir.join(&record.study).join("timings.json");
    let timings = std::fs::read_to_string(path).ok().and_then(|text| serde_json::from_str::<Timings>(&text).ok());
    let Some(timings) = timings else { return String::new() };
    let Some(case) = timings.cases.iter().find(|c| c.case == record.case) else { return String::new() };
    let levels = case.levels.iter().enumerate().map(|(k, times)| row(k.to_string(), times));
    let reference = case.reference.iter().map(|times| row("reference".into(), times));
    let table = Table { columns: columns(), rows: levels.chain(reference).collect() };
    if table.rows.is_empty() {
        return String::new();
    }
    let words = format!(
        "Wall seconds of each phase, on {} threads shared with other levels. Peak: largest resident memory, of the whole process up to then \
         or, where another program solves, of that program.",
        timings.threads
    );
    format!("## Times\n\n{}\n{words}\n", table.to_markdown())
}

fn columns() -> Vec<Column> {
    let named = |name: &str| Column::new(name, name);
    let phases = LevelTimes::PHASES.into_iter().map(named);
    [named("level")].into_iter().chain(phases).chain([named("peak MB")]).collect()
}

fn row(level: String, times: &LevelTimes) -> Row {
    let seconds = times.phases().map(|s| Cell::Text(significant(s, 3)));
    let peak = times.peak_bytes.map_or(Cell::Missing, |bytes| Cell::Text((bytes / 1_000_000).to_string()));
    Row { cells: [vec![Cell::Text(level)], seconds.to_vec(), vec![peak]].concat(), excluded: None }
}
