//! Delaunay meshes of one body: given boundary nodes are kept, the inside is filled with near-equilateral triangles.
//!
//! ```text
//!  boundary nodes ─► lattice ─► ( Delaunay ─► clean ─► smooth ) × rounds ─► best mesh met ─► angles checked
//!  (given, fixed)    inner nodes             too long, too short sides      of several starts
//! ```
//!
//! The connectivity is always the constrained Delaunay triangulation of the nodes, so a mesh is its nodes. Every step runs in a
//! fixed order and random numbers depend on the seed alone: the same input gives the same bytes.

use super::random::Random;
use draft::Draft;
use lattice::Start;
use score::Score;
use signorini_contact::mesh::Triangulation;
use signorini_contact::{Error, Point, Vec2};
use wish::Wish;

mod chain;
mod clean;
mod draft;
mod lattice;
mod near;
mod outline;
mod refined;
mod score;
mod smooth;
mod strong;
#[cfg(test)]
mod tests;
mod wish;

pub use chain::{BlockOutline, Loop, Run, outer_loop};
pub use strong::{Strong, strongly_regular};

/// Inner nodes that all starts together may have; decides how many starts a large mesh gets.
const WORK: usize = 60_000;

/// A triangulation of the polygon `boundary` whose sides have about the length `size(x)`.
///
/// `boundary` runs counterclockwise; its nodes become nodes `0..n` of the result unchanged, its sides are kept, and no node is
/// put on them. `size` is asked anywhere in the bounding box of the polygon. The result is constrained Delaunay, every angle is
/// at least 20°, and no triangle owns two boundary sides with more than 120° between them. A uniform size that fits the
/// boundary's sides gives a ratio of the longest to the shortest side of at most about 2.
///
/// # Errors
/// [`Error::Mesh`] for a boundary that is not a simple counterclockwise polygon or has a corner below 20°, a size that is not
/// positive and finite or asks for more than four million triangles, and where no start leads to angles of 20° or to shared blunt corners.
pub fn fill(boundary: &[Point], size: &(dyn Fn(Point) -> f64 + Sync), seed: u64) -> Result<Triangulation, Error> {
    outline::check(boundary)?;
    let wish = Wish::new(boundary, size)?;
    let (draft, score) = search(&wish, seed, starts(&wish, 24)?, [0.92, 1.06], 1.0, &|draft| Score::of(draft, &wish))?;
    score::accept(&draft, &score)?;
    Ok(draft.into())
}

/// How many starts a mesh gets: at most `most`, fewer for a large one, at least 2.
fn starts(wish: &Wish, most: usize) -> Result<usize, Error> {
    let first = Start::random(&mut Random::new(0, 0), [1.0, 1.0]);
    Ok((WORK / lattice::inner_nodes(wish, &first)?.len().max(1)).clamp(2, most))
}

/// The best mesh of several starts as `judge` sees it; the first one whose score falls to `enough` ends the search. `spacings`
/// bounds the lattice's spacing as a share of the wished length; the first start has the spacing 1.
fn search(
    wish: &Wish,
    seed: u64,
    starts: usize,
    spacings: [f64; 2],
    enough: f64,
    judge: &dyn Fn(&Draft) -> Score,
) -> Result<(Draft, Score), Error> {
    let start = |k: usize| Start::random(&mut Random::new(seed, k as u64), if k == 0 { [1.0; 2] } else { spacings });
    let mut best = from_start(wish, &start(0), judge)?;
    for k in 1..starts {
        if best.1.is_at_most(enough) {
            break;
        }
        let found = from_start(wish, &start(k), judge)?;
        if found.1 < best.1 {
            best = found;
        }
    }
    Ok(best)
}

/// Rounds of smoothing, each with its exponent (see [`smooth`]) and whether nodes are inserted and removed before it.
const ROUNDS: [(i32, bool); 22] = [
    (1, true),
    (1, true),
    (1, true),
    (2, true),
    (2, true),
    (2, true),
    (2, true),
    (2, true),
    (2, false),
    (2, true),
    (2, false),
    (3, true),
    (3, false),
    (3, true),
    (4, false),
    (4, false),
    (5, false),
    (6, false),
    (7, false),
    (8, false),
    (8, false),
    (8, false),
];

/// The best mesh met on the way from one lattice.
fn from_start(wish: &Wish, start: &Start, judge: &dyn Fn(&Draft) -> Score) -> Result<(Draft, Score), Error> {
    let points = [wish.boundary, &lattice::inner_nodes(wish, start)?].concat();
    let mut draft = Draft::new(points, wish.boundary.len())?;
    let mut best = (draft.clone(), judge(&draft));
    for (exponent, cleans) in ROUNDS {
        if cleans {
            draft = clean::clean(&draft, wish)?;
        }
        smooth::smooth(&mut draft, wish, exponent);
        draft = Draft::new(draft.points, draft.fixed)?;
        let score = judge(&draft);
        if score < best.1 {
            best = (draft.clone(), score);
        }
    }
    Ok(best)
}

/// Refuses a mesh.
fn refuse<T>(message: String) -> Result<T, Error> {
    Err(Error::Mesh(message))
}

/// A point as it appears in messages.
fn at(p: Vec2) -> String {
    format!("({}, {})", p.x, p.y)
}
