//! Which blocks a matrix in the changed basis has: found before the first of them is computed.

use super::surroundings::Surroundings;
use crate::basis::Basis;
use crate::mesh::Mesh;
use rayon::prelude::*;

/// Rows that one task handles.
pub(super) const CHUNK: usize = 4096;

/// Where the rows of a matrix start, and the block column of each entry.
pub(super) struct Pattern {
    pub row_start: Vec<u32>,
    pub columns: Vec<u32>,
}

/// The rows of a matrix by way of the triangles that they are gathered from.
pub(super) struct Rows<'a> {
    pub mesh: &'a Mesh,
    pub basis: &'a Basis,
    pub around: Surroundings,
}

impl Rows<'_> {
    /// The nodes whose displacement depends on a slot: itself, and its partner in a pair.
    pub fn nodes_of(&self, slot: usize) -> impl Iterator<Item = usize> + use<> {
        let partner = self.basis.pair_nodes(slot).map(|[a, b]| if a as usize == slot { b } else { a });
        std::iter::once(slot).chain(partner.map(|p| p as usize))
    }

    pub fn pattern(&self) -> Pattern {
        let nodes = self.basis.nodes();
        let parts: Vec<Part> = (0..nodes.div_ceil(CHUNK))
            .into_par_iter()
            .map(|chunk| self.part(chunk * CHUNK..((chunk + 1) * CHUNK).min(nodes)))
            .collect();
        let entries = parts.iter().map(|p| p.columns.len()).sum();
        assert!(entries <= u32::MAX as usize, "entries of a matrix are counted with 32 bits");
        let mut pattern = Pattern { row_start: Vec::with_capacity(nodes + 1), columns: Vec::with_capacity(entries) };
        pattern.row_start.push(0);
        for part in parts {
            let before = pattern.columns.len();
            pattern.row_start.extend(part.ends.iter().map(|end| (before + *end as usize) as u32));
            pattern.columns.extend(part.columns);
        }
        pattern
    }

    fn part(&self, rows: std::ops::Range<usize>) -> Part {
        let mut part = Part { ends: Vec::with_capacity(rows.len()), columns: Vec::with_capacity(8 * rows.len()) };
        let mut row = Vec::with_capacity(16);
        for slot in rows {
            row.clear();
            for node in self.nodes_of(slot) {
                for (t, _) in self.around.of(node) {
                    self.mesh.triangles[t].iter().for_each(|&j| self.add_slots(j, &mut row));
                }
            }
            row.sort_unstable();
            part.columns.extend_from_slice(&row);
            part.ends.push(part.columns.len() as u32);
        }
        part
    }

    /// The slots that the displacement of node `j` depends on, unless they are in the row.
    fn add_slots(&self, j: u32, row: &mut Vec<u32>) {
        let mut add = |slot| {
            if !row.contains(&slot) {
                row.push(slot);
            }
        };
        if self.basis.is_plain(j as usize) {
            return add(j);
        }
        let (slots, n) = self.basis.slots(j as usize);
        slots[..n].iter().for_each(|(slot, _)| add(*slot));
    }
}

/// The pattern of some consecutive rows: where each ends, and its columns.
struct Part {
    ends: Vec<u32>,
    columns: Vec<u32>,
}
