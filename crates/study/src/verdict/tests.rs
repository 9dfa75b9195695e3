//! Every rule beside its twin: the same levels with one defect that has to turn the verdict.

use super::*;
use crate::record::{Ledger, Level};
use crate::sample::{self, Noise};
use Outcome::{Fail, Inconclusive, Pass};

const GATE_1: Bounds = Bounds {
    paper: Some(1.0),
    today: Some(1.0),
    expected: Some(1.0),
};

/// Excludes and judges with the default gates, changed by `adjust`.
fn judged(
    kind: ClaimKind,
    norm: &str,
    mut levels: Vec<Level>,
    bounds: Bounds,
    adjust: impl Fn(&mut Gates),
) -> Verdict {
    let mut gates = Gates::default();
    adjust(&mut gates);
    exclude_levels(&mut levels, &gates);
    let input = JudgeInput {
        kind,
        norm,
        levels: &levels,
        bounds: &bounds,
        gates: &gates,
        expected_is_asymptotic: false,
    };
    judge(&input)
}

/// A rate claim with gate 1 in the strain norm.
fn of_rate(levels: Vec<Level>) -> Verdict {
    judged(ClaimKind::Rate, "strain", levels, GATE_1, |_| {})
}

fn of_kind(kind: ClaimKind, norm: &str, levels: Vec<Level>) -> Verdict {
    judged(kind, norm, levels, GATE_1, |_| {})
}

/// Five sound levels with the given rate, one of them spoilt.
fn spoilt(rate: f64, spoil: impl Fn(&mut Vec<Level>)) -> Vec<Level> {
    let mut levels = sample::levels(5, |h| h.powf(rate));
    spoil(&mut levels);
    levels
}

/// Levels with these pairwise rates.
fn with_rates(rates: &[f64]) -> Vec<Level> {
    let mut error = 0.1;
    let mut levels = vec![sample::level(0, error)];
    for (k, rate) in rates.iter().enumerate() {
        error *= 0.5_f64.powf(*rate);
        levels.push(sample::level(k + 1, error));
    }
    levels
}

#[track_caller]
fn expect(verdict: &Verdict, outcome: Outcome, word: &str) {
    assert_eq!(verdict.outcome, outcome, "{verdict:?}");
    assert!(
        verdict.reasons.iter().any(|r| r.contains(word)),
        "no '{word}' in {verdict:?}"
    );
}

fn ledger(lhs: f64, b: f64, holds: Option<bool>) -> Option<Ledger> {
    Some(Ledger {
        lhs,
        a: 0.5,
        b,
        c: 0.0,
        delta: 1e-9,
        holds,
    })
}

#[test]
fn the_claimed_rate_passes() {
    expect(
        &of_rate(spoilt(1.0, |_| {})),
        Pass,
        "against 1.000 − 0.050 (the paper)",
    );
    // within the tolerance
    expect(&of_rate(spoilt(0.97, |_| {})), Pass, "rate 0.970");
}

#[test]
fn a_rate_below_the_gate_fails() {
    expect(&of_rate(spoilt(0.94, |_| {})), Fail, "too slow: rate 0.940");
    expect(&of_rate(spoilt(0.75, |_| {})), Fail, "too slow");
    expect(&of_rate(spoilt(-0.2, |_| {})), Fail, "too slow");
    let tight = judged(
        ClaimKind::Rate,
        "strain",
        spoilt(0.97, |_| {}),
        GATE_1,
        |g| g.rate_tolerance = 0.02,
    );
    expect(&tight, Fail, "too slow");
}

#[test]
fn the_gate_is_the_papers_bound_else_todays_else_the_expected_rate() {
    let slow = || spoilt(0.8, |_| {});
    let bounds = |paper, today, expected| Bounds {
        paper,
        today,
        expected,
    };
    let judge = |b| judged(ClaimKind::Rate, "strain", slow(), b, |_| {});
    expect(
        &judge(bounds(Some(0.75), Some(1.0), Some(0.8))),
        Pass,
        "0.750 − 0.050 (the paper)",
    );
    expect(
        &judge(bounds(None, Some(1.0), Some(0.8))),
        Fail,
        "(today's bound)",
    );
    expect(&judge(bounds(None, None, Some(0.8))), Pass, "(expected)");
    expect(&judge(bounds(None, None, None)), Inconclusive, "no bound");
}

