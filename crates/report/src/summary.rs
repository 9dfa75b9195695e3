//! One row per case: what was claimed, what was observed, what the verdict is.

use crate::error::ReportError;
use crate::format;
use crate::norm::judged_rate;
use crate::table::{Cell, Column, Row, Table, text};
use crate::verdict;
use serde::Serialize;
use signorini_study::record::{Outcome, Reference, StudyRecord};

/// Widest line of [`summary_text`].
pub const TEXT_WIDTH: usize = 110;

/// A row of `summary.json`. A number is `null` exactly where there is none.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SummaryRow {
    /// Study id.
    pub study: String,
    /// Case name.
    pub case: String,
    /// Claim id.
    pub claim: String,
    /// Family of triangulations.
    pub family: String,
    /// `exact`, `overkill` or `none`.
    pub reference: String,
    /// The norm that the claim judges.
    pub norm: String,
    /// Observed rate.
    pub rate: Option<f64>,
    /// Lower end of its 95 % interval.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
    /// The paper's bound.
    pub paper: Option<f64>,
    /// Today's best bound.
    pub today: Option<f64>,
    /// The rate expected from the regularity.
    pub expected: Option<f64>,
    /// The verdict.
    pub outcome: Outcome,
    /// What a control expects.
    pub expect: Option<Outcome>,
    /// Why an inconclusive verdict is expected at this profile's sizes.
    pub expected_inconclusive: Option<String>,
    /// Why, most important first.
    pub reasons: Vec<String>,
}

impl SummaryRow {
    /// The row of one record.
    pub fn new(record: &StudyRecord) -> Self {
        let rate = judged_rate(record);
        Self {
            study: record.study.clone(),
            case: record.case.clone(),
            claim: record.claim.clone(),
            family: record.family.clone(),
            reference: reference_word(&record.reference).into(),
            norm: record.norm.clone(),
            rate: rate.map(|r| r.slope),
            low: rate.map(|r| r.low),
            high: rate.map(|r| r.high),
            paper: record.bounds.paper,
            today: record.bounds.today,
            expected: record.bounds.expected,
            outcome: record.verdict.outcome,
            expect: record.expect,
            expected_inconclusive: record.expected_inconclusive.clone(),
            reasons: record.verdict.reasons.clone(),
        }
    }

    fn numbers(&self) -> [(&'static str, Option<f64>); 6] {
        [
            ("rate", self.rate),
            ("low", self.low),
            ("high", self.high),
            ("paper", self.paper),
            ("today", self.today),
            ("expected", self.expected),
        ]
    }
}

/// The rows of `summary.json`, in the order of the records.
///
/// # Errors
/// [`ReportError::NonFinite`] on NaN or infinity.
pub fn summary_rows(records: &[StudyRecord]) -> Result<Vec<SummaryRow>, ReportError> {
    let rows: Vec<SummaryRow> = records.iter().map(SummaryRow::new).collect();
    for row in &rows {
        for (name, value) in row.numbers() {
            if let Some(value) = value.filter(|x| !x.is_finite()) {
                let place = format!("{name} of {}/{}", row.study, row.case);
                return Err(ReportError::NonFinite { place, value });
            }
        }
    }
    Ok(rows)
}

/// `summary.md`: the counts, one table row per case with a link to its page, and the reasons behind what did not pass.
pub fn summary_markdown(records: &[StudyRecord]) -> String {
    let mut out = format!("# Summary\n\n{}\n\n", verdict::counts(records));
    if records.is_empty() {
        return out;
    }
    out += &markdown_table(records).to_markdown();
    let reasons: Vec<String> = (records.iter().filter(|r| verdict::needs_reason(r)))
        .map(|r| format!("- **{}**, {}: {}\n", name(r), verdict::words(r), verdict::why(r)))
        .collect();
    if !reasons.is_empty() {
        out += &format!("\n## Reasons\n\n{}", reasons.concat());
    }
    out + LEGEND
}

const LEGEND: &str = "\nObserved: fitted rate and its 95 % interval over the asymptotic window, in the norm that the \
claim judges. Paper, today: proven bounds. Expected: from the regularity of the solution. A control is built to be \
refused and counts as met when it is.\n";

/// The same for the terminal: aligned, at most [`TEXT_WIDTH`] characters wide.
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
    let rows = records.iter().map(|r| Row {
        cells: [
            vec![Cell::text(&r.claim), Cell::text(&r.statement), Cell::text(link(r)), Cell::text(&r.case)],
            figures(r, format::interval),
        ]
        .concat(),
        excluded: None,
    });
    Table { rows: rows.collect(), columns: columns.map(|(key, heading)| Column::new(key, heading)).to_vec() }
}

fn text_table(records: &[StudyRecord]) -> Table {
    let columns = ["study · case", "claim", "norm", "observed, 95 %", "paper", "today", "exp.", "verdict"];
    let rows = records.iter().map(|r| Row {
        cells: [vec![Cell::text(name(r)), Cell::text(&r.claim)], figures(r, format::half_interval)].concat(),
        excluded: None,
    });
    Table { rows: rows.collect(), columns: columns.map(|heading| Column::new(heading, heading)).to_vec() }
}

/// Norm, observed rate with its interval as `shown` writes it, the three bounds, verdict.
fn figures(record: &StudyRecord, shown: fn(f64, f64, f64) -> String) -> Vec<Cell> {
    let observed = judged_rate(record).map(|r| shown(r.slope, r.low, r.high));
    vec![
        Cell::text(&record.norm),
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

pub(crate) fn reference_word(reference: &Reference) -> &'static str {
    match reference {
        Reference::Exact => "exact",
        Reference::Overkill { .. } => "overkill",
        Reference::None => "none",
    }
}

fn link(record: &StudyRecord) -> String {
    let folder = if record.several { format!("{}/{}", record.study, record.case) } else { record.study.clone() };
    format!("[{}]({folder}/report.md)", record.study)
}
