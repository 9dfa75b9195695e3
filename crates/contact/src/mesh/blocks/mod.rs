//! Triangulations of bodies made of quadrilateral blocks, whose sides may follow curves.
//!
//! ```text
//!   3 ------ 2     Cell (i, j) has the lower left node (i, j); i runs along 0 → 1, j along 0 → 3.
//!   | block  |
//!   |        |       structured    criss-cross    union-jack
//!   0 ------ 1        /  /           ><             / \      (by the parity of i + j)
//! ```

mod frame;

use super::triangulation::{Triangulation, at, mesh_error};
use crate::Error;
use crate::geometry::{Piece, Point, Segment, SharedCurve, twice_area};
use frame::Frame;

/// How each cell is cut into triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pattern {
    /// In two, by the diagonal from the lower left to the upper right node.
    Structured,
    /// In four, by both diagonals.
    CrissCross,
    /// In two, the diagonals alternating like the fields of a chessboard; cell (0, 0) is cut as in `Structured`.
    UnionJack,
    /// In two, with every other row of nodes moved by half a cell along itself, so that cells that are flat across the rows are cut
    /// into triangles with an obtuse angle. The direction counts the rows: 0 for rows one after the other along `0 → 1`, 1 along
    /// `0 → 3`. Nodes on the sides of a block stay.
    Staggered(usize),
}

/// A quadrilateral with convex corners and its division into cells.
#[derive(Clone, Debug, PartialEq)]
pub struct QuadBlock {
    /// Corners, counterclockwise.
    pub corners: [Point; 4],
    /// Cells along `0 → 1` and along `0 → 3`; at least 1.
    pub cells: [usize; 2],
    /// The curve of side `k`, from corner `k` to corner `k + 1`, or none where it is straight. Nodes divide it evenly in its
    /// parameter.
    pub curves: [Option<SharedCurve>; 4],
    /// How many times as long the last cell is as the first, along `0 → 1` and along `0 → 3`: see [`graded`].
    pub grading: [f64; 2],
}

/// Even division.
pub const EVEN: [f64; 2] = [1.0, 1.0];

/// Where the share `i/n` of a side lies that is divided with growing cells, `0 ≤ graded ≤ 1`.
///
/// `s ↦ (g^s − 1)/(g − 1)`: the cells grow by the same factor from one to the next, and near the end they are `g` times as
/// long as near the start. Since `s` enters alone, the division into `2n` cells contains that into `n`.
pub fn graded(i: usize, n: usize, grading: f64) -> f64 {
    grade(i as f64 / n as f64, grading)
}

fn grade(s: f64, grading: f64) -> f64 {
    // s itself, to the bit, where the division is even; 0 and 1 are met exactly for every g
    if grading == 1.0 || s == 1.0 { s } else { (s * grading.ln()).exp_m1() / (grading - 1.0) }
}

impl QuadBlock {
    /// A block with straight sides, evenly divided.
    pub fn straight(corners: [Point; 4], cells: [usize; 2]) -> Self {
        Self { corners, cells, curves: Default::default(), grading: EVEN }
    }

    /// Side `k`, from corner `k` to corner `k + 1`.
    pub fn side(&self, k: usize) -> Piece {
        let (a, b) = (self.corners[k], self.corners[(k + 1) % 4]);
        self.curves[k].as_ref().map_or(Piece::Straight(Segment { a, b }), |curve| Piece::on_curve(curve, a, b))
    }

    fn bilinear(&self, s: f64, t: f64) -> Point {
        let [a, b, c, d] = self.corners;
        // x = (1−s)(1−t) a + s(1−t) b + s t c + (1−s) t d
        (1.0 - s) * (1.0 - t) * a + s * (1.0 - t) * b + s * t * c + (1.0 - s) * t * d
    }

