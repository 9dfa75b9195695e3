//! A scene that has no solution, and what the program said of it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A case that was to be refused for want of equilibrium.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Refusal {
    /// The program's message on the coarsest level; `None` where it accepted the scene.
    pub message: Option<String>,
    /// How many levels were tried.
    pub levels: usize,
    /// How many of them were refused.
    pub refused: usize,
}
