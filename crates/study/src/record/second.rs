//! A second solver's answer beside the first one's.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What another solver says of the same discrete problem, and how far the two answers are apart.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SecondOpinion {
    /// `interior-point`, `monotone`, `condensed`.
    pub name: String,
    /// How its solve ended.
    pub status: String,
    /// Whether its answer may be used.
    pub solved: bool,
    /// Its iterations.
    pub iterations: usize,
    /// `|L(u₁) − L(u₂)| / ½A(u₁,u₁)`.
    pub energy_difference: f64,
    /// `max|u₁ − u₂| / max|u₁|` over the nodes.
    pub displacement_difference: f64,
    /// Constraints that press clearly (`λ > 1e-8 max λ`) in one answer and are clearly open (`g − n·d > 1e-8 max|u|`) in the other.
    pub active_difference: usize,
    /// `Σ |x_i||K_ij||x_j| / xᵀKx`: how many times the terms of the strain energy exceed their sum. Rounding of the data moves the
    /// energy by this times the unit roundoff, whatever the solver.
    pub cancellation: f64,
}
