//! From one formula, generic in its numbers, to values, first and second derivatives.

use super::{Exact, Jet, Jet2};
use crate::expr::{Dual, Dual2, Real};
use signorini_contact::{Body, Point, Vec2, geometry::Segment};

/// A displacement as one formula. Everything that is a `Field` is [`Exact`] by automatic differentiation.
pub trait Field: Send + Sync {
    /// `u(x, y)` in `body`. The body decides which side of the contact zone the formula is for, never the sign of `y`:
    /// on the contact line itself both bodies are asked at the same point.
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2];
    /// See [`Exact::singular_points`].
    fn singular_points(&self) -> Vec<Point> {
        Vec::new()
    }
    /// See [`Exact::break_lines`].
    fn break_lines(&self) -> Vec<Segment> {
        Vec::new()
    }
    /// See [`Exact::switch_points`].
    fn switch_points(&self) -> Vec<Point> {
        Vec::new()
    }
    /// See [`Exact::notes`].
    fn notes(&self) -> Vec<String> {
        Vec::new()
    }
}

impl<F: Field> Exact for F {
    fn value(&self, body: Body, x: Point) -> Vec2 {
        self.eval(body, x.x, x.y).into()
    }

    fn jet(&self, body: Body, x: Point) -> Jet {
        let u = self.eval(body, Dual::variable(x.x, 0), Dual::variable(x.y, 1));
        Jet { value: Vec2::new(u[0].re, u[1].re), gradient: u.map(|c| c.gradient) }
    }

    fn jet2(&self, body: Body, x: Point) -> Jet2 {
        let u = self.eval(body, Dual2::variable(x.x, 0), Dual2::variable(x.y, 1));
        let square = |[xx, xy, yy]: [f64; 3]| [[xx, xy], [xy, yy]];
        Jet2 {
            value: Vec2::new(u[0].re, u[1].re),
            gradient: u.map(|c| c.gradient),
            hessian: u.map(|c| square(c.hessian)),
        }
    }

    fn singular_points(&self) -> Vec<Point> {
        Field::singular_points(self)
    }

    fn break_lines(&self) -> Vec<Segment> {
        Field::break_lines(self)
    }

    fn switch_points(&self) -> Vec<Point> {
        Field::switch_points(self)
    }

    fn notes(&self) -> Vec<String> {
        Field::notes(self)
    }
}