#[test]
fn too_few_levels_cannot_be_judged() {
    expect(
        &of_rate(sample::levels(3, |h| h)),
        Inconclusive,
        "3 usable levels",
    );
    expect(&of_rate(Vec::new()), Inconclusive, "no levels");
    expect(
        &of_kind(ClaimKind::Rate, "h1", sample::levels(5, |h| h)),
        Inconclusive,
        "0 usable levels",
    );
    expect(&of_rate(sample::levels(4, |h| h)), Pass, "levels 0–3");
}

#[test]
fn broken_numbers_cannot_be_judged() {
    expect(
        &of_rate(spoilt(1.0, |l| l[2].errors.strain = Some(f64::NAN))),
        Inconclusive,
        "errors.strain is NaN",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[4].errors.strain = Some(f64::INFINITY))),
        Inconclusive,
        "is inf",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[4].kkt.tension = f64::NAN)),
        Inconclusive,
        "kkt.tension is NaN",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[1].errors.strain = Some(0.0))),
        Inconclusive,
        "level 1: the error is 0",
    );
    let repeated = spoilt(1.0, |l| l[3].errors.strain = l[2].errors.strain);
    expect(
        &of_rate(repeated),
        Inconclusive,
        "levels 2 and 3 have the same error",
    );
    let rounding = spoilt(1.0, |l| {
        l.iter_mut().for_each(|l| l.solution_energy = Some(1e10))
    });
    expect(&of_rate(rounding), Inconclusive, "is rounding");
}

#[test]
fn a_mesh_that_did_not_refine_cannot_be_judged() {
    let reused = spoilt(1.0, |l| l[3].mesh_hash = l[2].mesh_hash.clone());
    expect(
        &of_rate(reused.clone()),
        Inconclusive,
        "levels 2 and 3 have the same mesh",
    );
    expect(
        &of_kind(ClaimKind::Convergence, "energy", reused.clone()),
        Inconclusive,
        "the same mesh",
    );
    expect(
        &of_kind(ClaimKind::Bounded, "energy", reused),
        Inconclusive,
        "the same mesh",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[3].h = l[2].h)),
        Inconclusive,
        "no refinement",
    );
}

#[test]
fn an_unfinished_solve_cannot_be_judged() {
    let unfinished = spoilt(1.0, |l| {
        l[0].solver.solved = false;
        l[0].solver.status = "iteration limit".into();
    });
    for kind in [
        ClaimKind::Rate,
        ClaimKind::Inequality,
        ClaimKind::Exact,
        ClaimKind::Convergence,
        ClaimKind::Bounded,
    ] {
        expect(
            &of_kind(kind, "energy", unfinished.clone()),
            Inconclusive,
            "did not finish (iteration limit",
        );
    }
    expect(
        &of_rate(spoilt(1.0, |l| l[4].kkt.tension = 1e-4)),
        Inconclusive,
        "scaled tension",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[4].kkt.tension = 1e-9)),
        Pass,
        "rate 1.000",
    );
}

#[test]
fn our_own_broken_budget_cannot_be_judged() {
    expect(
        &of_rate(spoilt(1.0, |l| l[4].budget.algebraic = Some(0.2))),
        Inconclusive,
        "algebraic error is 20.0 %",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[0].budget.quadrature = Some(0.06))),
        Inconclusive,
        "quadrature error is 6.0 %",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[0].budget.geometry = Some(0.06))),
        Inconclusive,
        "geometry error",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[0].budget.quadrature = Some(0.05))),
        Pass,
        "rate 1.000",
    );
}

