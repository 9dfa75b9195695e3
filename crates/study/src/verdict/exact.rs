//! Rounding error on every level: `√A(e,e) ≤ tolerance · ‖u‖_A`.

use super::{JudgeInput, fail, inconclusive, ledger, pass};
use crate::record::Verdict;

/// Rule of the kind `exact`, for the energy norm whatever norm the claim names: only there is `‖u‖_A` the scale.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    let mut relative = Vec::new();
    for level in input.levels {
        match (level.errors.energy, level.solution_energy) {
            (Some(error), Some(size)) if size > 0.0 => relative.push((level.level, error / size)),
            _ => {
                return inconclusive(vec![format!("level {}: no energy error or no ‖u‖_A to scale it", level.level)]);
            }
        }
    }
    if relative.iter().all(|(_, r)| *r == 0.0) {
        return inconclusive(vec![
            "the error is exactly zero on every level: was the solution compared with itself?".into(),
        ]);
    }
    let tolerance = input.gates.exact_tolerance;
    let mut failures = ledger::broken(input);
    failures.extend(relative.iter().filter(|(_, r)| *r > tolerance).map(|(level, r)| {
        format!("level {level}: energy error {r:.2e} of ‖u‖_A, more than rounding ({tolerance:.0e})")
    }));
    if !failures.is_empty() {
        return fail(failures);
    }
    let largest = relative.iter().fold(0.0_f64, |m, (_, r)| m.max(*r));
    pass(vec![format!("energy error at most {largest:.2e} of ‖u‖_A on {} levels", relative.len())])
}
