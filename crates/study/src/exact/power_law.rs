//! R(α): a switch point of chosen regularity, `u ∈ H^{1+α−δ}`, `0 < α < 2`.
//!
//! In polar coordinates `r, θ` about `(s, 0)`, `θ ∈ [0, π]` measured from the open side in either body,
//!
//! ```text
//! Ω' :  u_1 = −α A r^α sin θ (1+cos θ)/2,   u_2 = r^α [ A (1+cos θ)/2 − (B/L') sin θ (1−cos θ)/2 ]
//! Ω'':  u_1 = 0,                            u_2 = (B/L'') r^α sin θ (1−cos θ)/2             L = λ + 2μ
//! ```
//!
//! times `χ = 1 − y²`, plus the smooth part. Then `g = A (x−s)_+^α` and `T_n = −B (s−x)_+^{α−1}`. The body force behaves
//! like `r^{α−2}`: it is square integrable only for `α > 1`.

use super::Field;
use super::line::{cutoff, depth, normal_modulus, smooth};
use super::parameters;
use super::polynomial::switch;
use super::wedge::{self, Wedge};
use crate::expr::Real;
use signorini_contact::{Body, Point, material::Lame};

/// Gap per `(x−s)^α`.
const GAP: f64 = 0.4;
/// Pressure per `(s−x)^{α−1}`.
const PRESSURE: f64 = 2.0;

/// R(α).
#[derive(Clone, Copy, Debug)]
pub struct PowerLaw {
    alpha: f64,
    lame: [Lame; 2],
}

impl PowerLaw {
    /// By the exponent of the gap, `0 < α < 2`: below it the energy is infinite.
    ///
    /// # Errors
    /// If `α` is outside its range.
    pub fn new(alpha: f64, lame: [Lame; 2]) -> Result<Self, String> {
        parameters::between("alpha", alpha, 0.0, 2.0)?;
        Ok(Self { alpha, lame })
    }

    fn singular<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let wedge = Wedge::new(x, y, self.alpha);
        let pressed = wedge.press * (PRESSURE / normal_modulus(self.lame[body.index()]));
        match body {
            Body::First => [wedge.slide * (-self.alpha * GAP), wedge.open * GAP - pressed],
            Body::Second => [D::from(0.0), pressed],
        }
    }
}

impl Field for PowerLaw {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let lame = self.lame[body.index()];
        let [s1, s2] = self.singular(body, x - switch(), depth(body, y));
        let [r1, r2] = smooth(body, x).extended(lame, y);
        let chi = cutoff(y);
        [(r1 + s1) * chi, (r2 + s2) * chi]
    }

    fn singular_points(&self) -> Vec<Point> {
        vec![Point::new(switch(), 0.0)]
    }

    fn switch_points(&self) -> Vec<Point> {
        vec![Point::new(switch(), 0.0)]
    }

    fn notes(&self) -> Vec<String> {
        wedge::notes(self.alpha)
    }
}
