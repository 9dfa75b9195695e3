//! Falk's splitting as a verdict.

use super::*;
use crate::record::Estimate;
use crate::splitting::Sides;

fn with(excess: f64) -> Vec<Level> {
    let mut levels = sample::levels(3, |h| h);
    let entry = |right: f64| {
        Sides { terms: [right, 0.0, 0.0, 0.0, 0.0], left: 0.5 }.record(Estimate::General, ["a", "b"], 1e-9)
    };
    levels.iter_mut().for_each(|l| l.splitting = vec![entry(0.7), entry(0.5)]);
    levels[1].splitting[1] = entry(0.5 - excess);
    levels
}

#[test]
fn a_splitting_holds_for_every_pair_on_every_level() {
    let judge = |levels| of_kind(ClaimKind::Inequality, "splitting", levels);
    expect(&judge(with(0.0)), Pass, "6 pairs of fields on 3 levels");
    expect(&judge(with(5e-10)), Pass, "of the left side");
    expect(&judge(with(5e-9)), Inconclusive, "level 1: v = a, vₕ = b");
    expect(&judge(with(1e-6)), Fail, "is broken");
    let mut missing = with(0.0);
    missing[2].splitting.clear();
    expect(&judge(missing), Inconclusive, "level 2: no splitting");
    let mut excluded = with(0.0);
    excluded[0].budget.reference = Some(0.5);
    expect(&judge(excluded), Inconclusive, "level 0");
}
