//! Coarse functions that a frozen fine component cuts short.
//!
//! Near the end of contact a coarse hat of `n·d` reaches pairs that are closed and pairs that are open. What remains of it on the open
//! ones is still a useful correction: the row of its component in the coarse matrix becomes that of the function cut short,
//!
//! ```text
//! K_c[j, k] = φ_jᵀ K_f φ_k,     φ_k = (P e_k without the frozen components)
//! ```
//!
//! There are one or two such components for each end of contact and level, so a change of the active set costs next to nothing.
//! R. Kornhuber, *Monotone multigrid methods for elliptic variational inequalities I* (1994).

use super::motion::Row;
use super::transfer::Transfer;
use crate::sparse::BlockMatrix;
use std::collections::BTreeMap;

/// A few entries of a vector, by slot.
type Few = BTreeMap<u32, [f64; 2]>;

/// The entries of a coarse matrix as they were before a function was cut short.
#[derive(Default)]
pub struct Undo(Vec<(u32, u32, [f64; 4])>);

impl Undo {
    /// Brings back the matrix of whole functions.
    pub fn restore(&mut self, matrix: &mut BlockMatrix) {
        for (row, place, block) in self.0.drain(..).rev() {
            *matrix.block_mut(row as usize, place as usize) = block;
        }
    }

    fn set(&mut self, matrix: &mut BlockMatrix, row: u32, column: u32, change: impl FnOnce(&mut [f64; 4])) {
        let Ok(place) = matrix.columns_of(row as usize).binary_search(&column) else { return };
        let block = matrix.block_mut(row as usize, place);
        self.0.push((row, place as u32, *block));
        change(block);
    }

    /// Puts the row and column of the component `dof`, cut short where `frozen` holds, into the coarse matrix.
    pub fn cut_short(
        &mut self,
        coarse: &mut BlockMatrix,
        fine: &BlockMatrix,
        transfer: &Transfer,
        frozen: &dyn Fn(u32) -> bool,
        dof: u32,
    ) {
        let (slot, k) = (dof / 2, (dof % 2) as usize);
        let function = without(transfer.column(fine, slot, k), frozen);
        let force = without(product(fine, &function), frozen);
        let column = transfer.restrict_few(&force);
        let neighbours: Vec<u32> = coarse.columns_of(slot as usize).to_vec();
        for j in neighbours {
            let value = column.get(&j).copied().unwrap_or_default();
            // column k of block (j, slot), then row k of block (slot, j)
            self.set(coarse, j, slot, |b| (b[k], b[2 + k]) = (value[0], value[1]));
            self.set(coarse, slot, j, |b| (b[2 * k], b[2 * k + 1]) = (value[0], value[1]));
        }
    }
}

fn without(mut few: Few, frozen: &dyn Fn(u32) -> bool) -> Few {
    for (slot, value) in &mut few {
        (0..2).filter(|&k| frozen(2 * slot + k)).for_each(|k| value[k as usize] = 0.0);
    }
    few
}

/// `K v`, with `K` symmetric.
fn product(matrix: &BlockMatrix, v: &Few) -> Few {
    let mut sum = Few::new();
    for (&j, [u, w]) in v.iter().filter(|(_, v)| **v != [0.0; 2]) {
        for (i, b) in matrix.row(j as usize) {
            let at = sum.entry(i as u32).or_default();
            at[0] += b[0] * u + b[2] * w;
            at[1] += b[1] * u + b[3] * w;
        }
    }
    sum
}

impl Transfer<'_> {
    /// Column `(slot, k)` of the prolongation of a slot whose new neighbours are all special.
    fn column(&self, fine: &BlockMatrix, slot: u32, k: usize) -> Few {
        let mut column = Few::new();
        column.entry(slot).or_default()[k] = 1.0;
        for &j in fine.columns_of(slot as usize) {
            let Ok(found) = self.special.binary_search_by_key(&j, |row| row.slot) else { continue };
            if let Some((_, b)) = self.special[found].entries.iter().find(|(c, _)| *c == slot) {
                column.insert(j, [b[k], b[2 + k]]);
            }
        }
        column
    }

    /// The functional `x ↦ row(P x)`.
    pub fn pull_back(&self, row: &Row) -> Row {
        let few = row.iter().fold(Few::new(), |mut few, (dof, w)| {
            few.entry(dof / 2).or_default()[(dof % 2) as usize] += w;
            few
        });
        let coarse = self.restrict_few(&few).into_iter();
        coarse.flat_map(|(slot, [u, v])| [(2 * slot, u), (2 * slot + 1, v)]).filter(|(_, w)| *w != 0.0).collect()
    }

    /// `Pᵀ f` of a few entries.
    fn restrict_few(&self, f: &Few) -> Few {
        let mut coarse = Few::new();
        let mut add = |slot: u32, [u, v]: [f64; 2]| {
            let sum = coarse.entry(slot).or_default();
            sum[0] += u;
            sum[1] += v;
        };
        for (&slot, &[u, v]) in f {
            if (slot as usize) < self.coarse {
                add(slot, [u, v]);
            } else if let Ok(found) = self.special.binary_search_by_key(&slot, |row| row.slot) {
                for (c, b) in &self.special[found].entries {
                    add(*c, [b[0] * u + b[2] * v, b[1] * u + b[3] * v]);
                }
            } else {
                self.parents[slot as usize - self.coarse].iter().for_each(|&p| add(p, [0.5 * u, 0.5 * v]));
            }
        }
        coarse
    }
}
