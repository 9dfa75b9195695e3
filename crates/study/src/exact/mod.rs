//! Exact solutions of contact problems: built-in closed forms and expressions of a study file.

pub mod arc;
mod built_in;
mod cell;
mod condition;
pub mod derived;
mod differences;
mod expression;
mod field;
pub mod graph;
mod line;
mod many_switches;
mod natural;
mod parameters;
mod patch;
mod polar;
mod polynomial;
mod power_law;
mod slanted;
mod slide;
#[cfg(test)]
mod tests;
mod tiles;
mod traces;
pub mod verify;
mod wedge;

pub use arc::{ArcPolynomial, ArcPowerLaw};
pub use built_in::{BUILT_INS, BuiltIn, built_in, sobolev_order};
pub use expression::{ComponentError, Expressions};
pub use field::Field;
pub use graph::{GapShape, GraphPolynomial, GraphPowerLaw};
pub use many_switches::ManySwitches;
pub use natural::Natural;
pub use parameters::Parameter;
pub use patch::CornerPatch;
pub use polynomial::Polynomial;
pub use power_law::PowerLaw;
pub use slanted::Slanted;
pub use slide::Slide;
pub use tiles::Tiles;
pub use traces::{LineText, TraceError, TraceName, TraceTexts, Traces};

use signorini_contact::{Body, Point, Vec2, geometry::Segment};

/// Displacement and its first derivatives at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// `u_i`.
    pub value: Vec2,
    /// `gradient[i][j] = ∂_j u_i`.
    pub gradient: [[f64; 2]; 2],
}

/// Displacement with first and second derivatives at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet2 {
    /// `u_i`.
    pub value: Vec2,
    /// `gradient[i][j] = ∂_j u_i`.
    pub gradient: [[f64; 2]; 2],
    /// `hessian[i][j][k] = ∂_j ∂_k u_i`.
    pub hessian: [[[f64; 2]; 2]; 2],
}

/// An exact displacement of both bodies, with what quadrature has to know of it.
pub trait Exact: Send + Sync {
    /// `u(x)` in `body`.
    fn value(&self, body: Body, x: Point) -> Vec2;
    /// `u` and `∇u`.
    fn jet(&self, body: Body, x: Point) -> Jet;
    /// `u`, `∇u` and `∇∇u`.
    fn jet2(&self, body: Body, x: Point) -> Jet2;
    /// Points where derivatives blow up: quadrature is graded towards them.
    fn singular_points(&self) -> Vec<Point>;
    /// Lines across which a derivative up to the second jumps: quadrature is cut there.
    fn break_lines(&self) -> Vec<Segment>;
    /// Points of `Γ_K` where contact switches on or off.
    fn switch_points(&self) -> Vec<Point>;
    /// Remarks for the record, e.g. a dropped tail.
    fn notes(&self) -> Vec<String> {
        Vec::new()
    }
}
