//! What a study leaves behind: one [`StudyRecord`] per case. Tables, plots, pages and gates read nothing else.
//!
//! A number is `null` exactly where there is no value; a non-finite number is refused by [`StudyRecord::to_json`].

use crate::fields::Fields;
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
mod log_alternative;
mod refusal;
mod second;
mod splitting;
mod zone;
pub use bilateral::BilateralRecord;
pub use changed::{Changed, Setting};
pub use corner::{Corner, CornerState, CornerWedge, RayState, corner_rate};
pub use errors::Errors;
pub use extrapolation::Extrapolation;
pub use ledger::Ledger;
pub use log_alternative::LogAlternative;
pub use refusal::Refusal;
pub use second::SecondOpinion;
pub use splitting::{Estimate, Splitting};
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

/// One mesh size of a case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Level {
    /// From 0, the coarsest.
    pub level: usize,
    /// Cells per unit of the coarse division, the study's `n`.
    pub cells: usize,
    /// Largest side of the mesh.
    pub h: f64,
    /// Smallest angle, in degrees.
    pub min_angle: f64,
    /// Longest over shortest side, `β`.
    pub side_ratio: f64,
    /// Longest straight side over the longest chord of a curved one, at most 1 where the hypothesis of Theorem 3.3 is met;
    /// `None` where nothing is curved, and in records of older runs.
    #[serde(default)]
    pub straight_over_chord: Option<f64>,
    /// Whether `V_{k−1} ⊂ V_k` (false on the coarsest level of a family that is not nested).
    pub nested: bool,
    /// Displacement components not fixed by `Γ_u` or `Γ_0`.
    pub dofs: usize,
    /// Node pairs on `Γ_K`.
    pub contact_pairs: usize,
    /// Constraint rows kept.
    pub constraints: usize,
    /// Constraints with a multiplier `λ > 1e-8 max λ`.
    pub active: usize,
    /// Sides of the contact zone that hold a switch point.
    pub switch_sides: Option<usize>,
    /// `L(u_h)`.
    pub energy: f64,
    /// Relative difference of `A(e,e)` by quadrature and by energies.
    pub two_way: Option<f64>,
    /// 16 hex digits of the mesh's FNV-1a hash.
    pub mesh_hash: String,
    /// Errors of the discrete solution (norms, both bodies together).
    pub errors: Errors,
    /// Ledger of the error estimate, in squares of the energy norm.
    pub ledger: Option<Ledger>,
    /// Falk's splitting, by kinds of `v` and `v_h`, where the study measures it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub splitting: Vec<Splitting>,
    /// Whether `K_h ⊂ K` by construction, so that energies of nested meshes may only fall. Not in records of older runs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inside: Option<bool>,
    /// KKT certificate.
    pub kkt: Kkt,
    /// Shares of `errors.energy`.
    pub budget: Budget,
    /// How it was solved.
    pub solver: SolverRecord,
    /// What deserves a warning: nearly dependent normals, a free slide that was pinned.
    pub warnings: Vec<String>,
    /// Whether the level may enter the fit, and if not why.
    pub excluded: Option<String>,
    /// `‖u‖_A = √A(u,u)` of the reference, or of `u_h` where there is none: what makes an error rounding.
    pub solution_energy: Option<f64>,
    /// `‖u_h‖_1`, both bodies together: what Remarks 3.4 to 3.6 ask to be bounded. Not in records of older runs.
    #[serde(default)]
    pub solution_h1: Option<f64>,
    /// `max |u_h|` over the nodes times the square root of the length of `Γ_K`: the scale of `penetration_l2`.
    pub solution_trace: Option<f64>,
    /// Force, width and pressure of the contact; none of a lemma, and not in records of older runs.
    #[serde(default)]
    pub contact: Option<ContactMeasure>,
    /// What another solver says, where the study asks one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second: Option<SecondOpinion>,
    /// The fields of the level, on their way into [`CaseRun::fields`](crate::run::CaseRun::fields): only while a case is unfinished.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(skip)]
    pub fields: Option<Box<Fields>>,
}

/// Scaled residuals of the optimality conditions (no units), recomputed from the raw data.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Kkt {
    /// `‖f−Kx−λ‖_∞ / (‖K‖_∞‖x‖_∞ + ‖f‖_∞)`.
    pub stationarity: f64,
    /// The same row by row, `max_i |f−Kx−λ|_i / (|K||x| + |f|)_i`; recorded where a second solver is asked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub componentwise: Option<f64>,
    /// `max(x_c−g)_+ / max|u|`.
    pub penetration: f64,
    /// `max(−λ)_+ / max|λ|`.
    pub tension: f64,
    /// `Σ|λ(g−x_c)| / A(u_h,u_h)`.
    pub complementarity: f64,
    /// Constraints with `λ < 1e-8 max λ` and `g−x_c < 1e-8 max|u|`.
    pub weakly_active: usize,
    /// The bilateral constraints, of which the residuals above know nothing; none without a bilateral part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bilateral: Option<BilateralRecord>,
}

