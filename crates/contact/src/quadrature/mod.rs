//! Quadrature on triangles and sides, cut at lines where the integrand breaks and graded towards singular points.
//!
//! A *leaf* is a piece on which the integrand is smooth on the piece's own scale: its diameter is at most
//! [`Cubature::grading`] times its distance from the nearest singular point, or it has reached the floor.

mod cut;
mod patch;
mod rules;
#[cfg(test)]
mod tests;

use crate::geometry::{Point, Segment, twice_area};
use cut::{crossing, cut_leaf};
pub use patch::Patch;
use rules::five_points;
pub use rules::{GAUSS_4, GAUSS_6, GAUSS_8, conical_points, seven_points, six_points, sixteen_points, three_points};

/// How large a leaf may be relative to its distance from a singular point, unless said otherwise.
pub const GRADING: f64 = 0.6;

/// A leaf of a triangle is not cut below this diameter.
pub const TRIANGLE_FLOOR: f64 = 1e-10;

/// A leaf of a side is not cut below this length.
pub const SIDE_FLOOR: f64 = 1e-14;

/// How to integrate over triangles and sides.
#[derive(Clone, Debug)]
pub struct Cubature {
    /// Points to grade towards.
    pub singular: Vec<Point>,
    /// Segments to cut at.
    pub breaks: Vec<Segment>,
    /// Every leaf is split this many more times, a triangle into four, a side into two.
    pub depth: u32,
    /// A leaf may be this large relative to its distance from a singular point ([`GRADING`]).
    pub grading: f64,
}

impl Default for Cubature {
    fn default() -> Self {
        Self { singular: Vec::new(), breaks: Vec::new(), depth: 0, grading: GRADING }
    }
}

impl Cubature {
    /// The same pieces, each split once more: what a quadrature error is measured against.
    pub fn finer(&self) -> Self {
        Self { depth: self.depth + 1, ..self.clone() }
    }

    /// Calls `visit(point, weight)` at the quadrature points of a triangle. Exact for polynomials of degree 5.
    pub fn triangle(&self, corners: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
        self.pieces(corners, &mut |piece| split_triangle(piece, self.depth, &mut |t| seven_points(t, visit)));
    }

    /// Calls `visit(piece)` for the pieces of a triangle on which one rule may be used: leaves, cut at the breaks.
    pub fn pieces(&self, corners: [Point; 3], visit: &mut impl FnMut([Point; 3])) {
        if self.is_leaf(diameter(&corners), TRIANGLE_FLOOR, |p| distance_to_triangle(p, &corners)) {
            cut_leaf(corners, &self.breaks, visit);
        } else {
            quarter(corners).into_iter().for_each(|child| self.pieces(child, visit));
        }
    }

    /// Calls `visit(point, weight)` at the quadrature points of the side `a b`. Exact for polynomials of degree 9.
    pub fn side(&self, a: Point, b: Point, visit: &mut impl FnMut(Point, f64)) {
        let side = Segment { a, b };
        let mut cuts = vec![0.0, 1.0];
        cuts.extend(self.breaks.iter().filter_map(|cut| crossing(&side, cut)));
        let on_side = |p: &&Point| side.distance(**p) < 1e-12 * side.length();
        cuts.extend(self.singular.iter().filter(on_side).map(|&p| side.parameter(p)));
        cuts.retain(|s| (0.0..=1.0).contains(s));
        cuts.sort_by(f64::total_cmp);
        for w in cuts.windows(2).filter(|w| w[1] - w[0] > SIDE_FLOOR) {
            self.graded_side(a + w[0] * (b - a), a + w[1] * (b - a), visit);
        }
    }

    fn graded_side(&self, a: Point, b: Point, visit: &mut impl FnMut(Point, f64)) {
        let side = Segment { a, b };
        if self.is_leaf(side.length(), SIDE_FLOOR, |p| side.distance(p)) {
            let parts = 1u32 << self.depth;
            for k in 0..parts {
                let at = |i: u32| a + (f64::from(i) / f64::from(parts)) * (b - a);
                five_points(at(k), at(k + 1), visit);
            }
        } else {
            let middle = 0.5 * (a + b);
            self.graded_side(a, middle, visit);
            self.graded_side(middle, b, visit);
        }
    }

    fn is_leaf(&self, size: f64, floor: f64, distance: impl Fn(Point) -> f64) -> bool {
        size <= floor || self.singular.iter().all(|&p| size <= self.grading * distance(p))
    }
}

fn split_triangle(t: [Point; 3], depth: u32, visit: &mut impl FnMut([Point; 3])) {
    if depth == 0 {
        visit(t);
    } else {
        quarter(t).into_iter().for_each(|child| split_triangle(child, depth - 1, visit));
    }
}

/// The four triangles of red refinement.
pub fn quarter([a, b, c]: [Point; 3]) -> [[Point; 3]; 4] {
    let (ab, bc, ca) = (0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]]
}

fn diameter(t: &[Point; 3]) -> f64 {
    (0..3).map(|i| (t[i] - t[(i + 1) % 3]).norm()).fold(0.0, f64::max)
}

fn distance_to_triangle(p: Point, t: &[Point; 3]) -> f64 {
    let orientation = twice_area(t[0], t[1], t[2]).signum();
    if (0..3).all(|i| orientation * twice_area(t[i], t[(i + 1) % 3], p) >= 0.0) {
        return 0.0;
    }
    (0..3).map(|i| Segment { a: t[i], b: t[(i + 1) % 3] }.distance(p)).fold(f64::INFINITY, f64::min)
}
