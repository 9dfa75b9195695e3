//! `TᵀAT`, row by row into its final place.

use super::pattern::{CHUNK, Pattern, Rows};
use super::shared::{KnownRows, ShapeBlocks};
use super::surroundings::Surroundings;
use crate::basis::{Basis, Slot};
use crate::element::{gradients, stiffness_row};
use crate::material::Material;
use crate::mesh::Mesh;
use crate::sparse::BlockMatrix;
use rayon::prelude::*;

/// `Tᵀ A T`; a fixed component keeps nothing but a diagonal entry, the largest of the others, so that no unit enters the matrix.
/// Where the mesh knows shapes that repeat, so do rows, and they are stored once.
pub fn stiffness(mesh: &Mesh, materials: &[Material; 2], basis: &Basis) -> BlockMatrix {
    let shapes = ShapeBlocks::new(mesh, materials);
    let rows = Rows { mesh, basis, around: Surroundings::new(mesh) };
    let Pattern { row_start, columns } = rows.pattern();
    let assembly = Assembly { rows, materials, shapes, row_start: &row_start, columns: &columns };
    let (block_start, blocks, largest) = if assembly.shapes.is_empty() {
        let (blocks, largest) = assembly.in_place();
        (Vec::new(), blocks, largest)
    } else {
        assembly.sharing()
    };
    let mut matrix = match block_start.is_empty() {
        true => BlockMatrix::new(row_start, columns, blocks),
        false => BlockMatrix::with_shared_rows(row_start, columns, block_start, blocks),
    };
    fill_fixed(&mut matrix, basis, if largest > 0.0 { largest } else { 1.0 });
    matrix
}

/// Rows on their way into a matrix.
struct Assembly<'a> {
    rows: Rows<'a>,
    materials: &'a [Material; 2],
    shapes: ShapeBlocks<'a>,
    row_start: &'a [u32],
    columns: &'a [u32],
}

