//! Traces as a study writes them, and what may be wrong with them.

use super::{BodyTraces, Function, Line, Traces};
use crate::expr::{ExprError, Expression};
use signorini_contact::{Body, Point, material::Lame};
use std::collections::BTreeMap;
use std::fmt;

/// The contact line of a lemma, and the name of its parameter in the traces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineText<'a> {
    /// The line `y = 0`; parameter `x`.
    Straight,
    /// The circle `centre + radius (cos θ, sin θ)`; parameter `theta`, within half a turn of `middle` (radians): the contact
    /// zone may not cross the angle opposite to it.
    Arc {
        /// The centre.
        centre: Point,
        /// The radius `R > 0`.
        radius: f64,
        /// The angle about which `theta` is measured, so that `middle − π < theta ≤ middle + π`.
        middle: f64,
    },
    /// The graphs `x = f(η)`, `y = η`; parameter `eta`. `f` of `Ω'` (to the right of its graph) and of `Ω''`.
    Graph {
        /// Expressions in `eta`.
        f: [&'a str; 2],
    },
}

/// The expressions of the traces; where there are two, of `Ω'` and of `Ω''`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceTexts<'a> {
    /// The contact line.
    pub line: LineText<'a>,
    /// The component of the displacement across the line: `u_2` on a straight line, `u_r` on an arc, `u_x` on a graph.
    pub w: [&'a str; 2],
    /// The component along it: `u_1`, `u_θ`, `u_y`.
    pub a: [&'a str; 2],
    /// The stress on the line: `τ_22`, `τ_rr`, and `p` with `τ (1, −F)ᵀ = (p, 0)ᵀ` on a graph of slope `F`.
    pub p: &'a str,
    /// `q(x, y)`, zero where the body is clamped and nowhere on the contact line; `None`: no cutoff.
    pub cutoff: Option<[&'a str; 2]>,
}

/// Which of the expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TraceName {
    /// `w`.
    W,
    /// `a`.
    A,
    /// `p`, shared by the bodies.
    P,
    /// `f` of a graph.
    F,
    /// The cutoff.
    Cutoff,
}

/// Traces that make no sense.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TraceError {
    /// An expression does not parse.
    #[error("{name}{}: {source}", body.map_or("", |b| [" of Ω'", " of Ω''"][b.index()]))]
    Expression {
        /// Which one.
        name: TraceName,
        /// Whose; `None` for `p`.
        body: Option<Body>,
        /// What is wrong with it.
        source: ExprError,
    },
    /// The circle is none.
    #[error("the radius {0} must be positive and finite")]
    Radius(f64),
}

impl fmt::Display for TraceName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::W => "trace w",
            Self::A => "trace a",
            Self::P => "stress p",
            Self::F => "graph f",
            Self::Cutoff => "cutoff",
        })
    }
}

impl LineText<'_> {
    /// The name of the parameter of the line.
    pub fn parameter(&self) -> &'static str {
        match self {
            Self::Straight => "x",
            Self::Arc { .. } => "theta",
            Self::Graph { .. } => "eta",
        }
    }
}

impl TraceTexts<'_> {
    /// The variables of an expression.
    pub fn variables(&self, name: TraceName) -> Vec<&'static str> {
        if name == TraceName::Cutoff { vec!["x", "y"] } else { vec![self.line.parameter()] }
    }
}

impl Traces {
    /// Parses the traces, with parameters by name, for bodies with the given Lamé constants. Switches, singular points and
    /// breaks start empty, `reach` is 1.
    ///
    /// # Errors
    /// The first expression that does not parse, or a radius that is not positive.
    pub fn parse(
        texts: &TraceTexts<'_>,
        parameters: &BTreeMap<String, f64>,
        lame: [Lame; 2],
    ) -> Result<Self, TraceError> {
        let one = |name: TraceName, body: Option<Body>, text: &str| {
            Expression::parse(text, &texts.variables(name), parameters).map_err(|source| TraceError::Expression {
                name,
                body,
                source,
            })
        };
        let of = |body: Body, name: TraceName, pair: [&str; 2]| one(name, Some(body), pair[body.index()]);
        let line = match texts.line {
            LineText::Straight => Line::Straight,
            LineText::Arc { radius, .. } if !(radius > 0.0 && radius.is_finite()) => {
                return Err(TraceError::Radius(radius));
            }
            LineText::Arc { centre, radius, middle } => Line::Arc { centre, radius, middle },
            LineText::Graph { f } => {
                let f = [of(Body::First, TraceName::F, f)?, of(Body::Second, TraceName::F, f)?];
                Line::Graph(Box::new(f.map(|value| Function { slope: value.derivative(0), value })))
            }
        };
        let body = |body: Body| -> Result<BodyTraces, TraceError> {
            let (w, a) = (of(body, TraceName::W, texts.w)?, of(body, TraceName::A, texts.a)?);
            let cutoff = texts.cutoff.map(|q| of(body, TraceName::Cutoff, q)).transpose()?;
            Ok(BodyTraces { slope_w: w.derivative(0), slope_a: a.derivative(0), w, a, cutoff })
        };
        Ok(Self {
            bodies: [body(Body::First)?, body(Body::Second)?],
            p: one(TraceName::P, None, texts.p)?,
            line,
            lame,
            switches: Vec::new(),
            singular: Vec::new(),
            breaks: Vec::new(),
            reach: 1.0,
        })
    }
}
