//! The line lemma: displacements with given trace and pressure on a straight contact line, without friction.
//!
//! ```text
//!            y = 1   u' = 0
//!        ┌───────────────┐      For any a(x), w(x), p(x) and c = (p − λ a_x)/(λ + 2μ),
//!        │      Ω'       │
//!        │               │          u_1 = (a − y w_x) χ(y),   u_2 = (w + y c) χ(y)
//! y = 0  ├───────────────┤
//!        │      Ω''      │      has on y = 0 the trace (a, w) and the stresses τ_12 = 0, τ_22 = p, provided
//!        └───────────────┘      χ(0) = 1 and χ_y(0) = 0. It vanishes where χ does.
//!            y = −1  u'' = 0
//! ```
//!
//! With the same `p` in both bodies the gap is `g = w' − w''` (primes: the bodies) and `T_n = p`; any two `a` are allowed,
//! for without friction the bodies may slip.

use crate::expr::Real;
use signorini_contact::{Body, material::Lame};

/// Data on the line at one `x`.
pub(super) struct Trace<D> {
    /// `a`.
    pub a: D,
    /// `a_x`.
    pub slope_a: D,
    /// `w`.
    pub w: D,
    /// `w_x`.
    pub slope_w: D,
    /// `p`, the normal stress; pressing is negative.
    pub p: D,
}

impl<D: Real> Trace<D> {
    /// `(u_1, u_2)/χ = (a − y w_x, w + y c)`.
    pub(super) fn extended(&self, lame: Lame, y: D) -> [D; 2] {
        // c = (p − λ a_x)/(λ + 2μ)
        let c = (self.p - self.slope_a * lame.lambda) * (1.0 / normal_modulus(lame));
        [self.a - y * self.slope_w, self.w + y * c]
    }
}

/// The smooth part that several solutions share: `w = cos(2x)/20` in both bodies, `a = sin(2x)/10` in `Ω'` and
/// `−x²/20` in `Ω''`, `p = 0`.
pub(super) fn smooth<D: Real>(body: Body, x: D) -> Trace<D> {
    let (sin, cos) = (x * 2.0).sin_cos();
    let (a, slope_a) = match body {
        Body::First => (sin * 0.1, cos * 0.2),
        Body::Second => (-(x * x) * 0.05, -x * 0.1),
    };
    Trace { a, slope_a, w: cos * 0.05, slope_w: -sin * 0.1, p: D::from(0.0) }
}

/// `λ + 2μ`.
pub(super) fn normal_modulus(lame: Lame) -> f64 {
    lame.lambda + 2.0 * lame.mu
}

/// `χ = 1 − y²`, which vanishes on `y = ±1`.
pub(super) fn cutoff<D: Real>(y: D) -> D {
    -(y * y) + 1.0
}

/// `|y|` in `body`: `y` in the upper body `Ω'`, `−y` in the lower one. The sign of `y` itself is not asked, since on the
/// line both signs of zero occur.
pub(super) fn depth<D: Real>(body: Body, y: D) -> D {
    match body {
        Body::First => y,
        Body::Second => -y,
    }
}
