//! A bilateral part on a slanted contact line (Remark 3.3), which alone keeps `Ω''` from sliding away on its floor.
//!
//! ```text
//!  y = 1.5  u' = 0
//!   ┌─────────────┐        The line lemma in the coordinates (s, d) along and across the line y = 0.3 x, with
//!   │     Ω'   __╱│        s_0 = √(3/8) √1.09, and bilateral contact for x < 1/4:
//!   │     __╱╱ d  │
//!   │__╱╱ ⟂  s →  │           p = −30 (s_0 − s)_+² (s − 0.2),   tension for s < 0.2, inside the bilateral part
//!   │             │           g = (s − s_0)_+³
//!   │     Ω''     │
//!   └─────────────┘        Cutoffs: χ' = Q (2 − Q), Q = (1.5 − y)/(1.5 − 0.3x);
//!  y = −1  u_2 = 0, T_t = 0           χ'' = Q² (3 − 2Q), Q = (y + 1)/(0.3x + 1)
//! ```

use super::Field;
use super::line::smooth;
use super::slide::smooth_step;
use crate::expr::Real;
use signorini_contact::{Body, Point, geometry::Segment, material::Lame};

/// The slope of the contact line.
const SLOPE: f64 = 0.3;
/// Where `Ω'` ends above, and `Ω''` below.
const TOP: f64 = 1.5;
const FLOOR: f64 = -1.0;
/// Stress per cubed length.
const STRESS: f64 = 30.0;
/// Where along the line tension turns into pressure.
const TURN: f64 = 0.2;

/// The slanted line, tied for `x < 1/4`.
#[derive(Clone, Copy, Debug)]
pub struct Slanted {
    lame: [Lame; 2],
}

/// Length along the line per unit of `x`.
fn stretch() -> f64 {
    (1.0 + SLOPE * SLOPE).sqrt()
}

/// The abscissa `√(3/8)` of the switch point.
fn switch() -> f64 {
    0.375f64.sqrt()
}

impl Slanted {
    /// For the Lamé constants of `Ω'` and `Ω''`.
    pub fn new(lame: [Lame; 2]) -> Self {
        Self { lame }
    }
}

impl Field for Slanted {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let (cos, sin) = (1.0 / stretch(), SLOPE / stretch());
        let (s, d) = (x * cos + y * sin, y * cos - x * sin);
        let end = switch() * stretch();
        let mut trace = smooth(body, s);
        if s.re() > end {
            // w of Ω' and Ω'' differ by g = (s − s_0)³
            let share = if body == Body::First { 0.6 } else { -0.4 };
            let slope = (s - end) * (s - end);
            trace.w += slope * (s - end) * share;
            trace.slope_w += slope * (3.0 * share);
        } else {
            // p = −30 (s_0 − s)² (s − 0.2)
            trace.p = (s - end) * (s - end) * (s - TURN) * -STRESS;
        }
        let chi = match body {
            Body::First => {
                let q = (-y + TOP) / (-x * SLOPE + TOP);
                q * (-q + 2.0)
            }
            Body::Second => smooth_step((y - FLOOR) / (x * SLOPE - FLOOR)),
        };
        let [along, across] = trace.extended(self.lame[body.index()], d).map(|u| u * chi);
        [along * cos - across * sin, along * sin + across * cos]
    }

    /// Across both bodies where `s = s_0`.
    fn break_lines(&self) -> Vec<Segment> {
        let foot = Point::new(switch(), SLOPE * switch());
        let across = Point::new(-SLOPE, 1.0);
        vec![Segment { a: foot - 2.0 * across, b: foot + 2.0 * across }]
    }

    fn switch_points(&self) -> Vec<Point> {
        vec![Point::new(switch(), SLOPE * switch())]
    }
}
