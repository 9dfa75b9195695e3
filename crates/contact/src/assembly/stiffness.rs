//! `TᵀAT`, row by row into its final place.

use super::pattern::{CHUNK, Pattern, Rows};
use super::surroundings::Surroundings;
use crate::basis::{Basis, Slot};
use crate::element::{gradients, stiffness_row};
use crate::material::Material;
use crate::mesh::Mesh;
use crate::sparse::BlockMatrix;
use rayon::prelude::*;

/// `Tᵀ A T`; a fixed component keeps nothing but a diagonal entry, the largest of the others, so that no unit enters the matrix.
pub fn stiffness(mesh: &Mesh, materials: &[Material; 2], basis: &Basis) -> BlockMatrix {
    let rows = Rows { mesh, basis, around: Surroundings::new(mesh) };
    let pattern = rows.pattern();
    let mut blocks = vec![[0.0; 4]; pattern.columns.len()];
    let tasks: Vec<(usize, &mut [[f64; 4]])> = split(&mut blocks, &pattern.row_start).collect();
    let fill = |(first, blocks)| rows.fill(materials, &pattern, first, blocks);
    let largest = tasks.into_par_iter().map(fill).reduce(|| 0.0, f64::max);
    let mut matrix = BlockMatrix { row_start: pattern.row_start, columns: pattern.columns, blocks };
    fill_fixed(&mut matrix, basis, if largest > 0.0 { largest } else { 1.0 });
    matrix
}

/// The blocks of each `CHUNK` rows with the first of these rows.
fn split<'a>(blocks: &'a mut [[f64; 4]], row_start: &[usize]) -> impl Iterator<Item = (usize, &'a mut [[f64; 4]])> {
    let mut rest = blocks;
    let rows = row_start.len() - 1;
    (0..rows).step_by(CHUNK).map(move |first| {
        let entries = row_start[(first + CHUNK).min(rows)] - row_start[first];
        let (chunk, after) = std::mem::take(&mut rest).split_at_mut(entries);
        rest = after;
        (first, chunk)
    })
}

impl Rows<'_> {
    /// Computes `CHUNK` rows from `first` on; their largest diagonal entry of a component that is not fixed.
    fn fill(&self, materials: &[Material; 2], pattern: &Pattern, first: usize, blocks: &mut [[f64; 4]]) -> f64 {
        let (mut rest, mut largest) = (blocks, 0.0);
        let mut row = Vec::with_capacity(16);
        for slot in first..(first + CHUNK).min(self.basis.nodes()) {
            let columns = &pattern.columns[pattern.row_start[slot]..pattern.row_start[slot + 1]];
            row.clear();
            row.resize(columns.len(), [0.0; 4]);
            if std::iter::once(&(slot as u32)).chain(columns).all(|&j| self.basis.is_plain(j as usize)) {
                self.gather_plain(materials, slot, columns, &mut row);
            } else {
                self.gather(materials, slot, columns, &mut row);
            }
            if let Some(k) = columns.iter().position(|&j| j as usize == slot) {
                // A fixed component has a zero here.
                largest = row[k][0].max(row[k][3]).max(largest);
            }
            let (place, after) = rest.split_at_mut(columns.len());
            place.copy_from_slice(&row);
            rest = after;
        }
        largest
    }

    /// A row whose node and all of its neighbours are plain: `Σ k_ij` over the elements around node `i`.
    fn gather_plain(&self, materials: &[Material; 2], node: usize, columns: &[u32], row: &mut [[f64; 4]]) {
        for (t, corner) in self.around.of(node) {
            let blocks = element_row(self.mesh, &materials[self.mesh.body(t).index()], t, corner);
            for (block, &j) in blocks.iter().zip(&self.mesh.triangles[t]) {
                add_block(columns, row, j, block);
            }
        }
    }

    /// Row `slot` of `TᵀAT`: `Σ T_i,slotᵀ k_ij T_j,s` over the elements around the nodes `i` that depend on the slot.
    fn gather(&self, materials: &[Material; 2], slot: usize, columns: &[u32], row: &mut [[f64; 4]]) {
        let (mesh, basis) = (self.mesh, self.basis);
        for node in self.nodes_of(slot) {
            let left = block_of_slot(basis, node, slot);
            for (t, corner) in self.around.of(node) {
                let blocks = element_row(mesh, &materials[mesh.body(t).index()], t, corner);
                for (block, &j) in blocks.iter().zip(&mesh.triangles[t]) {
                    let left_block = transposed_product(&left, block);
                    let (slots, n) = basis.slots(j as usize);
                    for (column, right) in &slots[..n] {
                        add_block(columns, row, *column, &product(&left_block, right));
                    }
                }
            }
        }
        columns.iter().zip(row).for_each(|(&column, block)| fix_components(basis, slot, column as usize, block));
    }
}

/// The diagonal entries of the fixed components.
fn fill_fixed(matrix: &mut BlockMatrix, basis: &Basis, entry: f64) {
    for row in (0..matrix.rows()).filter(|row| basis.fixed[2 * row] || basis.fixed[2 * row + 1]) {
        let stored = matrix.row_start[row]..matrix.row_start[row + 1];
        let Some(k) = stored.into_iter().find(|&k| matrix.columns[k] as usize == row) else { continue };
        for i in (0..2).filter(|i| basis.fixed[2 * row + i]) {
            matrix.blocks[k][3 * i] = entry;
        }
    }
}

/// The blocks `k_ij` of triangle `t` for `i = corner` and its three corners `j`.
fn element_row(mesh: &Mesh, material: &Material, t: usize, corner: usize) -> [[f64; 4]; 3] {
    if let Some(curved) = mesh.curved_triangle(t) {
        return curved.stiffness_row(material, corner);
    }
    let (g, area) = gradients(mesh.corners(t));
    stiffness_row(material, area, &g, corner)
}

fn block_of_slot(basis: &Basis, node: usize, slot: usize) -> [f64; 4] {
    let (slots, n) = basis.slots(node);
    let of_slot = |s: &&Slot| s.0 as usize == slot;
    slots[..n].iter().find(of_slot).map_or([0.0; 4], |s| s.1)
}

/// Adds to the block in `column`, which the row has.
fn add_block(columns: &[u32], row: &mut [[f64; 4]], column: u32, block: &[f64; 4]) {
    if let Some(sum) = columns.iter().position(|&c| c == column).map(|k| &mut row[k]) {
        (0..4).for_each(|k| sum[k] += block[k]);
    }
}

/// Zero where the row's or the column's component is fixed.
fn fix_components(basis: &Basis, row: usize, column: usize, block: &mut [f64; 4]) {
    for (entry, value) in block.iter_mut().enumerate() {
        let (i, j) = (2 * row + entry / 2, 2 * column + entry % 2);
        if basis.fixed[i] || basis.fixed[j] {
            *value = 0.0;
        }
    }
}

pub(crate) fn product(a: &[f64; 4], b: &[f64; 4]) -> [f64; 4] {
    [a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]]
}

fn transposed_product(a: &[f64; 4], b: &[f64; 4]) -> [f64; 4] {
    product(&[a[0], a[2], a[1], a[3]], b)
}
