//! The kind `certificate`: one sound answer and every way of spoiling it.

use super::*;
use crate::record::SecondOpinion;

fn opinion() -> SecondOpinion {
    SecondOpinion {
        name: "interior-point".into(),
        status: "converged in 9 steps".into(),
        solved: true,
        iterations: 9,
        energy_difference: 1e-14,
        displacement_difference: 1e-12,
        active_difference: 0,
        cancellation: 1e4,
    }
}

/// Three confirmed levels whose energy falls from −0.4 towards −0.5.
fn confirmed() -> Vec<Level> {
    let mut levels = sample::levels(3, |h| h);
    for (k, level) in levels.iter_mut().enumerate() {
        (level.second, level.inside) = (Some(opinion()), Some(true));
        level.kkt.componentwise = Some(3e-16);
        level.energy = -0.5 + 0.1 * 0.25_f64.powi(k as i32);
    }
    levels
}

#[track_caller]
fn verdict_of(outcome: Outcome, word: &str, spoil: impl Fn(&mut Vec<Level>)) {
    let mut levels = confirmed();
    spoil(&mut levels);
    expect(&of_kind(ClaimKind::Certificate, "kkt", levels), outcome, word);
}

fn second(level: &mut Level) -> &mut SecondOpinion {
    level.second.as_mut().unwrap()
}

#[test]
fn a_confirmed_solve_passes() {
    verdict_of(Pass, "solved on 3 levels", |_| {});
}

#[test]
fn every_residual_can_break_it() {
    verdict_of(Fail, "level 1: scaled stationarity", |l| l[1].kkt.stationarity = 1e-10);
    verdict_of(Fail, "stationarity row by row", |l| l[0].kkt.componentwise = Some(1e-9));
    verdict_of(Fail, "scaled penetration", |l| l[2].kkt.penetration = 1e-11);
    verdict_of(Fail, "scaled tension", |l| l[2].kkt.tension = 1e-11);
    verdict_of(Fail, "scaled complementarity", |l| l[2].kkt.complementarity = 1e-11);
    verdict_of(Fail, "NaN", |l| l[2].kkt.tension = f64::NAN);
}

#[test]
fn an_unfinished_solve_refutes_it() {
    verdict_of(Fail, "did not finish", |l| l[2].solver.solved = false);
    verdict_of(Fail, "asked second, did not finish", |l| second(&mut l[2]).solved = false);
}

#[test]
fn another_answer_refutes_it() {
    verdict_of(Fail, "the energy of interior-point differs", |l| second(&mut l[1]).energy_difference = 1e-8);
    verdict_of(Fail, "2 constraints press in one answer", |l| second(&mut l[1]).active_difference = 2);
    // rounding takes eleven digits of such an energy from any solver
    verdict_of(Pass, "agrees", |l| {
        (second(&mut l[1]).energy_difference, second(&mut l[1]).cancellation) = (1e-8, 1e11)
    });
}

#[test]
fn an_energy_that_rises_on_a_nested_mesh_refutes_it() {
    verdict_of(Fail, "level 2: the energy rises by 2.0e-2", |l| l[2].energy = l[1].energy + 0.01);
    // nothing is claimed where the meshes or the constraints are not nested
    verdict_of(Pass, "solved", |l| (l[2].energy, l[2].nested) = (0.0, false));
    verdict_of(Pass, "solved", |l| {
        l[2].energy = 0.0;
        l[1].inside = Some(false);
    });
}

#[test]
fn nobody_confirms_himself() {
    verdict_of(Inconclusive, "level 1: nobody else was asked", |l| l[1].second = None);
    verdict_of(Inconclusive, "the same mesh", |l| l[1].mesh_hash = l[0].mesh_hash.clone());
    verdict_of(Inconclusive, "no levels", Vec::clear);
}
