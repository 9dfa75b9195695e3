//! How good a mesh is, and whether it may be handed out.

use super::draft::Draft;
use super::wish::Wish;
use super::{at, refuse};
use signorini_contact::geometry::tangent_of;
use signorini_contact::mesh::quality::largest_cotangent;
use signorini_contact::{Error, Point, Vec2};

/// cot 20°: the bound on angles. Literals, because trigonometry differs between machines in the last bit.
pub(super) const COT_20: f64 = 2.747_477_419_454_621_6;

/// cot 26°: the angle to aim at.
const COT_26: f64 = 2.050_303_841_579_296_3;

/// cos 75° and cos 120°, the corners from which on a triangle should not, and must not, own both sides.
const COS_75: f64 = 0.258_819_045_102_520_74;
const COS_120: f64 = -0.5;

/// A mesh's faults, the gravest first; less is better.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(super) struct Score {
    /// Triangles with an angle below 20° or with both sides of a blunt corner.
    pub forbidden: usize,
    /// Triangles with three boundary nodes that a further node could avoid.
    pub bridges: usize,
    /// At most 1 if every side is within a factor `√2` of its wished length, and every angle at least 26°.
    pub spread: f64,
}

impl Score {
    pub fn of(draft: &Draft, wish: &Wish) -> Self {
        let (mut forbidden, mut bridges, mut cotangent) = (0, 0, 0.0);
        for &t in &draft.triangles {
            let worst = largest_cotangent(draft.corners(t));
            let fault = fault(draft, t);
            forbidden += usize::from(worst > COT_20 || matches!(fault, Fault::Corner { blunt: true, .. }));
            bridges += usize::from(fault != Fault::None);
            cotangent = f64::max(cotangent, worst);
        }
        Self { forbidden, bridges, spread: side_spread(draft, wish).max(cotangent / COT_26) }
    }

    /// Whether nothing is left to improve beyond `spread`.
    pub fn is_at_most(&self, spread: f64) -> bool {
        self.forbidden == 0 && self.bridges == 0 && self.spread <= spread
    }
}

/// `max(l/s, s/l)/√2` over all inner sides.
fn side_spread(draft: &Draft, wish: &Wish) -> f64 {
    let sizes: Vec<f64> = draft.points.iter().map(|&p| wish.size(p)).collect();
    let inner = draft.sides().filter(|&[a, b]| !draft.is_boundary_side(a, b));
    let spread = |[a, b]: [u32; 2]| {
        let [a, b] = [a as usize, b as usize];
        let share = (draft.points[a] - draft.points[b]).norm() / (0.5 * (sizes[a] + sizes[b]));
        share.max(1.0 / share)
    };
    inner.map(spread).fold(0.0, f64::max) / std::f64::consts::SQRT_2
}

/// What is wrong with a triangle whose three nodes are on the boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Fault {
    /// Nothing, or unavoidable.
    None,
    /// It reaches across the body.
    Across,
    /// It owns both sides at a corner of more than 75°.
    Corner {
        /// The corner.
        node: u32,
        /// Whether the corner has more than 120°.
        blunt: bool,
        /// From the corner into the body, across to the triangle's third side, half as long as the corner's two sides together.
        inward: Vec2,
    },
}

/// Looks at the boundary sides of a triangle.
pub(super) fn fault(draft: &Draft, triangle: [u32; 3]) -> Fault {
    let n = draft.fixed as u32;
    if triangle.iter().any(|&i| i >= n) {
        return Fault::None;
    }
    let turns = [0, 1, 2].map(|k| [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]]);
    let owned = turns.into_iter().filter(|&[before, node, after]| (before + 1) % n == node && (node + 1) % n == after);
    let corners = owned.map(|[before, node, after]| (node, draft.corners([before, node, after])));
    // The bluntest corner, where a small polygon is one triangle.
    let cosine = |[p, x, q]: [Point; 3]| (p - x).normalize().dot(&(q - x).normalize());
    match corners.min_by(|a, b| cosine(a.1).total_cmp(&cosine(b.1))) {
        None => Fault::Across,
        Some((_, sides)) if cosine(sides) >= COS_75 => Fault::None,
        Some((node, sides @ [p, x, q])) => {
            // Turned counterclockwise from the direction of the boundary: to the body's side.
            let inward = 0.5 * ((p - x).norm() + (q - x).norm()) * tangent_of((q - p).normalize());
            Fault::Corner { node, blunt: cosine(sides) < COS_120 - 1e-12, inward }
        }
    }
}

/// Refuses a mesh with forbidden triangles.
///
/// # Errors
/// [`Error::Mesh`] with the place and the angle of the worst triangle.
pub(super) fn accept(draft: &Draft, score: &Score) -> Result<(), Error> {
    if score.forbidden == 0 {
        return Ok(());
    }
    let place = |t: [u32; 3]| draft.corners(t).iter().sum::<Vec2>() / 3.0;
    let cotangent = |t: &[u32; 3]| largest_cotangent(draft.corners(*t));
    let blunt = |t: &&[u32; 3]| matches!(fault(draft, **t), Fault::Corner { blunt: true, .. });
    if let Some(&t) = draft.triangles.iter().find(blunt) {
        return refuse(format!(
            "the triangle at {} owns both boundary sides of a corner of more than 120°, where it would be flat; give the \
             boundary shorter sides there or ask for shorter sides inside",
            at(place(t))
        ));
    }
    let worst = draft.triangles.iter().copied().max_by(|a, b| cotangent(a).total_cmp(&cotangent(b))).unwrap_or([0; 3]);
    refuse(format!(
        "the best Delaunay mesh still has an angle of {:.1}°, in the triangle at {}, below the bound of 20°; let the wished \
         length fit the boundary's sides there, or take another seed",
        f64::atan2(1.0, cotangent(&worst)).to_degrees(),
        at(place(worst))
    ))
}
