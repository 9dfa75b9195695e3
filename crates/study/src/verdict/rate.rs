//! A rate against its bound.
//!
//! The gate is the paper's bound, else today's, else the expected rate; the rate has to reach the gate minus a
//! tolerance. In this order:
//!
//! 1. no rate can be fitted, or there is no gate: inconclusive;
//! 2. the theorem's inequality is broken, the whole interval lies below, or the error exceeds its ceiling: fail;
//! 3. the interval, or every pairwise rate in the window and the slope, lies above: pass, unless the slope exceeds the
//!    expected rate by more than [`TOO_GOOD`];
//! 4. otherwise inconclusive.
//!
//! *Not asymptotic.* Where the pairwise rates have not settled the fit is that of the last four levels, and its interval
//! describes a trend as if it were noise. Then the interval decides only together with the trend: to pass, the finest
//! pairwise rate and its continuation one level further must lie above too; to fail by the interval, both must lie below.

use super::{JudgeInput, fail, inconclusive, ledger, pass};
use crate::claim::quantity::in_words;
use crate::rate::fit_levels;
use crate::record::{Bounds, Rate, Verdict};

/// A slope this far above the expected rate is too good to be believed.
pub const TOO_GOOD: f64 = 0.15;

/// Rule of the kind `rate`.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    let rate = match fit_levels(input.levels, input.norm) {
        Ok(rate) => rate,
        Err(why) => {
            return inconclusive(vec![format!("no rate of the {} error: {why}", in_words(input.norm))]);
        }
    };
    let Some((gate, source)) = gate(input.bounds) else {
        return inconclusive(vec![format!("{}; no bound to judge it by", describe(&rate))]);
    };
    let wanted = gate - input.gates.rate_tolerance;
    let finding = format!("{} against {gate:.3} − {:.3} ({source})", describe(&rate), input.gates.rate_tolerance);

    let mut failures = ledger::broken(input);
    failures.extend(below(&rate, wanted).then(|| format!("too slow: {finding}")));
    failures.extend(above_ceiling(input, &rate));
    if !failures.is_empty() {
        return fail(failures);
    }
    let mut reasons = vec![finding];
    reasons.extend(ledger::undecided(input));
    reasons.extend(without_ceiling(input, &rate));
    if !reaches(&rate, wanted) {
        reasons.insert(0, "neither the interval nor the pairwise rates decide".into());
        return inconclusive(reasons);
    }
    match too_good(&rate, input.bounds) {
        Some(why) if input.expected_is_asymptotic => reasons.push(format!("{why}, expected of large sizes only")),
        Some(why) => {
            reasons.insert(0, why);
            return inconclusive(reasons);
        }
        None => {}
    }
    pass(reasons)
}

/// The bound that judges, and whose it is.
pub fn gate(bounds: &Bounds) -> Option<(f64, &'static str)> {
    let named = [(bounds.paper, "the paper"), (bounds.today, "today's bound"), (bounds.expected, "expected")];
    named.into_iter().find_map(|(bound, source)| Some((bound?, source)))
}

fn describe(rate: &Rate) -> String {
    let (first, last) = (rate.levels[0], rate.levels[rate.levels.len() - 1]);
    let state = if rate.asymptotic { "" } else { ", not asymptotic" };
    format!("rate {:.3} [{:.3}, {:.3}] on levels {first}–{last}{state}", rate.slope, rate.low, rate.high)
}

/// The pairwise rates inside the window.
fn inside(rate: &Rate) -> impl Iterator<Item = f64> + '_ {
    let first = rate.levels[0];
    rate.pairwise.iter().filter(move |(finer, _)| *finer > first).map(|(_, r)| *r)
}

/// The finest pairwise rate, and what it becomes one level further if the trend of the window goes on.
fn trend(rate: &Rate) -> [f64; 2] {
    let finest = rate.pairwise[rate.pairwise.len() - 1].1;
    [finest, finest + rate.curvature]
}

fn below(rate: &Rate, wanted: f64) -> bool {
    rate.high < wanted && (rate.asymptotic || trend(rate).iter().all(|r| *r < wanted))
}

fn reaches(rate: &Rate, wanted: f64) -> bool {
    let by_interval = rate.low > wanted;
    let by_pairs = rate.slope > wanted && inside(rate).all(|r| r > wanted);
    (by_interval || by_pairs) && (rate.asymptotic || trend(rate).iter().all(|r| *r > wanted))
}

fn too_good(rate: &Rate, bounds: &Bounds) -> Option<String> {
    let expected = bounds.expected?;
    (rate.slope > expected + TOO_GOOD)
        .then(|| format!("too good: rate {:.3} where {expected:.3} is expected", rate.slope))
}

/// Levels of the window where `√A(e,e) > ceiling · √A(u−u_I, u−u_I)`.
fn above_ceiling(input: &JudgeInput, rate: &Rate) -> Vec<String> {
    let Some(ceiling) = input.gates.ceiling else {
        return Vec::new();
    };
    let window = input.levels.iter().filter(|l| rate.levels.contains(&l.level));
    window
        .filter_map(|l| Some((l.level, l.errors.energy?, l.errors.interpolation?)))
        .filter(|(_, error, interpolation)| *error > ceiling * interpolation)
        .map(|(level, error, interpolation)| {
            format!("level {level}: energy error {error:.4e} exceeds {ceiling} × {interpolation:.4e} (interpolation)")
        })
        .collect()
}

/// A remark where a ceiling is stated and some level of the window has nothing to hold it against.
fn without_ceiling(input: &JudgeInput, rate: &Rate) -> Option<String> {
    input.gates.ceiling?;
    let mut window = input.levels.iter().filter(|l| rate.levels.contains(&l.level));
    let unknown = window.find(|l| l.errors.energy.is_none() || l.errors.interpolation.is_none())?;
    Some(format!("level {}: no interpolation error, the ceiling is not checked", unknown.level))
}