    fn map(&self) -> BlockMap<'_> {
        let curved = self.curves.iter().any(Option::is_some);
        BlockMap { block: self, sides: curved.then(|| [0, 1, 2, 3].map(|k| self.side(k))) }
    }

    fn check(&self, number: usize) -> Result<(), Error> {
        if self.cells.contains(&0) {
            return Err(mesh_error(format!(
                "block {number} is divided into {} × {} cells; give at least 1 in each direction",
                self.cells[0], self.cells[1]
            )));
        }
        if self.grading.iter().any(|g| !(g.is_finite() && *g > 0.0)) {
            return Err(mesh_error(format!(
                "block {number} has the grading {:?}; give a positive ratio of the last cell to the first in each direction",
                self.grading
            )));
        }
        let c = self.corners;
        let size = (c[2] - c[0]).norm_squared().max((c[3] - c[1]).norm_squared());
        let turns = [0, 1, 2, 3].map(|i| twice_area(c[(i + 3) % 4], c[i], c[(i + 1) % 4]));
        let bad = |&turn: &f64| turn.is_nan() || turn <= 1e-10 * size;
        let Some(i) = turns.iter().position(bad) else {
            return Ok(());
        };
        let (what, hint) = if turns.iter().all(|&turn| turn < 0.0) {
            ("runs clockwise", "list its corners in the opposite order")
        } else {
            ("is not convex", "cut it into convex blocks")
        };
        Err(mesh_error(format!(
            "block {number} {what}: at its corner {i}, {}, it turns by {:.3e}, which must exceed {:.3e}; {hint}",
            at(c[i]),
            turns[i],
            1e-10 * size
        )))
    }
}

/// The map of the unit square onto a block.
struct BlockMap<'a> {
    block: &'a QuadBlock,
    /// Its sides, if one of them is curved.
    sides: Option<[Piece; 4]>,
}

impl BlockMap<'_> {
    /// The node `(i, j)`: the image of `(s, t) = (i / cells[0], j / cells[1])`, graded.
    fn node(&self, i: usize, j: usize) -> Point {
        let [nx, ny] = self.block.cells;
        let [gx, gy] = self.block.grading;
        self.at(graded(i, nx, gx), graded(j, ny, gy))
    }

    /// The same in a staggered pattern whose rows are counted by `direction`.
    fn staggered_node(&self, i: usize, j: usize, direction: usize) -> Point {
        let cells = self.block.cells;
        let at = [i, j];
        let moved = at[direction] % 2 == 1 && (0..2).all(|d| 0 < at[d] && at[d] < cells[d]);
        let shift = |d: usize| if moved && d != direction { 0.5 } else { 0.0 };
        let share = |d: usize| grade((at[d] as f64 + shift(d)) / cells[d] as f64, self.block.grading[d]);
        self.at(share(0), share(1))
    }

    /// The middle of the cell `(i, j)`.
    fn centre(&self, i: usize, j: usize) -> Point {
        let [nx, ny] = self.block.cells.map(|n| n as f64);
        let [gx, gy] = self.block.grading;
        self.at(grade((i as f64 + 0.5) / nx, gx), grade((j as f64 + 0.5) / ny, gy))
    }

    /// Bilinear, plus for each curved side its departure from the chord, fading towards the side opposite.
    fn at(&self, s: f64, t: f64) -> Point {
        let place = self.block.bilinear(s, t);
        let Some(sides) = &self.sides else { return place };
        // side k: its own parameter, how near (s, t) is to it
        let shares = [(s, 1.0 - t), (t, s), (1.0 - s, t), (1.0 - t, 1.0 - s)];
        (0..4).fold(place, |x, k| {
            let (along, near) = shares[k];
            let (a, b) = (self.block.corners[k], self.block.corners[(k + 1) % 4]);
            match &sides[k] {
                Piece::Straight(_) => x,
                // exactly on the curve, whatever the bilinear part was rounded to
                curved if near == 1.0 => curved.point(along),
                curved => x + near * (curved.point(along) - ((1.0 - along) * a + along * b)),
            }
        })
    }
}

