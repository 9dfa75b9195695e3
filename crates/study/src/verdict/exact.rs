//! Rounding error on every level: `√A(e,e) ≤ tolerance · ‖u‖_A`; or a constant that is known, `|c − c₀| ≤ tolerance · c₀`.

use super::{JudgeInput, fail, inconclusive, ledger, pass};
use crate::record::{Level, Verdict};

/// Rule of the kind `exact`: for the norm `constant` against [`Gates::constant`](crate::study::Gates::constant), 1 where none
/// is stated; else for the energy norm whatever norm the claim names: only there is `‖u‖_A` the scale.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    let constant = input.norm == "constant";
    let known = input.gates.constant.unwrap_or(1.0);
    let (what, scale) = if constant {
        ("difference of the constant", format!("{known}"))
    } else {
        ("energy error", "‖u‖_A".into())
    };
    let sizes = |level: &Level| match (constant, &level.errors) {
        (true, errors) => Some(((errors.constant? - known).abs(), known)),
        (false, errors) => errors.energy.zip(level.solution_energy),
    };
    let mut relative = Vec::new();
    for level in input.levels {
        match sizes(level) {
            Some((error, size)) if size > 0.0 => relative.push((level.level, error / size)),
            _ => {
                return inconclusive(vec![format!("level {}: no {what} or no {scale} to scale it", level.level)]);
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
            format!("level {level}: {what} {r:.2e} of {scale}, more than rounding ({tolerance:.0e})")
        }),
    );
    if !failures.is_empty() {
        return fail(failures);
    }
    let largest = relative.iter().fold(0.0_f64, |m, (_, r)| m.max(*r));
    pass(vec![format!("{what} at most {largest:.2e} of {scale} on {} levels", relative.len())])
}
