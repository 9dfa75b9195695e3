//! Meshes of bodies with curved sides that are strongly regular with `β = 2`, no straight side longer than the longest chord,
//! and stay so under red refinement.
//!
//! With `c` the longest chord on the curved sides of *both* bodies, every side gets a length between `c/2` and `c`: chords
//! are given and near `c`, straight boundary pieces are divided into steps near `c/√2`, and the inside is filled with
//! sides of about `c/√2`, the geometric mean of the bounds. Refinement halves straight sides exactly, chords a little less than
//! exactly, and it moves the sides that end on an arc; the search for a mesh looks at all levels at once ([`Lengths`]).

use super::chain::{Loop, Run};
use super::draft::Draft;
use super::refined::{Lengths, ROOM};
use super::score::{Score, accept};
use super::wish::Wish;
use super::{outline, refuse, search, starts};
use signorini_contact::mesh::Triangulation;
use signorini_contact::{Error, Point};

/// A mesh of one body and its boundary.
#[derive(Clone, Debug)]
pub struct Strong {
    /// The boundary with the steps chosen for straight pieces; its nodes are the first of the mesh.
    pub outline: Loop,
    /// The mesh.
    pub triangulation: Triangulation,
    /// The shortest and the longest side, chords of curved sides included.
    pub sides: [f64; 2],
}

/// The largest of all ratios to their bounds at which the search stops; below 1 is enough.
const ENOUGH: f64 = 0.97;

/// Most starts for a body.
const STARTS: usize = 100;

/// Meshes of both bodies with `c/2 ≤ side ≤ c`, `c` the longest chord on the curved pieces of either outline, such that the same
/// holds on every level of their red refinement with new nodes in the middle of the arcs' parameters. Curved pieces keep their
/// steps, straight ones are divided anew: equally in both bodies where they share a piece.
///
/// # Errors
/// [`Error::Mesh`] if no piece is curved, chords differ by more than a factor of 2, a straight piece is shorter than `c/2`, no
/// start reaches the bounds, and whatever [`fill`](super::fill) refuses.
pub fn strongly_regular(outlines: [&Loop; 2], seed: u64) -> Result<[Strong; 2], Error> {
    let ranges: Vec<_> = outlines.iter().filter_map(|o| chords(o)).collect();
    let Some(&first) = ranges.first() else {
        return refuse(
            "no side of the bodies is curved, so there is no longest chord; use a plain Delaunay mesh".into(),
        );
    };
    let [low, high, limit] = ranges[1..].iter().fold(first, |a, b| [a[0].min(b[0]), a[1].max(b[1]), a[2].max(b[2])]);
    if low < 0.5 * limit {
        return refuse(format!(
            "the chords on curved sides reach from {low} to {high}, more than a factor of 2; divide the curves more evenly"
        ));
    }
    let [first, second] = outlines.map(|o| one_body(o, [high, limit], seed));
    Ok([first?, second?])
}

/// The shortest and the longest chord, and the longest that refinement makes of a chord, times `2^k`.
fn chords(outline: &Loop) -> Option<[f64; 3]> {
    let [low, high] = outline.chords()?;
    let fine = outline.runs.iter().map(|r| Run { steps: r.steps << 8, ..r.clone() }).collect();
    let [_, limit] = Loop { runs: fine }.chords()?;
    Some([low, high, f64::max(high, limit * 256.0)])
}

/// `chord`: the longest chord of the coarse mesh, and of all its refinements.
fn one_body(outline: &Loop, chord: [f64; 2], seed: u64) -> Result<Strong, Error> {
    let outline = divide(outline, chord[0])?;
    let boundary = outline.nodes();
    outline::check(&boundary)?;
    let size = chord[0] / std::f64::consts::SQRT_2;
    let wished = move |_: Point| size;
    let wish = Wish::new(&boundary, &wished)?;
    let judge = |draft: &Draft| {
        let score = Score::of(draft, &wish);
        Score { spread: score.spread.max(Lengths::of(draft, &outline).spread(chord)), ..score }
    };
    let (draft, score) = search(&wish, seed, starts(&wish, STARTS)?, [0.85, 1.35], ENOUGH, &judge)?;
    accept(&draft, &score)?;
    let sides = within_bounds(&draft, &Lengths::of(&draft, &outline), chord)?;
    Ok(Strong { outline, triangulation: draft.into(), sides })
}

/// Steps of straight pieces: those nearest to `c/√2` in ratio.
pub(super) fn divide(outline: &Loop, chord: f64) -> Result<Loop, Error> {
    let mut outline = outline.clone();
    for run in outline.runs.iter_mut().filter(|r| r.piece.curve().is_none()) {
        let length = run.piece.length();
        if length < 0.5 * chord {
            let [a, b] = [0.0, 1.0].map(|t| super::at(run.piece.point(t)));
            return refuse(format!(
                "the straight side from {a} to {b} has the length {length}, less than half of the longest chord {chord}; \
                 divide the curved sides into more steps"
            ));
        }
        run.steps = steps(length / chord);
    }
    Ok(outline)
}

/// The `k` that brings `q/k` nearest to `1/√2` in ratio: the smallest with `q/k · q/(k+1) ≤ ½`. Rounding cannot change it
/// between two bodies unless they tie to the last digits, where the smaller one is taken.
fn steps(quotient: f64) -> usize {
    (1..).find(|&k| 2.0 * quotient * quotient <= (k * (k + 1)) as f64 * (1.0 + 1e-9)).unwrap_or(1)
}

fn within_bounds(draft: &Draft, lengths: &Lengths, chord: [f64; 2]) -> Result<[f64; 2], Error> {
    if lengths.spread(chord) <= ROOM {
        let sides = draft.sides().map(|[a, b]| (draft.points[a as usize] - draft.points[b as usize]).norm());
        return Ok(sides.fold([f64::INFINITY, 0.0], |[l, u], s| [f64::min(l, s), f64::max(u, s)]));
    }
    let [low, high] = lengths.straight;
    refuse(format!(
        "the best mesh has straight sides from {:.3} to {:.3} of the longest chord, refinements included, and strong regularity \
         asks for {:.3} to 1; divide the curved sides into more steps or take another seed",
        low / chord[0],
        high / chord[0],
        0.5 * chord[1] / chord[0]
    ))
}
