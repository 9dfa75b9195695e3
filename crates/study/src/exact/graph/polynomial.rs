//! graphP: contact in the middle of the two graphs, gap and pressure powers of the distance from two switch points.
//!
//! Contact for `−c_1 ≤ y ≤ c_2`, `c_1 = 1/√5`, `c_2 = 1/√3`, with `p = −12 [(y+c_1)(c_2−y)]_+²` and
//! `g = (−c_1−y)_+³ + (y−c_2)_+³`, by the graph lemma with `w = q_0 − W/2` in `Ω'`, `q_0 + W/2` in `Ω''`, `W = ε − g`. The body
//! force jumps across `y = −c_1` and `y = c_2`; `u ∈ H^{5/2−δ}`.

use super::{GapShape, REACH, closed, cutoff, extended, share, upper_switch};
use crate::exact::Field;
use crate::expr::{Real, positive_power};
use signorini_contact::{Body, Point, geometry::Segment, material::Lame};

/// Pressure per `[(y+c_1)(c_2−y)]²`.
const PRESSURE: f64 = 12.0;

/// graphP.
#[derive(Clone, Copy, Debug)]
pub struct GraphPolynomial {
    shape: GapShape,
    lame: [Lame; 2],
}

/// `y` of the two switch points, `−c_1` and `c_2`.
fn switches() -> [f64; 2] {
    [-1.0 / 5.0f64.sqrt(), upper_switch()]
}

impl GraphPolynomial {
    /// For two isotropic bodies with the given gap.
    pub fn new(shape: GapShape, lame: [Lame; 2]) -> Self {
        Self { shape, lame }
    }
}

impl Field for GraphPolynomial {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let [low, high] = switches();
        let [f, slope] = self.shape.graph(body, y);
        let mut trace = closed(body, self.shape, y);
        let (below, above) = (-y + low, y - high);
        // W = ε − g: w loses its share of g = (−c_1−y)_+³ + (y−c_2)_+³
        let share = share(body);
        trace.w -= (positive_power(below, 3.0) + positive_power(above, 3.0)) * share;
        trace.slope_w -= (positive_power(above, 2.0) - positive_power(below, 2.0)) * (3.0 * share);
        if below.re() < 0.0 && above.re() < 0.0 {
            // p = −12 [(y+c_1)(c_2−y)]²
            let bubble = below * above;
            trace.p = bubble * bubble * -PRESSURE;
        }
        let chi = cutoff(body, x, f);
        extended(&trace, self.lame[body.index()], slope, x - f).map(|u| u * chi)
    }

    fn break_lines(&self) -> Vec<Segment> {
        switches().map(|y| Segment { a: Point::new(-REACH, y), b: Point::new(REACH, y) }).to_vec()
    }

    fn switch_points(&self) -> Vec<Point> {
        switches().map(|y| Point::new(self.shape.boundary(Body::First, y)[0], y)).to_vec()
    }
}
