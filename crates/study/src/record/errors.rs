//! The errors of one level, as a record holds them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Errors against the reference. `None` where the reference or the scene gives no value.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Errors {
    /// The paper's seminorm, `(∫ ε_ij(e) ε_ij(e) dx)^{1/2}`.
    pub strain: Option<f64>,
    /// `√A(e,e)`.
    pub energy: Option<f64>,
    /// The full `H¹` norm.
    pub h1: Option<f64>,
    /// `L²`.
    pub l2: Option<f64>,
    /// `L²(Γ_K)` norm of the contact pressure's error.
    pub pressure_l2: Option<f64>,
    /// Lumped dual norm of the contact pressure's error, `(Σ_sides h_s ‖p − p_h‖²_{0,s})^{1/2}`.
    pub pressure_dual: Option<f64>,
    /// `‖([u_h]_n)_+‖_{0,Γ_K}`: penetration between nodes.
    pub penetration_l2: Option<f64>,
    /// Length of the symmetric difference of the contact sets.
    pub contact_set: Option<f64>,
    /// Largest distance of a switch point of the reference from the nearest of the discrete solution, the middle of a side
    /// with one active end. Not in records of older runs.
    #[serde(default)]
    pub switch_position: Option<f64>,
    /// Error of the energy, `L(u_h) − L(u)`.
    pub energy_gap: Option<f64>,
    /// Strain seminorm on `Ω'` and on `Ω''`.
    pub strain_bodies: Option<[f64; 2]>,
    /// `√A(u−u_I, u−u_I)`, the interpolation error the ceiling is measured by.
    pub interpolation: Option<f64>,
    /// `‖u − u_I‖_{0,∂Ω}`, of Lemma 3.2. Not in records of older runs.
    #[serde(default)]
    pub boundary_l2: Option<f64>,
    /// The constant of an estimate, of Lemmas 3.3 and 3.4: no error, so no rate is fitted to it. Not in records of older
    /// runs.
    #[serde(default)]
    pub constant: Option<f64>,
    /// Relative difference of the half width from the study's formula, signed: positive where the discrete contact is
    /// wider. Not in records of older runs, as the two below.
    #[serde(default)]
    pub half_width: Option<f64>,
    /// The same of the peak pressure.
    #[serde(default)]
    pub peak_pressure: Option<f64>,
    /// The same of the force.
    #[serde(default)]
    pub force: Option<f64>,
}

impl Errors {
    /// Names of the errors that a rate is fitted to, in the order of the record.
    pub const NORMS: [&'static str; 10] = [
        "strain",
        "energy",
        "h1",
        "l2",
        "pressure_l2",
        "pressure_dual",
        "penetration_l2",
        "contact_set",
        "energy_gap",
        "boundary_l2",
    ];

    /// Differences from a formula. They contain what the formula neglects and need not vanish, so no rate is fitted to
    /// them; `formula` is the largest of the others.
    pub const OF_FORMULA: [&'static str; 4] = ["half_width", "peak_pressure", "force", "formula"];

    /// The error of the given name, signed ones by their absolute value; `constant` and [`Errors::OF_FORMULA`] too, which
    /// are none of [`Errors::NORMS`]. `None` for a missing value and for an unknown name.
    pub fn size(&self, name: &str) -> Option<f64> {
        match name {
            "strain" => self.strain,
            "energy" => self.energy,
            "h1" => self.h1,
            "l2" => self.l2,
            "pressure_l2" => self.pressure_l2,
            "pressure_dual" => self.pressure_dual,
            "penetration_l2" => self.penetration_l2,
            "contact_set" => self.contact_set,
            "energy_gap" => self.energy_gap.map(f64::abs),
            "boundary_l2" => self.boundary_l2,
            "constant" => self.constant,
            _ => self.difference(name).map(f64::abs),
        }
    }

    /// The signed difference of one of the names of [`Errors::OF_FORMULA`]; of `formula` the one farthest from zero.
    pub fn difference(&self, name: &str) -> Option<f64> {
        match name {
            "half_width" => self.half_width,
            "peak_pressure" => self.peak_pressure,
            "force" => self.force,
            "formula" => {
                let all = [self.half_width, self.peak_pressure, self.force].into_iter().flatten();
                all.reduce(|a, b| if b.abs() > a.abs() { b } else { a })
            }
            _ => None,
        }
    }
}
