//! P(k, m): gap and pressure are powers of the distance from one switch point.
//!
//! `g = (x−s)_+^k`, `p = −6 (s−x)_+^m`, `s = 1/√6`, by the line lemma with the smooth part's `a`, and `w = q + 0.6 g` in
//! `Ω'`, `q − 0.4 g` in `Ω''`. Across `x = s` the `k`-th derivative of the gap and the `m`-th of the pressure jump, so
//! `u ∈ H^{min(k, m+1) − 1/2 − δ}`; for `k = 3` the body force jumps there.

use super::Field;
use super::line::{Trace, cutoff, smooth};
use super::parameters;
use crate::expr::{Real, positive_power};
use signorini_contact::{Body, Point, geometry::Segment, material::Lame};

/// P(k, m).
#[derive(Clone, Copy, Debug)]
pub struct Polynomial {
    k: f64,
    m: f64,
    lame: [Lame; 2],
}

/// The switch point `s = 1/√6`, a node of no mesh with rational nodes.
pub(super) fn switch() -> f64 {
    1.0 / 6.0f64.sqrt()
}

/// Pressure per `(s−x)^m`.
const PRESSURE: f64 = 6.0;

impl Polynomial {
    /// By the exponents of gap and pressure. `k > 2` and `m > 1`: below that the stress jumps across `x = s`, and the
    /// load would have to be concentrated on that line.
    ///
    /// # Errors
    /// If an exponent is outside its range.
    pub fn new(k: f64, m: f64, lame: [Lame; 2]) -> Result<Self, String> {
        parameters::above("k", k, 2.0, 12.0)?;
        parameters::above("m", m, 1.0, 12.0)?;
        Ok(Self { k, m, lame })
    }
}

/// Trace and pressure of P(k, m) at `x`.
pub(super) fn trace<D: Real>(body: Body, x: D, k: f64, m: f64) -> Trace<D> {
    let s = switch();
    let share = match body {
        Body::First => 0.6,
        Body::Second => -0.4,
    };
    let mut trace = smooth(body, x);
    if x.re() > s {
        // w = q + share g, g = (x−s)^k
        let slope = positive_power(x - s, k - 1.0);
        trace.w += slope * (x - s) * share;
        trace.slope_w += slope * (k * share);
    } else {
        // p = −6 (s−x)^m
        trace.p = positive_power(-x + s, m) * -PRESSURE;
    }
    trace
}

impl Field for Polynomial {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let chi = cutoff(y);
        trace(body, x, self.k, self.m).extended(self.lame[body.index()], y).map(|u| u * chi)
    }

    fn break_lines(&self) -> Vec<Segment> {
        vec![vertical(switch(), 1.0)]
    }

    fn switch_points(&self) -> Vec<Point> {
        vec![Point::new(switch(), 0.0)]
    }

    fn notes(&self) -> Vec<String> {
        if self.k >= 3.0 && self.m >= 2.0 {
            return Vec::new();
        }
        let s = switch();
        vec![format!(
            "second derivatives of u grow without bound on one side of the line x = {s:.6} (k = {}, m = {}); quadrature \
             is cut there, not graded",
            self.k, self.m
        )]
    }
}

/// The segment from `(x, −half)` to `(x, half)`, through both bodies.
pub(super) fn vertical(x: f64, half: f64) -> Segment {
    Segment { a: Point::new(x, -half), b: Point::new(x, half) }
}
