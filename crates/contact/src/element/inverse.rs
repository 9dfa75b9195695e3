//! From a point of the plane back to a curved triangle: whether the point lies in its exact region, and what the element's
//! own hat functions are there.
//!
//! ```text
//!         S                 The region is star-shaped about S, so each of its points is x = S + ρ (γ(τ) − S) with one
//!        /|\                (ρ, τ) ∈ [0,1]², whatever the element on it is. Beyond the arc ρ exceeds 1: there a bulging
//!       / x \               triangle ends behind its chord and a bitten one before it.
//!      A'-γ(τ)-'B
//! ```

use super::curved::{CurvedElement, CurvedTriangle};
use super::isoparametric::Isoparametric;
use super::{gradients, hats};
use crate::geometry::{Point, Vec2, cross};

/// Steps of a safeguarded Newton iteration; bisection alone would reach rounding in fewer.
const STEPS: u32 = 60;

/// A Newton step this small moves nothing but the last digit.
const ROUNDING: f64 = 2e-16;

impl CurvedTriangle<'_> {
    /// The `(ρ, τ)` with `x = S + ρ (γ(τ) − S)`. `τ` stays between 0 and 1, so a point beside the two straight sides is
    /// given the ray of the nearer one.
    pub fn star(&self, x: Point) -> (f64, f64) {
        let apex = self.corners[self.apex];
        let to = x - apex;
        let tau = self.ray(to);
        let ray = self.arc(tau).0 - apex;
        (to.dot(&ray) / ray.norm_squared(), tau)
    }

    /// How far `x` lies outside the region: the largest of its distances beyond the two straight sides and, along the ray from
    /// `S`, beyond the arc. Not positive inside.
    pub fn excess(&self, x: Point) -> f64 {
        let [s, a, b] = self.from_apex();
        let to = x - s;
        let beside = f64::max(cross(to, a - s) / (a - s).norm(), cross(b - s, to) / (b - s).norm());
        let (rho, tau) = self.star(x);
        f64::max(beside, (rho - 1.0) * (self.arc(tau).0 - s).norm())
    }

    /// The hat functions and their gradients at `x`, which may lie slightly outside: there the functions are continued.
    pub fn evaluate(&self, x: Point) -> ([f64; 3], [Vec2; 3]) {
        match self.element {
            CurvedElement::Physical => (hats(self.corners, x), gradients(self.corners).0),
            CurvedElement::Isoparametric { skew } => {
                // the chord triangle's coordinates are off by the size of the bump
                let chord = hats(self.corners, x);
                let start = [chord[self.apex], chord[(self.apex + 2) % 3]];
                let point = Isoparametric { triangle: self, skew }.at_place(x, start);
                (point.hats, point.gradients)
            }
        }
    }

    /// The `τ` whose ray from `S` has the direction `to`: the zero of `(γ(τ) − S) × to`, which falls as `τ` grows.
    fn ray(&self, to: Vec2) -> f64 {
        let [s, a, b] = self.from_apex();
        let (before, after) = (cross(a - s, to), cross(b - s, to));
        if before <= 0.0 || after >= 0.0 {
            return if before <= -after { 0.0 } else { 1.0 };
        }
        let (mut low, mut high) = (0.0, 1.0);
        let mut tau = before / (before - after);
        for _ in 0..STEPS {
            let (gamma, velocity) = self.arc(tau);
            let turn = cross(gamma - s, to);
            *if turn > 0.0 { &mut low } else { &mut high } = tau;
            let step = turn / cross(velocity, to);
            if step.abs() < ROUNDING {
                break;
            }
            let newton = tau - step;
            tau = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        }
        tau
    }
}
