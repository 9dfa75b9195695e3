//! W: the natural singularity of a switch between contact and no contact, `u ∈ H^{5/2−δ}`.
//!
//! With `ζ = (x−s) + i|y|`, `Z = i ζ^{1/2}`, `Ẑ = (2i/3) ζ^{3/2}` and `κ = (λ+3μ)/(λ+μ)`,
//!
//! ```text
//! u_1 = [ (κ−1)/2 Re Ẑ − |y| Im Z ]/(2μ),    u_2 = ± [ (κ+1)/2 Im Ẑ − |y| Re Z ]/(2μ)      (+ in Ω', − in Ω'')
//! ```
//!
//! is in equilibrium, has `τ_12 = 0` and `τ_22 = −(s−x)_+^{1/2}` on `y = 0`, and opens like `(x−s)_+^{3/2}`. It is
//! multiplied by `χ = 1 − y²` and added to the smooth part of the line lemma.

use super::Field;
use super::line::{cutoff, depth, smooth};
use super::polar::{Polar, tip};
use super::polynomial::switch;
use crate::expr::Real;
use signorini_contact::{Body, Point, material::Lame};

/// W.
#[derive(Clone, Copy, Debug)]
pub struct Natural {
    lame: [Lame; 2],
}

impl Natural {
    /// For two isotropic bodies.
    pub fn new(lame: [Lame; 2]) -> Self {
        Self { lame }
    }

    /// The constant `G` of the gap `g = G (x−s)_+^{3/2}`: `G = (2/3) Σ (κ+1)/(4μ)` over both bodies.
    pub fn gap_factor(&self) -> f64 {
        let share = |l: Lame| (kolosov(l) + 1.0) / (4.0 * l.mu);
        2.0 / 3.0 * (share(self.lame[0]) + share(self.lame[1]))
    }
}

/// `κ = (λ+3μ)/(λ+μ)`.
fn kolosov(lame: Lame) -> f64 {
    (lame.lambda + 3.0 * lame.mu) / (lame.lambda + lame.mu)
}

impl Field for Natural {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let lame = self.lame[body.index()];
        let depth = depth(body, y);
        let [s1, s2] = singular(lame, x - switch(), depth);
        let [r1, r2] = smooth(body, x).extended(lame, y);
        let chi = cutoff(y);
        match body {
            Body::First => [(r1 + s1) * chi, (r2 + s2) * chi],
            Body::Second => [(r1 + s1) * chi, (r2 - s2) * chi],
        }
    }

    fn singular_points(&self) -> Vec<Point> {
        vec![Point::new(switch(), 0.0)]
    }

    fn switch_points(&self) -> Vec<Point> {
        vec![Point::new(switch(), 0.0)]
    }
}

/// The singular part for the upper body, at `X = x−s`, `Y = |y|`.
fn singular<D: Real>(lame: Lame, x: D, y: D) -> [D; 2] {
    let Some(polar) = Polar::new(x, y) else {
        return [tip(x, y, 0.0); 2];
    };
    let kappa = kolosov(lame);
    let scale = 0.5 / lame.mu;
    let (p, q) = polar.complex_root();
    // Z = i ζ^{1/2} = −q + i p;  Ẑ = (2i/3) ζ^{3/2} = (2/3)(−(Xq + Yp) + i (Xp − Yq))
    let potential = [-(x * q + y * p) * (2.0 / 3.0), (x * p - y * q) * (2.0 / 3.0)];
    [(potential[0] * (0.5 * (kappa - 1.0)) - y * p) * scale, (potential[1] * (0.5 * (kappa + 1.0)) + y * q) * scale]
}
