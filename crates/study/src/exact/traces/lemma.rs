//! The lemmas on curved contact lines; `Trace::extended` is the one on a straight line.
//!
//! Traces `w(s)`, `a(s)` and a stress `p(s)` are given along the contact line, `w_s, a_s` are their slopes, `L = λ + 2μ`:
//! the displacement below has them on the line, without friction. A factor `X` with `X = 1`, `∇X = 0` on the line changes
//! nothing there.

use super::super::line::{Trace, normal_modulus};
use crate::expr::Real;
use signorini_contact::material::Lame;

/// `(u_r, u_θ)` at the distance `r` from the centre of a circle of radius `R`: on the circle `u_r = w(θ)`, `u_θ = a(θ)`,
/// `τ_rθ = 0`, `τ_rr = p`.
pub(super) fn arc<D: Real>(t: &Trace<D>, lame: Lame, radius: f64, r: D) -> [D; 2] {
    let away = r - radius;
    // 2ε_rθ = (∂_θ u_r − u_θ)/r + ∂_r u_θ = 0:  b = (a − w_θ)/R
    let b = (t.a - t.slope_w) / radius;
    // ε_θθ = (u_r + ∂_θ u_θ)/r:  c = (p − λ (w + a_θ)/R)/L
    let c = (t.p - (t.w + t.slope_a) * (lame.lambda / radius)) / normal_modulus(lame);
    [t.w + away * c, t.a + away * b]
}

/// `(u_x, u_y)` at the distance `x − f` from the graph `x = f(η)`, `y = η`, whose slope is `F`: on the graph
/// `u_x = w(η)`, `u_y = a(η)`, `τ (1, −F)ᵀ = (p, 0)ᵀ`.
pub(super) fn graph<D: Real>(t: &Trace<D>, lame: Lame, slope: D, away: D) -> [D; 2] {
    let (lambda, mu, normal) = (lame.lambda, lame.mu, normal_modulus(lame));
    let square = slope * slope;
    // D = L μ (1 + F²)²
    let determinant = (square + 1.0) * (square + 1.0) * (normal * mu);
    // r_1 = p − λ a_η + μ F w_η,   r_2 = −μ w_η + L F a_η
    let r1 = t.p - t.slope_a * lambda + slope * t.slope_w * mu;
    let r2 = slope * t.slope_a * normal - t.slope_w * mu;
    let coupling = slope * (lambda + mu);
    // c = [(μ + L F²) r_1 + (λ + μ) F r_2]/D,   b = [(λ + μ) F r_1 + (L + μ F²) r_2]/D
    let c = ((square * normal + mu) * r1 + coupling * r2) / determinant;
    let b = (coupling * r1 + (square * mu + normal) * r2) / determinant;
    [t.w + away * c, t.a + away * b]
}
