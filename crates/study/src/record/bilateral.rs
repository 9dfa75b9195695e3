//! What a level did on the bilateral part of its contact zone.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The bilateral constraints of a level. The certificate's signs are asked of the unilateral ones alone.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BilateralRecord {
    /// How many there are.
    pub constraints: usize,
    /// `max|n·(u'_h − u''_h) − g|/max|u|` over them, from the nodal displacements: rounding.
    pub jump: f64,
    /// Largest tension `max(−λ/m)_+`, a stress, `m` the length that the constraint stands for.
    pub tension: f64,
    /// Sum of their forces `λ`, positive where they press in total.
    pub force: f64,
}
