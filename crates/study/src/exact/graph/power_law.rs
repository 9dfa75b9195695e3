//! graphR(α): one switch point of chosen regularity on two graphs, `u ∈ H^{1+α−δ}`, `0 < α < 2`.
//!
//! Contact for `y < c_2 = 1/√3`. On the graphs `g = A (y−c_2)_+^α` and `p = −B (c_2−y)_+^{α−1}`, `A = 0.4`, `B = 2`. The singular part has
//! the traces `w = ±A/2 (y−c_2)_+^α` (`+` in `Ω'`), `a = 0`. With `X̂ = y − c_2`, `Ŷ = |x − f|`, the fields of the wedge in
//! these coordinates (a smooth change of coordinates, so of the same regularity) and `σ = ∂Ŷ/∂x = ±1`, the graph lemma
//! asks for the derivatives across the graph
//!
//! ```text
//! (∂_x u_x, ∂_x u_y) = (c, b) = M(F) (p + μ F w_y, −μ w_y),    M(F) = the lemma's matrix of (r_1, r_2) → (c, b)
//! ```
//!
//! linear in `w_y = ±(αA/2) X̂_+^{α−1}` and `p = −B (−X̂)_+^{α−1}`: the normal derivatives of `slide` and `press`. Hence
//!
//! ```text
//! (u_x, u_y) = ±A/2 open e_x + σ M(F) ( μ F k slide − B press,  −μ k slide ),    k = ±αA/2
//! ```
//!
//! satisfies `τ (1, −F)ᵀ = (p, 0)ᵀ` exactly. It is added to the trace that closes the gap before both are cut off.

use super::{Across, GapShape, closed, cutoff, extended, share, upper_switch};
use crate::exact::wedge::{self, Wedge};
use crate::exact::{Field, parameters};
use crate::expr::Real;
use signorini_contact::{Body, Point, material::Lame};

/// Gap per `(y−c_2)^α`.
const GAP: f64 = 0.4;
/// Pressure per `(c_2−y)^{α−1}`.
const PRESSURE: f64 = 2.0;

/// graphR(α).
#[derive(Clone, Copy, Debug)]
pub struct GraphPowerLaw {
    alpha: f64,
    shape: GapShape,
    lame: [Lame; 2],
}

impl GraphPowerLaw {
    /// By the exponent of the gap, `0 < α < 2`: below it the energy is infinite.
    ///
    /// # Errors
    /// If `α` is outside its range.
    pub fn new(alpha: f64, shape: GapShape, lame: [Lame; 2]) -> Result<Self, String> {
        parameters::between("alpha", alpha, 0.0, 2.0)?;
        Ok(Self { alpha, shape, lame })
    }

    /// The singular part at the offset `x − f` from the graph of slope `F`. `Ŷ = σ (x − f)`: the body decides on the sign.
    fn singular<D: Real>(&self, body: Body, y: D, slope: D, offset: D) -> [D; 2] {
        let sigma = match body {
            Body::First => 1.0,
            Body::Second => -1.0,
        };
        let lame = self.lame[body.index()];
        let wedge = Wedge::new(y - upper_switch(), offset * sigma, self.alpha);
        let opening = -share(body) * GAP;
        // μ k slide
        let sheared = wedge.slide * (lame.mu * self.alpha * opening);
        let [c, b] = Across::new(lame, slope).solve(slope * sheared - wedge.press * PRESSURE, -sheared);
        [wedge.open * opening + c * sigma, b * sigma]
    }

    /// The switch point on the boundary of `body`.
    fn tip(&self, body: Body) -> Point {
        Point::new(self.shape.boundary(body, upper_switch())[0], upper_switch())
    }
}

impl Field for GraphPowerLaw {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let [f, slope] = self.shape.graph(body, y);
        let offset = x - f;
        let [s_x, s_y] = self.singular(body, y, slope, offset);
        let [u_x, u_y] = extended(&closed(body, self.shape, y), self.lame[body.index()], slope, offset);
        let chi = cutoff(body, x, f);
        [(u_x + s_x) * chi, (u_y + s_y) * chi]
    }

    fn singular_points(&self) -> Vec<Point> {
        Body::BOTH.map(|b| self.tip(b)).to_vec()
    }

    fn switch_points(&self) -> Vec<Point> {
        vec![self.tip(Body::First)]
    }

    fn notes(&self) -> Vec<String> {
        wedge::notes(self.alpha)
    }
}
