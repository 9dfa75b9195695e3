//! What follows from the levels of one solver: seconds to an error, and how they grow.

use super::record::Exponent;
use crate::rate::Line;

/// Meshes that a growth is fitted on: the finest, where what costs the same on every mesh no longer counts.
const FINEST: usize = 4;
/// Fewest meshes of a fit.
const FEWEST: usize = 3;
/// Most targets of a table.
const TARGETS: usize = 6;

/// Seconds at which an error is reached: by powers between the two levels, coarsest first, whose errors enclose it.
///
/// `points` are errors and seconds. Nothing is said beyond the measured errors.
pub fn seconds_to(points: &[(f64, f64)], target: f64) -> Option<f64> {
    let enclosing = points.windows(2).find(|p| p[0].0 >= target && p[1].0 <= target);
    let Some(&[(e0, t0), (e1, t1)]) = enclosing else {
        return points.iter().find(|p| p.0 == target).map(|p| p.1);
    };
    if e0 == e1 {
        return Some(t0);
    }
    // log t is linear in log e
    let share = (target / e0).ln() / (e1 / e0).ln();
    Some(t0 * (t1 / t0).powf(share))
}

/// Round errors, 1, 2 or 5 times a power of ten, between the largest and the smallest, largest first; the smallest six.
pub fn targets(errors: impl Iterator<Item = f64>) -> Vec<f64> {
    let (low, high) = errors.fold((f64::INFINITY, 0.0_f64), |(a, b), e| (a.min(e), b.max(e)));
    let round = (-16..2).flat_map(|k| [1, 2, 5].map(|m| format!("{m}e{k}")));
    let mut inside: Vec<f64> = round.filter_map(|t| t.parse().ok()).filter(|e| (low..=high).contains(e)).collect();
    inside.truncate(TARGETS);
    inside.reverse();
    inside
}

/// The exponent `p` of `seconds = c · dofs^p` on the finest meshes; `None` of fewer than three.
pub fn growth(points: &[(usize, f64)]) -> Option<Exponent> {
    let finest = &points[points.len().saturating_sub(FINEST)..];
    let logs: Vec<(f64, f64)> = finest.iter().filter(|p| p.1 > 0.0).map(|&(n, t)| ((n as f64).ln(), t.ln())).collect();
    if logs.len() < FEWEST {
        return None;
    }
    let line = Line::through(&logs);
    let exponent = Exponent { value: line.slope, stderr: line.stderr, sizes: logs.len() };
    (exponent.value.is_finite() && exponent.stderr.is_finite()).then_some(exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `t = 3 e^{-2}`: exact between levels, since powers are interpolated as powers.
    #[test]
    fn seconds_to_an_error_follow_the_power() {
        let points: Vec<(f64, f64)> = [0.4, 0.2, 0.1].iter().map(|&e: &f64| (e, 3.0 * e.powi(-2))).collect();
        for target in [0.4, 0.3, 0.2, 0.15, 0.1] {
            let found = seconds_to(&points, target).unwrap();
            assert!((found / (3.0 / (target * target)) - 1.0).abs() < 1e-13, "{target}: {found}");
        }
        assert_eq!((seconds_to(&points, 0.41), seconds_to(&points, 0.09)), (None, None));
        assert_eq!((seconds_to(&points[..1], 0.4), seconds_to(&[], 0.4)), (Some(points[0].1), None));
    }

    #[test]
    fn targets_are_round_and_inside() {
        assert_eq!(targets([0.13, 0.03, 0.0081].into_iter()), [0.1, 0.05, 0.02, 0.01]);
        assert_eq!(targets([1.0, 1e-9].into_iter()).len(), TARGETS);
        assert!(targets(std::iter::empty()).is_empty());
    }

    #[test]
    fn the_exponent_is_that_of_the_finest_meshes() {
        let seconds = |n: usize| if n < 1000 { 7.0 } else { 1e-6 * (n as f64).powf(1.25) };
        let points: Vec<(usize, f64)> = (0..6).map(|k| 100 << (2 * k)).map(|n| (n, seconds(n))).collect();
        let fitted = growth(&points).unwrap();
        assert!((fitted.value - 1.25).abs() < 1e-12 && fitted.stderr < 1e-12 && fitted.sizes == 4, "{fitted:?}");
        assert_eq!(growth(&points[4..]), None);
    }
}
