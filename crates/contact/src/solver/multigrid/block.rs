//! The unknowns that are relaxed together: a contact pair, or a slot with a bound of its own.
//!
//! ```text
//! min ½ δᵀBδ − ρᵀδ   subject to   δ_c ≤ s_c
//! ```
//!
//! over the four components of a pair, with `B` its block of the matrix, `ρ` its residual and `s` the slack of its bounds. At
//! a corner both constraints are bounds of one block, so that neither waits for the other.

use crate::qp::Bound;
use crate::sparse::BlockMatrix;
use std::cell::Cell;

/// Stands for a slot or a bound that is not there.
pub const NONE: u32 = u32::MAX;

/// Components of a block.
const WIDTH: usize = 4;

/// One or two slots relaxed together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// The slots; the second may be [`NONE`].
    pub slots: [u32; 2],
    /// For each component, the index of its bound, or [`NONE`].
    pub bounds: [u32; WIDTH],
}

/// The blocks of a level: every pair, and every bound outside the pairs by itself. `bounds` ascend by dof.
pub fn blocks(pairs: &[[u32; 2]], bounds: &[Bound]) -> Vec<Block> {
    let bound_of = |dof: u32| match bounds.binary_search_by_key(&dof, |b| b.dof) {
        Ok(k) => k as u32,
        Err(_) => NONE,
    };
    let block = |slots: [u32; 2]| {
        let of = |slot: u32, k: u32| if slot == NONE { NONE } else { bound_of(2 * slot + k) };
        Block { slots, bounds: [of(slots[0], 0), of(slots[0], 1), of(slots[1], 0), of(slots[1], 1)] }
    };
    let mut all: Vec<Block> = pairs.iter().map(|&p| block(p)).collect();
    let mut paired: Vec<u32> = pairs.iter().flatten().copied().collect();
    paired.sort_unstable();
    let mut alone: Vec<u32> = bounds.iter().map(|b| b.dof / 2).collect();
    alone.dedup();
    all.extend(alone.into_iter().filter(|s| paired.binary_search(s).is_err()).map(|s| block([s, NONE])));
    all
}

/// The local problem at the current point.
struct Local {
    matrix: [[f64; WIDTH]; WIDTH],
    residual: [f64; WIDTH],
}

impl Block {
    fn local(&self, matrix: &BlockMatrix, load: &[f64], x: &[Cell<[f64; 2]>]) -> Local {
        let mut local = Local { matrix: [[0.0; WIDTH]; WIDTH], residual: [0.0; WIDTH] };
        for (top, &slot) in self.slots.iter().enumerate().filter(|(_, s)| **s != NONE) {
            let i = slot as usize;
            let kx = matrix.times_row(i, |j| x[j].get());
            (local.residual[2 * top], local.residual[2 * top + 1]) = (load[2 * i] - kx[0], load[2 * i + 1] - kx[1]);
            for (j, b) in matrix.row(i) {
                if let Some(left) = self.slots.iter().position(|&s| s as usize == j) {
                    for k in 0..4 {
                        local.matrix[2 * top + k / 2][2 * left + k % 2] = b[k];
                    }
                }
            }
        }
        local
    }

    fn get(&self, k: usize, x: &[Cell<[f64; 2]>]) -> f64 {
        x[self.slots[k / 2] as usize].get()[k % 2]
    }

    fn set(&self, k: usize, x: &[Cell<[f64; 2]>], value: f64) {
        let cell = &x[self.slots[k / 2] as usize];
        let mut both = cell.get();
        both[k % 2] = value;
        cell.set(both);
    }

    fn width(&self) -> usize {
        if self.slots[1] == NONE { 2 } else { WIDTH }
    }

    /// Minimises over the block's components within their bounds; a component that ends on its bound is there exactly.
    pub fn relax(&self, matrix: &BlockMatrix, load: &[f64], bounds: &[Bound], x: &[Cell<[f64; 2]>]) {
        let local = self.local(matrix, load, x);
        let mut slack = [f64::INFINITY; WIDTH];
        for k in (0..WIDTH).filter(|&k| self.bounds[k] != NONE) {
            slack[k] = bounds[self.bounds[k] as usize].upper - self.get(k, x);
        }
        let (change, active) = local.minimise(&slack);
        for k in 0..self.width() {
            let moved = self.get(k, x) + change[k];
            self.set(k, x, if active[k] { bounds[self.bounds[k] as usize].upper } else { moved });
        }
    }

    /// Minimises with the frozen components held: the linear problem on a face.
    pub fn relax_linear(&self, matrix: &BlockMatrix, load: &[f64], frozen: &[bool], x: &[Cell<[f64; 2]>]) {
        let local = self.local(matrix, load, x);
        let held = self.bounds.map(|b| b != NONE && frozen[b as usize]);
        let change = local.solve(&held, &[0.0; WIDTH]);
        for k in (0..self.width()).filter(|&k| !held[k]) {
            self.set(k, x, self.get(k, x) + change[k]);
        }
    }
}

