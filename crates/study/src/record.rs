//! What a study leaves behind: one [`StudyRecord`] per case. Tables, plots, pages and gates read nothing else.
//!
//! A number is `null` exactly where there is no value; a non-finite number is refused by [`StudyRecord::to_json`].

use crate::finite;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

mod bilateral;
mod changed;
mod corner;
mod errors;
mod extrapolation;
mod ledger;
mod level;
mod log_alternative;
mod refusal;
mod second;
mod splitting;
mod verdict;
mod zone;
pub use bilateral::BilateralRecord;
pub use changed::{Changed, Setting};
pub use corner::{Corner, CornerState, CornerWedge, RayState, corner_rate};
pub use errors::Errors;
pub use extrapolation::Extrapolation;
pub use ledger::Ledger;
pub use level::{Budget, Kkt, Level, NO_SOLVER, SolverRecord};
pub use log_alternative::LogAlternative;
pub use refusal::Refusal;
pub use second::SecondOpinion;
pub use splitting::{Estimate, Splitting};
pub use verdict::{Bounds, ClaimKind, Outcome, Rate, Verdict};
pub use zone::{ContactMeasure, FormulaValues, PressureSource, ReferencePressure, ZoneProfile};

/// The version of the record's form.
pub const SCHEMA: u32 = 1;

/// The result of one case of a study.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StudyRecord {
    /// [`SCHEMA`] of the writer.
    pub schema: u32,
    /// Study id.
    pub study: String,
    /// Case name; the study's id where there is one case only.
    pub case: String,
    /// Whether the study has several cases (each then has a folder of its own).
    pub several: bool,
    /// Title of the study.
    pub title: String,
    /// What the study asks, in words.
    pub question: String,
    /// What is set up, in words.
    pub setup: String,
    /// What would refute the claim, in words.
    pub refuted_by: String,
    /// Numbers that define the case (`k`, `m`, `alpha`, `N`, …).
    pub parameters: BTreeMap<String, f64>,
    /// Claim id of the catalogue, or `own`.
    pub claim: String,
    /// The statement of the claim in words.
    pub statement: String,
    /// What must hold for the claim to apply. Not in records of older runs.
    #[serde(default)]
    pub hypotheses: Vec<String>,
    /// How the claim is judged.
    pub kind: ClaimKind,
    /// The norm that the claim judges: a key of `rates`.
    pub norm: String,
    /// Family of triangulations.
    pub family: String,
    /// `exact` or `overkill`.
    pub reference: Reference,
    /// `quick`, `full` or `custom` (`--levels`).
    pub profile: String,
    /// Seed of the random family, 0 where nothing is random.
    pub seed: u64,
    /// From the coarsest to the finest.
    pub levels: Vec<Level>,
    /// Fitted rates by name of the error norm (a field of [`Errors`]); `ledger.<term>` for the terms of the ledger (see
    /// [`Ledger::term`]), by absolute value; and `dofs` against `dofs^{-1/2}`.
    pub rates: BTreeMap<String, Rate>,
    /// The three numbers a rate is held against.
    pub bounds: Bounds,
    /// The judgement.
    pub verdict: Verdict,
    /// What a control expects; a control passes when it gets it.
    pub expect: Option<Outcome>,
    /// Why an inconclusive verdict is expected at this profile's sizes.
    pub expected_inconclusive: Option<String>,
    /// Remarks for the reader: dropped tails, warnings of the mesh, drift from the baseline.
    pub notes: Vec<String>,
    /// Pressure and gap along the contact zone on the finest level; none of a lemma, and not in records of older runs.
    #[serde(default)]
    pub zone: Option<ZoneProfile>,
    /// The corners of a scene without exact solution and their exponents. Not in records of older runs, as the field below.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub corners: Vec<Corner>,
    /// The energy that the levels' energies tend to, where `K_h ⊂ K` on nested meshes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extrapolation: Option<Extrapolation>,
    /// Of a case that was to be refused: it has no levels.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refusal: Option<Refusal>,
    /// What options changed of the study before it ran; nothing of a study as its file has it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changed: Option<Changed>,
}

/// Which reference the errors are measured against.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Reference {
    /// A closed form.
    Exact,
    /// The discrete solution on a finer mesh, nested where that can be.
    Overkill {
        /// Mesh size of the reference.
        h: f64,
        /// Its free displacement components.
        dofs: usize,
        /// Its energy `L(u_ref)`.
        energy: f64,
        /// Its own error in the energy norm, estimated from its place on the fitted curve.
        estimated_error: Option<f64>,
        /// Its scaled stationarity residual.
        stationarity: f64,
        /// The solver that computed it.
        solver: String,
    },
    /// No reference: energies and KKT residuals alone.
    None,
}

impl Reference {
    /// `exact`, `overkill` or `none`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Overkill { .. } => "overkill",
            Self::None => "none",
        }
    }
}

/// A record that cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// A number is NaN or infinite; JSON has no word for it.
    #[error("record: {path} is {value}, and JSON has no such number")]
    NonFinite {
        /// Where in the record, e.g. `levels[3].errors.strain`.
        path: String,
        /// `NaN`, `inf` or `-inf`.
        value: f64,
    },
    /// Malformed JSON, or a record with missing or mistyped fields.
    #[error("record: {0}")]
    Json(#[from] serde_json::Error),
    /// A record of another schema.
    #[error("record: schema {found}, this program reads {SCHEMA}: run the study again")]
    Schema {
        /// What the record says.
        found: u32,
    },
}

/// Any value as indented JSON with a closing newline: fields in the order of their declaration, maps by key.
///
/// # Errors
/// [`RecordError::NonFinite`] names the first NaN or infinite number.
pub fn to_json(value: &impl Serialize) -> Result<String, RecordError> {
    finite::check(value)?;
    Ok(serde_json::to_string_pretty(value)? + "\n")
}

impl StudyRecord {
    /// The record as indented JSON, the same bytes for the same record.
    ///
    /// # Errors
    /// [`RecordError::NonFinite`] names the first NaN or infinite number.
    pub fn to_json(&self) -> Result<String, RecordError> {
        to_json(self)
    }

    /// Reads a record of this [`SCHEMA`].
    ///
    /// # Errors
    /// [`RecordError::Schema`] for another schema, [`RecordError::Json`] for anything that is no record.
    pub fn from_json(text: &str) -> Result<Self, RecordError> {
        #[derive(Deserialize)]
        struct Head {
            schema: u32,
        }
        // the head first: a record of another schema is told so, not that a field is missing
        let found = serde_json::from_str::<Head>(text)?.schema;
        if found != SCHEMA {
            return Err(RecordError::Schema { found });
        }
        Ok(serde_json::from_str(text)?)
    }
}

#[cfg(test)]
mod tests;
