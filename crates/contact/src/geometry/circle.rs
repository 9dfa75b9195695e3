//! An arc of a circle.

use super::{Curve, Point, Vec2};

/// `γ(s) = c + r (cos θ, sin θ)`, `θ = from + s (to − from)`: counterclockwise if `to > from`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircularArc {
    /// The centre `c`.
    pub centre: Point,
    /// The radius `r > 0`.
    pub radius: f64,
    /// The angle at `s = 0`, in radians.
    pub from: f64,
    /// The angle at `s = 1`; at most a full turn away.
    pub to: f64,
}

impl CircularArc {
    fn angle(&self, s: f64) -> f64 {
        self.from + s * (self.to - self.from)
    }
}

impl Curve for CircularArc {
    fn point(&self, s: f64) -> Point {
        let (sin, cos) = self.angle(s).sin_cos();
        self.centre + self.radius * Vec2::new(cos, sin)
    }

    fn derivatives(&self, s: f64) -> [Vec2; 2] {
        let (sin, cos) = self.angle(s).sin_cos();
        let turn = self.to - self.from;
        [self.radius * turn * Vec2::new(-sin, cos), -self.radius * turn * turn * Vec2::new(cos, sin)]
    }

    fn point_and_velocity(&self, s: f64) -> (Point, Vec2) {
        let (sin, cos) = self.angle(s).sin_cos();
        let velocity = self.radius * (self.to - self.from) * Vec2::new(-sin, cos);
        (self.centre + self.radius * Vec2::new(cos, sin), velocity)
    }

    fn describe(&self) -> String {
        format!(
            "circle centre ({:?}, {:?}) radius {:?} from {:?} to {:?}",
            self.centre.x, self.centre.y, self.radius, self.from, self.to
        )
    }

    fn foot(&self, x: Point) -> f64 {
        let d = x - self.centre;
        let turn = self.to - self.from;
        // The angle of x, moved by full turns as near as possible to the middle of the arc.
        let middle = 0.5 * (self.from + self.to);
        let angle = d.y.atan2(d.x);
        let angle = angle + ((middle - angle) / std::f64::consts::TAU).round() * std::f64::consts::TAU;
        ((angle - self.from) / turn).clamp(0.0, 1.0)
    }
}
