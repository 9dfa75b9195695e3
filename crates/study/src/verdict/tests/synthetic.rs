//! Made-up series of errors whose truth is known, each with the verdict that it has to get against the gate 1.

use super::*;

/// `count` levels, `h = 1/8, 1/16, …`.
fn series(count: usize, error: impl Fn(f64) -> f64) -> Verdict {
    of_rate(sample::levels(count, error))
}

#[test]
fn a_series_that_is_still_rising_is_not_refuted_and_passes_in_time() {
    let rising = |h: f64| h / (1.0 + 4.0 * h);
    expect(&series(5, rising), Inconclusive, "not asymptotic");
    expect(&series(9, rising), Pass, "rate 0.9");
    // the twin: rising as slowly, towards 3/4
    expect(&series(9, |h| h.powf(0.75) / (1.0 + 4.0 * h)), Fail, "too slow");
}

#[test]
fn a_second_term_of_lower_order_comes_to_light() {
    let sum = |h: f64| h + 0.05 * h.sqrt();
    assert_eq!(series(9, |h| h + 1e-4 * h.sqrt()).outcome, Pass);
    assert_ne!(series(9, sum).outcome, Pass);
}

/// A discrete reference twice as fine as the finest level: on nested meshes squares add, and the rates rise; elsewhere the
/// reference's error adds to the measured one, and they fall.
#[test]
fn a_reference_that_is_too_near_is_no_pass_unless_its_level_is_left_out() {
    let finest = 0.125 / 16.0;
    let added = |h: f64| h + 0.5 * finest;
    assert_ne!(series(5, added).outcome, Pass);
    let known = |error: &dyn Fn(f64) -> f64| {
        let mut levels = sample::levels(6, error);
        levels[4..].iter_mut().for_each(|l| l.budget.reference = Some(0.2));
        of_rate(levels)
    };
    let nested = |h: f64| (h * h - 0.2 * finest * finest).sqrt();
    expect(&known(&nested), Pass, "on levels 0–3");
    // where the reference is the finest mesh itself the error vanishes there
    expect(&series(5, |h| (h * h - finest * finest).sqrt()), Inconclusive, "the error is 0");
}

#[test]
fn stagnation_fails_and_repetition_is_no_measurement() {
    expect(&series(6, |h| 0.02 + h * h), Fail, "too slow");
    expect(&series(6, |h| h.max(0.02)), Inconclusive, "the same error");
    expect(&series(6, |h| 0.02 * (1.0 - h)), Fail, "too slow");
}

#[test]
fn superconvergence_is_doubted_where_a_rate_is_expected_and_only_there() {
    expect(&series(5, |h| h * h), Inconclusive, "too good");
    let open = Bounds { expected: None, ..GATE_1 };
    expect(&judged(ClaimKind::Rate, "strain", sample::levels(5, |h| h * h), open, |_| {}), Pass, "rate 2.000");
}

#[test]
fn what_is_no_number_is_no_measurement() {
    for bad in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        expect(&series(5, |h| if h < 0.01 { bad } else { h }), Inconclusive, "");
    }
}

/// Random meshes: `h` jumps by a tenth while the error follows the number of unknowns. At the true rate 1 few series may fail, at
/// 0.8 few may pass.
#[test]
fn meshes_of_uneven_size_rarely_mislead() {
    let mut noise = Noise::new(5);
    let mut outcomes = |rate: f64| {
        let drawn: Vec<Outcome> = (0..400)
            .map(|_| {
                let mut levels = sample::levels(5, |h| h.powf(rate));
                levels.iter_mut().for_each(|l| l.h *= 1.0 + 0.1 * noise.uniform());
                of_rate(levels).outcome
            })
            .collect();
        [Pass, Inconclusive, Fail].map(|o| drawn.iter().filter(|d| **d == o).count())
    };
    let [_, doubtful, wrong] = outcomes(1.0);
    assert!(wrong < 20 && doubtful > 0, "{wrong} of 400 fail, {doubtful} are doubtful");
    let [wrong, _, right] = outcomes(0.8);
    assert!(wrong < 4 && right > 100, "{wrong} of 400 pass, {right} fail");
}
