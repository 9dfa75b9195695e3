//! Every rule beside its twin: the same levels with one defect that has to turn the verdict.

use super::*;
use crate::record::{Ledger, Level};
use crate::sample::{self, Noise};
use Outcome::{Fail, Inconclusive, Pass};

mod certificate;
mod chain;
mod doubt;
mod kinds;
mod rate;
mod splitting;
mod synthetic;

const GATE_1: Bounds = Bounds { paper: Some(1.0), today: Some(1.0), expected: Some(1.0) };

/// Excludes and judges with the default gates, changed by `adjust`.
fn judged(kind: ClaimKind, norm: &str, mut levels: Vec<Level>, bounds: Bounds, adjust: impl Fn(&mut Gates)) -> Verdict {
    let mut gates = Gates::default();
    adjust(&mut gates);
    exclude_levels(&mut levels, &gates);
    let input =
        JudgeInput { kind, norm, levels: &levels, bounds: &bounds, gates: &gates, expected_is_asymptotic: false };
    judge(&input)
}

/// A rate claim with gate 1 in the strain norm.
fn of_rate(levels: Vec<Level>) -> Verdict {
    judged(ClaimKind::Rate, "strain", levels, GATE_1, |_| {})
}

fn of_kind(kind: ClaimKind, norm: &str, levels: Vec<Level>) -> Verdict {
    judged(kind, norm, levels, GATE_1, |_| {})
}

/// Five sound levels with the given rate, one of them spoilt.
fn spoilt(rate: f64, spoil: impl Fn(&mut Vec<Level>)) -> Vec<Level> {
    let mut levels = sample::levels(5, |h| h.powf(rate));
    spoil(&mut levels);
    levels
}

/// Levels with these pairwise rates.
fn with_rates(rates: &[f64]) -> Vec<Level> {
    let mut error = 0.1;
    let mut levels = vec![sample::level(0, error)];
    for (k, rate) in rates.iter().enumerate() {
        error *= 0.5_f64.powf(*rate);
        levels.push(sample::level(k + 1, error));
    }
    levels
}

#[track_caller]
fn expect(verdict: &Verdict, outcome: Outcome, word: &str) {
    assert_eq!(verdict.outcome, outcome, "{verdict:?}");
    assert!(verdict.reasons.iter().any(|r| r.contains(word)), "no '{word}' in {verdict:?}");
}

fn ledger(lhs: f64, b: f64, holds: Option<bool>) -> Option<Ledger> {
    Some(Ledger { lhs, a: 0.5, b, c: 0.0, parts: Default::default(), delta: 1e-9, holds })
}
