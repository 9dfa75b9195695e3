//! How good a mesh is: measured, never assumed.

use super::Mesh;
use crate::geometry::{Point, cross};
use rayon::prelude::*;

/// Triangles that one task measures.
const CHUNK: usize = 4096;

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
        let chunks = (0..self.triangles.len().div_ceil(CHUNK)).into_par_iter();
        let of_chunk = |chunk: usize| {
            let end = ((chunk + 1) * CHUNK).min(self.triangles.len());
            (chunk * CHUNK..end).fold(Extremes::NONE, |e, t| e.with(self, t))
        };
        // Of maxima and minima every order gives the same.
        let Extremes { longest, shortest, straight, chord, cotangent } =
            chunks.map(of_chunk).reduce(|| Extremes::NONE, Extremes::and);
        Quality {
            h: self.curved_triangles().map(|(_, c)| c.diameter()).fold(longest, f64::max),
            min_angle: f64::atan2(1.0, cotangent).to_degrees(),
            side_ratio: longest / shortest,
            straight_over_chord: (chord > 0.0).then(|| straight / chord),
        }
    }
}

/// Of some triangles.
struct Extremes {
    longest: f64,
    shortest: f64,
    /// The longest straight side.
    straight: f64,
    /// The longest chord of a curved one.
    chord: f64,
    /// The cotangent of the smallest angle.
    cotangent: f64,
}

impl Extremes {
    const NONE: Self = Self { longest: 0.0, shortest: f64::INFINITY, straight: 0.0, chord: 0.0, cotangent: 0.0 };

    /// With triangle `t` in addition.
    fn with(self, mesh: &Mesh, t: usize) -> Self {
        let mut all = self;
        let corners = mesh.corners(t);
        let curved = mesh.curved.of(t).map(|c| usize::from(c.apex));
        for i in 0..3 {
            // side i is opposite corner i
            let side = (corners[(i + 2) % 3] - corners[(i + 1) % 3]).norm();
            all.longest = f64::max(all.longest, side);
            all.shortest = f64::min(all.shortest, side);
            let kind = if curved == Some(i) { &mut all.chord } else { &mut all.straight };
            *kind = f64::max(*kind, side);
        }
        all.cotangent = f64::max(all.cotangent, largest_cotangent(corners));
        all
    }

    fn and(self, other: Self) -> Self {
        Self {
            longest: f64::max(self.longest, other.longest),
            shortest: f64::min(self.shortest, other.shortest),
            straight: f64::max(self.straight, other.straight),
            chord: f64::max(self.chord, other.chord),
            cotangent: f64::max(self.cotangent, other.cotangent),
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
