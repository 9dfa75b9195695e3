//! The element of the bounded contact zone: displacements linear in the physical coordinates on the exact region (2.4).
//!
//! Gradients are those of the chord triangle; only the domain of integration is curved. Off the chord the hat function of
//! the apex does not vanish, so the trace on the arc depends on all three corners.

use super::curved::{CurvedTriangle, ElementPoint};
use super::{gradients, hats};
use crate::geometry::cross;

/// The view of a curved triangle as this element.
pub(super) struct Physical<'a>(pub &'a CurvedTriangle<'a>);

impl Physical<'_> {
    /// `x = S + ρ(γ(τ) − S)`, Jacobian `ρ (γ − S) × γ'`: positive everywhere if the region is star-shaped about `S`.
    pub fn at(&self, rho: f64, tau: f64) -> ElementPoint {
        let apex = self.0.corners[self.0.apex];
        let (gamma, velocity) = self.0.arc(tau);
        let x = apex + rho * (gamma - apex);
        ElementPoint {
            x,
            jacobian: rho * cross(gamma - apex, velocity),
            hats: hats(self.0.corners, x),
            gradients: gradients(self.0.corners).0,
        }
    }

    /// The hat functions at `γ(t)`.
    pub fn trace(&self, t: f64) -> [f64; 3] {
        hats(self.0.corners, self.0.arc(t).0)
    }
}
