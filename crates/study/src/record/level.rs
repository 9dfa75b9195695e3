//! One mesh size of a case: what was solved there, how well, and how large the error is.

use super::{BilateralRecord, ContactMeasure, Errors, Ledger, SecondOpinion, Splitting};
use crate::fields::Fields;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
