//! An exact solution given by the expressions of a study file.

use super::Field;
use crate::expr::{ExprError, Expression, Real};
use signorini_contact::{Body, Point, geometry::Segment};
use std::collections::BTreeMap;

/// Four expressions in `x, y`, with what quadrature cannot see from them.
#[derive(Clone, Debug)]
pub struct Expressions {
    /// `[u'_1, u'_2], [u''_1, u''_2]`.
    components: [[Expression; 2]; 2],
    /// Points where derivatives blow up.
    pub singular_points: Vec<Point>,
    /// Lines across which a derivative up to the second jumps.
    pub break_lines: Vec<Segment>,
    /// Points where contact switches on or off.
    pub switch_points: Vec<Point>,
}

/// An expression of an exact solution that makes no sense.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("u_{} of Ω{}: {source}", component + 1, ["'", "''"][body.index()])]
pub struct ComponentError {
    /// The body.
    pub body: Body,
    /// The component, 0 or 1.
    pub component: usize,
    /// What is wrong with the expression.
    pub source: ExprError,
}

impl Expressions {
    /// Parses `[[u'_1, u'_2], [u''_1, u''_2]]` in `x, y` and the given parameters. Singular points, break lines and switch
    /// points start empty.
    ///
    /// # Errors
    /// The first expression that does not parse.
    pub fn parse(texts: [[&str; 2]; 2], parameters: &BTreeMap<String, f64>) -> Result<Self, ComponentError> {
        let one = |body: Body, component: usize| {
            let text = texts[body.index()][component];
            Expression::parse(text, &["x", "y"], parameters).map_err(|source| ComponentError {
                body,
                component,
                source,
            })
        };
        let both = |body| Ok([one(body, 0)?, one(body, 1)?]);
        Ok(Self {
            components: [both(Body::First)?, both(Body::Second)?],
            singular_points: Vec::new(),
            break_lines: Vec::new(),
            switch_points: Vec::new(),
        })
    }
}

impl Field for Expressions {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let [first, second] = &self.components[body.index()];
        [first.eval(&[x, y]), second.eval(&[x, y])]
    }

    fn singular_points(&self) -> Vec<Point> {
        self.singular_points.clone()
    }

    fn break_lines(&self) -> Vec<Segment> {
        self.break_lines.clone()
    }

    fn switch_points(&self) -> Vec<Point> {
        self.switch_points.clone()
    }
}
