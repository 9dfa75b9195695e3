//! How good a mesh is: measured, never assumed.

use super::Mesh;
use crate::geometry::{Point, cross};

/// Mesh size and regularity of a triangulation of both bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// `h`: the largest side.
    pub h: f64,
    /// `ϑ`: the smallest interior angle, in degrees.
    pub min_angle: f64,
    /// `β`: the longest side over the shortest, over the whole mesh.
    pub side_ratio: f64,
}

impl Mesh {
    /// Measures every triangle of both bodies. An inverted triangle has the angle 0.
    pub fn quality(&self) -> Quality {
        let (mut longest, mut shortest, mut cotangent) = (0.0, f64::INFINITY, 0.0);
        for t in 0..self.triangles.len() {
            let corners = self.corners(t);
            for i in 0..3 {
                let side = (corners[(i + 1) % 3] - corners[i]).norm();
                longest = f64::max(longest, side);
                shortest = f64::min(shortest, side);
            }
            cotangent = f64::max(cotangent, largest_cotangent(corners));
        }
        Quality { h: longest, min_angle: f64::atan2(1.0, cotangent).to_degrees(), side_ratio: longest / shortest }
    }
}

/// The cotangent of the smallest angle of a triangle, at least `1/√3`; infinite if its corners do not run counterclockwise.
pub fn largest_cotangent(corners: [Point; 3]) -> f64 {
    let mut largest = 0.0;
    for i in 0..3 {
        let a = corners[(i + 1) % 3] - corners[i];
        let b = corners[(i + 2) % 3] - corners[i];
        // cot ϑ_i = a·b / a×b
        let area = cross(a, b);
        if area.is_nan() || area <= 0.0 {
            return f64::INFINITY;
        }
        largest = f64::max(largest, a.dot(&b) / area);
    }
    largest
}
