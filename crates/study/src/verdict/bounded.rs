//! A constant that stays bounded under refinement.
//!
//! With a reference constant ([`Gates::constant`](crate::study::Gates::constant)) the claim is an upper bound: the
//! largest value is at most `spread` times the reference, and small or vanishing values are welcome. This is the form for
//! `b/h²`, which is zero where every switch point is a node and far below its bound elsewhere. Without a reference the
//! largest is held against the smallest; if some values vanish that ratio says nothing, and the verdict is inconclusive.

use super::{JudgeInput, fail, inconclusive, ledger, pass};
use crate::claim::quantity::in_words;
use crate::record::{Level, Verdict};

/// Fewest levels that show boundedness.
const MIN_LEVELS: usize = 3;

/// The constant of the given name on a level: `b_over_h2` is `|b|/h²` of the ledger, `solution_h1` is `‖u_h‖_1`, any other name an error's own size.
pub fn constant(level: &Level, norm: &str) -> Option<f64> {
    match norm {
        "solution_h1" => level.solution_h1,
        "b_over_h2" => level.ledger.as_ref().map(|t| t.b.abs() / (level.h * level.h)),
        _ => level.errors.size(norm),
    }
}

/// Rule of the kind `bounded`.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    let constants: Vec<f64> = input.usable().filter_map(|l| constant(l, input.norm)).collect();
    if constants.len() < MIN_LEVELS {
        return inconclusive(vec![format!("{} usable levels, {MIN_LEVELS} are needed", constants.len())]);
    }
    let broken = ledger::broken(input);
    if !broken.is_empty() {
        return fail(broken);
    }
    let largest = constants.iter().copied().fold(0.0, f64::max);
    let smallest = constants.iter().copied().fold(f64::INFINITY, f64::min);
    let mut verdict = match input.gates.constant {
        Some(reference) => within(input, largest, reference, "the reference constant"),
        None if largest == 0.0 => pass(vec![format!("{} vanishes on every level", in_words(input.norm))]),
        None if smallest == 0.0 => inconclusive(vec![format!(
            "{} vanishes on some levels and reaches {largest:.3e} on others: state a reference constant",
            in_words(input.norm)
        )]),
        None => within(input, largest, smallest, "the smallest"),
    };
    verdict.reasons.extend(ledger::undecided(input));
    verdict
}

fn within(input: &JudgeInput, largest: f64, reference: f64, name: &str) -> Verdict {
    let spread = input.gates.spread;
    let words = in_words(input.norm);
    let finding = format!("{words} reaches {largest:.3e}; {spread} times {name} is {:.3e}", spread * reference);
    if largest <= spread * reference { pass(vec![finding]) } else { fail(vec![finding]) }
}
