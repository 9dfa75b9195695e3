//! One cell `U(ξ, η)`, `0 < ξ < 1`: contact on `ξ < σ`, open beyond, zero with all first derivatives on the cell's edge.
//!
//! By the line lemma with `p = −3000 [ξ(σ−ξ)]²` on `ξ < σ`, `g = 400 [(ξ−σ)(1−ξ)]³` beyond, `w = 0.6 g` in `Ω'` and
//! `−0.4 g` in `Ω''`, `a = 0`, and `χ = (1−η²)_+³`, whose second derivative is continuous at `η = ±1`.

use crate::expr::Real;
use signorini_contact::{Body, material::Lame};

use super::line::Trace;

/// The switch point inside a cell.
pub(super) const SIGMA: f64 = 0.43;

/// `U(ξ, η)` in `body`; zero for `|η| ≥ 1`. `ξ` must lie in the cell.
pub(super) fn cell<D: Real>(body: Body, lame: Lame, xi: D, eta: D) -> [D; 2] {
    let zero = D::from(0.0);
    if eta.re().abs() >= 1.0 {
        return [zero; 2];
    }
    let mut trace = Trace { a: zero, slope_a: zero, w: zero, slope_w: zero, p: zero };
    if xi.re() < SIGMA {
        // p = −3000 [ξ(σ−ξ)]²
        let bubble = xi * (-xi + SIGMA);
        trace.p = bubble * bubble * -3000.0;
    } else {
        let share = match body {
            Body::First => 0.6,
            Body::Second => -0.4,
        };
        // g = 400 b³, b = (ξ−σ)(1−ξ), g_ξ = 1200 b² (1 + σ − 2ξ)
        let bubble = (xi - SIGMA) * (-xi + 1.0);
        let square = bubble * bubble;
        trace.w = square * bubble * (400.0 * share);
        trace.slope_w = square * (-xi * 2.0 + (1.0 + SIGMA)) * (1200.0 * share);
    }
    let t = -(eta * eta) + 1.0;
    let chi = t * t * t;
    trace.extended(lame, eta).map(|u| u * chi)
}
