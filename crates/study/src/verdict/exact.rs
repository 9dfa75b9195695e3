//! Rounding error on every level: `√A(e,e) ≤ tolerance · ‖u‖_A`; or a constant that is to be 1,
//! `|c − 1| ≤ tolerance`.

use super::{JudgeInput, fail, inconclusive, ledger, pass};
use crate::record::{Level, Verdict};

/// Rule of the kind `exact`: for the norm `constant` its distance from 1, else for the energy norm whatever norm the claim
/// names: only there is `‖u‖_A` the scale.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    let constant = input.norm == "constant";
    let (what, of, scale) =
        if constant { ("distance of the constant", "from", "1") } else { ("energy error", "of", "‖u‖_A") };
    let missing = if constant { "no constant" } else { "no energy error or no ‖u‖_A to scale it" };
    let sizes = |level: &Level| match constant {
        true => Some(((level.errors.constant? - 1.0).abs(), 1.0)),
        false => level.errors.energy.zip(level.solution_energy),
    };
    let mut relative = Vec::new();
    for level in input.levels {
        match sizes(level) {
            Some((error, size)) if size > 0.0 => relative.push((level.level, error / size)),
            _ => {
                return inconclusive(vec![format!("level {}: {missing}", level.level)]);
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
    failures.extend(
        relative.iter().filter(|(_, r)| *r > tolerance).map(|(level, r)| {
            format!("level {level}: {what} {r:.2e} {of} {scale}, more than rounding ({tolerance:.0e})")
        }),
    );
    if !failures.is_empty() {
        return fail(failures);
    }
    let largest = relative.iter().fold(0.0_f64, |m, (_, r)| m.max(*r));
    pass(vec![format!("{what} at most {largest:.2e} {of} {scale} on {} levels", relative.len())])
}
