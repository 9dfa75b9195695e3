//! A body that may slide (Remark 3.7): P(3, 2) above, and below it a body on a smooth floor `y = −1`.
//!
//! In `Ω''` the cutoff of P becomes `χ'' = Q² (3 − 2Q)`, `Q = 1 + y`, and `u_1` grows by `[cos(2πx)/10 + (3x² − 1)/20] (1 − χ'')`.
//! Both `χ''` and its slope are 1 and 0 on `y = 0` and 0 on `y = −1`. So the contact line sees P; on the floor `u_2 = 0`,
//! `T_t = 0` and `∫ u_1 dx = 0`. Whatever constant is added to `u_1` of `Ω''`, it solves the same problem.

use super::Field;
use super::line::cutoff;
use super::parameters;
use super::polynomial::{switch, trace, vertical};
use crate::expr::Real;
use signorini_contact::{Body, Point, geometry::Segment, material::Lame};
use std::f64::consts::TAU;

/// The sliding body.
#[derive(Clone, Copy, Debug)]
pub struct Slide {
    slide: f64,
    lame: [Lame; 2],
}

impl Slide {
    /// With `u_1` of `Ω''` larger by `slide`: another solution for the same load.
    ///
    /// # Errors
    /// If the slide is outside its range.
    pub fn new(slide: f64, lame: [Lame; 2]) -> Result<Self, String> {
        parameters::within("slide", slide, -10.0, 10.0)?;
        Ok(Self { slide, lame })
    }
}

/// `Q² (3 − 2Q)`: 0 and 1 with slope 0 at `Q = 0` and `Q = 1`.
pub(super) fn smooth_step<D: Real>(q: D) -> D {
    q * q * (-q * 2.0 + 3.0)
}

impl Field for Slide {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let u = trace(body, x, 3.0, 2.0).extended(self.lame[body.index()], y);
        if body == Body::First {
            let chi = cutoff(y);
            return u.map(|u| u * chi);
        }
        let chi = smooth_step(y + 1.0);
        // cos(2πx)/10 + (3x² − 1)/20, of mean zero on (0, 1)
        let (_, cos) = (x * TAU).sin_cos();
        let along = cos * 0.1 + (x * x * 3.0 - 1.0) * 0.05;
        [u[0] * chi + along * (-chi + 1.0) + self.slide, u[1] * chi]
    }

    fn break_lines(&self) -> Vec<Segment> {
        vec![vertical(switch(), 1.0)]
    }

    fn switch_points(&self) -> Vec<Point> {
        vec![Point::new(switch(), 0.0)]
    }
}
