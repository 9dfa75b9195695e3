//! Points, segments and curves of the plane.

mod circle;
mod contact_line;
mod curve;
mod graph;
mod initial_gap;
mod path;
mod spline;
#[cfg(test)]
mod tests;

pub use circle::CircularArc;
pub use contact_line::{ContactLine, LinePoint};
pub use curve::{Curve, SharedCurve, arc_length};
pub use graph::{Graph, GraphFn};
pub use initial_gap::InitialGap;
pub use path::{Path, Piece};
pub use spline::Spline;

/// A vector of the plane: displacements, tractions, normals.
pub type Vec2 = nalgebra::Vector2<f64>;

/// A point of the plane, given by its position vector.
pub type Point = Vec2;

/// `a × b = a_1 b_2 − a_2 b_1`: twice the signed area of the triangle `0, a, b`.
#[inline]
pub fn cross(a: Vec2, b: Vec2) -> f64 {
    a.x * b.y - a.y * b.x
}

/// Twice the signed area of the triangle `a, b, c`; positive when they run counterclockwise.
#[inline]
pub fn twice_area(a: Point, b: Point, c: Point) -> f64 {
    cross(b - a, c - a)
}

/// The unit vector to the right of the direction `a → b`: the outward normal of a body on the left.
pub fn right_normal(a: Point, b: Point) -> Vec2 {
    let t = (b - a).normalize();
    Vec2::new(t.y, -t.x)
}

/// The unit vector `t = (−n_2, n_1)`: the normal turned counterclockwise by a right angle.
pub fn tangent_of(normal: Vec2) -> Vec2 {
    Vec2::new(-normal.y, normal.x)
}

/// A straight segment from `a` to `b`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// First end.
    pub a: Point,
    /// Second end.
    pub b: Point,
}

impl Segment {
    /// Length of the segment.
    pub fn length(&self) -> f64 {
        (self.b - self.a).norm()
    }

    /// The parameter `s ∈ ℝ` of the foot of `x` on the line through the segment, `a + s (b − a)`.
    pub fn parameter(&self, x: Point) -> f64 {
        let d = self.b - self.a;
        (x - self.a).dot(&d) / d.norm_squared()
    }

    /// Distance of `x` from the segment.
    pub fn distance(&self, x: Point) -> f64 {
        let s = self.parameter(x).clamp(0.0, 1.0);
        (x - (self.a + s * (self.b - self.a))).norm()
    }
}

/// The segments `A_1 A_2, A_2 A_3, …` of a polyline.
pub fn segments(polyline: &[Point]) -> impl Iterator<Item = Segment> + '_ {
    polyline.windows(2).map(|w| Segment { a: w[0], b: w[1] })
}
