//! The graph of a function over an axis.

use super::{Curve, Point, Vec2, tangent_of};
use std::fmt;
use std::sync::Arc;

/// `f(η)`, `f'(η)`, `f''(η)`.
pub type GraphFn = Arc<dyn Fn(f64) -> [f64; 3] + Send + Sync>;

/// `γ(s) = f(η) e_ξ + η e_η`, `η = from + s (to − from)`: the parameter is an affine function of `η`. `e_η` is `e_ξ`
/// turned counterclockwise by a right angle.
#[derive(Clone)]
pub struct Graph {
    /// The function with two derivatives.
    pub function: GraphFn,
    /// The function in words, the same for equal functions.
    pub name: String,
    /// `e_ξ`, a unit vector.
    pub direction: Vec2,
    /// `η` at `s = 0`.
    pub from: f64,
    /// `η` at `s = 1`.
    pub to: f64,
}

impl Graph {
    fn combine(&self, xi: f64, eta: f64) -> Vec2 {
        xi * self.direction + eta * tangent_of(self.direction)
    }
}

impl fmt::Debug for Graph {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.describe())
    }
}

impl Curve for Graph {
    fn point(&self, s: f64) -> Point {
        let eta = self.from + s * (self.to - self.from);
        self.combine((self.function)(eta)[0], eta)
    }

    fn derivatives(&self, s: f64) -> [Vec2; 2] {
        let width = self.to - self.from;
        let [_, f1, f2] = (self.function)(self.from + s * width);
        [width * self.combine(f1, 1.0), width * width * self.combine(f2, 0.0)]
    }

    fn point_and_velocity(&self, s: f64) -> (Point, Vec2) {
        let width = self.to - self.from;
        let eta = self.from + s * width;
        let [f, f1, _] = (self.function)(eta);
        (self.combine(f, eta), width * self.combine(f1, 1.0))
    }

    fn describe(&self) -> String {
        let e = self.direction;
        format!("graph of {} along ({:?}, {:?}) from {:?} to {:?}", self.name, e.x, e.y, self.from, self.to)
    }
}
