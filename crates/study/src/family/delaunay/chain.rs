//! The boundary of a body as a closed chain of divided pieces.
//!
//! ```text
//!     ┌────2────┐
//!     3  block  1      side k runs from corner k to corner k + 1, the block on its left;
//!     └────0────┘      sides 0 and 2 carry cells[0] cells, sides 1 and 3 carry cells[1]
//! ```

use super::{at, refuse};
use signorini_contact::geometry::Piece;
use signorini_contact::{Error, Point};

/// A piece of the boundary and the number of equal parameter steps that its nodes divide it into.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The piece, the body on its left.
    pub piece: Piece,
    /// Sides of the mesh on it, at least 1.
    pub steps: usize,
}

impl Run {
    /// The nodes from the first end on, without the last.
    pub fn nodes(&self) -> impl Iterator<Item = Point> + '_ {
        (0..self.steps).map(|k| self.piece.point(k as f64 / self.steps as f64))
    }
}

/// A closed chain of pieces, each starting where the one before it ends, the body on the left.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// The pieces in order.
    pub runs: Vec<Run>,
}

impl Loop {
    /// The boundary nodes, counterclockwise.
    pub fn nodes(&self) -> Vec<Point> {
        self.runs.iter().flat_map(Run::nodes).collect()
    }

    /// The shortest and the longest chord on curved pieces; `None` if all are straight.
    pub fn chords(&self) -> Option<[f64; 2]> {
        let curved = self.runs.iter().filter(|r| r.piece.curve().is_some());
        let ends = |r: &Run| r.nodes().chain([r.piece.point(1.0)]).collect::<Vec<_>>();
        let chords = curved.flat_map(|r| ends(r).windows(2).map(|w| (w[1] - w[0]).norm()).collect::<Vec<_>>());
        chords.fold(None, |range: Option<[f64; 2]>, c| Some(range.map_or([c, c], |[l, u]| [l.min(c), u.max(c)])))
    }
}

/// The sides of a quadrilateral block, counterclockwise, and the cells along sides 0, 2 and along sides 1, 3.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockOutline {
    /// The sides.
    pub sides: [Piece; 4],
    /// Cells in the two directions.
    pub cells: [usize; 2],
}

/// Ends nearer than this share of the body's extent are one corner.
const SAME: f64 = 1e-10;

/// The sides that belong to one block only, in a chain that starts with the first outer side of the first block that has one.
/// Each is divided into its block's cells.
///
/// # Errors
/// [`Error::Mesh`] for no blocks, a side without cells, sides that do not close up (blocks must share whole sides), a body that
/// touches itself in a corner, and one with holes or in several parts.
pub fn outer_loop(blocks: &[BlockOutline]) -> Result<Loop, Error> {
    let sides = all_sides(blocks)?;
    let tolerance = SAME * extent(&sides);
    let mut outer = outer_sides(sides, tolerance);
    if outer.is_empty() {
        return refuse("the body has no blocks, so no boundary; give it at least one".into());
    }
    let mut chain = vec![outer.remove(0)];
    loop {
        let end = chain[chain.len() - 1].piece.point(1.0);
        let follows: Vec<usize> =
            (0..outer.len()).filter(|&k| (outer[k].piece.point(0.0) - end).norm() <= tolerance).collect();
        let closes = (chain[0].piece.point(0.0) - end).norm() <= tolerance;
        match (&follows[..], closes) {
            (&[k], false) => chain.push(outer.remove(k)),
            ([], true) => break,
            ([], false) => {
                return refuse(format!(
                    "the boundary of the body stops at {}; blocks must share whole sides: divide the larger block",
                    at(end)
                ));
            }
            _ => {
                return refuse(format!(
                    "the body touches itself at {}, where more than two outer sides meet; join the blocks by a side or \
                     move them apart",
                    at(end)
                ));
            }
        }
    }
    match outer.first() {
        None => Ok(Loop { runs: chain }),
        Some(left) => refuse(format!(
            "the body has a second boundary, through {}: a hole or a separate part; a Delaunay mesh needs one loop: cut the \
             body into several",
            at(left.piece.point(0.5))
        )),
    }
}

fn all_sides(blocks: &[BlockOutline]) -> Result<Vec<Run>, Error> {
    let mut sides = Vec::new();
    for (b, block) in blocks.iter().enumerate() {
        for (k, piece) in block.sides.iter().enumerate() {
            let steps = block.cells[k % 2];
            if steps == 0 {
                return refuse(format!("side {k} of block {b} has no cells; give it at least one"));
            }
            sides.push(Run { piece: piece.clone(), steps });
        }
    }
    Ok(sides)
}

fn extent(sides: &[Run]) -> f64 {
    let from = sides.first().map_or(Point::zeros(), |s| s.piece.point(0.0));
    sides.iter().map(|s| (s.piece.point(0.0) - from).norm()).fold(0.0, f64::max)
}

/// Sides without a twin that runs the other way. Blocks are few, so all pairs are compared.
fn outer_sides(sides: Vec<Run>, tolerance: f64) -> Vec<Run> {
    let places = |run: &Run| [0.0, 0.5, 1.0].map(|t| run.piece.point(t));
    let all: Vec<_> = sides.iter().map(places).collect();
    let twins = |a: &[Point; 3], b: &[Point; 3]| (0..3).all(|k| (a[k] - b[2 - k]).norm() <= tolerance);
    let is_outer = |k: usize| !all.iter().enumerate().any(|(j, b)| j != k && twins(&all[k], b));
    let keep: Vec<bool> = (0..all.len()).map(is_outer).collect();
    sides.into_iter().zip(keep).filter(|(_, keep)| *keep).map(|(side, _)| side).collect()
}
