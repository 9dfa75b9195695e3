//! The primal–dual active set method on the dense problem.
//!
//! Each step solves `S x + λ = b` with `x = g` on the active components and `λ = 0` on the others, then declares active
//! what satisfies `λ_i + S_ii (x_i − g_i) > 0`. When the set repeats at once, `x, λ` is the solution. `S` is no
//! M-matrix, so the sets may run in a cycle: earlier sets are remembered, and a return ends the method.

use super::dense::{DenseQp, Face};

/// A solution of the dense problem.
#[derive(Clone, Debug)]
pub struct DenseSolution {
    /// The minimiser.
    pub x: Vec<f64>,
    /// The active components.
    pub active: Vec<bool>,
    /// The factor of the last face.
    pub face: Face,
    /// Linear solves used.
    pub steps: usize,
}

/// How the method ended.
#[derive(Clone, Debug)]
pub enum PrimalDual {
    /// The set repeated itself.
    Solved(DenseSolution),
    /// It did not come to an end; a slower method has to continue from `x`.
    Stopped {
        /// Length of the cycle of sets; 0 if the steps ran out or the face matrix was singular.
        cycle: usize,
        /// The last iterate; it may violate the bounds.
        x: Vec<f64>,
    },
}

/// Runs at most `max_steps` steps from the set of all components; records the sizes of the sets.
pub fn primal_dual(qp: &DenseQp, max_steps: usize, history: &mut Vec<usize>) -> PrimalDual {
    let mut active = vec![true; qp.len()];
    let mut x = qp.upper.clone();
    let mut earlier = SetHistory::default();
    for step in 1..=max_steps.max(1) {
        if let Some(cycle) = earlier.record(&active) {
            return PrimalDual::Stopped { cycle, x };
        }
        history.push(active.iter().filter(|a| **a).count());
        let face = Face::new(qp, &active);
        if face.is_singular() {
            return PrimalDual::Stopped { cycle: 0, x };
        }
        x = face_minimiser(qp, &active, &face);
        let next = next_set(qp, &active, &x);
        if next == active {
            return PrimalDual::Solved(DenseSolution { x, active, face, steps: step });
        }
        active = next;
    }
    PrimalDual::Stopped { cycle: 0, x }
}

/// `x_A = g_A`, `S_II x_I = b_I − S_IA g_A`. From zero, not from the last iterate, whose rounding would stay where the solution vanishes.
pub(super) fn face_minimiser(qp: &DenseQp, active: &[bool], face: &Face) -> Vec<f64> {
    let mut x: Vec<f64> = active.iter().zip(&qp.upper).map(|(active, g)| if *active { *g } else { 0.0 }).collect();
    let step = face.solve(&qp.residual(&x));
    x.iter_mut().zip(step).for_each(|(x, d)| *x += d);
    x
}

/// Active next: `λ_i + S_ii (x_i − g_i) > 0`. A component stays in its set while this is zero to rounding, so that a tie
/// (multiplier and slack both zero) does not flip for ever.
fn next_set(qp: &DenseQp, active: &[bool], x: &[f64]) -> Vec<bool> {
    let tolerance = qp.tolerance(x);
    let multipliers = qp.residual(x);
    let stays = |i: usize| {
        if active[i] { multipliers[i] > -tolerance } else { qp.matrix[(i, i)] * (x[i] - qp.upper[i]) > tolerance }
    };
    (0..qp.len()).map(stays).collect()
}

/// The sets seen so far. Hashes find a candidate, the sets themselves decide.
#[derive(Default)]
struct SetHistory {
    seen: Vec<(u64, Vec<u64>)>,
}

impl SetHistory {
    /// Remembers the set; if it was seen before, tells how many steps ago.
    fn record(&mut self, active: &[bool]) -> Option<usize> {
        let words = pack(active);
        let hash = fnv(&words);
        let same = |(h, w): &(u64, Vec<u64>)| *h == hash && *w == words;
        let age = self.seen.iter().rev().position(same).map(|k| k + 1);
        self.seen.push((hash, words));
        age
    }
}

/// 64 components per word.
fn pack(active: &[bool]) -> Vec<u64> {
    let word = |chunk: &[bool]| chunk.iter().rev().fold(0, |w, &a| 2 * w + u64::from(a));
    active.chunks(64).map(word).collect()
}

/// The FNV-1a hash, by words.
fn fnv(words: &[u64]) -> u64 {
    words.iter().fold(0xcbf2_9ce4_8422_2325, |hash, word| (hash ^ word).wrapping_mul(0x0100_0000_01b3))
}
