//! The bounds of the error that the energies give without a reference, beside the measured errors.

use crate::format;
use crate::levels::{build, h_column, level_column, measured, measured_at};
use crate::table::{Cell, Table};
use signorini_study::record::{Extrapolation, StudyRecord};

/// One row per level; no rows where the energies were not extrapolated.
pub fn table(record: &StudyRecord) -> Table {
    let Some(found) = &record.extrapolation else { return Table::default() };
    let bound = |i: usize| found.bounds.get(i).copied().flatten();
    let columns = vec![
        level_column(),
        h_column(),
        measured("energy_value", "L(uₕ)", |l| Cell::Number(l.energy)),
        measured_at("bound", "√(2(L(uₕ)−L*))", move |i, _| Cell::number(bound(i))),
        measured_at("bound_rate", "rate", move |i, _| Cell::rate(pairwise(found, i))),
        measured("energy", "√A(e,e)", |l| Cell::number(l.errors.energy)),
        measured_at("share", "measured/bound", move |i, l| {
            Cell::number(l.errors.energy.zip(bound(i)).map(|(e, b)| e / b))
        }),
    ];
    build(record, columns)
}

fn pairwise(found: &Extrapolation, level: usize) -> Option<f64> {
    found.fitted.as_ref()?.pairwise.iter().find(|(l, _)| *l == level).map(|(_, rate)| *rate)
}

/// The limit with its uncertainty and rate, and the reference's distance from it.
pub fn sentence(found: &Extrapolation) -> String {
    let reference = found.reference_above.map_or_else(String::new, |above| {
        let way = if above < 0.0 { "below" } else { "above" };
        format!(" The energy of the reference lies {} {way} it.", format::significant(above.abs(), 2))
    });
    format!(
        "The energies tend to L* = {} (± {}, from leaving one of the four finest levels out), like h to the power {} = 2r, \
         r = {}.{reference} Where Kₕ ⊂ K, A(e,e) ≤ 2(L(uₕ)−L(u)): the bound needs no reference, and its distance from the \
         measured error is the contact integral and the reference's own error.",
        format::significant(found.energy, 10),
        format::significant(found.uncertainty, 2),
        format::rate(2.0 * found.rate),
        format::rate(found.rate),
    )
}
