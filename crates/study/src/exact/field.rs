//! From one formula, generic in its numbers, to values, first and second derivatives.

use super::{Exact, Jet, Jet2};
use crate::expr::Real;
use nalgebra::{Matrix1x2, Matrix2};
use num_dual::{Dual2SVec64, DualSVec64};
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
        let u = self.eval(body, DualSVec64::from_re(x.x).derivative(0), DualSVec64::from_re(x.y).derivative(1));
        Jet { value: Vec2::new(u[0].re, u[1].re), gradient: u.map(|c| c.eps.0.map_or([0.0; 2], |v| [v[0], v[1]])) }
    }

    fn jet2(&self, body: Body, x: Point) -> Jet2 {
        let u = self.eval(body, Dual2SVec64::from_re(x.x).derivative(0), Dual2SVec64::from_re(x.y).derivative(1));
        Jet2 {
            value: Vec2::new(u[0].re, u[1].re),
            gradient: u.map(|c| row(c.v1.0.unwrap_or_else(Matrix1x2::zeros))),
            hessian: u.map(|c| square(c.v2.0.unwrap_or_else(Matrix2::zeros))),
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

fn row(v: Matrix1x2<f64>) -> [f64; 2] {
    [v[0], v[1]]
}

/// The two mixed derivatives are summed in different orders; their mean makes the result symmetric to the last bit.
fn square(h: Matrix2<f64>) -> [[f64; 2]; 2] {
    let mixed = 0.5 * (h[(0, 1)] + h[(1, 0)]);
    [[h[(0, 0)], mixed], [mixed, h[(1, 1)]]]
}
