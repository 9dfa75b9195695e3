//! Triangles and sides cut at the segments where the integrand breaks.

use super::diameter;
use crate::geometry::{Point, Segment, cross};

/// Cuts a leaf at the breaks that cross it. Leaves are cut, not triangles: a long sliver would be graded into far too
/// many pieces.
pub(super) fn cut_leaf(leaf: [Point; 3], breaks: &[Segment], visit: &mut impl FnMut([Point; 3])) {
    let own = bounding_box(&leaf);
    let mut cuts = breaks.iter().filter(|cut| boxes_meet(own, bounding_box(&[cut.a, cut.b]))).peekable();
    if cuts.peek().is_none() {
        return visit(leaf);
    }
    let mut pieces = vec![leaf];
    for cut in cuts {
        pieces = pieces.into_iter().flat_map(|t| cut_triangle(t, cut)).collect();
    }
    pieces.into_iter().for_each(visit);
}

fn bounding_box(points: &[Point]) -> (Point, Point) {
    points.iter().fold((points[0], points[0]), |(low, high), p| (low.inf(p), high.sup(p)))
}

fn boxes_meet(a: (Point, Point), b: (Point, Point)) -> bool {
    (0..2).all(|k| a.0[k] <= b.1[k] && b.0[k] <= a.1[k])
}

/// The pieces of a triangle on both sides of the line through `cut`; pieces below rounding are dropped.
fn cut_triangle(t: [Point; 3], cut: &Segment) -> Vec<[Point; 3]> {
    let d = cut.b - cut.a;
    let height = t.map(|p| cross(d, p - cut.a) / d.norm());
    let tolerance = 1e-13 * diameter(&t);
    if height.iter().all(|&h| h >= -tolerance) || height.iter().all(|&h| h <= tolerance) {
        return vec![t];
    }
    [1.0, -1.0].into_iter().flat_map(|sign| fan(&half_plane_part(&t, &height.map(|h| sign * h)))).collect()
}

/// The corners of the part of the triangle where the height is not negative, in order.
fn half_plane_part(t: &[Point; 3], height: &[f64; 3]) -> Vec<Point> {
    let mut corners = Vec::with_capacity(4);
    for i in 0..3 {
        let j = (i + 1) % 3;
        if height[i] >= 0.0 {
            corners.push(t[i]);
        }
        if height[i] * height[j] < 0.0 {
            corners.push(t[i] + height[i] / (height[i] - height[j]) * (t[j] - t[i]));
        }
    }
    corners
}

fn fan(polygon: &[Point]) -> Vec<[Point; 3]> {
    (2..polygon.len()).map(|i| [polygon[0], polygon[i - 1], polygon[i]]).collect()
}

/// The parameter on `side` where the line through `cut` crosses it, if within the cut.
pub(super) fn crossing(side: &Segment, cut: &Segment) -> Option<f64> {
    let (d, e) = (side.b - side.a, cut.b - cut.a);
    let det = cross(d, e);
    if det.abs() < 1e-14 * d.norm() * e.norm() {
        return None;
    }
    let s = cross(cut.a - side.a, e) / det;
    let t = cross(cut.a - side.a, d) / det;
    ((0.0..=1.0).contains(&s) && (-1e-12..=1.0 + 1e-12).contains(&t)).then_some(s)
}
