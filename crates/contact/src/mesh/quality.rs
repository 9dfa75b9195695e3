//! How good a mesh is: measured, never assumed.

use super::Mesh;
use crate::geometry::{Point, cross};

/// Mesh size and regularity of a triangulation of both bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// `h`: the largest side; of a curved element the largest distance of two of its points.
    pub h: f64,
    /// `ϑ`: the smallest interior angle, in degrees; of a curved element that of its chord triangle.
    pub min_angle: f64,
    /// `β`: the longest side or chord over the shortest, over the whole mesh.
    pub side_ratio: f64,
    /// The longest straight side over the longest chord of a curved one, at most 1 where the hypothesis of Theorem 3.3 is met;
    /// none where nothing is curved.
    pub straight_over_chord: Option<f64>,
}

impl Mesh {
    /// Measures every triangle of both bodies. An inverted triangle has the angle 0.
    pub fn quality(&self) -> Quality {
        let (mut longest, mut shortest, mut cotangent) = (0.0, f64::INFINITY, 0.0);
        let (mut straight, mut chord) = (0.0, 0.0);
        for t in 0..self.triangles.len() {
            let corners = self.corners(t);
            let curved = self.curved.of(t).map(|c| usize::from(c.apex));
            for i in 0..3 {
                // side i is opposite corner i
                let side = (corners[(i + 2) % 3] - corners[(i + 1) % 3]).norm();
                longest = f64::max(longest, side);
                shortest = f64::min(shortest, side);
                let kind = if curved == Some(i) { &mut chord } else { &mut straight };
                *kind = f64::max(*kind, side);
            }
            cotangent = f64::max(cotangent, largest_cotangent(corners));
        }
        Quality {
            h: self.curved_triangles().map(|(_, c)| c.diameter()).fold(longest, f64::max),
            min_angle: f64::atan2(1.0, cotangent).to_degrees(),
            side_ratio: longest / shortest,
            straight_over_chord: (chord > 0.0).then(|| straight / chord),
        }
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
