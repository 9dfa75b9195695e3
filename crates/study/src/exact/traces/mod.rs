//! Exact solutions from traces that a study gives: displacement and stress on the contact line, continued into the bodies
//! by the lemma that belongs to the line.
//!
//! ```text
//!    straight: y = 0                  arc: r = R, general centre         graph: x = f(η), y = η
//!
//!    (u_1, u_2) = (a, w)              (u_r, u_θ) = (w, a)                (u_x, u_y) = (w, a)
//!    τ_12 = 0, τ_22 = p               τ_rθ = 0, τ_rr = p                 τ (1, −F)ᵀ = (p, 0)ᵀ, F = df/dη
//!    g = w' − w''                     g = w'' − w', Ω' inside            ε − g = w'' − w', Ω' on the right
//!                                     g = w' − w'', Ω' outside           ε = f' − f''
//! ```
//!
//! (primes mark the bodies). `p ≤ 0` presses, with `p g = 0`, and is the same for both bodies; any two `a` are allowed, for
//! without friction the bodies slip. The displacement is multiplied by `X = Q (2 − Q)`, `Q = q(x, y)/q(foot point)`, where
//! the cutoff `q` vanishes on the clamped part of the body: there `X = 0`, and on the contact line `X = 1`, `∇X = 0`.

#[cfg(test)]
mod tests;
mod text;

pub use text::{LineText, TraceError, TraceName, TraceTexts};

use super::line::Trace;
use super::{Field, arc, graph};
use crate::expr::{Expression, Real, atan2, sqrt};
use signorini_contact::geometry::{Segment, Vec2};
use signorini_contact::{Body, Point, material::Lame};

/// An exact solution by traces on a straight line, an arc or two graphs.
#[derive(Clone, Debug)]
pub struct Traces {
    line: Line,
    bodies: [BodyTraces; 2],
    p: Expression,
    lame: [Lame; 2],
    /// Parameters where contact switches on or off.
    pub switches: Vec<f64>,
    /// Parameters where derivatives blow up.
    pub singular: Vec<f64>,
    /// Parameters where a derivative jumps, up to the third of `w`, `a` and `f` or the second of `p`: there the displacement
    /// breaks across the line on which the parameter is constant, in both bodies.
    pub breaks: Vec<f64>,
    /// How far breaks run from the contact line into the bodies; at least the diameter of either body.
    pub reach: f64,
}

/// The contact line.
#[derive(Clone, Debug)]
enum Line {
    Straight,
    Arc {
        centre: Point,
        radius: f64,
        middle: f64,
    },
    /// Of `Ω'` and of `Ω''`.
    Graph(Box<[Function; 2]>),
}

/// A function with its derivative.
#[derive(Clone, Debug)]
struct Function {
    value: Expression,
    slope: Expression,
}

/// The traces of one body with their slopes by the parameter.
#[derive(Clone, Debug)]
struct BodyTraces {
    w: Expression,
    slope_w: Expression,
    a: Expression,
    slope_a: Expression,
    cutoff: Option<Expression>,
}

impl Traces {
    fn trace<D: Real>(&self, body: Body, parameter: D) -> Trace<D> {
        let own = &self.bodies[body.index()];
        let at = |e: &Expression| parameter.through(e);
        Trace { a: at(&own.a), slope_a: at(&own.slope_a), w: at(&own.w), slope_w: at(&own.slope_w), p: at(&self.p) }
    }

    /// The displacement before the cutoff, and the foot point on the contact line.
    fn extended<D: Real>(&self, body: Body, x: D, y: D) -> ([D; 2], [D; 2]) {
        let lame = self.lame[body.index()];
        match &self.line {
            Line::Straight => (self.trace(body, x).extended(lame, y), [x, D::from(0.0)]),
            Line::Arc { centre, radius, middle } => {
                let (dx, dy) = (x - centre.x, y - centre.y);
                let r = sqrt(dx * dx + dy * dy);
                let (cos, sin) = (dx / r, dy / r);
                let [across, along] =
                    arc::extended(&self.trace(body, angle(dx, dy, *middle)), lame, *radius, r - *radius);
                // u = u_r e_r + u_θ e_θ
                let u = [across * cos - along * sin, across * sin + along * cos];
                (u, [cos * *radius + centre.x, sin * *radius + centre.y])
            }
            Line::Graph(f) => {
                let f = &f[body.index()];
                let (foot, slope) = (y.through(&f.value), y.through(&f.slope));
                (graph::extended(&self.trace(body, y), lame, slope, x - foot), [foot, y])
            }
        }
    }

    /// The points of the line at a parameter: of a graph one on each body, `Ω'` first.
    fn points(&self, parameter: f64) -> Vec<Point> {
        match &self.line {
            Line::Straight => vec![Point::new(parameter, 0.0)],
            Line::Arc { centre, radius, .. } => vec![centre + *radius * ray(parameter)],
            Line::Graph(f) => f.iter().map(|f| Point::new(f.value.eval(&[parameter]), parameter)).collect(),
        }
    }

    /// Where the parameter is constant: through both bodies across the contact line.
    fn across(&self, parameter: f64) -> Segment {
        let points = self.points(parameter);
        match &self.line {
            Line::Straight => around(&points, self.reach * Vec2::y()),
            // No break crosses the centre, where every angle meets.
            Line::Arc { centre, radius, .. } => {
                let inward = self.reach.min(*radius);
                Segment { a: points[0] - inward * ray(parameter), b: centre + (radius + self.reach) * ray(parameter) }
            }
            Line::Graph(_) => around(&[points[1], points[0]], self.reach * Vec2::x()),
        }
    }
}

/// From the first point to the last one, longer by `reach` at both ends.
fn around(points: &[Point], reach: Vec2) -> Segment {
    Segment { a: points[0] - reach, b: points[points.len() - 1] + reach }
}

/// `(cos θ, sin θ)`.
fn ray(angle: f64) -> Vec2 {
    Vec2::new(angle.cos(), angle.sin())
}

/// The angle of `(x, y)` within half a turn of `middle`.
fn angle<D: Real>(x: D, y: D, middle: f64) -> D {
    let e = ray(middle);
    atan2(y * e.x - x * e.y, x * e.x + y * e.y) + middle
}

impl Field for Traces {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let (u, foot) = self.extended(body, x, y);
        let Some(q) = &self.bodies[body.index()].cutoff else {
            return u;
        };
        // X = Q (2 − Q), Q = q(x, y)/q(foot point)
        let share = q.eval(&[x, y]) / q.eval(&foot);
        let factor = share * (-share + 2.0);
        u.map(|component| component * factor)
    }

    fn singular_points(&self) -> Vec<Point> {
        self.singular.iter().flat_map(|&s| self.points(s)).collect()
    }

    fn break_lines(&self) -> Vec<Segment> {
        self.breaks.iter().map(|&s| self.across(s)).collect()
    }

    /// On a graph those of `Ω'`.
    fn switch_points(&self) -> Vec<Point> {
        self.switches.iter().map(|&s| self.points(s)[0]).collect()
    }
}
