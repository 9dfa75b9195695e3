//! Rates of the terms of a ledger, by absolute value.
//!
//! A signed term that passes through zero falls like nothing on its way: only the levels since its last change of sign
//! carry a rate. Terms at the size of rounding carry none.

use super::{NoFit, Point, ROUNDING, fit_above};
use crate::record::{Ledger, Level, Rate};

/// Before the name of a ledger's term in [`StudyRecord::rates`](crate::record::StudyRecord::rates).
pub const PREFIX: &str = "ledger.";

/// Rounding in a square, as a share of `‖u‖²_A`: what the inequality itself allows for.
const ROUNDING_OF_SQUARES: f64 = 1e-14;

/// The rates that the terms can carry, as `ledger.<term>`.
pub(super) fn rates(levels: &[Level]) -> impl Iterator<Item = (String, Rate)> {
    let terms = Ledger::TERMS.into_iter().chain(Ledger::PARTS.map(|(name, _)| name));
    terms.filter_map(move |term| Some((format!("{PREFIX}{term}"), fit_term(levels, term).ok()?)))
}

/// [`fit`](super::fit) of one term's absolute values on the levels that are not excluded, since its last change of sign.
///
/// # Errors
/// [`NoFit`] where they cannot carry a rate.
pub fn fit_term(levels: &[Level], term: &str) -> Result<Rate, NoFit> {
    let mut points: Vec<Point> = Vec::new();
    for level in levels.iter().filter(|l| l.excluded.is_none()) {
        let Some(value) = level.ledger.as_ref().and_then(|l| l.term(term)) else {
            continue;
        };
        if points.last().is_some_and(|p| p.error * value < 0.0) {
            points.clear();
        }
        points.push(Point { level: level.level, h: level.h, dofs: level.dofs, error: value });
    }
    points.iter_mut().for_each(|p| p.error = p.error.abs());
    fit_above(&points, rounding(levels, term))
}

/// The size of rounding in a term: of a square against `‖u‖²_A`, of a norm on the zone against the trace of the solution.
fn rounding(levels: &[Level], term: &str) -> f64 {
    let largest = |size: fn(&Level) -> Option<f64>| levels.iter().filter_map(size).fold(0.0, f64::max);
    if Ledger::is_square(term) {
        ROUNDING_OF_SQUARES * largest(|l| l.solution_energy).powi(2)
    } else {
        ROUNDING * largest(|l| l.solution_trace)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rate;
    use crate::sample;

    /// Six levels with a ledger `lhs = a = h²`, `b`, `c = −2 h^{3/2}`, and one part `h²/10`.
    fn levels(b: impl Fn(usize, f64) -> f64) -> Vec<Level> {
        let mut levels = sample::levels(6, |h| h);
        for (k, level) in levels.iter_mut().enumerate() {
            let h = level.h;
            level.ledger = Some(Ledger {
                lhs: h * h,
                a: h * h,
                b: b(k, h),
                c: -2.0 * h.powf(1.5),
                parts: [("nodal_minus_jump".into(), 0.1 * h * h)].into(),
                delta: 0.0,
                holds: Some(true),
            });
        }
        levels
    }

    #[test]
    fn terms_are_fitted_beside_the_norms() {
        let rates = rate::all(&levels(|_, h| h.powi(3)), "strain");
        let slopes = [("lhs", 2.0), ("a", 2.0), ("b", 3.0), ("c", 1.5), ("nodal_minus_jump", 2.0)];
        for (term, slope) in slopes {
            let rate = &rates[&format!("ledger.{term}")];
            assert!((rate.slope - slope).abs() < 1e-12 && rate.asymptotic, "{term}: {rate:?}");
            assert_eq!(rate.levels, [0, 1, 2, 3, 4, 5]);
        }
        assert_eq!(rates.keys().filter(|k| !k.starts_with(PREFIX)).collect::<Vec<_>>(), ["dofs", "energy", "strain"]);
        assert_eq!(rates.len(), 3 + slopes.len());
    }

    #[test]
    fn only_the_levels_since_the_last_change_of_sign_count() {
        let sign = |k: usize| if k < 2 { -1.0 } else { 1.0 };
        let rate = fit_term(&levels(|k, h| sign(k) * h * h), "b").unwrap();
        assert_eq!(rate.levels, [2, 3, 4, 5]);
        let alternating = fit_term(&levels(|k, h| if k % 2 == 0 { h * h } else { -h * h }), "b");
        assert!(matches!(alternating, Err(NoFit::TooFew { usable: 1, .. })), "{alternating:?}");
    }

    #[test]
    fn what_vanishes_has_no_rate() {
        for b in [0.0, 1e-19, -1e-15] {
            assert!(fit_term(&levels(|k, h| if k == 4 { b } else { h }), "b").is_err(), "{b}");
        }
        assert!(fit_term(&levels(|_, h| 1e-11 * h), "b").is_ok());
        let mut small = levels(|_, h| h);
        small.iter_mut().for_each(|l| l.solution_trace = Some(1e9));
        assert!(matches!(fit_term(&small, "nodal_minus_jump"), Err(NoFit::Rounding { .. })));
        assert!(matches!(fit_term(&small, "gap_interpolation"), Err(NoFit::TooFew { usable: 0, .. })));
    }

    #[test]
    fn excluded_levels_stay_out() {
        let mut levels = levels(|_, h| h * h);
        levels[5].excluded = Some("reference".into());
        if let Some(ledger) = &mut levels[5].ledger {
            ledger.a = 1e9;
        }
        assert_eq!(fit_term(&levels, "a").unwrap().levels, [0, 1, 2, 3, 4]);
    }
}
