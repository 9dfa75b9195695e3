//! Gates and expectations.

use crate::file::expected::ExpectedRate;
use crate::file::number::{Finite, OrNone};
use crate::file::spanned::Spanned;
use schemars::JsonSchema;
use serde::Deserialize;

/// Gates of the verdict that are moved.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawGates {
    /// Tolerance on the rate; default 0.05.
    pub rate_tolerance: Option<Spanned<Finite>>,
    /// Largest error over the interpolant's; default 1.5, "none": no ceiling.
    pub ceiling: Option<Spanned<OrNone>>,
    /// Kind `exact`: largest error over the norm of the solution; default 1e-11.
    pub exact_tolerance: Option<Spanned<Finite>>,
    /// Kind `convergence`: largest error over that of the level before; default 0.9.
    pub fall: Option<Spanned<Finite>>,
    /// Kind `bounded`: largest over smallest constant; default 2.
    pub spread: Option<Spanned<Finite>>,
    /// Kind `bounded`: what the largest is held against; kind `agreement`: the largest relative difference from the formula.
    pub constant: Option<Spanned<Finite>>,
    /// Largest part of the measured error that anything but the discretisation may have; default 0.05.
    pub share: Option<Spanned<Finite>>,
    /// Only in controls: no grading of quadrature towards singular points.
    pub fixed_quadrature: Option<Spanned<bool>>,
    /// Why they are moved; needed.
    pub reason: Option<String>,
}

/// What to expect of the rate.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawExpected {
    /// The rate that the regularity suggests; "corners": computed from the corners of the scene; "none".
    pub rate: Option<ExpectedRate>,
    /// In place of the claim's bound of the paper; "none" takes it away.
    pub paper: Option<OrNone>,
    /// In place of today's bound.
    pub today: Option<OrNone>,
    /// Whether a rate above the expected one is reported, not gated; needs a reason.
    #[serde(default)]
    pub asymptotic_only: bool,
    /// Whether fits with a logarithm are reported beside the rate.
    pub borderline: Option<bool>,
    /// Shown in the report.
    pub reason: Option<String>,
}
