//! Errors that fall from level to level by a stated factor; the rate is reported, not gated.

use super::{JudgeInput, chain, fail, inconclusive, ledger, pass};
use crate::claim::quantity::in_words;
use crate::rate::{self, Point};
use crate::record::Verdict;

/// Fewest levels: two falls.
const MIN_LEVELS: usize = 3;

/// Rule of the kind `convergence`.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    let words = in_words(input.norm);
    let points = rate::points(input.levels, input.norm);
    if let Err(why) = rate::check(&points, rate::rounding_floor(input.levels, input.norm), MIN_LEVELS) {
        return inconclusive(vec![format!("{words} error: {why}")]);
    }
    let fall = input.gates.fall;
    let mut failures = ledger::broken(input);
    failures.extend(points.windows(2).filter(|p| factor(p) > fall).map(|p| {
        let level = p[1].level;
        format!("level {level}: {words} error times {:.3}, it has to fall to {fall} of the level before", factor(p))
    }));
    if !failures.is_empty() {
        return fail(failures);
    }
    let slowest = points.windows(2).map(factor).fold(0.0, f64::max);
    let mut reasons = vec![format!("each {words} error is at most {slowest:.3} of the level before")];
    let links = chain::links(input);
    if input.norm == "energy_gap" && links > 0 {
        reasons.push(format!("L(u) ≤ L(u_h) ≤ L(u_2h) on {links} pairs of nested levels"));
    }
    reasons.extend(ledger::undecided(input));
    pass(reasons)
}

fn factor(pair: &[Point]) -> f64 {
    pair[1].error / pair[0].error
}
