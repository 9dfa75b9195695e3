//! An inequality that holds on every level.
//!
//! Three sorts: a quantity that must vanish (the claim names it, such as `penetration_l2`: Lemma 2.1), the inequality
//! between the terms of the ledger (the claim names `ledger`), and Falk's splitting ([`splitting`]). Where a
//! ledger is present it must hold in the first two.

use super::{JudgeInput, fail, inconclusive, ledger, pass, splitting};
use crate::claim::quantity::in_words;
use crate::record::Verdict;

/// A vanishing quantity is at most this times its scale.
pub const VANISHES: f64 = 1e-12;

/// Rule of the kind `inequality`.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    match input.norm {
        "ledger" => ledger_holds(input),
        "splitting" => splitting::holds(input),
        _ => vanishes(input),
    }
}

fn ledger_holds(input: &JudgeInput) -> Verdict {
    let broken = ledger::broken(input);
    if !broken.is_empty() {
        return fail(broken);
    }
    let mut doubts = ledger::undecided(input);
    doubts.extend(input.levels.iter().filter(|l| l.ledger.is_none()).map(|l| format!("level {}: no ledger", l.level)));
    // a level left out of the fit has a ledger that nobody looked at
    doubts.extend(input.levels.iter().filter_map(|l| Some(format!("level {}: {}", l.level, l.excluded.as_ref()?))));
    if !doubts.is_empty() {
        return inconclusive(doubts);
    }
    pass(vec![format!("½A(e,e) ≤ a + b + c on {} levels", input.levels.len())])
}

fn vanishes(input: &JudgeInput) -> Verdict {
    let words = in_words(input.norm);
    let mut relative = Vec::new();
    for level in input.levels {
        match (level.errors.size(input.norm), level.solution_trace) {
            (Some(value), Some(scale)) if scale > 0.0 => relative.push((level.level, value / scale)),
            _ => {
                return inconclusive(vec![format!("level {}: no {words} or no scale for it", level.level)]);
            }
        }
    }
    let mut failures = ledger::broken(input);
    failures.extend(
        relative.iter().filter(|(_, r)| *r > VANISHES).map(|(level, r)| {
            format!("level {level}: {words} is {r:.2e} of the displacement, more than {VANISHES:.0e}")
        }),
    );
    if !failures.is_empty() {
        return fail(failures);
    }
    let largest = relative.iter().fold(0.0_f64, |m, (_, r)| m.max(*r));
    let mut reasons = vec![format!("{words} at most {largest:.2e} of the displacement on {} levels", relative.len())];
    reasons.extend(ledger::undecided(input));
    pass(reasons)
}
