//! The boundary of a disc or an ellipse, divided by arc length.

use signorini_contact::geometry::{Curve, arc_length};
use signorini_contact::{Point, Vec2};
use std::f64::consts::{FRAC_PI_2, TAU};

/// `γ(t) = (a cos t, b sin t)`, `0 ≤ t ≤ 2π`, counterclockwise; as a [`Curve`] with the parameter `s = t/2π`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// `a ≥ b > 0`; a disc has both the same.
    pub semi_axes: [f64; 2],
}

impl Ellipse {
    /// `γ(t)`.
    pub fn at(&self, t: f64) -> Point {
        let ([a, b], (sin, cos)) = (self.semi_axes, t.sin_cos());
        Point::new(a * cos, b * sin)
    }

    /// `γ'(t)`.
    pub fn velocity(&self, t: f64) -> Vec2 {
        let ([a, b], (sin, cos)) = (self.semi_axes, t.sin_cos());
        Vec2::new(-a * sin, b * cos)
    }

    /// The length of the boundary.
    pub fn perimeter(&self) -> f64 {
        4.0 * self.length([0.0, FRAC_PI_2])
    }

    /// The length of the arc between two angles.
    pub fn length(&self, [from, to]: [f64; 2]) -> f64 {
        arc_length(self, [from / TAU, to / TAU])
    }

    /// The angle at the given share of the length of an arc: Newton's method for `length(from, t) = share · length`, which
    /// converges from the share of the angle because the speed changes little along an arc.
    pub fn divide(&self, [from, to]: [f64; 2], share: f64) -> f64 {
        let wanted = share * self.length([from, to]);
        let mut t = from + share * (to - from);
        for _ in 0..30 {
            let step = (self.length([from, t]) - wanted) / self.velocity(t).norm();
            t = (t - step).clamp(from, to);
            if step.abs() <= 1e-15 * (to - from) {
                break;
            }
        }
        t
    }
}

impl Curve for Ellipse {
    fn point(&self, s: f64) -> Point {
        self.at(TAU * s)
    }

    fn derivatives(&self, s: f64) -> [Vec2; 2] {
        // γ'' = −γ in the angle
        [TAU * self.velocity(TAU * s), -TAU * TAU * self.at(TAU * s)]
    }

    fn describe(&self) -> String {
        format!("ellipse with semi-axes {:?} and {:?}", self.semi_axes[0], self.semi_axes[1])
    }
}
