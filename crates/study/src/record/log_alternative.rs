//! A rate with a logarithm, as a record holds it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// `e ≈ C h^exponent |log h|^q` with `q` given, fitted to the levels of the [`Rate`](super::Rate) that holds it. Reported where
/// the regularity is borderline and never gated: on a few levels a logarithm is hard to tell from a change of the exponent.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LogAlternative {
    /// The given power of the logarithm.
    pub q: f64,
    /// The exponent of `h` beside it.
    pub exponent: f64,
    /// Coefficient of determination of `log e − q log|log h|` against `log h`.
    pub r2: f64,
    /// Root mean square of the residuals of `log e`, to be held against that of the plain power.
    pub residual: f64,
    /// The same of the plain power `C h^slope`.
    pub plain_residual: f64,
}
