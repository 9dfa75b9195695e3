//! Gauss–Seidel: slot by slot, block by block, each to the minimum of the energy in its own components.

use super::block::Block;
use super::order::{Order, Slots};
use crate::qp::Bound;
use crate::sparse::BlockMatrix;
use rayon::prelude::*;
use std::cell::Cell;

/// Below this many slots a sweep is not worth dividing among threads.
const WORTH_DIVIDING: usize = 20_000;

/// The direction of a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Blocks, interface, parts.
    Forward,
    /// The other way round.
    Backward,
}

/// What the blocks of a sweep obey.
#[derive(Clone, Copy)]
pub enum Limits<'a> {
    /// `x_c ≤ g_c`.
    Bounds(&'a [Bound]),
    /// Frozen components stay, the others are free; one entry for each bound.
    Frozen(&'a [bool]),
}

/// One level as a sweep sees it.
pub struct Sweep<'a> {
    /// The matrix.
    pub matrix: &'a BlockMatrix,
    /// Blocks, which the order leaves out.
    pub blocks: &'a [Block],
    /// The order of the other slots.
    pub order: &'a Order,
}

/// Cells that several threads may touch, as long as they keep to different parts.
struct Parts<'a>(&'a [Cell<[f64; 2]>]);

// SAFETY: a `Parts` is shared only by the loop over `Order::parts` below. Each task writes the slots of its own part and reads
// these, the interface and nothing else: `Order::new` refuses parts with a common slot or with a coupling between them, and no
// one writes the interface meanwhile. So no cell that is written is touched by two threads.
#[allow(unsafe_code)]
unsafe impl Sync for Parts<'_> {}

impl Sweep<'_> {
    /// Relaxes every slot once; `x` and `load` have two entries for each slot.
    pub fn run(&self, direction: Direction, limits: Limits, load: &[f64], x: &mut [f64]) {
        let x = Cell::from_mut(x.as_chunks_mut::<2>().0).as_slice_of_cells();
        match direction {
            Direction::Forward => {
                self.blocks.iter().for_each(|b| self.relax(b, limits, load, x));
                self.order.interface().iter().for_each(|s| forward(self.matrix, s, load, x));
                self.each_part(x, &|slots, x| slots.iter().for_each(|s| forward(self.matrix, s, load, x)));
            }
            Direction::Backward => {
                self.each_part(x, &|slots, x| slots.iter().rev().for_each(|s| backward(self.matrix, s, load, x)));
                self.order.interface().iter().rev().for_each(|s| backward(self.matrix, s, load, x));
                self.blocks.iter().rev().for_each(|b| self.relax(b, limits, load, x));
            }
        }
    }

    fn relax(&self, block: &Block, limits: Limits, load: &[f64], x: &[Cell<[f64; 2]>]) {
        match limits {
            Limits::Bounds(bounds) => block.relax(self.matrix, load, bounds, x),
            Limits::Frozen(frozen) => block.relax_linear(self.matrix, load, frozen, x),
        }
    }

    fn each_part(&self, x: &[Cell<[f64; 2]>], visit: &(impl Fn(&[Slots], &[Cell<[f64; 2]>]) + Sync)) {
        if self.matrix.rows() < WORTH_DIVIDING {
            self.order.parts().iter().for_each(|slots| visit(slots, x));
            return;
        }
        let shared = Parts(x);
        self.order.parts().par_iter().for_each(|slots| {
            let Parts(x) = &shared;
            visit(slots, x);
        });
    }
}

fn forward(matrix: &BlockMatrix, slots: &Slots, load: &[f64], x: &[Cell<[f64; 2]>]) {
    slots.clone().for_each(|i| relax_slot(matrix, i as usize, load, x));
}

fn backward(matrix: &BlockMatrix, slots: &Slots, load: &[f64], x: &[Cell<[f64; 2]>]) {
    slots.clone().rev().for_each(|i| relax_slot(matrix, i as usize, load, x));
}

/// `x_i += D⁻¹ (f − Kx)_i` with the 2×2 diagonal block `D`.
#[inline]
fn relax_slot(matrix: &BlockMatrix, i: usize, load: &[f64], x: &[Cell<[f64; 2]>]) {
    let (columns, blocks) = matrix.parts(i);
    let (mut kx, mut diagonal) = ([0.0; 2], [0.0; 4]);
    for (&j, b) in columns.iter().zip(blocks) {
        let [u, v] = x[j as usize].get();
        kx[0] += b[0] * u + b[1] * v;
        kx[1] += b[2] * u + b[3] * v;
        if j as usize == i {
            diagonal = *b;
        }
    }
    let [a, b, c, d] = diagonal;
    let determinant = a * d - b * c;
    if determinant > 0.0 {
        let rest = [load[2 * i] - kx[0], load[2 * i + 1] - kx[1]];
        let (scale, [u, v]) = (1.0 / determinant, x[i].get());
        x[i].set([u + scale * (d * rest[0] - b * rest[1]), v + scale * (a * rest[1] - c * rest[0])]);
    }
}
