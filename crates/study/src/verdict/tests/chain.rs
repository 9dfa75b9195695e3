//! The chain of energies: what breaks it, and what it breaks.

use super::*;

/// Levels whose energies are these, with `K_h ⊂ K_{h/2} ⊂ K`.
fn with(energies: &[f64]) -> Vec<Level> {
    let mut levels = sample::levels(energies.len(), |h| h);
    for (level, energy) in levels.iter_mut().zip(energies) {
        (level.energy, level.inside) = (*energy, Some(true));
        level.errors.energy_gap = Some(energy + 0.5);
        level.ledger = ledger(0.4, 0.0, Some(true));
    }
    levels
}

fn gap(levels: Vec<Level>) -> Verdict {
    of_kind(ClaimKind::Convergence, "energy_gap", levels)
}

const FALLING: [f64; 4] = [-0.4, -0.45, -0.475, -0.4875];

#[test]
fn energies_of_nested_sets_may_only_fall() {
    expect(&gap(with(&FALLING)), Pass, "on 3 pairs of nested levels");
    let rising = [-0.4, -0.45, -0.44, -0.4875];
    expect(&gap(with(&rising)), Fail, "level 2: L(u_h) rises by 1.00e-2");
    // below the solution's own energy, and closer to it each time
    let below = [-0.6, -0.55, -0.525, -0.5125];
    expect(&gap(with(&below)), Fail, "level 3: L(u_h) is 1.25e-2 below L(u)");
    // rounding is no rise
    let still: Vec<Level> = with(&[-0.4, -0.45, -0.475, -0.475 + 1e-13]);
    assert!(!gap(still).reasons.iter().any(|r| r.contains("rises")));
}

#[test]
fn a_rise_casts_doubt_on_every_other_claim() {
    let judge = |levels| of_kind(ClaimKind::Convergence, "energy", levels);
    let rising = || with(&[-0.4, -0.45, -0.44, -0.4875]);
    expect(&judge(with(&FALLING)), Pass, "at most");
    expect(&judge(rising()), Inconclusive, "rises by");
    expect(&of_rate(rising()), Inconclusive, "rises by");
    // a failure stays one
    let mut failing = rising();
    failing[3].errors.energy = Some(1.0);
    expect(&judge(failing), Fail, "has to fall");
}

#[test]
fn nothing_is_claimed_of_sets_that_are_not_nested() {
    type Change = fn(&mut Level);
    let changes: [Change; 3] = [|l| l.nested = false, |l| l.inside = Some(false), |l| l.inside = None];
    for change in changes {
        let mut levels = with(&[-0.4, -0.45, -0.44, -0.4875]);
        levels.iter_mut().for_each(change);
        assert!(!gap(levels).reasons.iter().any(|r| r.contains("rises") || r.contains("nested levels")));
    }
    let mut located = with(&[-0.6, -0.55, -0.525, -0.5125]);
    located.iter_mut().for_each(|l| (l.ledger, l.nested) = (None, false));
    expect(&gap(located), Pass, "at most");
}
