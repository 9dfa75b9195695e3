//! Rates against bounds, ceilings and trends.

use super::*;

#[test]
fn the_claimed_rate_passes() {
    expect(&of_rate(spoilt(1.0, |_| {})), Pass, "against 1.000 − 0.050 (the paper)");
    // within the tolerance
    expect(&of_rate(spoilt(0.97, |_| {})), Pass, "rate 0.970");
}

#[test]
fn a_rate_below_the_gate_fails() {
    expect(&of_rate(spoilt(0.94, |_| {})), Fail, "too slow: rate 0.940");
    expect(&of_rate(spoilt(0.75, |_| {})), Fail, "too slow");
    expect(&of_rate(spoilt(-0.2, |_| {})), Fail, "too slow");
    let tight = judged(ClaimKind::Rate, "strain", spoilt(0.97, |_| {}), GATE_1, |g| g.rate_tolerance = 0.02);
    expect(&tight, Fail, "too slow");
}

#[test]
fn the_gate_is_the_papers_bound_else_todays_else_the_expected_rate() {
    let slow = || spoilt(0.8, |_| {});
    let bounds = |paper, today, expected| Bounds { paper, today, expected };
    let judge = |b| judged(ClaimKind::Rate, "strain", slow(), b, |_| {});
    expect(&judge(bounds(Some(0.75), Some(1.0), Some(0.8))), Pass, "0.750 − 0.050 (the paper)");
    expect(&judge(bounds(None, Some(1.0), Some(0.8))), Fail, "(today's bound)");
    expect(&judge(bounds(None, None, Some(0.8))), Pass, "(expected)");
    expect(&judge(bounds(None, None, None)), Inconclusive, "no bound");
}

#[test]
fn a_broken_theorem_fails_whatever_the_rate() {
    let broken = spoilt(1.0, |l| l[1].ledger = ledger(0.6, 0.0, Some(false)));
    for (kind, norm) in
        [(ClaimKind::Rate, "strain"), (ClaimKind::Convergence, "strain"), (ClaimKind::Inequality, "ledger")]
    {
        expect(&of_kind(kind, norm, broken.clone()), Fail, "½A(e,e) ≤ a + b + c is broken");
    }
    expect(&of_rate(spoilt(1.0, |l| l[1].ledger = ledger(0.5, 0.0, Some(true)))), Pass, "rate");
    expect(&of_rate(spoilt(1.0, |l| l[1].ledger = ledger(0.5, 0.0, None))), Pass, "within its quadrature estimate");
}

#[test]
fn an_error_above_its_ceiling_fails() {
    let high =
        |l: &mut Vec<Level>| l.iter_mut().for_each(|l| l.errors.interpolation = l.errors.energy.map(|e| e / 1.6));
    expect(&of_rate(spoilt(1.0, high)), Fail, "exceeds 1.5 ×");
    let lifted = judged(ClaimKind::Rate, "strain", spoilt(1.0, high), GATE_1, |g| g.ceiling = Some(2.0));
    expect(&lifted, Pass, "rate");
    let none = judged(ClaimKind::Rate, "strain", spoilt(1.0, high), GATE_1, |g| g.ceiling = None);
    expect(&none, Pass, "rate");
    // outside the window nothing is held against it
    let coarse = |l: &mut Vec<Level>| {
        l[0].errors.interpolation = l[0].errors.energy.map(|e| e / 1.6);
        l[0].budget.reference = Some(0.06);
    };
    expect(&of_rate(spoilt(1.0, coarse)), Pass, "levels 1–4");
    let unknown = spoilt(1.0, |l| l.iter_mut().for_each(|l| l.errors.interpolation = None));
    expect(&of_rate(unknown), Pass, "the ceiling is not checked");
}

#[test]
fn too_good_is_not_believed() {
    expect(&of_rate(spoilt(1.2, |_| {})), Inconclusive, "too good: rate 1.200 where 1.000");
    expect(&of_rate(spoilt(1.1, |_| {})), Pass, "rate 1.100");
    // above the paper's bound but not above the expected rate
    let bounds = Bounds { paper: Some(0.75), today: Some(1.0), expected: Some(1.0) };
    expect(&judged(ClaimKind::Rate, "strain", spoilt(1.0, |_| {}), bounds, |_| {}), Pass, "rate 1.000");
}

