//! Corner patch tests: piecewise linear solutions on a contact polyline with a corner at the origin, where one node meets
//! two normals. They lie in every P1 space, so a method that treats the corner rightly has no error but rounding.
//!
//! ```text
//!    patch 1:  y = −0.2x │ y = 0.5x          patch 2:  y = |x|
//!                Ω'   ／                        ＼  Ω'  ／
//!      ──────────── 0    Ω''                Ω''   ＼0／   Ω''
//! ```

use super::Field;
use crate::expr::Real;
use signorini_contact::{Body, material::Lame};

/// `u = ε^M x` with one constant strain in each body.
#[derive(Clone, Copy, Debug)]
pub struct CornerPatch {
    /// `ε_11, ε_22, ε_12` of both bodies.
    strain: [[f64; 3]; 2],
}

impl CornerPatch {
    /// Patch 1, `τ = −I` in both bodies: `T_n = −1`, and the jump is tangential on every line through the corner.
    pub fn first(lame: [Lame; 2]) -> Self {
        Self::stressed([-1.0, -1.0, 0.0], lame)
    }

    /// Patch 2, `τ = −n¹n¹ᵀ − 3 n²n²ᵀ` with `n¹ = (1,−1)/√2`, `n² = (−1,−1)/√2`: `T_n = −1` for `x > 0` and `−3` for `x < 0`.
    pub fn second(lame: [Lame; 2]) -> Self {
        Self::stressed([-2.0, -2.0, -1.0], lame)
    }

    fn stressed(stress: [f64; 3], lame: [Lame; 2]) -> Self {
        Self {
            strain: lame.map(|l| {
                // ε = τ/(2μ) − λ tr τ/(4μ(λ+μ)) I
                let spherical = l.lambda * (stress[0] + stress[1]) / (4.0 * l.mu * (l.lambda + l.mu));
                let s = stress.map(|t| t / (2.0 * l.mu));
                [s[0] - spherical, s[1] - spherical, s[2]]
            }),
        }
    }
}

impl Field for CornerPatch {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let [e11, e22, e12] = self.strain[body.index()];
        [x * e11 + y * e12, x * e12 + y * e22]
    }
}
