//! Between two levels, in the basis in which constraints are bounds.
//!
//! Slots of a level keep their numbers on the next finer one. A new slot halves a side: `x_new = ½(x_a + x_b)`. Where a basis
//! differs from that of the plane, or a component is fixed, the row is `T_f⁻¹ P T_c`, block by block: these rows are stored.

use crate::sparse::BlockMatrix;
use rayon::prelude::*;

/// A row of the prolongation that is no plain mean: `x_slot = Σ block · x_coarse`.
#[derive(Clone, Debug, PartialEq)]
pub struct SpecialRow {
    /// The new slot on the finer level.
    pub slot: u32,
    /// Coarse slots with their blocks, by rows.
    pub entries: Vec<(u32, [f64; 4])>,
}

/// The prolongation from a level to the next finer one, and its transpose.
#[derive(Clone, Debug)]
pub struct Transfer<'a> {
    /// Slots of the coarse level.
    pub coarse: usize,
    /// The two coarse slots whose mean a new slot is; new slot `i` has the number `coarse + i`.
    pub parents: &'a [[u32; 2]],
    /// The rows that differ, by ascending slot. A new slot with a parent that another row treats apart, or that has a fixed
    /// component, is among them.
    pub special: Vec<SpecialRow>,
}

/// Couplings below this are rounding.
const UNRELATED: f64 = 1e-8;

impl Transfer<'_> {
    /// `fine = P coarse`.
    pub fn prolong(&self, coarse: &[f64], fine: &mut [f64]) {
        let (old, new) = fine.split_at_mut(2 * self.coarse);
        old.copy_from_slice(coarse);
        new.par_chunks_mut(2).zip(self.parents).with_min_len(4096).for_each(|(x, &[a, b])| {
            let (a, b) = (2 * a as usize, 2 * b as usize);
            x[0] = 0.5 * (coarse[a] + coarse[b]);
            x[1] = 0.5 * (coarse[a + 1] + coarse[b + 1]);
        });
        for row in &self.special {
            let mut x = [0.0; 2];
            for (slot, b) in &row.entries {
                let (u, v) = (coarse[2 * *slot as usize], coarse[2 * *slot as usize + 1]);
                x[0] += b[0] * u + b[1] * v;
                x[1] += b[2] * u + b[3] * v;
            }
            fine[2 * row.slot as usize..][..2].copy_from_slice(&x);
        }
    }

    /// `coarse = Pᵀ fine`; the entries of special slots in `fine` are lost. The new slots that have an old slot as parent are its
    /// neighbours in the fine mesh, so they are read off its matrix row and nothing is scattered.
    pub fn restrict(&self, pattern: &BlockMatrix, fine: &mut [f64], coarse: &mut [f64]) {
        let forces: Vec<[f64; 2]> = self.special.iter().map(|row| take(fine, row.slot as usize)).collect();
        let (fine, new) = (&*fine, self.coarse);
        coarse.par_chunks_mut(2).enumerate().with_min_len(2048).for_each(|(i, sum)| {
            let mut halves = [0.0; 2];
            for &j in pattern.columns_of(i) {
                if j as usize >= new {
                    halves[0] += fine[2 * j as usize];
                    halves[1] += fine[2 * j as usize + 1];
                }
            }
            sum[0] = fine[2 * i] + 0.5 * halves[0];
            sum[1] = fine[2 * i + 1] + 0.5 * halves[1];
        });
        for (row, force) in self.special.iter().zip(&forces) {
            for (slot, b) in &row.entries {
                let sum = &mut coarse[2 * *slot as usize..][..2];
                sum[0] += b[0] * force[0] + b[2] * force[1];
                sum[1] += b[1] * force[0] + b[3] * force[1];
            }
        }
    }

    /// The coarse components that a fine component depends on.
    pub fn origins(&self, dof: u32) -> Vec<u32> {
        let (slot, k) = (dof / 2, (dof % 2) as usize);
        if (slot as usize) < self.coarse {
            return vec![dof];
        }
        match self.special.binary_search_by_key(&slot, |row| row.slot) {
            Ok(found) => {
                let related = |(slot, b): &(u32, [f64; 4])| {
                    let (slot, b) = (*slot, *b);
                    (0..2).filter(move |j| b[2 * k + j].abs() > UNRELATED).map(move |j| 2 * slot + j as u32)
                };
                self.special[found].entries.iter().flat_map(related).collect()
            }
            Err(_) => self.parents[slot as usize - self.coarse].map(|p| 2 * p + k as u32).to_vec(),
        }
    }
}

/// The two entries of a slot, which become zero.
fn take(x: &mut [f64], slot: usize) -> [f64; 2] {
    [std::mem::take(&mut x[2 * slot]), std::mem::take(&mut x[2 * slot + 1])]
}
