//! What has moved from the baselines, as a table.

use crate::summary::TEXT_WIDTH;
use crate::table::{Cell, Column, Row, Table};
use signorini_study::store::Drift;

/// What drifted in a case: its name, `study/case`, and the differences.
pub type CaseDrift = (String, Vec<Drift>);

/// One row per difference: case, quantity, the baseline's value, the run's, the relative change, and the change that counts as
/// none. Aligned for a terminal; empty where nothing drifted.
pub fn drift_text(cases: &[CaseDrift]) -> String {
    let table = table(cases);
    if table.rows.is_empty() { String::new() } else { table.to_text(TEXT_WIDTH) }
}

fn table(cases: &[CaseDrift]) -> Table {
    let columns = ["case", "quantity", "baseline", "now", "change", "allowed"];
    let rows = cases.iter().flat_map(|(name, drifts)| drifts.iter().map(move |drift| row(name, drift)));
    Table { rows: rows.collect(), columns: columns.map(|heading| Column::new(heading, heading)).to_vec() }
}

fn row(name: &str, drift: &Drift) -> Row {
    let figure = |text: &Option<String>| text.clone().map_or(Cell::Missing, Cell::Figure);
    let share = |x: Option<f64>| x.map_or(Cell::Missing, |x| Cell::Figure(format!("{x:.1e}")));
    // what is no number says all in words
    let quantity = if drift.was.is_none() && drift.now.is_none() { drift.to_string() } else { drift.quantity.clone() };
    let values = [figure(&drift.was), figure(&drift.now), share(drift.change), share(drift.allowed)];
    Row { cells: [vec![Cell::text(name), Cell::text(quantity)], values.to_vec()].concat(), excluded: None }
}
