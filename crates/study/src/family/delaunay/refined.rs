//! What red refinement makes of the triangles on curved sides, before it is done.
//!
//! ```text
//!            p                  Straight sides halve exactly. On the arc the new node k leaves the chord's middle, and with
//!           / \                 it move the two sides k–l and k–m; the children a, k, m and k, b, l are again triangles on
//!          m───l                the arc. All other children are halves of straight triangles.
//!         / \ / \
//!        a ─ k ─ b
//! ```

use super::chain::Loop;
use super::draft::Draft;
use super::score::COT_20;
use signorini_contact::Point;
use signorini_contact::geometry::Piece;
use signorini_contact::mesh::quality::largest_cotangent;

/// Levels that are followed. In proportion, each moves a side by half of what the one before did.
const LEVELS: u32 = 8;

/// The largest [`Lengths::spread`] to accept: the levels beyond [`LEVELS`] together move sides by less than a thousandth.
pub(super) const ROOM: f64 = 0.999;

/// Lengths over all levels, those of level `k` times `2^k`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lengths {
    /// The shortest and the longest straight side.
    pub straight: [f64; 2],
    /// The shortest and the longest chord.
    pub chord: [f64; 2],
    /// The largest cotangent of an angle in the triangles on arcs.
    pub cotangent: f64,
}

impl Lengths {
    /// The lengths of a mesh whose first nodes are those of `outline`, and of its refinements.
    pub fn of(draft: &Draft, outline: &Loop) -> Self {
        Self::up_to(LEVELS, draft, outline)
    }

    /// The same for a given number of refinements.
    pub fn up_to(levels: u32, draft: &Draft, outline: &Loop) -> Self {
        let none = [f64::INFINITY, 0.0];
        let mut lengths = Self { straight: none, chord: none, cotangent: 0.0 };
        let arcs = arcs(draft, outline);
        for [a, b] in draft.sides() {
            let on_boundary = draft.is_boundary_side(a, b);
            // The boundary side before node k + 1 starts at node k; the last one runs from n − 1 to 0.
            let starts_at = if on_boundary && b - a > 1 { b } else { a };
            if !(on_boundary && arcs[starts_at as usize].is_some()) {
                widen(&mut lengths.straight, (draft.points[a as usize] - draft.points[b as usize]).norm());
            }
        }
        let n = draft.fixed as u32;
        for &t in &draft.triangles {
            for [a, b, p] in [t, [t[1], t[2], t[0]], [t[2], t[0], t[1]]] {
                if a < n
                    && b == (a + 1) % n
                    && let Some((piece, span)) = arcs[a as usize]
                {
                    lengths.follow(piece, span, draft.corners([a, b, p]), [0, levels]);
                }
            }
        }
        lengths
    }

    /// A triangle `a, b, p` on the arc over `span`, and its children there, from one level to another.
    fn follow(&mut self, piece: &Piece, span: [f64; 2], [a, b, p]: [Point; 3], [level, last]: [u32; 2]) {
        let scale = f64::from(1 << level);
        widen(&mut self.chord, scale * (b - a).norm());
        widen(&mut self.straight, scale * (p - a).norm());
        widen(&mut self.straight, scale * (p - b).norm());
        self.cotangent = self.cotangent.max(largest_cotangent([a, b, p]));
        if level < last {
            let middle = 0.5 * (span[0] + span[1]);
            let k = piece.point(middle);
            self.follow(piece, [span[0], middle], [a, k, 0.5 * (a + p)], [level + 1, last]);
            self.follow(piece, [middle, span[1]], [k, b, 0.5 * (b + p)], [level + 1, last]);
        }
    }

    /// At most 1 if on every level no straight side is longer than the longest chord, `β ≤ 2`, and the angles on arcs are at
    /// least 20°; `chord` is the longest chord of both bodies on the coarsest level and over all levels.
    pub fn spread(&self, chord: [f64; 2]) -> f64 {
        let [low, high] = [self.straight[0].min(self.chord[0]), self.straight[1]];
        (high / chord[0]).max(0.5 * chord[1] / low).max(self.cotangent / COT_20)
    }
}

fn widen(range: &mut [f64; 2], length: f64) {
    *range = [range[0].min(length), range[1].max(length)];
}

/// For each boundary node the curved piece and the parameters of the side that starts there; `None` where it is straight.
fn arcs<'a>(draft: &Draft, outline: &'a Loop) -> Vec<Option<(&'a Piece, [f64; 2])>> {
    let sides = outline.runs.iter().flat_map(|run| {
        let share = |k: usize| k as f64 / run.steps as f64;
        let curved = run.piece.curve().is_some();
        (0..run.steps).map(move |k| curved.then(|| (&run.piece, [share(k), share(k + 1)])))
    });
    let arcs: Vec<_> = sides.collect();
    assert_eq!(arcs.len(), draft.fixed, "the outline has the boundary's nodes");
    arcs
}
