//! What is known of the solution.

use super::{RawField, RawPoint};
use crate::file::fixed::Fixed;
use crate::file::number::{Finite, NumberOrText};
use crate::file::spanned::Spanned;
use schemars::JsonSchema;
use serde::Deserialize;

/// The exact solution, by one of: `builtin`; `first` and `second`; `traces`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawExact {
    /// Name of a built-in solution; `none` takes the study's back in a case.
    pub builtin: Option<Spanned<String>>,
    /// Displacement of Ω', two expressions in x, y.
    pub first: Option<RawField>,
    /// Displacement of Ω''.
    pub second: Option<RawField>,
    /// Traces on the contact line, which a lemma continues into both bodies.
    pub traces: Option<Spanned<RawTraces>>,
    /// Points where derivatives blow up; quadrature is graded towards them.
    #[serde(default)]
    pub singular: Vec<RawPoint>,
    /// Segments across which a derivative up to the second jumps; quadrature is cut there.
    #[serde(default)]
    pub breaks: Vec<Fixed<RawPoint, 2>>,
    /// Points of the contact zone where contact begins or ends.
    #[serde(default)]
    pub switches: Vec<RawPoint>,
    /// Only in controls: the materials that the loads belong to, in place of the bodies' own.
    pub materials: Option<Spanned<Fixed<RawLame, 2>>>,
}

/// Traces of the exact solution on the contact line, expressions of its parameter.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawTraces {
    /// The contact line and its parameter.
    pub lemma: Spanned<TraceLemma>,
    /// Displacement across the line, of Ω' and of Ω''.
    pub w: RawField,
    /// Displacement along the line, of Ω' and of Ω''.
    pub a: RawField,
    /// Stress on the line, the same for both bodies: negative in contact, zero across an open gap.
    pub p: Spanned<String>,
    /// Of `graph`: the two functions of eta.
    pub f: Option<Spanned<RawField>>,
    /// Of `arc`: its centre.
    pub centre: Option<Spanned<RawPoint>>,
    /// Of `arc`: its radius.
    pub radius: Option<Spanned<Finite>>,
    /// Of `arc`: theta runs within half a turn of this angle; default 0.
    pub middle: Option<Spanned<Finite>>,
    /// Expressions in x, y that vanish where the body is clamped and nowhere on the line; "1" is none.
    pub cutoff: Option<RawField>,
    /// Parameters where contact begins or ends.
    #[serde(default)]
    pub switches: Vec<Finite>,
    /// Parameters where derivatives blow up.
    #[serde(default)]
    pub singular: Vec<Finite>,
    /// Parameters where a derivative jumps.
    #[serde(default)]
    pub breaks: Vec<Finite>,
}

/// The contact line of traces.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum TraceLemma {
    /// y = 0, parameter x.
    Line,
    /// A circle, parameter theta.
    Arc,
    /// x = f(eta), y = eta, one graph per body.
    Graph,
}

impl TraceLemma {
    /// As it is written in the file.
    pub fn word(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Arc => "arc",
            Self::Graph => "graph",
        }
    }
}

/// What a formula says of the contact. Each entry may use the ones above it by name.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawFormula {
    /// The contact force.
    pub force: Option<Spanned<NumberOrText>>,
    /// Half the measure of the contact set.
    pub half_width: Option<Spanned<NumberOrText>>,
    /// The largest contact pressure.
    pub peak_pressure: Option<Spanned<NumberOrText>>,
    /// The pressure at a point of the boundary of Ω', an expression in x, y; zero where nothing touches.
    pub pressure: Option<Spanned<String>>,
}

/// An isotropic material.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawLame {
    /// Lamé's constants [λ, μ].
    pub lame: Fixed<Finite, 2>,
}
