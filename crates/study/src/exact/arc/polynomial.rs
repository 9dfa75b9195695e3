//! arcP: gap and pressure on the arc are powers of the angle from one switch point.
//!
//! `g = (θ−θ_s)_+³`, `p = −4 (θ_s−θ)_+²`, `θ_s = 0.9`, by the arc lemma with the smooth part's `a`, and
//! `w = q_0 − 0.6 g` in `Ω'`, `q_0 + 0.4 g` in `Ω''`. The bodies slip along each other, so that no part of the error of
//! a straight-sided treatment vanishes by chance. The body force jumps across the ray `θ = θ_s`; `u ∈ H^{5/2−δ}`.

use super::{Place, RADIUS, SWITCH, extended, smooth, switch_point};
use crate::exact::Field;
use crate::expr::{Real, positive_power};
use signorini_contact::{Body, Point, geometry::Segment, material::Lame};

/// Pressure per `(θ_s−θ)²`.
const PRESSURE: f64 = 4.0;
/// The length of the ray along which quadrature is cut: both bodies end before it does.
const REACH: f64 = 3.0;

/// arcP.
#[derive(Clone, Copy, Debug)]
pub struct ArcPolynomial {
    lame: [Lame; 2],
}

impl ArcPolynomial {
    /// For two isotropic bodies.
    pub fn new(lame: [Lame; 2]) -> Self {
        Self { lame }
    }
}

impl Field for ArcPolynomial {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let share = match body {
            Body::First => -0.6,
            Body::Second => 0.4,
        };
        let place = Place::new(x, y);
        let mut trace = smooth(body, place.theta);
        let beyond = place.theta - SWITCH;
        // w = q_0 + share g, g = (θ−θ_s)_+³
        let slope = positive_power(beyond, 2.0);
        trace.w += slope * beyond * share;
        trace.slope_w += slope * (3.0 * share);
        // p = −4 (θ_s−θ)_+²
        trace.p = positive_power(-beyond, 2.0) * -PRESSURE;
        let chi = place.cutoff(body, x, y);
        place.turned(extended(&trace, self.lame[body.index()], RADIUS, place.height)).map(|u| u * chi)
    }

    fn break_lines(&self) -> Vec<Segment> {
        vec![Segment { a: Point::zeros(), b: REACH * switch_point() }]
    }

    fn switch_points(&self) -> Vec<Point> {
        vec![switch_point()]
    }
}
