//! `TᵀAT`, row by row into its final place.

use super::pattern::{CHUNK, Rows};
use super::surroundings::Surroundings;
use crate::basis::{Basis, Slot};
use crate::element::{gradients, stiffness_block};
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
    tasks.into_par_iter().for_each(|(first, blocks)| {
        let mut rest = blocks;
        for slot in first..(first + CHUNK).min(basis.nodes()) {
            let columns = &pattern.columns[pattern.row_start[slot]..pattern.row_start[slot + 1]];
            let (row, after) = rest.split_at_mut(columns.len());
            rest = after;
            rows.gather(materials, slot, columns, row);
        }
    });
    let mut matrix = BlockMatrix { row_start: pattern.row_start, columns: pattern.columns, blocks };
    fill_fixed(&mut matrix, basis);
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
    /// Row `slot` of `TᵀAT`: `Σ T_i,slotᵀ k_ij T_j,s` over the elements around the nodes `i` that depend on the slot.
    fn gather(&self, materials: &[Material; 2], slot: usize, columns: &[u32], row: &mut [[f64; 4]]) {
        let (mesh, basis) = (self.mesh, self.basis);
        for node in self.nodes_of(slot) {
            let left = block_of_slot(basis, node, slot);
            for (t, corner) in self.around.of(node) {
                let corners = mesh.triangles[t];
                let blocks = element_row(mesh, &materials[mesh.body(t).index()], t, corner);
                let all_plain = basis.is_plain(node) && corners.iter().all(|&j| basis.is_plain(j as usize));
                for (block, &j) in blocks.iter().zip(&corners) {
                    if all_plain {
                        add_block(columns, row, j, block);
                        continue;
                    }
                    let left_block = transposed_product(&left, block);
                    let (slots, n) = basis.slots(j as usize);
                    for (column, right) in &slots[..n] {
                        add_block(columns, row, *column, &product(&left_block, right));
                    }
                }
            }
        }
        if basis.is_plain(slot) && columns.iter().all(|&j| basis.is_plain(j as usize)) {
            return;
        }
        columns.iter().zip(row).for_each(|(&column, block)| fix_components(basis, slot, column as usize, block));
    }
}

/// The diagonal entries of the fixed components.
fn fill_fixed(matrix: &mut BlockMatrix, basis: &Basis) {
    let largest_of = |row: usize| {
        let block = matrix.diagonal_block(row);
        (0..2).filter(|i| !basis.fixed[2 * row + i]).map(|i| block[3 * i]).fold(0.0, f64::max)
    };
    let rows = (0..matrix.rows()).into_par_iter().with_min_len(CHUNK);
    let largest = rows.map(largest_of).reduce(|| 0.0, f64::max);
    let entry = if largest > 0.0 { largest } else { 1.0 };
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
    [0, 1, 2].map(|k| stiffness_block(material, area, g[corner], g[k]))
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

fn product(a: &[f64; 4], b: &[f64; 4]) -> [f64; 4] {
    [a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]]
}

fn transposed_product(a: &[f64; 4], b: &[f64; 4]) -> [f64; 4] {
    product(&[a[0], a[2], a[1], a[3]], b)
}