#[test]
fn a_contaminated_level_leaves_the_fit() {
    // the finest level stagnates because the reference is too near; the budget knows
    let near = spoilt(1.0, |l| {
        l[4].errors.strain = l[4].errors.strain.map(|e| 1.5 * e);
        l[4].budget.reference = Some(0.3);
    });
    expect(&of_rate(near), Pass, "on levels 0–3");
    // the twin: nobody noticed
    let unnoticed = spoilt(1.0, |l| {
        l[4].errors.strain = l[4].errors.strain.map(|e| 1.5 * e)
    });
    expect(&of_rate(unnoticed), Inconclusive, "not asymptotic");
    let two_lost = spoilt(1.0, |l| {
        l[3..]
            .iter_mut()
            .for_each(|l| l.budget.reference = Some(0.3))
    });
    expect(&of_rate(two_lost), Inconclusive, "3 usable levels");
}

#[test]
fn exclusion_states_its_reason_and_keeps_marks_already_set() {
    let gates = Gates::default();
    let mut levels = spoilt(1.0, |l| {
        l[0].excluded = Some("by hand".into());
        l[1].budget.reference = Some(0.07);
        l[2].solver.solved = false;
        l[3].budget.algebraic = Some(f64::NAN);
    });
    exclude_levels(&mut levels, &gates);
    let marks: Vec<_> = levels
        .iter()
        .map(|l| l.excluded.as_deref().unwrap_or(""))
        .collect();
    assert_eq!(marks[0], "by hand");
    assert!(marks[1].contains("reference error is 7.0 %") && marks[2].contains("not solved"));
    assert!(marks[3].contains("algebraic error is NaN"));
    assert_eq!(marks[4], "");
}

#[test]
fn energies_and_quadrature_must_agree() {
    expect(
        &of_rate(spoilt(1.0, |l| l[2].two_way = Some(1e-3))),
        Inconclusive,
        "A(e,e) by quadrature and by energies",
    );
    let budgeted = spoilt(1.0, |l| {
        l[2].two_way = Some(1e-3);
        l[2].budget.quadrature = Some(6e-4);
    });
    expect(&of_rate(budgeted), Pass, "rate 1.000");
    // rounding of the energies grows with ‖u‖²/‖e‖²: 1e-7 is a defect beside an error of 0.1, rounding beside 1e-4
    let large = sample::levels(5, |h| h);
    let small = sample::levels(5, |h| 1e-3 * h);
    let with = |mut l: Vec<Level>| {
        l.iter_mut()
            .for_each(|l| (l.two_way, l.budget.quadrature) = (Some(1e-7), None));
        of_rate(l)
    };
    expect(&with(large), Inconclusive, "differ by 1.0e-7");
    expect(&with(small), Pass, "rate 1.000");
}

#[test]
fn a_broken_theorem_fails_whatever_the_rate() {
    let broken = spoilt(1.0, |l| l[1].ledger = ledger(0.6, 0.0, Some(false)));
    for (kind, norm) in [
        (ClaimKind::Rate, "strain"),
        (ClaimKind::Convergence, "strain"),
        (ClaimKind::Inequality, "ledger"),
    ] {
        expect(
            &of_kind(kind, norm, broken.clone()),
            Fail,
            "½A(e,e) ≤ a + b + c is broken",
        );
    }
    expect(
        &of_rate(spoilt(1.0, |l| l[1].ledger = ledger(0.5, 0.0, Some(true)))),
        Pass,
        "rate",
    );
    expect(
        &of_rate(spoilt(1.0, |l| l[1].ledger = ledger(0.5, 0.0, None))),
        Pass,
        "within its quadrature estimate",
    );
}

