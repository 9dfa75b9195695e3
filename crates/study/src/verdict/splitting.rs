//! Falk's splitting on every level, for every kind of `v` and `v_h` that was tried.

use super::{JudgeInput, fail, inconclusive, pass};
use crate::record::{Level, Splitting, Verdict};

/// Rule of the kind `inequality` for the norm `splitting`.
pub(super) fn holds(input: &JudgeInput) -> Verdict {
    let broken = with(input, Some(false), "is broken");
    if !broken.is_empty() {
        return fail(broken);
    }
    let mut doubts = with(input, None, "is open, within what the numbers may be off by");
    let unmeasured = |l: &&Level| l.splitting.is_empty();
    doubts.extend(input.levels.iter().filter(unmeasured).map(|l| format!("level {}: no splitting", l.level)));
    // a level left out of the fit has an estimate that nobody looked at
    doubts.extend(input.levels.iter().filter_map(|l| Some(format!("level {}: {}", l.level, l.excluded.as_ref()?))));
    if !doubts.is_empty() {
        return inconclusive(doubts);
    }
    pass(vec![summary(input)])
}

fn with(input: &JudgeInput, holds: Option<bool>, how: &str) -> Vec<String> {
    let entries = input.usable().flat_map(|l| l.splitting.iter().map(move |s| (l.level, s)));
    let wrong = entries.filter(|(_, s)| s.holds == holds);
    wrong.map(|(level, s)| format!("level {level}: {} {how}", sentence(s))).collect()
}

/// `v = …, vₕ = …: 1.2e-3 ≤ 1.5e-3`.
fn sentence(s: &Splitting) -> String {
    format!("v = {}, vₕ = {}: {:.9e} ≤ {:.9e}", s.v, s.v_h, s.left, s.right)
}

fn summary(input: &JudgeInput) -> String {
    let entries = || input.levels.iter().flat_map(|l| &l.splitting);
    let tried: usize = entries().map(|s| s.tried).sum();
    let least = entries().filter(|s| s.left > 0.0).map(|s| s.slack() / s.left).fold(f64::INFINITY, f64::min);
    format!("{tried} pairs of fields on {} levels; the least slack is {least:.1e} of the left side", input.levels.len())
}
