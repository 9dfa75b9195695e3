//! Kinds without a fit: exact, inequality, convergence, bounded.

use super::*;

#[test]
fn exact_means_rounding() {
    let sound = || sample::levels(3, |h| 1e-14 / h);
    expect(&of_kind(ClaimKind::Exact, "energy", sound()), Pass, "on 3 levels");
    // shares of a rounding error may be anything
    let shares = || {
        let mut levels = sound();
        levels.iter_mut().for_each(|l| l.budget.algebraic = Some(0.9));
        levels
    };
    expect(&of_kind(ClaimKind::Exact, "energy", shares()), Pass, "at most");
    let mut defect = sound();
    defect[1].errors.energy = Some(1e-9);
    expect(&of_kind(ClaimKind::Exact, "energy", defect), Fail, "level 1: energy error 1.00e-9 of ‖u‖_A");
    // an error of order h has a fine rate and is no rounding
    expect(&of_kind(ClaimKind::Exact, "energy", sample::levels(3, |h| h)), Fail, "more than rounding");
    let mut zero = sound();
    zero.iter_mut().for_each(|l| l.errors.energy = Some(0.0));
    expect(&of_kind(ClaimKind::Exact, "energy", zero), Inconclusive, "exactly zero");
    let mut unscaled = sound();
    unscaled[0].solution_energy = None;
    unscaled[0].budget = Default::default();
    expect(&of_kind(ClaimKind::Exact, "energy", unscaled), Inconclusive, "no ‖u‖_A");
}

#[test]
fn a_vanishing_quantity_vanishes() {
    let with = |penetration: f64| {
        let mut levels = sample::levels(3, |h| h);
        levels.iter_mut().for_each(|l| l.errors.penetration_l2 = Some(penetration));
        levels
    };
    let judge = |levels| of_kind(ClaimKind::Inequality, "penetration_l2", levels);
    expect(&judge(with(0.0)), Pass, "at most 0.00e0");
    expect(&judge(with(1e-16)), Pass, "on 3 levels");
    expect(&judge(with(1e-9)), Fail, "level 0: penetration is 1.00e-9");
    let mut large_units = with(1e-9);
    large_units.iter_mut().for_each(|l| l.solution_trace = Some(1e6));
    expect(&judge(large_units), Pass, "on 3 levels");
    let mut unscaled = with(0.0);
    unscaled[2].solution_trace = None;
    expect(&judge(unscaled), Inconclusive, "level 2: no penetration or no scale");
    let mut broken = with(0.0);
    broken[0].ledger = ledger(0.6, 0.0, Some(false));
    expect(&judge(broken), Fail, "is broken");
}

#[test]
fn a_ledger_inequality_is_decided_on_every_level() {
    let with = |holds: Option<bool>| {
        let mut levels = sample::levels(3, |h| h);
        levels.iter_mut().for_each(|l| l.ledger = ledger(0.4, 0.0, Some(true)));
        levels[1].ledger = ledger(0.5, 0.0, holds);
        levels
    };
    let judge = |levels| of_kind(ClaimKind::Inequality, "ledger", levels);
    expect(&judge(with(Some(true))), Pass, "on 3 levels");
    expect(&judge(with(None)), Inconclusive, "within its quadrature estimate");
    expect(&judge(with(Some(false))), Fail, "is broken");
    let mut missing = with(Some(true));
    missing[2].ledger = None;
    expect(&judge(missing), Inconclusive, "level 2: no ledger");
}

#[test]
fn convergence_needs_every_error_to_fall() {
    let judge = |levels| of_kind(ClaimKind::Convergence, "energy", levels);
    expect(&judge(with_rates(&[0.5, 0.2, 0.7])), Pass, "at most 0.871");
    expect(&judge(with_rates(&[0.5, 0.1, 0.7])), Fail, "level 2: energy error times 0.933");
    expect(&judge(with_rates(&[0.5, -0.1, 0.7])), Fail, "level 2");
    expect(&judge(with_rates(&[0.5])), Inconclusive, "2 usable levels");
    expect(&judge(with_rates(&[0.5, 0.0, 0.7])), Inconclusive, "the same error");
}

#[test]
fn bounded_constants() {
    let with = |b_over_h2: &[f64]| {
        let mut levels = sample::levels(b_over_h2.len(), |h| h);
        for (l, c) in levels.iter_mut().zip(b_over_h2) {
            l.ledger = ledger(0.4, c * l.h * l.h, Some(true));
        }
        levels
    };
    let judge = |values: &[f64]| of_kind(ClaimKind::Bounded, "b_over_h2", with(values));
    expect(&judge(&[0.3, 0.5, 0.4]), Pass, "constant b/h² reaches 5.000e-1");
    expect(&judge(&[0.3, 0.6001, 0.4]), Fail, "2 times the smallest");
    expect(&judge(&[0.3, 0.4]), Inconclusive, "2 usable levels");
    expect(&judge(&[0.0, 0.0, 0.0]), Pass, "vanishes on every level");
    expect(&judge(&[0.3, 0.0, 0.3]), Inconclusive, "state a reference constant");
    let against =
        |values: &[f64]| judged(ClaimKind::Bounded, "b_over_h2", with(values), GATE_1, |g| g.constant = Some(0.25));
    expect(&against(&[0.3, 0.0, 1e-6]), Pass, "2 times the reference constant");
    expect(&against(&[0.3, 0.0, 0.51]), Fail, "2 times the reference constant");
    // of either sign: the bound is one for |b|
    expect(&against(&[0.3, -0.51, 0.0]), Fail, "reaches 5.100e-1");
}

#[test]
fn an_agreement_is_judged_on_the_finest_level_and_doubts_coarse_meshes() {
    let with = |differences: &[f64]| {
        let mut levels = sample::levels(differences.len(), |h| h);
        for (level, d) in levels.iter_mut().zip(differences) {
            (level.errors.half_width, level.errors.peak_pressure) = (Some(*d), Some(0.1 * d));
        }
        levels
    };
    let norm = |norm: &str, differences: &[f64], bound: f64| {
        judged(ClaimKind::Agreement, norm, with(differences), GATE_1, |g| g.constant = Some(bound))
    };
    expect(&norm("formula", &[0.3, -0.02, -0.009], 0.03), Pass, "-9.000e-3 on the finest level");
    expect(&norm("peak_pressure", &[0.3, -0.02, -0.009], 0.003), Pass, "-9.000e-4");
    expect(&norm("half_width", &[0.3, 0.051, 0.05], 0.03), Fail, "3.000e-2 are allowed");
    // one refinement moves it from beyond the bound to beyond the other
    expect(&norm("half_width", &[0.3, -0.02, 0.02], 0.03), Inconclusive, "too coarse to tell");
    expect(&norm("half_width", &[0.3, 0.05, 0.04], 0.035), Inconclusive, "too coarse to tell");
    expect(&norm("half_width", &[0.02, 0.02], 0.03), Inconclusive, "2 usable levels");
    expect(&of_kind(ClaimKind::Agreement, "formula", with(&[0.0; 3])), Inconclusive, "no `constant`");
    expect(&norm("half_width", &[0.02, 0.02, f64::NAN], 0.03), Inconclusive, "half_width is NaN");
}
