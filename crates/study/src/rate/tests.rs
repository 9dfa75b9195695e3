//! The fit alone, on synthetic errors whose slope, spread and interval are known by hand.

use super::*;
use crate::sample::{self, Noise};

/// `h = 2^{-k}`, `dofs = 4·4^k`, errors given.
fn halved(errors: &[f64]) -> Vec<Point> {
    let point =
        |(k, error): (usize, &f64)| Point { level: k, h: 0.5_f64.powi(k as i32), dofs: 4 << (2 * k), error: *error };
    errors.iter().enumerate().map(point).collect()
}

/// Errors that fall with the given pairwise rates from 1 on.
fn falling(rates: &[f64]) -> Vec<Point> {
    let mut errors = vec![1.0];
    for r in rates {
        errors.push(errors[errors.len() - 1] * 2.0_f64.powf(-r));
    }
    halved(&errors)
}

#[test]
fn a_power_law_is_found_exactly() {
    let rate = fit(&halved(&[0.3, 0.15, 0.075, 0.0375, 0.01875])).unwrap();
    assert!((rate.slope - 1.0).abs() < 1e-14 && rate.stderr < 1e-14);
    assert!((rate.high - rate.low).abs() < 1e-13 && (rate.r2 - 1.0).abs() < 1e-14);
    assert!((rate.intercept - 0.3_f64.ln()).abs() < 1e-14);
    assert!((rate.dofs_slope - 1.0).abs() < 1e-14 && rate.curvature.abs() < 1e-14);
    assert_eq!(rate.levels, [0, 1, 2, 3, 4]);
    assert!(rate.asymptotic);
}

/// `log₂ e = −k` at 0, 1, 2, 3 plus `δ (1, −1, −1, 1)`: the disturbance is orthogonal to lines, so the slope is 1,
/// `SSE = 4 δ²`, `stderr = √(4 δ² / (2 · 5))`, and the interval ends `4.302652730` of these away.
#[test]
fn slope_spread_and_interval_by_hand() {
    let delta: f64 = 0.004;
    let shift = [delta, -delta, -delta, delta];
    let errors: Vec<f64> = (0..4).map(|k| 2.0_f64.powf(shift[k] - k as f64)).collect();
    let rate = fit(&halved(&errors)).unwrap();
    let stderr = (0.4 * delta * delta).sqrt();
    assert!((rate.slope - 1.0).abs() < 1e-13);
    assert!((rate.stderr - stderr).abs() < 1e-13);
    assert!((rate.high - rate.slope - 4.302652730 * stderr).abs() < 1e-11);
    assert!((rate.slope - rate.low - 4.302652730 * stderr).abs() < 1e-11);
    assert!((rate.r2 - (1.0 - 4.0 * delta * delta / (5.0 + 4.0 * delta * delta))).abs() < 1e-13);
    // pairwise rates 1 + 2δ, 1, 1 − 2δ
    assert!((rate.curvature + 2.0 * delta).abs() < 1e-13);
    assert!((rate.pairwise[0].1 - 1.0 - 2.0 * delta).abs() < 1e-13 && rate.pairwise[0].0 == 1);
}

#[test]
fn the_window_is_the_longest_settled_tail() {
    let rate = fit(&falling(&[0.4, 0.6, 0.93, 0.96, 0.98, 0.99])).unwrap();
    assert_eq!(rate.levels, [2, 3, 4, 5, 6]);
    assert!(rate.asymptotic && rate.pairwise.len() == 6);
    // each change is small though the whole drift is not: successive differences are what counts
    let slow = fit(&falling(&[0.80, 0.84, 0.88, 0.92, 0.96])).unwrap();
    assert_eq!(slow.levels.len(), 6);
    assert!((slow.curvature - 0.04).abs() < 1e-12);
}

#[test]
fn an_unsettled_tail_is_fitted_and_marked() {
    let rate = fit(&falling(&[1.0, 1.0, 1.0, 0.8, 0.5])).unwrap();
    assert_eq!(rate.levels, [2, 3, 4, 5]);
    assert!(!rate.asymptotic);
}

#[test]
fn rates_against_dofs_and_h_differ_where_h_jumps() {
    let mut points = halved(&[1.0, 0.5, 0.25, 0.125]);
    points[3].h *= 1.2;
    let rate = fit(&points).unwrap();
    assert!((rate.dofs_slope - 1.0).abs() < 1e-13 && rate.slope > 1.05);
}

#[test]
fn what_cannot_carry_a_rate_is_refused() {
    assert!(matches!(fit(&halved(&[1.0, 0.5, 0.25])), Err(NoFit::TooFew { usable: 3, needed: 4 })));
    for bad in [f64::NAN, f64::INFINITY, 0.0, -0.1] {
        let refused = fit(&halved(&[1.0, 0.5, bad, 0.125, 0.06]));
        assert!(matches!(refused, Err(NoFit::NotPositive { level: 2, .. })), "{bad}: {refused:?}");
    }
    let repeated = fit(&halved(&[1.0, 0.5, 0.25, 0.125, 0.125 * (1.0 + 1e-12)]));
    assert!(matches!(repeated, Err(NoFit::Repeated { first: 3, second: 4, .. })));
    // the twin: a stagnating error is no repeated one and is fitted
    assert!(fit(&halved(&[1.0, 0.5, 0.25, 0.125, 0.124])).is_ok());
}

