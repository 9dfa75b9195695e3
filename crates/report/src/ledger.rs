//! The tables of a ledger: its terms, the parts that bound them, observed rates beside what is proven.

use crate::format;
use crate::levels::{Measured, build, h_column, level_column, measured};
use crate::norm::Trust;
use crate::table::{Cell, Column, Row, Table};
use signorini_study::claim::proof::{Proven, proven_terms, term_words};
use signorini_study::rate;
use signorini_study::record::{Ledger, Level, Rate, StudyRecord};

/// The terms of the estimate; `None` if no level has a ledger.
pub fn terms(record: &StudyRecord) -> Option<Table> {
    record.levels.iter().find(|l| l.ledger.is_some())?;
    Some(sized(record, term_columns()))
}

/// The parts that bound `b` and `c`; `None` if no level has any.
pub fn parts(record: &StudyRecord) -> Option<Table> {
    let columns = part_columns(record);
    (!columns.is_empty()).then(|| sized(record, columns))
}

/// One row per term of the proof: the observed rate of its absolute value beside the proven exponent. `None` where
/// nothing is proven of the ledger, or no term has a rate.
pub fn rates(record: &StudyRecord) -> Option<Table> {
    let rows: Vec<Row> = proven_terms(record).iter().map(|proven| rate_row(record, proven)).collect();
    let fitted = proven_terms(record).iter().any(|p| term_rate(record, p.term).is_some());
    let columns = [
        ("term", "term"),
        ("slope", "observed rate"),
        ("low", "95 % from"),
        ("high", "95 % to"),
        ("levels", "levels"),
        ("proven", "proven exponent"),
        ("source", "source"),
    ];
    let columns = columns.map(|(key, heading)| Column::new(key, heading)).to_vec();
    fitted.then_some(Table { columns, rows })
}

/// The fitted rate of a term.
pub fn term_rate<'a>(record: &'a StudyRecord, term: &str) -> Option<&'a Rate> {
    record.rates.get(&format!("{}{term}", rate::LEDGER))
}

/// The parts that some level has, with their symbols, in the order of [`Ledger::PARTS`].
pub(crate) fn present_parts(record: &StudyRecord) -> impl Iterator<Item = (&'static str, &'static str)> {
    let has = |level: &Level, name: &str| level.ledger.as_ref().is_some_and(|l| l.parts.contains_key(name));
    Ledger::PARTS.into_iter().filter(move |(name, _)| record.levels.iter().any(|l| has(l, name)))
}

/// Everything of the ledger, for the table of all numbers.
pub(crate) fn columns(record: &StudyRecord) -> Vec<Measured<'static>> {
    let mut columns = term_columns();
    columns.extend(part_columns(record));
    columns
}

fn sized(record: &StudyRecord, columns: Vec<Measured<'static>>) -> Table {
    build(record, [level_column(), h_column()].into_iter().chain(columns).collect())
}

fn rate_row(record: &StudyRecord, proven: &Proven) -> Row {
    let rate = term_rate(record, proven.term);
    let trust = rate.map(Trust::of);
    let shown = rate.filter(|_| trust != Some(Trust::Scattered));
    Row {
        cells: vec![
            Cell::text(term_words(proven.term)),
            Cell::rate(shown.map(|r| r.slope)),
            Cell::rate(shown.map(|r| r.low)),
            Cell::rate(shown.map(|r| r.high)),
            shown.map_or(Cell::Missing, |r| Cell::text(format::levels(&r.levels))),
            Cell::Bound(proven.exponent),
            Cell::text(proven.source),
        ],
        excluded: trust.and_then(Trust::remark).map(String::from),
    }
}

fn term_columns() -> Vec<Measured<'static>> {
    let term = |key, heading, value: fn(&Ledger) -> f64| {
        measured(key, heading, move |l| Cell::number(l.ledger.as_ref().map(value)))
    };
    vec![
        term("ledger_lhs", "½A(e,e)", |t| t.lhs),
        term("ledger_a", "a", |t| t.a),
        term("ledger_b", "b", |t| t.b),
        term("ledger_c", "c", |t| t.c),
        term("ledger_delta", "δ", |t| t.delta),
        measured("ledger_holds", "holds", |l| {
            let holds = l.ledger.as_ref().and_then(|t| t.holds);
            holds.map_or(Cell::Missing, Cell::Flag)
        }),
    ]
}

fn part_columns(record: &StudyRecord) -> Vec<Measured<'static>> {
    let column = |(name, symbol): (&'static str, &'static str)| {
        measured(&format!("ledger_{name}"), symbol, move |l| Cell::number(l.ledger.as_ref().and_then(|t| t.term(name))))
    };
    present_parts(record).map(column).collect()
}
