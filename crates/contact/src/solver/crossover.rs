//! From an interior point to a vertex of the active set: fix the identified bounds, solve the equality problem with a
//! sparse factorisation of its own, check the signs, set the active set right, repeat.

use super::cholesky::Cholesky;
use super::{QpSolution, Status};
use crate::qp::{BoundQp, largest, residual, row_norm, row_size};

/// Equality solves, at most.
const ROUNDS: usize = 20;
/// Rounding of a multiplier, and of a slack times its stiffness, relative to the terms of its row, `(|K||x| + |f|)_c`.
const ROUNDING: f64 = 1e-13;
/// Rounding of `x` relative to its largest entry, where the rows of a tie hold nothing else.
const NOISE: f64 = 1e2 * f64::EPSILON;
/// Rigid motions of two bodies, at most.
const MOTIONS: usize = 6;
/// Corrections of each equality solve by its residual.
const REFINEMENTS: usize = 2;

/// Replaces `answer.x` by the solution on the active set and returns that set; `None`, and the status says why, if the
/// set did not come to rest.
pub fn crossover(qp: &BoundQp, removed: &[bool], start: &[f64], answer: &mut QpSolution) -> Option<Vec<bool>> {
    let mut active = identified(qp, answer);
    let steps = answer.iterations;
    let mut earlier: Vec<Vec<bool>> = Vec::new();
    for _ in 0..ROUNDS {
        answer.history.push(active.iter().filter(|a| **a).count());
        let Some(x) = held_solve(qp, removed, start, &mut active, answer) else {
            answer.status = Status::NotPositiveDefinite;
            return None;
        };
        // a set that returns flips over a tie of rounding size: then the rounding of all of x counts as such
        let returned = earlier.contains(&active);
        let next = corrected(qp, &active, &x, if returned { NOISE * largest(&x) } else { 0.0 });
        earlier.push(active.clone());
        answer.x = x;
        if next == active {
            answer.status = Status::Converged { steps };
            return Some(active);
        }
        active = next;
    }
    answer.status = Status::IterationLimit { steps };
    None
}

/// The equality solve; where the set leaves a motion free, with the bound that is nearest to pressing added, one for each motion.
/// A multiplier below the interior point's tolerance may be all that holds a body.
fn held_solve(
    qp: &BoundQp,
    removed: &[bool],
    start: &[f64],
    active: &mut [bool],
    answer: &mut QpSolution,
) -> Option<Vec<f64>> {
    for _ in 0..=MOTIONS {
        answer.factorizations += 1;
        if let Some(x) = equality_solve(qp, removed, start, active) {
            return Some(x);
        }
        active[nearest_to_pressing(qp, active, answer)?] = true;
    }
    None
}

/// The inactive bound with the smallest slack times stiffness less its multiplier.
fn nearest_to_pressing(qp: &BoundQp, active: &[bool], answer: &QpSolution) -> Option<usize> {
    let distance = |k: usize| {
        let bound = &qp.bounds[k];
        let dof = bound.dof as usize;
        stiffness(qp, dof) * (bound.upper - answer.x[dof]) - answer.multipliers[k]
    };
    (0..qp.bounds.len()).filter(|&k| !active[k]).min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
}

/// Active: the multiplier exceeds the slack times its stiffness.
fn identified(qp: &BoundQp, answer: &QpSolution) -> Vec<bool> {
    let presses = |(bound, multiplier): (&crate::qp::Bound, &f64)| {
        let slack = bound.upper - answer.x[bound.dof as usize];
        *multiplier > stiffness(qp, bound.dof as usize) * slack
    };
    qp.bounds.iter().zip(&answer.multipliers).map(presses).collect()
}

/// Drops the active bounds that pull, adds the violated ones; rounding changes nothing, nor does a change of `x` by `noise`.
fn corrected(qp: &BoundQp, active: &[bool], x: &[f64], noise: f64) -> Vec<bool> {
    let reaction = residual(qp, x);
    let stays = |(bound, &active): (&crate::qp::Bound, &bool)| {
        let dof = bound.dof as usize;
        let tolerance = ROUNDING * row_size(qp, x, dof) + noise * row_norm(qp, x, dof);
        if active { reaction[dof] > -tolerance } else { stiffness(qp, dof) * (x[dof] - bound.upper) > tolerance }
    };
    qp.bounds.iter().zip(active).map(stays).collect()
}

/// `x_A = g_A`, `K_II x_I = f_I − K_IA g_A`, `x = start` on the removed unknowns. `None` if `K_II` is not positive definite.
fn equality_solve(qp: &BoundQp, removed: &[bool], start: &[f64], active: &[bool]) -> Option<Vec<f64>> {
    let mut fixed = removed.to_vec();
    let mut x = start.to_vec();
    for (bound, _) in qp.bounds.iter().zip(active).filter(|(_, a)| **a) {
        fixed[bound.dof as usize] = true;
        x[bound.dof as usize] = bound.upper;
    }
    let factor = Cholesky::new(&qp.matrix, &fixed, &[], &[]).ok()?;
    for _ in 0..=REFINEMENTS {
        let mut step = residual(qp, &x);
        factor.solve(&mut step);
        x.iter_mut().zip(step).for_each(|(x, d)| *x += d);
    }
    Some(x)
}

/// `K_ii`.
fn stiffness(qp: &BoundQp, dof: usize) -> f64 {
    qp.matrix.diagonal_block(dof / 2)[3 * (dof % 2)]
}