#[test]
fn an_error_above_its_ceiling_fails() {
    let high = |l: &mut Vec<Level>| {
        l.iter_mut()
            .for_each(|l| l.errors.interpolation = l.errors.energy.map(|e| e / 1.6))
    };
    expect(&of_rate(spoilt(1.0, high)), Fail, "exceeds 1.5 ×");
    let lifted = judged(ClaimKind::Rate, "strain", spoilt(1.0, high), GATE_1, |g| {
        g.ceiling = Some(2.0)
    });
    expect(&lifted, Pass, "rate");
    let none = judged(ClaimKind::Rate, "strain", spoilt(1.0, high), GATE_1, |g| {
        g.ceiling = None
    });
    expect(&none, Pass, "rate");
    // outside the window nothing is held against it
    let coarse = |l: &mut Vec<Level>| {
        l[0].errors.interpolation = l[0].errors.energy.map(|e| e / 1.6);
        l[0].budget.reference = Some(0.06);
    };
    expect(&of_rate(spoilt(1.0, coarse)), Pass, "levels 1–4");
    let unknown = spoilt(1.0, |l| {
        l.iter_mut().for_each(|l| l.errors.interpolation = None)
    });
    expect(&of_rate(unknown), Pass, "the ceiling is not checked");
}

#[test]
fn too_good_is_not_believed() {
    expect(
        &of_rate(spoilt(1.2, |_| {})),
        Inconclusive,
        "too good: rate 1.200 where 1.000",
    );
    expect(&of_rate(spoilt(1.1, |_| {})), Pass, "rate 1.100");
    // above the paper's bound but not above the expected rate
    let bounds = Bounds {
        paper: Some(0.75),
        today: Some(1.0),
        expected: Some(1.0),
    };
    expect(
        &judged(
            ClaimKind::Rate,
            "strain",
            spoilt(1.0, |_| {}),
            bounds,
            |_| {},
        ),
        Pass,
        "rate 1.000",
    );
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
    let noisy: Vec<Level> = (0..6)
        .map(|k| {
            sample::level(
                k,
                0.1 * 0.5_f64.powf(0.95 * k as f64 + 0.15 * noise.normal()),
            )
        })
        .collect();
    expect(
        &of_rate(noisy),
        Inconclusive,
        "neither the interval nor the pairwise rates decide",
    );
}

#[test]
fn scatter_that_stays_above_passes() {
    // changes above 0.05, so not asymptotic, but all rates and the trend lie above 0.95
    expect(
        &of_rate(with_rates(&[1.06, 0.98, 1.05, 0.99])),
        Pass,
        "not asymptotic",
    );
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
    expect(
        &of_rate(with_rates(&[0.20, 0.27, 0.21, 0.27])),
        Fail,
        "too slow",
    );
}

#[test]
fn preasymptotic_levels_are_left_out_of_the_window() {
    expect(
        &of_rate(with_rates(&[0.3, 0.7, 0.97, 0.99, 1.0])),
        Pass,
        "levels 2–5",
    );
}

#[test]
fn exact_means_rounding() {
    let sound = || sample::levels(3, |h| 1e-14 / h);
    expect(
        &of_kind(ClaimKind::Exact, "energy", sound()),
        Pass,
        "on 3 levels",
    );
    // shares of a rounding error may be anything
    let shares = || {
        let mut levels = sound();
        levels
            .iter_mut()
            .for_each(|l| l.budget.algebraic = Some(0.9));
        levels
    };
    expect(
        &of_kind(ClaimKind::Exact, "energy", shares()),
        Pass,
        "at most",
    );
    let mut defect = sound();
    defect[1].errors.energy = Some(1e-9);
    expect(
        &of_kind(ClaimKind::Exact, "energy", defect),
        Fail,
        "level 1: energy error 1.00e-9 of ‖u‖_A",
    );
    // an error of order h has a fine rate and is no rounding
    expect(
        &of_kind(ClaimKind::Exact, "energy", sample::levels(3, |h| h)),
        Fail,
        "more than rounding",
    );
    let mut zero = sound();
    zero.iter_mut().for_each(|l| l.errors.energy = Some(0.0));
    expect(
        &of_kind(ClaimKind::Exact, "energy", zero),
        Inconclusive,
        "exactly zero",
    );
    let mut unscaled = sound();
    unscaled[0].solution_energy = None;
    unscaled[0].budget = Default::default();
    expect(
        &of_kind(ClaimKind::Exact, "energy", unscaled),
        Inconclusive,
        "no ‖u‖_A",
    );
}

