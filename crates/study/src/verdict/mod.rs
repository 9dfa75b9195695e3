//! Pass, fail or inconclusive: doubt is never a pass.
//!
//! [`judge`] first looks for reasons to doubt the numbers ([`doubt`]); any of them makes the verdict inconclusive.
//! Then the claim's kind has its rule:
//!
//! | kind | passes when | module |
//! | --- | --- | --- |
//! | `rate` | the observed rate reaches the bound | [`rate`] |
//! | `inequality` | it holds on every level | [`inequality`] |
//! | `exact` | the error is rounding on every level | [`exact`] |
//! | `convergence` | the error falls from level to level | [`convergence`] |
//! | `bounded` | the constant stays bounded | [`bounded`] |
//! | `agreement` | the finest level agrees with a formula | [`agreement`] |
//! | `certificate` | every solve ends, certified, as another solver ends it | [`certificate`] |
//!
//! Everything is read from the levels themselves. [`exclude_levels`] has marked those that may not enter.

pub mod agreement;
pub mod bounded;
pub mod certificate;
mod chain;
pub mod convergence;
pub mod doubt;
pub mod exact;
mod exclude;
pub mod inequality;
mod ledger;
pub mod rate;
pub mod splitting;
mod status;

pub use exclude::exclude_levels;
pub use status::{BAD_INPUT, effective, exit_status, worst};

use crate::record::{Bounds, ClaimKind, Level, Outcome, Verdict};
use crate::study::Gates;

/// What a verdict is made of.
#[derive(Clone, Copy, Debug)]
pub struct JudgeInput<'a> {
    /// How the claim is judged.
    pub kind: ClaimKind,
    /// The norm that it judges: a field of [`Errors`](crate::record::Errors), `b_over_h2`, or `ledger` for an
    /// inequality between ledger terms alone.
    pub norm: &'a str,
    /// From the coarsest to the finest, [`exclude_levels`] done.
    pub levels: &'a [Level],
    /// What a rate is held against.
    pub bounds: &'a Bounds,
    /// How sharply to judge.
    pub gates: &'a Gates,
    /// Whether a rate above the expected one is reported and not gated.
    pub expected_is_asymptotic: bool,
}

impl<'a> JudgeInput<'a> {
    /// The levels that may enter.
    fn usable(&self) -> impl Iterator<Item = &'a Level> + use<'a> {
        self.levels.iter().filter(|l| l.excluded.is_none())
    }
}

/// Judges a claim by what was measured.
pub fn judge(input: &JudgeInput) -> Verdict {
    if input.kind == ClaimKind::Certificate {
        // a solve that does not end is no doubt there, but what the claim denies
        return certificate::judge(input);
    }
    let doubts = doubt::all(input);
    if !doubts.is_empty() {
        return inconclusive(doubts);
    }
    doubted_by_energies(input, by_kind(input))
}

/// A chain of energies that is broken fails a claim on the energy and casts doubt on any other that would pass.
fn doubted_by_energies(input: &JudgeInput, verdict: Verdict) -> Verdict {
    let mut reasons = chain::broken(input);
    let of_energy = input.norm == "energy_gap";
    if reasons.is_empty() || (verdict.outcome == Outcome::Fail && !of_energy) {
        return verdict;
    }
    reasons.extend(verdict.reasons);
    if of_energy { fail(reasons) } else { inconclusive(reasons) }
}

fn by_kind(input: &JudgeInput) -> Verdict {
    match input.kind {
        ClaimKind::Rate => rate::judge(input),
        ClaimKind::Inequality => inequality::judge(input),
        ClaimKind::Exact => exact::judge(input),
        ClaimKind::Convergence => convergence::judge(input),
        ClaimKind::Bounded => bounded::judge(input),
        ClaimKind::Agreement => agreement::judge(input),
        ClaimKind::Certificate => certificate::judge(input),
    }
}

fn pass(reasons: Vec<String>) -> Verdict {
    Verdict { outcome: Outcome::Pass, reasons }
}

fn fail(reasons: Vec<String>) -> Verdict {
    Verdict { outcome: Outcome::Fail, reasons }
}

fn inconclusive(reasons: Vec<String>) -> Verdict {
    Verdict { outcome: Outcome::Inconclusive, reasons }
}

#[cfg(test)]
mod tests;
