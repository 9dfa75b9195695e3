//! Tables for papers: that of a case, and one row per case of a run.

use crate::format;
use crate::levels;
use crate::norm::{self, judged_rate};
use crate::summary::{self, name};
use crate::verdict;
use signorini_study::record::StudyRecord;

/// Norms beyond these make the table of a case too wide for a page.
const LEFT_OUT: [&str; 2] = ["h1", "h1_rate"];

/// `table.tex`: mesh size, unknowns and errors with their orders between successive levels; `None` where there are no levels.
pub fn case(record: &StudyRecord) -> Option<String> {
    let mut table = levels::errors(record);
    if record.norm != "h1" {
        table = table.without(&LEFT_OUT);
    }
    let label = format!("tab:{}-{}", record.study, record.case);
    (!table.rows.is_empty()).then(|| table.to_latex(&caption(record), &label))
}

/// `Title (study · case). Claim theorem-3-1, strain: 0.998 [0.994, 1.002] on levels 2–6, pass.`
fn caption(record: &StudyRecord) -> String {
    let observed = judged_rate(record).map_or(String::new(), |r| {
        format!(": {} on {}", format::interval(r.slope, r.low, r.high), format::level_words(&r.levels))
    });
    let judged = norm::short_words(&record.norm);
    let words = verdict::words(record);
    format!("{} ({}). Claim {}, {judged}{observed}; verdict: {words}.", record.title, name(record), record.claim)
}

/// `summary.tex`: one row per case, across as many pages as it takes.
pub fn summary(records: &[StudyRecord]) -> String {
    summary::latex_table(records).to_latex_long(&format!("{}.", verdict::counts(records)), "tab:signorini-summary")
}