#[test]
fn a_vanishing_quantity_vanishes() {
    let with = |penetration: f64| {
        let mut levels = sample::levels(3, |h| h);
        levels
            .iter_mut()
            .for_each(|l| l.errors.penetration_l2 = Some(penetration));
        levels
    };
    let judge = |levels| of_kind(ClaimKind::Inequality, "penetration_l2", levels);
    expect(&judge(with(0.0)), Pass, "at most 0.00e0");
    expect(&judge(with(1e-16)), Pass, "on 3 levels");
    expect(&judge(with(1e-9)), Fail, "level 0: penetration_l2");
    let mut large_units = with(1e-9);
    large_units
        .iter_mut()
        .for_each(|l| l.solution_trace = Some(1e6));
    expect(&judge(large_units), Pass, "on 3 levels");
    let mut unscaled = with(0.0);
    unscaled[2].solution_trace = None;
    expect(
        &judge(unscaled),
        Inconclusive,
        "level 2: no penetration_l2 or no scale",
    );
    let mut broken = with(0.0);
    broken[0].ledger = ledger(0.6, 0.0, Some(false));
    expect(&judge(broken), Fail, "is broken");
}

#[test]
fn a_ledger_inequality_is_decided_on_every_level() {
    let with = |holds: Option<bool>| {
        let mut levels = sample::levels(3, |h| h);
        levels
            .iter_mut()
            .for_each(|l| l.ledger = ledger(0.4, 0.0, Some(true)));
        levels[1].ledger = ledger(0.5, 0.0, holds);
        levels
    };
    let judge = |levels| of_kind(ClaimKind::Inequality, "ledger", levels);
    expect(&judge(with(Some(true))), Pass, "on 3 levels");
    expect(
        &judge(with(None)),
        Inconclusive,
        "within its quadrature estimate",
    );
    expect(&judge(with(Some(false))), Fail, "is broken");
    let mut missing = with(Some(true));
    missing[2].ledger = None;
    expect(&judge(missing), Inconclusive, "level 2: no ledger");
}

#[test]
fn convergence_needs_every_error_to_fall() {
    let judge = |levels| of_kind(ClaimKind::Convergence, "energy", levels);
    expect(&judge(with_rates(&[0.5, 0.2, 0.7])), Pass, "at most 0.871");
    expect(
        &judge(with_rates(&[0.5, 0.1, 0.7])),
        Fail,
        "level 2: energy error times 0.933",
    );
    expect(&judge(with_rates(&[0.5, -0.1, 0.7])), Fail, "level 2");
    expect(&judge(with_rates(&[0.5])), Inconclusive, "2 usable levels");
    expect(
        &judge(with_rates(&[0.5, 0.0, 0.7])),
        Inconclusive,
        "the same error",
    );
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
    expect(&judge(&[0.3, 0.5, 0.4]), Pass, "reaches 5.000e-1");
    expect(&judge(&[0.3, 0.6001, 0.4]), Fail, "2 times the smallest");
    expect(&judge(&[0.3, 0.4]), Inconclusive, "2 usable levels");
    expect(&judge(&[0.0, 0.0, 0.0]), Pass, "vanishes on every level");
    expect(
        &judge(&[0.3, 0.0, 0.3]),
        Inconclusive,
        "state a reference constant",
    );
    let against = |values: &[f64]| {
        judged(ClaimKind::Bounded, "b_over_h2", with(values), GATE_1, |g| {
            g.constant = Some(0.25)
        })
    };
    expect(
        &against(&[0.3, 0.0, 1e-6]),
        Pass,
        "2 times the reference constant",
    );
    expect(
        &against(&[0.3, 0.0, 0.51]),
        Fail,
        "2 times the reference constant",
    );
    // of either sign: the bound is one for |b|
    expect(&against(&[0.3, -0.51, 0.0]), Fail, "reaches 5.100e-1");
}
