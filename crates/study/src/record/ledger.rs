//! The ledger of one level, as a record holds it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// `½A(e,e) ≤ a + b + c`, term by term.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Ledger {
    /// `½A(e,e)`.
    pub lhs: f64,
    /// `½A(u−u_I, u−u_I)`.
    pub a: f64,
    /// `∫ T_n [u_I]_n ds`.
    pub b: f64,
    /// Third term of the curved theorems, from `K_h ⊄ K`: `∫ T_n (Φ − U_h) ds` on an arc, `−∫ T_ξ (U_h − ε)_+ dη` across a
    /// gap; 0 on polygons.
    pub c: f64,
    /// What the proof bounds `b` and `c` by, name by name (see [`Ledger::PARTS`]); empty on polygons.
    #[serde(default)]
    pub parts: BTreeMap<String, f64>,
    /// Quadrature estimate of all terms together.
    pub delta: f64,
    /// `true`: holds; `false`: broken beyond `10 δ`; `None`: within `10 δ`.
    pub holds: Option<bool>,
}

impl Ledger {
    /// Names of the parts and what they are. Norms are those of `L²(Γ_K)`, in the measure of the zone; the others are
    /// squares, like `b` itself.
    pub const PARTS: [(&'static str, &'static str); 7] = [
        ("trace_interpolation", "‖[u_I−u]ₙ‖₀"),
        ("jump_minus_chord", "‖Uₕ−Ũₕ‖₀"),
        ("nodal_minus_chord", "‖Φ−Ũₕ‖₀"),
        ("nodal_minus_jump", "‖Φ−Uₕ‖₀"),
        ("b_gap", "b on full sides"),
        ("b_switch", "b on switch sides"),
        ("gap_interpolation", "‖ε_I−ε‖₀"),
    ];

    /// Names of the terms of the estimate itself.
    pub const TERMS: [&'static str; 4] = ["lhs", "a", "b", "c"];

    /// The term of [`Ledger::TERMS`] or part of [`Ledger::PARTS`] of that name, with its sign.
    pub fn term(&self, name: &str) -> Option<f64> {
        match name {
            "lhs" => Some(self.lhs),
            "a" => Some(self.a),
            "b" => Some(self.b),
            "c" => Some(self.c),
            part => self.parts.get(part).copied(),
        }
    }

    /// The right side, `a + b + c`.
    pub fn sum(&self) -> f64 {
        self.a + self.b + self.c
    }

    /// Whether a term is the square of an energy norm; the others are norms on the zone.
    pub fn is_square(name: &str) -> bool {
        Self::TERMS.contains(&name) || ["b_gap", "b_switch"].contains(&name)
    }
}
