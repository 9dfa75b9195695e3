//! What a record holds of the contact zone itself: force, contact width, pressure, and what a formula says of them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The contact of one level in numbers that an engineer asks for. Of a symmetric half model force and width are those of
/// the whole.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ContactMeasure {
    /// Sum of the multipliers of the zone, `∫ p dμ`: the force across a gap, the integral of the pressure along a path.
    pub force: f64,
    /// Half the measure of the contact set (length, or width in `η` across a gap); 0 where nothing touches.
    pub half_width: f64,
    /// Largest nodal pressure `λ_i/m_i`.
    pub peak_pressure: f64,
    /// What the study's formula says.
    #[serde(default)]
    pub formula: Option<FormulaValues>,
    /// The zone of this level, on its way into [`StudyRecord::zone`](super::StudyRecord::zone): only while a case is
    /// unfinished, and only on its finest level.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub profile: Option<ZoneProfile>,
}

/// The numbers of a formula; `None` where it gives none.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FormulaValues {
    /// As [`ContactMeasure::force`].
    pub force: Option<f64>,
    /// As [`ContactMeasure::half_width`].
    pub half_width: Option<f64>,
    /// As [`ContactMeasure::peak_pressure`].
    pub peak_pressure: Option<f64>,
}

/// Pressure and gap node by node, in the order of the zone. All lists have the same length; a corner with two
/// constraints stands twice, a constraint that the supports decide not at all.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ZoneProfile {
    /// Whether the zone is measured in `η`, across a gap, and not by its length.
    pub across_gap: bool,
    /// Whether the zone starts on an axis of symmetry.
    pub symmetric: bool,
    /// Distance from the start of the zone in that measure.
    pub coordinate: Vec<f64>,
    /// The node of `Ω'`.
    pub points: Vec<[f64; 2]>,
    /// `λ_i/m_i`, with the lumped mass `m_i` in that measure.
    pub pressure: Vec<f64>,
    /// `ε − n·(u'_h − u''_h)`, not negative but for rounding.
    pub gap: Vec<f64>,
    /// What the pressure is compared with.
    pub reference: Option<ReferencePressure>,
}

/// A pressure to compare with, at the nodes of a [`ZoneProfile`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReferencePressure {
    /// Where it comes from.
    pub source: PressureSource,
    /// Its values; none where it has none, as at a switch point where an exact pressure is infinite.
    pub pressure: Vec<Option<f64>>,
}

/// Where a [`ReferencePressure`] comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum PressureSource {
    /// The study's formula, which need not hold exactly.
    Formula,
    /// The exact solution.
    Exact,
}
