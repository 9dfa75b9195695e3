//! What the energies of nested levels say of the error without any reference.

use super::Rate;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The limit `L*` of the levels' energies `L(u_h) ≈ L* + C h^{2r}`, and the errors that it bounds. Where `K_h ⊂ K`,
/// `A(u−u_h, u−u_h) ≤ 2 (L(u_h) − L(u))`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Extrapolation {
    /// `L*`, from the three finest levels.
    pub energy: f64,
    /// Largest change of `L*` when another one of the four finest levels is left out.
    pub uncertainty: f64,
    /// `r`.
    pub rate: f64,
    /// `√(2 (L(u_h) − L*))` on each level: an upper bound of the energy error if `L* ≤ L(u)`. `None` where `L(u_h) ≤ L*`.
    pub bounds: Vec<Option<f64>>,
    /// The rate fitted to these bounds.
    pub fitted: Option<Rate>,
    /// `L_ref − L*` with the energy of the reference, exact or overkill; `None` without one. An overkill reference lies above
    /// `L(u)`, an exact one on it.
    pub reference_above: Option<f64>,
}