#[test]
fn a_mesh_that_did_not_refine_is_refused() {
    for h in [0.25, 0.249, 0.3, f64::NAN] {
        let mut points = halved(&[1.0, 0.5, 0.25, 0.12, 0.06]);
        points[3].h = h;
        assert!(matches!(fit(&points), Err(NoFit::NotRefined { level: 3, .. })), "h {h}");
    }
    let mut points = halved(&[1.0, 0.5, 0.25, 0.12, 0.06]);
    points[3].dofs = points[2].dofs;
    assert!(matches!(fit(&points), Err(NoFit::NotRefined { level: 3, .. })));
}

#[test]
fn rounding_is_no_error() {
    let points = halved(&[1e-3, 1e-6, 1e-9, 1e-12]);
    assert!(fit_above(&points, 1e-13).is_ok());
    assert!(matches!(fit_above(&points, 1e-11), Err(NoFit::Rounding { level: 3, .. })));
}

/// With normal noise on `log e` the 95 % interval holds the true slope in 95 of 100 draws. With four levels the
/// window is all of them, so nothing is selected. The normal quantile 1.96 in place of Student's would reach
/// `P(|T_2| ≤ 1.96) = 1.96/√(2 + 1.96²) = 0.811` only.
#[test]
fn the_interval_covers_the_true_slope() {
    let mut noise = Noise::new(7);
    let draws = 8000;
    let (mut covered, mut by_normal) = (0, 0);
    for _ in 0..draws {
        let errors: Vec<f64> = (0..4).map(|k| (0.03 * noise.normal()).exp() * 0.5_f64.powi(k)).collect();
        let rate = fit(&halved(&errors)).unwrap();
        covered += usize::from(rate.low <= 1.0 && 1.0 <= rate.high);
        by_normal += usize::from((rate.slope - 1.0).abs() <= 1.96 * rate.stderr);
    }
    let share = |count: usize| count as f64 / draws as f64;
    // three standard deviations of a share: 3 √(0.95 · 0.05 / 8000) = 0.0073, and 0.0131 for 0.811
    assert!((share(covered) - 0.95).abs() < 0.0073, "{}", share(covered));
    assert!((share(by_normal) - 0.811).abs() < 0.0131, "{}", share(by_normal));
}

/// Nine levels: seven degrees of freedom.
#[test]
fn the_interval_covers_with_more_levels() {
    let mut noise = Noise::new(11);
    let draws = 4000;
    let t = student::quantile(0.975, 7);
    let mut covered = 0;
    for _ in 0..draws {
        let points: Vec<(f64, f64)> = (0..9).map(|k| (k as f64, 0.7 * k as f64 + noise.normal())).collect();
        let line = Line::through(&points);
        covered += usize::from((line.slope - 0.7).abs() <= t * line.stderr);
    }
    let share = covered as f64 / draws as f64;
    assert!((share - 0.95).abs() < 0.0104, "{share}");
}

#[test]
fn levels_give_points_unless_excluded() {
    let mut levels = sample::levels(5, |h| h);
    assert_eq!(points(&levels, "energy").len(), 5);
    assert!((fit_levels(&levels, "energy").unwrap().slope - 1.0).abs() < 1e-12);
    levels[0].excluded = Some("reference".into());
    assert_eq!(fit_levels(&levels, "energy").unwrap().levels, [1, 2, 3, 4]);
    assert!(matches!(fit_levels(&levels, "pressure_l2"), Err(NoFit::TooFew { usable: 0, .. })));
    let rates = all(&levels, "energy");
    assert_eq!(rates.keys().collect::<Vec<_>>(), ["dofs", "energy", "strain"]);
}

#[test]
fn rounding_is_measured_by_the_solution() {
    let mut levels = sample::levels(5, |h| 1e-10 * h);
    levels.iter_mut().for_each(|l| l.solution_energy = Some(1e-8));
    assert!(fit_levels(&levels, "energy").is_ok());
    levels.iter_mut().for_each(|l| l.solution_energy = Some(1.0));
    assert!(matches!(fit_levels(&levels, "energy"), Err(NoFit::Rounding { level: 1, .. })));
}

#[test]
fn rounding_carries_no_rate_in_any_norm() {
    let mut levels = sample::levels(5, |h| 0.1 * h);
    levels.iter_mut().for_each(|l| l.errors.l2 = Some(l.h * l.h));
    assert!(all(&levels, "strain").contains_key("l2"));
    // one level at the size of rounding spoils them all: L² has no scale of its own
    levels[4].errors.energy = Some(9e-12);
    assert!(is_rounding(&levels[4]) && !is_rounding(&levels[3]));
    assert!(all(&levels, "strain").is_empty());
    // left out of the fit it spoils nothing
    levels[4].excluded = Some("rounding".into());
    assert!(all(&levels, "strain").contains_key("l2"));
}

#[test]
fn penetration_is_measured_by_the_trace() {
    let mut levels = sample::levels(4, |h| h);
    levels.iter_mut().for_each(|l| l.errors.penetration_l2 = Some(1e-10 * l.h * l.h));
    assert!(matches!(fit_levels(&levels, "penetration_l2"), Err(NoFit::Rounding { .. })));
    levels.iter_mut().for_each(|l| l.solution_trace = Some(1e-6));
    assert!((fit_levels(&levels, "penetration_l2").unwrap().slope - 2.0).abs() < 1e-12);
}
