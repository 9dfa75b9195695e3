//! The corners and sides of all blocks, each once: where blocks are glued.

use super::{QuadBlock, at, mesh_error};
use crate::Error;
use crate::geometry::{Point, Segment};

/// Corners and sides shared by the blocks, with the nodes on them as they get their numbers.
pub(super) struct Frame {
    corners: Vec<Corner>,
    sides: Vec<Side>,
    /// Corner numbers of each block.
    block_corners: Vec<[usize; 4]>,
    /// Side numbers of each block; side `k` runs from corner `k` to corner `k + 1`.
    block_sides: Vec<[usize; 4]>,
}

struct Corner {
    at: Point,
    node: Option<u32>,
}

struct Side {
    /// Corner numbers, lower first.
    ends: [usize; 2],
    /// The block that came first.
    block: usize,
    /// Its last cell over its first, from the lower end.
    grading: f64,
    /// Nodes strictly between the ends, from the lower end.
    nodes: Vec<Option<u32>>,
}

/// Share of a block's size within which two corners are one.
const TOLERANCE: f64 = 1e-10;

impl Frame {
    /// Merges equal corners and sides. Quadratic in the number of blocks.
    pub fn new(blocks: &[QuadBlock]) -> Result<Self, Error> {
        let size = |b: &QuadBlock| (b.corners[2] - b.corners[0]).norm();
        let tolerance = TOLERANCE * blocks.iter().map(size).fold(0.0, f64::max);
        let mut frame =
            Self { corners: Vec::new(), sides: Vec::new(), block_corners: Vec::new(), block_sides: Vec::new() };
        for (number, block) in blocks.iter().enumerate() {
            let corners = block.corners.map(|x| frame.corner(x, tolerance));
            let mut sides = [0; 4];
            for k in 0..4 {
                // sides 2 and 3 run against the block's own directions
                let grading = if k < 2 { block.grading[k] } else { block.grading[k - 2].recip() };
                sides[k] = frame.side([corners[k], corners[(k + 1) % 4]], number, block.cells[k % 2], grading)?;
            }
            frame.block_corners.push(corners);
            frame.block_sides.push(sides);
        }
        frame.check_whole_sides(tolerance)?;
        Ok(frame)
    }

    fn corner(&mut self, x: Point, tolerance: f64) -> usize {
        let known = self.corners.iter().position(|c| (c.at - x).norm() <= tolerance);
        known.unwrap_or_else(|| {
            self.corners.push(Corner { at: x, node: None });
            self.corners.len() - 1
        })
    }

    fn side(&mut self, [a, b]: [usize; 2], block: usize, cells: usize, grading: f64) -> Result<usize, Error> {
        let ends = [a.min(b), a.max(b)];
        let grading = if a < b { grading } else { grading.recip() };
        let Some(known) = self.sides.iter().position(|s| s.ends == ends) else {
            self.sides.push(Side { ends, block, grading, nodes: vec![None; cells - 1] });
            return Ok(self.sides.len() - 1);
        };
        let other = &self.sides[known];
        if other.nodes.len() + 1 != cells {
            return Err(mesh_error(format!(
                "blocks {} and {block} share the side from {} to {} but divide it into {} and {cells} cells; give them \
                 the same divisions there",
                other.block,
                at(self.corners[ends[0]].at),
                at(self.corners[ends[1]].at),
                other.nodes.len() + 1
            )));
        }
        if (grading / other.grading - 1.0).abs() > TOLERANCE {
            return Err(mesh_error(format!(
                "blocks {} and {block} share the side from {} to {} but grade it by {} and {grading}; give them the same \
                 grading there, its inverse where their directions differ",
                other.block,
                at(self.corners[ends[0]].at),
                at(self.corners[ends[1]].at),
                other.grading
            )));
        }
        Ok(known)
    }

    fn check_whole_sides(&self, tolerance: f64) -> Result<(), Error> {
        for side in &self.sides {
            let [a, b] = side.ends.map(|c| self.corners[c].at);
            let segment = Segment { a, b };
            let within = |c: &usize| !side.ends.contains(c) && segment.distance(self.corners[*c].at) <= tolerance;
            if let Some(c) = (0..self.corners.len()).find(within) {
                let owner = self.block_corners.iter().position(|b| b.contains(&c));
                return Err(mesh_error(format!(
                    "the corner {} of block {} lies within the side of block {} from {} to {}; blocks may share whole \
                     sides only: cut block {} there",
                    at(self.corners[c].at),
                    owner.unwrap_or(side.block),
                    side.block,
                    at(a),
                    at(b),
                    side.block
                )));
            }
        }
        Ok(())
    }

    /// The node numbers of block `number`, row by row; new nodes are appended to `points`, `place(i, j)` says where.
    pub fn number_nodes(
        &mut self,
        number: usize,
        cells: [usize; 2],
        place: &dyn Fn(usize, usize) -> Point,
        points: &mut Vec<Point>,
    ) -> Vec<u32> {
        let [nx, ny] = cells;
        let mut nodes = Vec::with_capacity((nx + 1) * (ny + 1));
        for j in 0..=ny {
            for i in 0..=nx {
                let mut append = || {
                    points.push(place(i, j));
                    points.len() as u32 - 1
                };
                nodes.push(match self.shared(number, cells, i, j) {
                    Some(slot) => *slot.get_or_insert_with(append),
                    None => append(),
                });
            }
        }
        nodes
    }

    /// The entry of node `(i, j)` of a block if it lies on the block's boundary.
    fn shared(&mut self, block: usize, [nx, ny]: [usize; 2], i: usize, j: usize) -> Option<&mut Option<u32>> {
        // Which side the node lies on, and how many cells from the side's first corner.
        let (k, place) = match (i, j) {
            (_, 0) if i < nx => (0, i),
            (_, _) if i == nx && j < ny => (1, j),
            (_, _) if j == ny && i > 0 => (2, nx - i),
            (0, _) => (3, ny - j),
            _ => return None,
        };
        let corners = self.block_corners[block];
        let (from, to) = (corners[k], corners[(k + 1) % 4]);
        if place == 0 {
            return Some(&mut self.corners[from].node);
        }
        let inner = &mut self.sides[self.block_sides[block][k]].nodes;
        let from_lower = if from < to { place - 1 } else { inner.len() - place };
        Some(&mut inner[from_lower])
    }
}