#[test]
fn an_asymptotic_expectation_is_reported_and_not_gated() {
    let levels = spoilt(1.2, |_| {});
    let gates = Gates::default();
    let input = JudgeInput {
        kind: ClaimKind::Rate,
        norm: "strain",
        levels: &levels,
        bounds: &GATE_1,
        gates: &gates,
        expected_is_asymptotic: true,
    };
    expect(&judge(&input), Pass, "expected of large sizes only");
}

#[test]
fn noise_around_the_gate_is_not_decided() {
    let mut noise = Noise::new(3);
    let noisy: Vec<Level> =
        (0..6).map(|k| sample::level(k, 0.1 * 0.5_f64.powf(0.95 * k as f64 + 0.15 * noise.normal()))).collect();
    expect(&of_rate(noisy), Inconclusive, "neither the interval nor the pairwise rates decide");
}

#[test]
fn scatter_that_stays_above_passes() {
    // changes above 0.05, so not asymptotic, but all rates and the trend lie above 0.95
    expect(&of_rate(with_rates(&[1.06, 0.98, 1.05, 0.99])), Pass, "not asymptotic");
}

#[test]
fn a_trend_is_no_noise() {
    // still rising towards the gate: the interval's upper end lies below it, yet nothing is refuted
    let rising = with_rates(&[0.10, 0.44, 0.70, 0.90]);
    expect(&of_rate(rising), Inconclusive, "not asymptotic");
    // falling through the gate: slope and pairwise rates still lie above it
    let falling = with_rates(&[1.20, 1.12, 1.04, 0.97]);
    expect(&of_rate(falling), Inconclusive, "not asymptotic");
    // far below and staying there
    expect(&of_rate(with_rates(&[0.20, 0.27, 0.21, 0.27])), Fail, "too slow");
}

#[test]
fn preasymptotic_levels_are_left_out_of_the_window() {
    expect(&of_rate(with_rates(&[0.3, 0.7, 0.97, 0.99, 1.0])), Pass, "levels 2–5");
}

/// Energy errors and interpolation errors of a piecewise polynomial solution on squares cut into `n × n` right
/// triangles, `n = 8 … 128`, computed by an independent program. The slope by hand: `log₂ e` falls by 0, 0.9564, 1.9377,
/// 2.9330, 3.9319 in all, so it is `(−0.9564 + 2.9330 + 2 · 3.9319)/10`.
#[test]
fn a_measured_table_is_judged_as_by_hand() {
    let table = [
        (1.7707e-01, 1.8412e-01),
        (9.1255e-02, 9.2482e-02),
        (4.6219e-02, 4.6411e-02),
        (2.3184e-02, 2.3212e-02),
        (1.1602e-02, 1.1606e-02),
    ];
    let measured = |k: usize| {
        let mut level = sample::level(k, table[k].0);
        level.errors.interpolation = Some(table[k].1);
        level
    };
    let levels: Vec<Level> = (0..5).map(measured).collect();
    let slope = crate::rate::fit_levels(&levels, "energy").unwrap().slope;
    assert!((slope - 0.98404).abs() < 2e-5, "{slope}");
    expect(&of_kind(ClaimKind::Rate, "energy", levels), Pass, "rate 0.984");
}

/// Four settled levels whose rates drift down: the interval reaches below 0.95, the pairwise rates do not.
#[test]
fn pairwise_rates_alone_may_decide() {
    let drifting = [1.058, 1.009, 0.960];
    let low = crate::rate::fit_levels(&with_rates(&drifting), "strain").unwrap().low;
    assert!(low < 0.95, "{low}");
    expect(&of_rate(with_rates(&drifting)), Pass, "rate 1.009");
    // the twin: one pair below as well
    expect(&of_rate(with_rates(&[1.038, 0.989, 0.940])), Inconclusive, "neither");
}

/// Eight settled levels with one pairwise rate below 0.95: the interval lies above all the same.
#[test]
fn the_interval_alone_may_decide() {
    let dip = with_rates(&[1.02, 0.98, 0.945, 0.98, 1.02, 1.03, 1.03]);
    expect(&of_rate(dip), Pass, "rate 0.996");
    // the twin: the same dip with fewer levels to outweigh it
    let short = with_rates(&[0.945, 0.98, 1.02]);
    expect(&of_rate(short), Inconclusive, "neither");
}
