//! Levels that are shown, greyed, and left out of every fit.

use crate::record::Level;
use crate::study::Gates;

/// Marks the levels that may not enter: those not solved, and those where a part of the error budget exceeds
/// [`Gates::share`] of the measured error. Marks already set stay.
pub fn exclude_levels(levels: &mut [Level], gates: &Gates) {
    for level in levels {
        if level.excluded.is_none() {
            level.excluded = reason(level, gates);
        }
    }
}

fn reason(level: &Level, gates: &Gates) -> Option<String> {
    if !level.solver.solved {
        return Some(format!("not solved: {}", level.solver.status));
    }
    let (part, share) = broken_parts(level, gates).next()?;
    Some(over_budget(part, share, gates))
}

/// "the `part` error is … of the measured error, more than …".
pub(super) fn over_budget(part: &str, share: f64, gates: &Gates) -> String {
    format!("{part} error is {:.1} % of the measured error, more than {:.1} %", 100.0 * share, 100.0 * gates.share)
}

/// Parts of the budget above their share; none where the measured error itself is rounding, since shares of rounding
/// mean nothing.
pub(super) fn broken_parts<'a>(level: &Level, gates: &'a Gates) -> impl Iterator<Item = (&'static str, f64)> + use<'a> {
    let b = &level.budget;
    let parts = [
        ("algebraic", b.algebraic),
        ("quadrature", b.quadrature),
        ("geometry", b.geometry),
        ("reference", b.reference),
    ];
    let rounding = is_rounding(level, gates);
    parts
        .into_iter()
        .filter_map(|(part, share)| Some((part, share?)))
        // a NaN share compares with nothing and is a broken one
        .filter(move |(_, share)| !rounding && share.partial_cmp(&gates.share).is_none_or(|o| o.is_gt()))
}

/// Whether the energy error is within [`Gates::exact_tolerance`] of the solution's norm.
fn is_rounding(level: &Level, gates: &Gates) -> bool {
    match (level.errors.energy, level.solution_energy) {
        (Some(error), Some(size)) => error <= gates.exact_tolerance * size,
        _ => false,
    }
}