impl Local {
    /// The minimiser and which components sit on their bounds. At most two are bounded: the four faces are tried in turn.
    fn minimise(&self, slack: &[f64; WIDTH]) -> ([f64; WIDTH], [bool; WIDTH]) {
        let bounded: Vec<usize> = (0..WIDTH).filter(|&k| slack[k].is_finite()).collect();
        let face = |set: usize| {
            let mut held = [false; WIDTH];
            bounded.iter().enumerate().for_each(|(i, &k)| held[k] = set >> i & 1 == 1);
            held
        };
        for set in 0..1 << bounded.len() {
            let held = face(set);
            let change = self.solve(&held, slack);
            let force = |k: usize| self.residual[k] - (0..WIDTH).map(|j| self.matrix[k][j] * change[j]).sum::<f64>();
            if bounded.iter().all(|&k| if held[k] { force(k) >= 0.0 } else { change[k] <= slack[k] }) {
                return (change, held);
            }
        }
        // rounding between two faces: on all bounds is feasible
        let held = face((1 << bounded.len()) - 1);
        (self.solve(&held, slack), held)
    }

    /// `δ = value` on the held components, `Bδ = ρ` on the others, by elimination; a component without stiffness stays.
    fn solve(&self, held: &[bool; WIDTH], value: &[f64; WIDTH]) -> [f64; WIDTH] {
        let (mut a, mut b) = (self.matrix, self.residual);
        for k in (0..WIDTH).filter(|&k| held[k]) {
            for i in 0..WIDTH {
                b[i] -= a[i][k] * value[k];
                (a[i][k], a[k][i]) = (0.0, 0.0);
            }
            (a[k][k], b[k]) = (1.0, value[k]);
        }
        let stiff = |k: usize, pivot: f64| pivot > 1e-14 * self.matrix[k][k].abs() && pivot > 0.0;
        for k in 0..WIDTH {
            if !(held[k] || stiff(k, a[k][k])) {
                (0..WIDTH).for_each(|i| (a[i][k], a[k][i]) = (0.0, 0.0));
                (a[k][k], b[k]) = (1.0, 0.0);
            }
            for i in k + 1..WIDTH {
                let factor = a[i][k] / a[k][k];
                for j in k..WIDTH {
                    a[i][j] -= factor * a[k][j];
                }
                b[i] -= factor * b[k];
            }
        }
        for k in (0..WIDTH).rev() {
            let rest: f64 = (k + 1..WIDTH).map(|j| a[k][j] * b[j]).sum();
            b[k] = (b[k] - rest) / a[k][k];
        }
        b
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const B: [[f64; 4]; 4] =
        [[4.0, 1.0, -1.0, 0.5], [1.0, 5.0, 0.3, -2.0], [-1.0, 0.3, 6.0, 1.0], [0.5, -2.0, 1.0, 3.0]];

    fn energy(local: &Local, d: &[f64; 4]) -> f64 {
        let quadratic: f64 = (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).map(|(i, j)| d[i] * B[i][j] * d[j]).sum();
        0.5 * quadratic - (0..4).map(|i| local.residual[i] * d[i]).sum::<f64>()
    }

    #[test]
    fn no_feasible_neighbour_has_less_energy() {
        for residual in [[3.0, 2.0, -1.0, 1.0], [-1.0, 4.0, 0.0, 2.0], [5.0, 5.0, 5.0, 5.0], [-2.0, -1.0, 1.0, 0.0]] {
            for slack in [[0.1, f64::INFINITY], [0.1, 0.2], [10.0, 10.0], [0.0, 0.0], [f64::INFINITY; 2]] {
                let slack = [slack[0], slack[1], f64::INFINITY, f64::INFINITY];
                let local = Local { matrix: B, residual };
                let (change, active) = local.minimise(&slack);
                assert!((0..4).all(|k| change[k] <= slack[k] + 1e-15 && (!active[k] || change[k] == slack[k])));
                let least = energy(&local, &change);
                for k in 0..4 {
                    for step in [-1e-4, 1e-4] {
                        let mut other = change;
                        other[k] += step;
                        assert!(other[k] > slack[k] || energy(&local, &other) >= least, "{residual:?} {slack:?} {k}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_component_without_stiffness_stays_where_it_is() {
        let mut matrix = B;
        (0..4).for_each(|i| (matrix[i][3], matrix[3][i]) = (0.0, 0.0));
        let change = Local { matrix, residual: [1.0, 0.0, 0.0, 0.0] }.solve(&[false; 4], &[0.0; 4]);
        assert_eq!(change[3], 0.0);
        assert!(change.iter().all(|c| c.is_finite()) && change[0] > 0.2);
    }

    #[test]
    fn every_bound_belongs_to_one_block() {
        let bounds = [0, 1, 6, 9].map(|dof| Bound { dof, upper: 0.0 });
        let found = blocks(&[[0, 2], [3, 1]], &bounds);
        assert_eq!(found[0], Block { slots: [0, 2], bounds: [0, 1, NONE, NONE] });
        assert_eq!(found[1], Block { slots: [3, 1], bounds: [2, NONE, NONE, NONE] });
        assert_eq!(found[2], Block { slots: [4, NONE], bounds: [NONE, 3, NONE, NONE] });
        assert_eq!(found.len(), 3);
    }
}
