//! The graph lemma: displacements with given trace and pressure on the boundary `x = f(y)` of each of two bodies that
//! need not touch before they are loaded, without friction.
//!
//! ```text
//!            x = f''(y)    x = f'(y)             With F = f_y, L = λ + 2μ, D = L μ (1 + F²)² and
//!  u''=0 ┌──────────┐        ┌──────────┐ u'=0   r_1 = p − λ a_y + μ F w_y,   r_2 = −μ w_y + L F a_y,
//!        │    Ω''    )  ε   (     Ω'    │        c = [(μ + L F²) r_1 + (λ+μ) F r_2]/D,
//!        │          │        │          │        b = [(λ+μ) F r_1 + (L + μ F²) r_2]/D
//!        └──────────┘        └──────────┘        the displacement
//!      x = −2         x → = ξ         x = 2          u_x = (w + (x−f) c) X,   u_y = (a + (x−f) b) X
//! ```
//!
//! has on `x = f(y)` the trace `(w, a)` and `τ (1, −F)ᵀ = (p, 0)ᵀ`, for any `a(y), w(y), p(y)`. `X = Q (2 − Q)`,
//! `Q = (x_u − x)/(x_u − f)`, is 1 on the graph with its derivatives 0, and vanishes at the far side `x_u = ±2`.
//!
//! `(1, −F)` is the outward normal of `Ω''` times `ds/dy = 1/cos α''`, and the inward one of `Ω'` times `1/cos α'`.
//! With the same `p` in both bodies `T''_ξ/cos α'' = −T'_ξ/cos α' = p` and `T'_η = T''_η = 0`. With `w'' − w' = ε − g`
//! (primes: the bodies), `ε = f' − f''`, the gap that remains is `g`.

mod polynomial;
mod power_law;
mod shape;

pub use polynomial::GraphPolynomial;
pub use power_law::GraphPowerLaw;
pub use shape::GapShape;

use super::line::{Trace, normal_modulus};
use crate::expr::Real;
use signorini_contact::{Body, material::Lame};

/// The far sides are `x = ±REACH`.
const REACH: f64 = 2.0;

/// `y` of the upper switch point, `1/√3`.
fn upper_switch() -> f64 {
    1.0 / 3.0f64.sqrt()
}

/// The matrix that takes `(r_1, r_2)` to `(c, b)`: rows `[(μ + L F²), (λ+μ) F]/D` and `[(λ+μ) F, (L + μ F²)]/D`. It
/// solves `τ (1, −F)ᵀ = (p, 0)ᵀ` for the derivatives of the displacement across the graph.
struct Across<D> {
    rows: [[D; 2]; 2],
}

impl<D: Real> Across<D> {
    fn new(lame: Lame, slope: D) -> Self {
        let modulus = normal_modulus(lame);
        let square = slope * slope;
        let stretched = square + 1.0;
        // 1/D, D = L μ (1 + F²)²
        let scale = (stretched * stretched * (modulus * lame.mu)).recip();
        let mixed = slope * (lame.lambda + lame.mu) * scale;
        Self { rows: [[(square * modulus + lame.mu) * scale, mixed], [mixed, (square * lame.mu + modulus) * scale]] }
    }

    /// `(c, b)`.
    fn solve(&self, r1: D, r2: D) -> [D; 2] {
        self.rows.map(|[k, l]| k * r1 + l * r2)
    }
}

/// `(u_x, u_y)/X` at the offset `x − f` from the graph of slope `F`, from the trace at `y`, whose slopes are
/// derivatives with respect to `y`.
pub(super) fn extended<D: Real>(trace: &Trace<D>, lame: Lame, slope: D, offset: D) -> [D; 2] {
    // r_1 = p − λ a_y + μ F w_y, r_2 = −μ w_y + L F a_y
    let r1 = trace.p - trace.slope_a * lame.lambda + slope * trace.slope_w * lame.mu;
    let r2 = slope * trace.slope_a * normal_modulus(lame) - trace.slope_w * lame.mu;
    let [c, b] = Across::new(lame, slope).solve(r1, r2);
    [trace.w + offset * c, trace.a + offset * b]
}

/// `X = Q (2 − Q)`, `Q = (x_u − x)/(x_u − f)`.
fn cutoff<D: Real>(body: Body, x: D, f: D) -> D {
    let far = match body {
        Body::First => REACH,
        Body::Second => -REACH,
    };
    let q = (-x + far) / (-f + far);
    q * (-q + 2.0)
}

/// The trace that the solutions share: each body comes half of the way, `w = q_0 − ε/2` in `Ω'` and `q_0 + ε/2` in
/// `Ω''`, `q_0 = cos(2y)/20`, `a = sin(2y)/10` in `Ω'` and `−y²/20` in `Ω''`, `p = 0`: the gap is closed everywhere.
fn closed<D: Real>(body: Body, shape: GapShape, y: D) -> Trace<D> {
    let (sin, cos) = (y * 2.0).sin_cos();
    let (a, slope_a) = match body {
        Body::First => (sin * 0.1, cos * 0.2),
        Body::Second => (-(y * y) * 0.05, -y * 0.1),
    };
    let [gap, slope] = shape.gap(y);
    let share = share(body);
    Trace { a, slope_a, w: cos * 0.05 + gap * share, slope_w: slope * share - sin * 0.1, p: D::from(0.0) }
}

/// What the body takes of the approach `w'' − w'`.
fn share(body: Body) -> f64 {
    match body {
        Body::First => -0.5,
        Body::Second => 0.5,
    }
}
