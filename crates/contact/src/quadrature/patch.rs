//! Quadrature over triangles with a curved side, and along curved sides, graded towards singular points.
//!
//! Patches are rectangles of the coordinates `(ρ, τ)` of the element. Breaks are not cut: near the zone what jumps across
//! them is small, and an adaptive rule finds them.

use super::{Cubature, SIDE_FLOOR, TRIANGLE_FLOOR};
use crate::element::{CurvedTriangle, ElementPoint};
use crate::geometry::{Piece, Point, Segment, cross, twice_area};
use crate::quadrature::GAUSS_8;

/// Pieces of a curved side are not divided below this length: nearer to a singular point the rounding of coordinates, of the size of
/// the bodies, decides where a quadrature point lies, and it may fall on the singular point itself.
const CURVE_FLOOR: f64 = 1e-12;

/// A rectangle of the coordinates `(ρ, τ)` of a curved triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// From the apex (0) to the arc (1).
    pub rho: [f64; 2],
    /// Along the arc.
    pub tau: [f64; 2],
}

impl Patch {
    /// The whole triangle.
    pub const WHOLE: Self = Self { rho: [0.0, 1.0], tau: [0.0, 1.0] };

    /// The four halves of halves.
    pub fn quarter(&self) -> [Self; 4] {
        let halves = |[a, b]: [f64; 2]| [[a, 0.5 * (a + b)], [0.5 * (a + b), b]];
        let ([r0, r1], [t0, t1]) = (halves(self.rho), halves(self.tau));
        [(r0, t0), (r0, t1), (r1, t0), (r1, t1)].map(|(rho, tau)| Self { rho, tau })
    }

    /// The places of its corners, in order around it.
    fn corners(&self, triangle: &CurvedTriangle) -> [Point; 4] {
        let ([r0, r1], [t0, t1]) = (self.rho, self.tau);
        // ρ = 0 is one point, and the isoparametric map has no limit trouble there
        [(r0, t0), (r1, t0), (r1, t1), (r0, t1)].map(|(rho, tau)| triangle.at(rho, tau).x)
    }
}

/// A piece is no longer than this many chords; what is farther from its start cannot lie on it.
const LONGEST: f64 = 8.0;

/// A cut nearer to an end than this share of the piece is that end: the points of what it cuts off would round to the singular point
/// itself.
const SLIVER: f64 = 1e-11;

impl Cubature {
    /// Calls `visit(point, weight)` at the quadrature points of a triangle with a curved side, 64 for each patch.
    pub fn curved(&self, triangle: &CurvedTriangle, visit: &mut impl FnMut(&ElementPoint, f64)) {
        self.patches(triangle, &mut |patch| {
            split(patch, self.depth, &mut |p| triangle.points_within(p.rho, p.tau, visit));
        });
    }

    /// Calls `visit(patch)` for the patches on which one rule may be used.
    pub fn patches(&self, triangle: &CurvedTriangle, visit: &mut impl FnMut(Patch)) {
        self.grade(triangle, Patch::WHOLE, visit);
    }

    fn grade(&self, triangle: &CurvedTriangle, patch: Patch, visit: &mut impl FnMut(Patch)) {
        let corners = patch.corners(triangle);
        if self.is_leaf(extent(&corners), TRIANGLE_FLOOR, |p| distance(p, &corners)) {
            visit(patch);
        } else {
            patch.quarter().into_iter().for_each(|part| self.grade(triangle, part, visit));
        }
    }

    /// Calls `visit(t, weight)` at quadrature points of the parameter `0 ≤ t ≤ 1` of a piece of the boundary, cut at singular
    /// points and breaks on it and graded towards them. The weights sum to 1.
    pub fn along(&self, piece: &Piece, visit: &mut impl FnMut(f64, f64)) {
        let mut cuts = Vec::new();
        let (start, size) = (piece.point(0.0), (piece.point(1.0) - piece.point(0.0)).norm());
        let near = |cut: &&Segment| cut.distance(start) <= LONGEST * size;
        cuts.extend(self.breaks.iter().filter(near).flat_map(|cut| crossings(piece, cut)));
        let on = |p: &&Point| (*p - start).norm() <= LONGEST * size && piece.distance(**p) < 1e-9 * size;
        cuts.extend(self.singular.iter().filter(on).map(|&p| piece.foot(p)));
        cuts.retain(|t| (SLIVER..=1.0 - SLIVER).contains(t));
        cuts.extend([0.0, 1.0]);
        cuts.sort_by(f64::total_cmp);
        for w in cuts.windows(2).filter(|w| w[1] - w[0] > SIDE_FLOOR) {
            self.graded(piece, [w[0], w[1]], visit);
        }
    }

    fn graded(&self, piece: &Piece, [from, to]: [f64; 2], visit: &mut impl FnMut(f64, f64)) {
        let chord = Segment { a: piece.point(from), b: piece.point(to) };
        if self.is_leaf(chord.length(), CURVE_FLOOR, |p| chord.distance(p)) {
            let parts = 1u32 << self.depth;
            let width = (to - from) / f64::from(parts);
            for k in 0..parts {
                let left = from + f64::from(k) * width;
                GAUSS_8.iter().for_each(|&(x, w)| visit(left + x * width, w * width));
            }
        } else {
            let middle = 0.5 * (from + to);
            self.graded(piece, [from, middle], visit);
            self.graded(piece, [middle, to], visit);
        }
    }
}

fn split(patch: Patch, depth: u32, visit: &mut impl FnMut(Patch)) {
    if depth == 0 {
        visit(patch);
    } else {
        patch.quarter().into_iter().for_each(|part| split(part, depth - 1, visit));
    }
}

fn extent(corners: &[Point; 4]) -> f64 {
    let pairs = (0..4).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs.map(|(i, j)| (corners[i] - corners[j]).norm()).fold(0.0, f64::max)
}

/// Distance of `p` from the quadrilateral, zero inside.
fn distance(p: Point, corners: &[Point; 4]) -> f64 {
    let orientation = twice_area(corners[0], corners[1], corners[2]) + twice_area(corners[0], corners[2], corners[3]);
    let side = |i: usize| Segment { a: corners[i], b: corners[(i + 1) % 4] };
    if (0..4).all(|i| orientation * twice_area(side(i).a, side(i).b, p) >= 0.0) {
        return 0.0;
    }
    (0..4).map(|i| side(i).distance(p)).fold(f64::INFINITY, f64::min)
}

/// The parameters at which a piece crosses the line of `cut` within the cut: sign changes on a grid, then bisection.
fn crossings(piece: &Piece, cut: &Segment) -> Vec<f64> {
    const GRID: u32 = 16;
    let height = |t: f64| cross(cut.b - cut.a, piece.point(t) - cut.a);
    let at = |k: u32| f64::from(k) / f64::from(GRID);
    let changes = (0..GRID).map(|k| (at(k), at(k + 1))).filter(|&(a, b)| height(a) * height(b) < 0.0);
    let root = |(mut a, mut b): (f64, f64)| {
        let left = height(a);
        for _ in 0..60 {
            let middle = 0.5 * (a + b);
            if height(middle) * left > 0.0 { a = middle } else { b = middle }
        }
        0.5 * (a + b)
    };
    let within = |t: &f64| (0.0..=1.0).contains(&cut.parameter(piece.point(*t)));
    changes.map(root).filter(within).collect()
}
