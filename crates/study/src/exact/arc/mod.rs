//! The arc lemma: displacements with given trace and pressure on the unit circle, without friction.
//!
//! ```text
//!  y = 2 ┌───────────────┐ u'' = 0     For any a(θ), w(θ), p(θ), with b = a − w_θ and
//!        │      Ω''      │             c = (p − λ (w + a_θ))/(λ + 2μ),
//!  r = 1 ┝━━┯━           │
//!        │   ＼━┓        │ u'' = 0         u_r = (w + (r−1) c) X,   u_θ = (a + (r−1) b) X
//!        │ Ω'  ＼ ┓      │
//!  y = ½ └┐      ＼┃     │             has on r = 1 the trace (w, a) and the stresses τ_rθ = 0, τ_rr = p.
//!         u' = 0   ┗━━━━━┘ x = 2       X = Q (2 − Q) is 1 there with its derivatives 0, and vanishes where q does:
//!          x + y = ½                   Q = q(x, y)/q(cos θ, sin θ), q = x + y − ½ or (2 − x)(2 − y)
//! ```
//!
//! `Ω' = {x, y > 0, x + y > ½, r < 1}` lies inside the arc, `Ω'' = (0,2)² ∖ disc` outside, so `n = e_r`. With the same
//! `p` in both bodies `T_n = p`, and the gap is `g = w'' − w'` (primes: the bodies); any two `a` are allowed.

mod polynomial;
mod power_law;

pub use polynomial::ArcPolynomial;
pub use power_law::ArcPowerLaw;

use super::line::{Trace, normal_modulus};
use crate::expr::{Real, atan2, sqrt};
use signorini_contact::geometry::CircularArc;
use signorini_contact::{Body, ContactLine, Path, Point, material::Lame};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// The angle `θ_s` of the switch point: pressed below, open above.
const SWITCH: f64 = 0.9;
/// The radius of the arc.
const RADIUS: f64 = 1.0;

/// The contact zone of the built-in solutions on the arc: the quarter of the unit circle in `x, y ≥ 0`.
pub fn contact_line() -> ContactLine {
    let arc = CircularArc { centre: Point::zeros(), radius: RADIUS, from: 0.0, to: FRAC_PI_2 };
    ContactLine::Common(Path::along(Arc::new(arc)))
}

/// A point in polar coordinates about the centre.
struct Place<D> {
    /// `θ`.
    theta: D,
    /// `r − 1`.
    height: D,
    /// `cos θ, sin θ`.
    direction: [D; 2],
}

impl<D: Real> Place<D> {
    fn new(x: D, y: D) -> Self {
        let r = sqrt(x * x + y * y);
        Self { theta: atan2(y, x), height: r - RADIUS, direction: [x / r, y / r] }
    }

    /// `(u_r, u_θ)` in the directions of the axes.
    fn turned(&self, [radial, angular]: [D; 2]) -> [D; 2] {
        let [cos, sin] = self.direction;
        [radial * cos - angular * sin, radial * sin + angular * cos]
    }

    /// `X = Q (2 − Q)`.
    fn cutoff(&self, body: Body, x: D, y: D) -> D {
        let [cos, sin] = self.direction;
        let q = distance(body, x, y) / distance(body, cos, sin);
        q * (-q + 2.0)
    }
}

/// `q`, zero where the body is held.
fn distance<D: Real>(body: Body, x: D, y: D) -> D {
    match body {
        Body::First => x + y - 0.5,
        Body::Second => (-x + 2.0) * (-y + 2.0),
    }
}

/// `(u_r, u_θ)/X` at the height `r − R` above a circle of radius `R`, from the trace at `θ`, whose slopes are derivatives
/// with respect to `θ`: the lemma above with `b = (a − w_θ)/R`, `c = (p − λ (w + a_θ)/R)/(λ + 2μ)`.
pub(super) fn extended<D: Real>(trace: &Trace<D>, lame: Lame, radius: f64, height: D) -> [D; 2] {
    // τ_rr = (λ + 2μ) c + λ ε_θθ, ε_θθ = (w + a_θ)/R
    let c = (trace.p - (trace.w + trace.slope_a) * (lame.lambda / radius)) * (1.0 / normal_modulus(lame));
    // 2ε_rθ = (w_θ − a)/R + b
    let b = (trace.a - trace.slope_w) * (1.0 / radius);
    [trace.w + height * c, trace.a + height * b]
}

/// The smooth part that the solutions share: `w = cos(2θ)/20` in both bodies, `a = sin(2θ+1)/5` in `Ω'` and `−θ²/10` in
/// `Ω''`, `p = 0`.
fn smooth<D: Real>(body: Body, theta: D) -> Trace<D> {
    let (a, slope_a) = match body {
        Body::First => {
            let (sin, cos) = (theta * 2.0 + 1.0).sin_cos();
            (sin * 0.2, cos * 0.4)
        }
        Body::Second => (-(theta * theta) * 0.1, -theta * 0.2),
    };
    let (sin, cos) = (theta * 2.0).sin_cos();
    Trace { a, slope_a, w: cos * 0.05, slope_w: -sin * 0.1, p: D::from(0.0) }
}

/// The point of the arc where contact switches.
fn switch_point() -> Point {
    Point::new(SWITCH.cos(), SWITCH.sin())
}
