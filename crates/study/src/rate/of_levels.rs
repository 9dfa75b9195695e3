//! Rates of a record's levels.

use super::{NoFit, Point, fit_above, of_ledger};
use crate::record::{Errors, Level, Rate};
use std::collections::BTreeMap;

/// An error below this share of the solution's norm is rounding.
pub const ROUNDING: f64 = 1e-11;

/// The measured errors of the levels that may enter a fit, in the norm named by a field of [`Errors`].
pub fn points(levels: &[Level], norm: &str) -> Vec<Point> {
    let usable = levels.iter().filter(|l| l.excluded.is_none());
    usable
        .filter_map(|l| {
            let error = l.errors.size(norm)?;
            Some(Point { level: l.level, h: l.h, dofs: l.dofs, error })
        })
        .collect()
}

/// The size of rounding in `norm`: `1e-11 ‖u‖_A` for the norms that compare with the energy norm, `1e-11` of the
/// solution's trace for the penetration, 0 for the others and where the solution's size is not known.
pub fn rounding_floor(levels: &[Level], norm: &str) -> f64 {
    let largest = |size: fn(&Level) -> Option<f64>| levels.iter().filter_map(size).fold(0.0, f64::max);
    match norm {
        "strain" | "energy" | "h1" => ROUNDING * largest(|l| l.solution_energy),
        "penetration_l2" => ROUNDING * largest(|l| l.solution_trace),
        _ => 0.0,
    }
}

/// Whether a level's energy error is rounding, `√A(e,e) ≤ 1e-11 ‖u‖_A`: then every other error of the level is, too.
pub fn is_rounding(level: &Level) -> bool {
    let sizes = level.errors.energy.zip(level.solution_energy);
    sizes.is_some_and(|(error, solution)| error <= ROUNDING * solution)
}

/// [`fit`](super::fit) of the levels that are not excluded, in the norm named by a field of [`Errors`].
///
/// # Errors
/// [`NoFit`] where the levels cannot carry a rate.
pub fn fit_levels(levels: &[Level], norm: &str) -> Result<Rate, NoFit> {
    fit_above(&points(levels, norm), rounding_floor(levels, norm))
}

/// Every rate that the levels can carry by name of the norm; under `ledger.<term>` those of the ledger's terms, and under
/// `dofs` the rate of the claim's `norm` against `dofs^{-1/2}` in place of `h`. None where a usable level's error is
/// rounding.
pub fn all(levels: &[Level], norm: &str) -> BTreeMap<String, Rate> {
    if levels.iter().any(|l| l.excluded.is_none() && is_rounding(l)) {
        return BTreeMap::new();
    }
    let named = Errors::NORMS.iter().map(|name| (*name, fit_levels(levels, name)));
    let dofs = ("dofs", fit_dofs(levels, norm));
    let norms = named.chain([dofs]).filter_map(|(name, rate)| Some((name.to_string(), rate.ok()?)));
    norms.chain(of_ledger::rates(levels)).collect()
}

fn fit_dofs(levels: &[Level], norm: &str) -> Result<Rate, NoFit> {
    let against_dofs = |p: Point| Point { h: (p.dofs as f64).powf(-0.5), ..p };
    let points: Vec<Point> = points(levels, norm).into_iter().map(against_dofs).collect();
    fit_above(&points, rounding_floor(levels, norm))
}