/// Triangulates the blocks of one body and glues them where they share whole sides. Blocks are numbered from 0.
///
/// Nodes are numbered block by block, row by row (`j` by `j`), shared ones where they come first; the centres of a criss-cross
/// follow the rows of their block. Triangles follow block by block, cell by cell, row by row.
///
/// # Errors
/// [`Error::Mesh`] if there is no block, a block has no cells, is clockwise or not convex, two blocks divide or grade a shared
/// side differently, or a corner lies within another block's side. Blocks that overlap are not looked for.
pub fn triangulate(blocks: &[QuadBlock], pattern: Pattern) -> Result<Triangulation, Error> {
    if blocks.is_empty() {
        return Err(mesh_error("a body needs at least one block".into()));
    }
    for (number, block) in blocks.iter().enumerate() {
        block.check(number)?;
    }
    check_size(blocks)?;
    let mut frame = Frame::new(blocks)?;
    let mut mesh = Triangulation::default();
    for (number, block) in blocks.iter().enumerate() {
        let map = block.map();
        let place = |i, j| match pattern {
            Pattern::Staggered(direction) => map.staggered_node(i, j, direction),
            _ => map.node(i, j),
        };
        let nodes = frame.number_nodes(number, block.cells, &place, &mut mesh.points);
        let add: fn(&mut Triangulation, &BlockMap, &[u32]) = match pattern {
            Pattern::Structured => add_structured,
            Pattern::CrissCross => add_criss_cross,
            Pattern::UnionJack => add_union_jack,
            Pattern::Staggered(0) => |mesh, map, nodes| add_staggered(mesh, map, nodes, |i, _| i),
            Pattern::Staggered(_) => |mesh, map, nodes| add_staggered(mesh, map, nodes, |_, j| j),
        };
        add(&mut mesh, &map, &nodes);
    }
    Ok(mesh)
}

fn check_size(blocks: &[QuadBlock]) -> Result<(), Error> {
    let largest = u32::MAX / 32;
    let cells = blocks.iter().map(|b| b.cells[0] as f64 * b.cells[1] as f64).sum::<f64>();
    if cells > f64::from(largest) {
        return Err(mesh_error(format!(
            "the blocks have {cells:.3e} cells together; node numbers of 32 bits reach to {largest}: use fewer"
        )));
    }
    Ok(())
}

/// The corners of each cell, row by row: lower left, lower right, upper right, upper left.
fn cells<'a>(block: &QuadBlock, nodes: &'a [u32]) -> impl Iterator<Item = (usize, usize, [u32; 4])> + use<'a> {
    let [nx, ny] = block.cells;
    let node = move |i: usize, j: usize| nodes[j * (nx + 1) + i];
    (0..ny).flat_map(move |j| {
        (0..nx).map(move |i| {
            let corners = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
            (i, j, corners)
        })
    })
}

fn add_structured(mesh: &mut Triangulation, map: &BlockMap, nodes: &[u32]) {
    for (_, _, [a, b, c, d]) in cells(map.block, nodes) {
        mesh.triangles.extend([[a, b, c], [a, c, d]]);
    }
}

fn add_union_jack(mesh: &mut Triangulation, map: &BlockMap, nodes: &[u32]) {
    for (i, j, [a, b, c, d]) in cells(map.block, nodes) {
        mesh.triangles.extend(match (i + j) % 2 {
            0 => [[a, b, c], [a, c, d]],
            _ => [[a, b, d], [b, c, d]],
        });
    }
}

/// Each cell is cut by the diagonal that makes its two triangles isosceles.
fn add_staggered(mesh: &mut Triangulation, map: &BlockMap, nodes: &[u32], row: fn(usize, usize) -> usize) {
    for (i, j, [a, b, c, d]) in cells(map.block, nodes) {
        mesh.triangles.extend(match row(i, j) % 2 {
            0 => [[a, b, d], [b, c, d]],
            _ => [[a, b, c], [a, c, d]],
        });
    }
}

fn add_criss_cross(mesh: &mut Triangulation, map: &BlockMap, nodes: &[u32]) {
    for (i, j, [a, b, c, d]) in cells(map.block, nodes) {
        let m = mesh.points.len() as u32;
        mesh.points.push(map.centre(i, j));
        mesh.triangles.extend([[a, b, m], [b, c, m], [c, d, m], [d, a, m]]);
    }
}
