//! arcR(α): a switch point of chosen regularity on the arc, `u ∈ H^{1+α−δ}`, `0 < α < 2`.
//!
//! With `X̂ = θ − θ_s`, `Ŷ = |r − 1|`, the fields of the wedge in these coordinates, `σ = −1` in `Ω'` and `1` in `Ω''`,
//! `A = −0.24` in `Ω'` and `0.16` in `Ω''`, `B = 2`, `L = λ + 2μ` and `W = A open`, the displacement
//!
//! ```text
//! u_r = W − σ (B/L) press − (r−1) (λ/L) W,    u_θ = −σ α A slide
//! ```
//!
//! has on the arc `τ_rθ = 0` and `τ_rr = −B (θ_s−θ)_+^{α−1}`: there `ε_θθ = W`, which the last term of `u_r` pays for.
//! It is added to the smooth part before both are cut off. The gap is `0.4 (θ−θ_s)_+^α`.

use super::{Place, RADIUS, SWITCH, extended, smooth, switch_point};
use crate::exact::line::normal_modulus;
use crate::exact::wedge::{self, Wedge};
use crate::exact::{Field, parameters};
use crate::expr::Real;
use signorini_contact::{Body, Point, material::Lame};

/// Pressure per `(θ_s−θ)^{α−1}`.
const PRESSURE: f64 = 2.0;

/// arcR(α).
#[derive(Clone, Copy, Debug)]
pub struct ArcPowerLaw {
    alpha: f64,
    lame: [Lame; 2],
}

impl ArcPowerLaw {
    /// By the exponent of the gap, `0 < α < 2`: below it the energy is infinite.
    ///
    /// # Errors
    /// If `α` is outside its range.
    pub fn new(alpha: f64, lame: [Lame; 2]) -> Result<Self, String> {
        parameters::between("alpha", alpha, 0.0, 2.0)?;
        Ok(Self { alpha, lame })
    }

    /// `(u_r, u_θ)` of the singular part. `Ŷ = σ (r − 1)`: the body decides on the sign, not the rounded radius.
    fn singular<D: Real>(&self, body: Body, place: &Place<D>) -> [D; 2] {
        let (sigma, opening) = match body {
            Body::First => (-1.0, -0.24),
            Body::Second => (1.0, 0.16),
        };
        let lame = self.lame[body.index()];
        let modulus = normal_modulus(lame);
        let wedge = Wedge::new(place.theta - SWITCH, place.height * sigma, self.alpha);
        let w = wedge.open * opening;
        [
            w - wedge.press * (sigma * PRESSURE / modulus) - place.height * w * (lame.lambda / modulus),
            wedge.slide * (-sigma * self.alpha * opening),
        ]
    }
}

impl Field for ArcPowerLaw {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let place = Place::new(x, y);
        let [s_r, s_theta] = self.singular(body, &place);
        let [u_r, u_theta] = extended(&smooth(body, place.theta), self.lame[body.index()], RADIUS, place.height);
        let chi = place.cutoff(body, x, y);
        place.turned([u_r + s_r, u_theta + s_theta]).map(|u| u * chi)
    }

    fn singular_points(&self) -> Vec<Point> {
        vec![switch_point()]
    }

    fn switch_points(&self) -> Vec<Point> {
        vec![switch_point()]
    }

    fn notes(&self) -> Vec<String> {
        wedge::notes(self.alpha)
    }
}
