//! Agreement with a formula that neglects something: a relative difference that need not vanish, but is small.
//!
//! Judged on the finest usable level, against [`Gates::constant`](crate::study::Gates::constant). The difference consists of
//! what the formula neglects and of what the mesh adds; the step between the two finest levels tells how much the mesh may
//! still add, and where that is more than half of the bound nothing can be said.

use super::{JudgeInput, fail, inconclusive, pass};
use crate::claim::quantity::in_words;
use crate::record::Verdict;

/// Rule of the kind `agreement`.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    let Some(bound) = input.gates.constant else {
        return inconclusive(vec!["no `constant` among the gates: how small is small?".into()]);
    };
    let differences: Vec<f64> = input.usable().filter_map(|l| l.errors.difference(input.norm)).collect();
    let [_, .., before, finest] = differences[..] else {
        return inconclusive(vec![format!("{} usable levels with a difference, 3 are needed", differences.len())]);
    };
    let step = (finest - before).abs();
    let finding = format!(
        "the {} is {finest:.3e} on the finest level, {bound:.3e} are allowed; the last refinement moved it by {step:.1e}",
        in_words(input.norm)
    );
    if finest.abs() > bound + step {
        fail(vec![finding])
    } else if step > 0.5 * bound || finest.abs() > bound {
        inconclusive(vec![finding + ": the meshes are too coarse to tell"])
    } else {
        pass(vec![finding])
    }
}
