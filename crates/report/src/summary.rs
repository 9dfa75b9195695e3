//! One row per case: what was claimed, what was observed, what the verdict is.

use crate::format;
use crate::norm::{self, judged_rate};
use crate::regularity;
use crate::table::{Cell, Column, Row, Table, text};
use crate::verdict;
use signorini_study::record::{ClaimKind, StudyRecord};

/// Widest line of [`summary_text`].
pub const TEXT_WIDTH: usize = 110;

/// `summary.md`: the counts, one table row per case with a link to its page, the reasons behind what did not pass, and
/// how regular the meshes are where the claim asks for it.
pub fn summary_markdown(records: &[StudyRecord]) -> String {
    let statements = "[The paper, statement by statement](statements.md)";
    let mut out = format!("# Summary\n\n{}\n\n{statements}\n\n", verdict::counts(records));
    if records.is_empty() {
        return out;
    }
    out += &markdown_table(records).to_markdown();
    let reasons: Vec<String> = (records.iter().filter(|r| verdict::needs_reason(r)))
        .map(|r| format!("- **{}**, {}: {}\n", name(r), verdict::words(r), verdict::why(r)))
        .collect();
    if records.iter().any(|r| r.kind == ClaimKind::Certificate) {
        out += "\nThe hard cases have a page of their own: [hard.md](hard.md).\n";
    }
    if !reasons.is_empty() {
        out += &format!("\n## Reasons\n\n{}", reasons.concat());
    }
    let regularity = records.iter().filter_map(|r| Some(format!("- **{}**: {}\n", name(r), regularity::sentence(r)?)));
    let regularity: String = regularity.collect();
    if !regularity.is_empty() {
        out += &format!("\n## Regularity of the families\n\n{regularity}");
    }
    out + LEGEND
}

const LEGEND: &str = "\nObserved: fitted rate and its 95 % interval over the asymptotic window, in the norm that the \
claim judges. Paper, today: proven bounds. Expected: from the regularity of the solution. A control is built to be \
refused and counts as met when it is.\n";

/// The same for the terminal, without the claims: aligned, at most [`TEXT_WIDTH`] characters wide.
pub fn summary_text(records: &[StudyRecord]) -> String {
    let mut out = String::new();
    if !records.is_empty() {
        out += &text_table(records).to_text(TEXT_WIDTH);
        out.push('\n');
    }
    for record in records.iter().filter(|r| verdict::needs_reason(r)) {
        let line = format!("{}: {}: {}", name(record), verdict::words(record), verdict::why(record));
        out += &text::wrap(&line, TEXT_WIDTH, 4);
        out.push('\n');
    }
    out + &verdict::counts(records) + "\n"
}

fn markdown_table(records: &[StudyRecord]) -> Table {
    let columns = [
        ("claim", "claim"),
        ("statement", "statement"),
        ("study", "study"),
        ("case", "case"),
        ("norm", "norm"),
        ("observed", "observed rate [95 %]"),
        ("paper", "paper"),
        ("today", "today"),
        ("expected", "expected"),
        ("outcome", "verdict"),
    ];
    let rows = records.iter().enumerate().map(|(i, r)| {
        let names = [Cell::text(&r.claim), Cell::text(statement(records, i)), Cell::text(link(r)), Cell::text(&r.case)];
        Row { cells: [names.to_vec(), figures(r, format::interval)].concat(), excluded: None }
    });
    Table { rows: rows.collect(), columns: columns.map(|(key, heading)| Column::new(key, heading)).to_vec() }
}

/// The statement of the claim, where it is not the same as in the row above.
fn statement(records: &[StudyRecord], row: usize) -> &str {
    let repeated = row > 0 && records[row - 1].statement == records[row].statement;
    if repeated { "" } else { &records[row].statement }
}

fn text_table(records: &[StudyRecord]) -> Table {
    let columns = ["study · case", "norm", "observed, 95 %", "paper", "today", "exp.", "verdict"];
    named(records, columns.map(|heading| (heading, heading)), format::half_interval)
}

/// A row for each case under its name, with the interval as `shown` writes it.
fn named(records: &[StudyRecord], columns: [(&str, &str); 7], shown: fn(f64, f64, f64) -> String) -> Table {
    let cells = |r| [vec![Cell::text(name(r))], figures(r, shown)].concat();
    let rows = records.iter().map(|r| Row { cells: cells(r), excluded: None });
    Table { rows: rows.collect(), columns: columns.map(|(key, heading)| Column::new(key, heading)).to_vec() }
}

/// The same for papers: no links, and no claims, by which most studies are named, since a page is narrow.
pub(crate) fn latex_table(records: &[StudyRecord]) -> Table {
    let columns = [
        ("name", "study · case"),
        ("norm", "norm"),
        ("observed", "observed rate [95 %]"),
        ("paper", "paper"),
        ("today", "today"),
        ("expected", "expected"),
        ("outcome", "verdict"),
    ];
    named(records, columns, format::interval)
}

/// Norm, observed rate with its interval as `shown` writes it, the three bounds, verdict.
fn figures(record: &StudyRecord, shown: fn(f64, f64, f64) -> String) -> Vec<Cell> {
    let observed = judged_rate(record).map(|r| shown(r.slope, r.low, r.high));
    vec![
        Cell::text(norm::short_words(&record.norm)),
        observed.map_or(Cell::Missing, Cell::Text),
        Cell::bound(record.bounds.paper),
        Cell::bound(record.bounds.today),
        Cell::bound(record.bounds.expected),
        Cell::text(verdict::words(record)),
    ]
}

/// `study · case`, or the study alone where it has one case.
pub(crate) fn name(record: &StudyRecord) -> String {
    if record.several { format!("{} · {}", record.study, record.case) } else { record.study.clone() }
}

fn link(record: &StudyRecord) -> String {
    let folder = if record.several { format!("{}/{}", record.study, record.case) } else { record.study.clone() };
    format!("[{}]({folder}/report.md)", record.study)
}