/// What else than the discretisation may sit in the measured error, as shares of `errors.energy`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Budget {
    /// KKT residual in the energy norm.
    pub algebraic: Option<f64>,
    /// Loads, error integrals and energies against a finer rule.
    pub quadrature: Option<f64>,
    /// Domain replaced by its mesh; 0 on polygons.
    pub geometry: Option<f64>,
    /// Contamination by the reference's own error.
    pub reference: Option<f64>,
    /// `‖u_h − I u_h‖_A`, with the interpolant `I` on the mesh of a reference that is not nested: the part of `u_h` that is not
    /// orthogonal to the reference's own error. A factor of `reference`, no error by itself; not in records of older runs.
    #[serde(default)]
    pub unresolved: Option<f64>,
}

/// [`SolverRecord::name`] of a level on which nothing is solved: a lemma is measured on it. Its energy, its counts of
/// pairs and constraints and its [`Kkt`] residuals are zero and mean nothing; `dofs` are two for every node; the smallest
/// angle is 0 where the family consists of intervals.
pub const NO_SOLVER: &str = "none";

/// How a level was solved.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SolverRecord {
    /// `condensed`, `interior-point`, …
    pub name: String,
    /// `converged`, `rescued`, `iteration limit`, …
    pub status: String,
    /// Whether the answer may be used.
    pub solved: bool,
    /// Active-set or interior-point iterations.
    pub iterations: usize,
    /// Sparse factorisations.
    pub factorizations: usize,
    /// Multigrid: work in products with the matrix, from the coarsest level on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work: Option<f64>,
}

impl SolverRecord {
    /// Of a level on which nothing is solved.
    pub fn nothing_to_solve() -> Self {
        Self { name: NO_SOLVER.into(), status: "nothing to solve".into(), solved: true, ..Self::default() }
    }
}

impl Level {
    /// Whether a contact problem was solved on this level; `false` where a lemma was measured, see [`NO_SOLVER`].
    pub fn has_solution(&self) -> bool {
        self.solver.name != NO_SOLVER
    }
}

/// A fitted rate, `e ≈ C h^slope`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Rate {
    /// Least-squares slope of `log e` against `log h`.
    pub slope: f64,
    /// Its standard error.
    pub stderr: f64,
    /// Lower end of the 95 % interval (Student t).
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// The levels of the asymptotic window.
    pub levels: Vec<usize>,
    /// `log C`.
    pub intercept: f64,
    /// Coefficient of determination.
    pub r2: f64,
    /// Rates between successive usable levels: `(finer level, rate)`.
    pub pairwise: Vec<(usize, f64)>,
    /// Second difference of the log–log curve: the mean change of the pairwise rate per level in the window.
    pub curvature: f64,
    /// Slope of the same window against `dofs^{-1/2}`.
    pub dofs_slope: f64,
    /// Whether the pairwise rates of the window have settled; if not, the window is the last four levels.
    pub asymptotic: bool,
    /// Fits with a logarithm, where the study calls the regularity borderline.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub log_alternatives: Vec<LogAlternative>,
}

/// What a rate is held against; `None` where there is no such bound.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Bounds {
    /// The paper's.
    pub paper: Option<f64>,
    /// Today's best.
    pub today: Option<f64>,
    /// From the regularity of the solution.
    pub expected: Option<f64>,
}

/// How a claim is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ClaimKind {
    /// The fitted rate against the bound.
    Rate,
    /// An inequality on every level.
    Inequality,
    /// Rounding error on every level.
    Exact,
    /// Errors fall from level to level by a stated factor.
    Convergence,
    /// The largest over the smallest constant of the levels or cases is bounded.
    Bounded,
    /// The difference from a formula is small on the finest level.
    Agreement,
    /// Every solve ends solved, certified, and as another solver ends it.
    Certificate,
}

/// Pass, fail or inconclusive. Ordered from best to worst, so the worst of several is their maximum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// The claim holds as far as the study can see.
    Pass,
    /// The study cannot judge.
    Inconclusive,
    /// The claim is refuted.
    Fail,
}

/// A judgement with its reasons, for the reader.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Verdict {
    /// What came out.
    pub outcome: Outcome,
    /// Why, most important first.
    pub reasons: Vec<String>,
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