impl Assembly<'_> {
    /// All blocks, each row computed where it stays; the largest diagonal entry of a component that is not fixed.
    fn in_place(&self) -> (Vec<[f64; 4]>, f64) {
        let mut blocks = vec![[0.0; 4]; self.columns.len()];
        let tasks: Vec<(usize, &mut [[f64; 4]])> = split(&mut blocks, self.row_start).collect();
        let fill = |(first, blocks): (usize, &mut [[f64; 4]])| {
            let (mut rest, mut row, mut largest) = (blocks, Vec::with_capacity(16), 0.0);
            for slot in self.chunk(first) {
                largest = self.row(slot, &mut row).max(largest);
                let (place, after) = std::mem::take(&mut rest).split_at_mut(row.len());
                place.copy_from_slice(&row);
                rest = after;
            }
            largest
        };
        let largest = tasks.into_par_iter().map(fill).reduce(|| 0.0, f64::max);
        (blocks, largest)
    }

    /// Where the blocks of each row start, the blocks, and the largest diagonal entry. Rows are compared within a chunk, so that one
    /// chunk's blocks stay in the cache while it is visited.
    fn sharing(&self) -> (Vec<u32>, Vec<[f64; 4]>, f64) {
        let nodes = self.rows.basis.nodes();
        let fill = |chunk: usize| {
            let (mut known, mut row, mut largest) = (KnownRows::default(), Vec::with_capacity(16), 0.0);
            for slot in self.chunk(chunk * CHUNK) {
                largest = self.row(slot, &mut row).max(largest);
                known.add(&row, self.is_shared(slot));
            }
            (known, largest)
        };
        let chunks: Vec<(KnownRows, f64)> = (0..nodes.div_ceil(CHUNK)).into_par_iter().map(fill).collect();
        let largest = chunks.iter().map(|(_, largest)| *largest).fold(0.0, f64::max);
        let mut start = Vec::with_capacity(nodes);
        let mut blocks = Vec::with_capacity(chunks.iter().map(|(known, _)| known.blocks.len()).sum());
        for (known, _) in chunks {
            let before = blocks.len() as u32;
            start.extend(known.start.iter().map(|s| before + s));
            blocks.extend(known.blocks);
        }
        (start, blocks, largest)
    }

    fn chunk(&self, first: usize) -> std::ops::Range<usize> {
        first..(first + CHUNK).min(self.rows.basis.nodes())
    }

    fn columns_of(&self, slot: usize) -> &[u32] {
        &self.columns[self.row_start[slot] as usize..self.row_start[slot + 1] as usize]
    }

    /// Only rows of plain nodes among plain nodes repeat; others may still be changed.
    fn is_shared(&self, slot: usize) -> bool {
        std::iter::once(&(slot as u32)).chain(self.columns_of(slot)).all(|&j| self.rows.basis.is_plain(j as usize))
    }

    /// Computes a row; its diagonal entry where the component is not fixed, where it is zero.
    fn row(&self, slot: usize, row: &mut Vec<[f64; 4]>) -> f64 {
        let columns = self.columns_of(slot);
        row.clear();
        row.resize(columns.len(), [0.0; 4]);
        if self.is_shared(slot) {
            self.gather_plain(slot, columns, row);
        } else {
            self.gather(slot, columns, row);
        }
        columns.iter().position(|&j| j as usize == slot).map_or(0.0, |k| f64::max(row[k][0], row[k][3]))
    }

    /// A row whose node and all of its neighbours are plain: `Σ k_ij` over the elements around node `i`.
    /// Elements are taken corner by corner, so that rows that repeat do so to the last bit.
    fn gather_plain(&self, node: usize, columns: &[u32], row: &mut [[f64; 4]]) {
        let Rows { mesh, around, .. } = &self.rows;
        for corner in 0..3 {
            for (t, _) in around.of(node).filter(|(_, k)| *k == corner) {
                let blocks = self.element_row(t, corner);
                for (block, &j) in blocks.iter().zip(&mesh.triangles[t]) {
                    add_block(columns, row, j, block);
                }
            }
        }
        balance(columns, node, row);
    }

    /// Row `slot` of `TᵀAT`: `Σ T_i,slotᵀ k_ij T_j,s` over the elements around the nodes `i` that depend on the slot.
    fn gather(&self, slot: usize, columns: &[u32], row: &mut [[f64; 4]]) {
        let Rows { mesh, basis, around } = &self.rows;
        for node in self.rows.nodes_of(slot) {
            let left = block_of_slot(basis, node, slot);
            for (t, corner) in around.of(node) {
                let blocks = self.element_row(t, corner);
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

    /// The blocks `k_ij` of triangle `t` for `i = corner` and its three corners `j`.
    fn element_row(&self, t: usize, corner: usize) -> [[f64; 4]; 3] {
        let mesh = self.rows.mesh;
        if let Some(blocks) = self.shapes.of(t) {
            return blocks[corner];
        }
        let material = &self.materials[mesh.body(t).index()];
        if let Some(curved) = mesh.curved_triangle(t) {
            return curved.stiffness_row(material, corner);
        }
        let (g, area) = gradients(mesh.corners(t));
        stiffness_row(material, area, &g, corner)
    }
}

/// The blocks of each `CHUNK` rows with the first of these rows.
fn split<'a>(blocks: &'a mut [[f64; 4]], row_start: &[u32]) -> impl Iterator<Item = (usize, &'a mut [[f64; 4]])> {
    let mut rest = blocks;
    let rows = row_start.len() - 1;
    (0..rows).step_by(CHUNK).map(move |first| {
        let entries = (row_start[(first + CHUNK).min(rows)] - row_start[first]) as usize;
        let (chunk, after) = std::mem::take(&mut rest).split_at_mut(entries);
        rest = after;
        (first, chunk)
    })
}

/// The diagonal entries of the fixed components.
fn fill_fixed(matrix: &mut BlockMatrix, basis: &Basis, entry: f64) {
    for row in (0..matrix.rows()).filter(|row| basis.fixed[2 * row] || basis.fixed[2 * row + 1]) {
        let Some(k) = matrix.columns_of(row).iter().position(|&j| j as usize == row) else { continue };
        for i in (0..2).filter(|i| basis.fixed[2 * row + i]) {
            matrix.block_mut(row, k)[3 * i] = entry;
        }
    }
}

fn block_of_slot(basis: &Basis, node: usize, slot: usize) -> [f64; 4] {
    let (slots, n) = basis.slots(node);
    let of_slot = |s: &&Slot| s.0 as usize == slot;
    slots[..n].iter().find(of_slot).map_or([0.0; 4], |s| s.1)
}

/// `k_ii = −Σ k_ij`, so that a translation calls up no force. Rows that repeat round alike: what is left of a translation in one is left
/// in all, and adds up like a load.
fn balance(columns: &[u32], node: usize, row: &mut [[f64; 4]]) {
    let Some(own) = columns.iter().position(|&j| j as usize == node) else { return };
    row[own] = [0.0; 4];
    let sum = row.iter().fold([0.0; 4], |sum, b| std::array::from_fn(|k| sum[k] + b[k]));
    row[own] = sum.map(|s| -s);
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
