//! The inequality of the theorem's proof, `½A(e,e) ≤ a + b + c`, level by level.

use super::JudgeInput;

/// Usable levels on which it is broken, as reasons to fail.
pub(super) fn broken(input: &JudgeInput) -> Vec<String> {
    on_levels(input, Some(false), "is broken")
}

/// Usable levels on which it is broken within the quadrature estimate, as remarks.
pub(super) fn undecided(input: &JudgeInput) -> Vec<String> {
    on_levels(input, None, "is open, within its quadrature estimate")
}

fn on_levels(input: &JudgeInput, holds: Option<bool>, how: &str) -> Vec<String> {
    let ledgers = input.usable().filter_map(|l| Some((l.level, l.ledger.as_ref()?)));
    ledgers
        .filter(|(_, t)| t.holds == holds)
        .map(|(level, t)| {
            let right = t.sum();
            format!("level {level}: ½A(e,e) ≤ a + b + c {how}: {:.9e} against {right:.9e}", t.lhs)
        })
        .collect()
}
