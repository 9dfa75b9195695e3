//! Lemma 3.4: the strip between arc and chord, `‖v‖²_{1,strip} ≤ c h ‖v‖²_{1,T_h}` for linear `v`.
//!
//! ```text
//!      ___ arc                     T_h the triangle with the chord as a side. On a bulging element the strip lies outside
//!    ╱ strip ╲                     T_h and `v` is continued into it; on a bitten one it lies inside.
//!   A ─────── B  chord
//! ```
//!
//! The smallest `c` of a triangle is the largest eigenvalue of a 3×3 problem in the values of `v` at the corners. Both
//! sides of the estimate are sums over the components of `v`, so scalar functions have the same constant as vectors.

use super::ellipse::Ellipse;
use super::gram::largest_ratio;
use super::mesh::{BoundarySide, DomainMesh};
use nalgebra::Matrix3;
use signorini_contact::element::{gradients, hats};
use signorini_contact::geometry::cross;
use signorini_contact::quadrature::GAUSS_8;
use signorini_contact::{Point, Vec2};

/// The smallest `c` that serves all curved triangles of a mesh of size `h`.
pub fn constant(mesh: &DomainMesh, h: f64) -> f64 {
    mesh.boundary.iter().map(|side| ratio(mesh, side)).fold(0.0, f64::max) / h
}

/// `max_v ‖v‖²_{1,strip} / ‖v‖²_{1,T_h}` of one triangle.
pub(super) fn ratio(mesh: &DomainMesh, side: &BoundarySide) -> f64 {
    let corners = mesh.corners(side.triangle);
    let ends = side.nodes.map(|i| mesh.points[i as usize]);
    let (gradients, area) = gradients(corners);
    let mut strip = Form::new(gradients);
    strip_points(&mesh.ellipse, side.angles, ends, &mut |x, weight| strip.add(hats(corners, x), weight));
    let mut triangle = Form::new(gradients);
    // exact for quadratic functions: the middles of the sides
    for hats in [[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5]] {
        triangle.add(hats, area / 3.0);
    }
    largest_ratio(&strip.matrix, &triangle.matrix).unwrap_or(f64::NAN)
}

/// `∫ (vw + ∇v·∇w)` in the values at the corners.
struct Form {
    gradients: [Vec2; 3],
    matrix: Matrix3<f64>,
}

impl Form {
    fn new(gradients: [Vec2; 3]) -> Self {
        Self { gradients, matrix: Matrix3::zeros() }
    }

    fn add(&mut self, hats: [f64; 3], weight: f64) {
        let g = &self.gradients;
        self.matrix += weight * Matrix3::from_fn(|i, j| hats[i] * hats[j] + g[i].dot(&g[j]));
    }
}

/// Quadrature points of the strip between an arc and its chord, `x(τ, σ) = c(τ) + σ (γ(τ) − c(τ))` with `c` on the chord and
/// `γ` on the arc.
pub(super) fn strip_points(
    ellipse: &Ellipse,
    [from, to]: [f64; 2],
    [a, b]: [Point; 2],
    visit: &mut impl FnMut(Point, f64),
) {
    for (tau, wt) in GAUSS_8 {
        let t = from + tau * (to - from);
        let chord = a + tau * (b - a);
        let across = ellipse.at(t) - chord;
        let along = (to - from) * ellipse.velocity(t) - (b - a);
        for (sigma, ws) in GAUSS_8 {
            // det ∂x/∂(τ,σ) = (c' + σ (γ' − c')) × (γ − c)
            let det = cross((b - a) + sigma * along, across);
            visit(chord + sigma * across, wt * ws * det.abs());
        }
    }
}
