//! The study file as it is written: one struct per table, field by field as `studies/README.md` documents them. The
//! comments are the descriptions of the JSON Schema.
//!
//! No `flatten` and no `untagged`: both lose line and column and let misspelt keys pass.

mod curved;
mod judge;
mod lemma;
mod method;
mod scene;
mod solution;

use super::fixed::Fixed;
use super::number::Finite;
use super::spanned::Spanned;
use super::splitting::RawSplitting;
use crate::record::ClaimKind;
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::Arc;

pub use curved::*;
pub use judge::*;
pub use lemma::*;
pub use method::*;
pub use scene::*;
pub use solution::*;

/// Two coordinates.
pub type RawPoint = Fixed<Finite, 2>;
/// Two components, each an expression.
pub type RawField = Fixed<Spanned<String>, 2>;

/// A study: one question about convergence, as data.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawStudy {
    /// Name of the study and of its file: lower-case letters, digits, `-` and `.`.
    pub id: Spanned<String>,
    /// One line.
    pub title: String,
    /// What is asked.
    pub question: String,
    /// What is set up.
    pub setup: String,
    /// What would refute the claim.
    pub refuted_by: String,
    /// Id of a claim of the catalogue; `signorini list` shows them, `signorini explain` one of them.
    pub claim: Option<Spanned<String>>,
    /// A claim of the study's own, in place of `claim`.
    pub own_claim: Option<Spanned<RawClaim>>,
    /// Only in controls: the verdict that the study must get; `refused` in any study: the scene has no equilibrium.
    pub expect: Option<Expect>,
    /// Why the quick profile's meshes are too coarse to judge; the full profile has to.
    pub inconclusive_at_quick: Option<String>,
    /// Numbers that every expression may use by name.
    pub parameters: Option<BTreeMap<String, Finite>>,
    /// A mesh file in place of blocks.
    pub mesh: Option<RawMesh>,
    /// The two bodies; the first is Ω', the second Ω''.
    pub body: Option<Vec<Spanned<RawBody>>>,
    /// The parts of the boundary outside the contact zone; every side belongs to exactly one.
    pub boundary: Option<Vec<RawBoundary>>,
    /// The contact zone.
    pub contact: Option<RawContact>,
    /// The condition p(v) = 0 where a body may slide rigidly in both directions.
    pub slide: Option<Spanned<RawSlide>>,
    /// Curves that blocks, boundary parts and the contact zone may follow.
    pub curve: Option<Vec<Spanned<RawCurve>>>,
    /// How curved sides are discretised; anything but the default departs from the paper on purpose.
    pub discretisation: Option<Spanned<RawDiscretisation>>,
    /// The exact solution.
    pub exact: Option<Spanned<RawExact>>,
    /// What a formula of engineering says of the contact; compared with, never solved with.
    pub formula: Option<Spanned<RawFormula>>,
    /// A lemma on meshes alone, in place of a scene.
    pub lemma: Option<Spanned<RawLemma>>,
    /// The family of triangulations.
    pub family: Option<Spanned<RawFamily>>,
    /// Cells per unit on each level.
    pub levels: Option<RawLevels>,
    /// What errors are measured against.
    pub reference: Option<Spanned<RawReference>>,
    /// How the levels are solved.
    pub solver: Option<RawSolver>,
    /// Measures Falk's splitting of the error on every level.
    pub splitting: Option<Spanned<RawSplitting>>,
    /// Gates of the verdict that are moved, with the reason.
    pub gates: Option<Spanned<RawGates>>,
    /// The rate to expect of this solution.
    pub expected: Option<Spanned<RawExpected>>,
    /// The cases; a table of a case replaces the study's table as a whole, only `parameters` are merged.
    #[serde(default)]
    pub case: Vec<RawCase>,
}

/// A case: whatever differs from the study.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawCase {
    /// Name of the case, unique in the study.
    pub name: Spanned<String>,
    /// As in the study.
    pub expect: Option<Expect>,
    /// As in the study.
    pub inconclusive_at_quick: Option<String>,
    /// Merged with the study's, name by name.
    pub parameters: Option<BTreeMap<String, Finite>>,
    /// In place of the study's.
    pub mesh: Option<RawMesh>,
    /// In place of the study's.
    pub body: Option<Vec<Spanned<RawBody>>>,
    /// In place of the study's.
    pub boundary: Option<Vec<RawBoundary>>,
    /// In place of the study's.
    pub contact: Option<RawContact>,
    /// In place of the study's.
    pub slide: Option<Spanned<RawSlide>>,
    /// In place of the study's.
    pub curve: Option<Vec<Spanned<RawCurve>>>,
    /// In place of the study's.
    pub discretisation: Option<Spanned<RawDiscretisation>>,
    /// In place of the study's.
    pub exact: Option<Spanned<RawExact>>,
    /// In place of the study's.
    pub formula: Option<Spanned<RawFormula>>,
    /// In place of the study's.
    pub lemma: Option<Spanned<RawLemma>>,
    /// In place of the study's.
    pub family: Option<Spanned<RawFamily>>,
    /// In place of the study's.
    pub levels: Option<RawLevels>,
    /// In place of the study's.
    pub reference: Option<Spanned<RawReference>>,
    /// In place of the study's.
    pub solver: Option<RawSolver>,
    /// In place of the study's.
    pub splitting: Option<Spanned<RawSplitting>>,
    /// In place of the study's.
    pub gates: Option<Spanned<RawGates>>,
    /// In place of the study's.
    pub expected: Option<Spanned<RawExpected>>,
}

/// A mesh file, whose physical groups name bodies, boundary parts and the contact zone.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawMesh {
    /// Gmsh 4.1, from the folder of the study.
    pub file: Spanned<String>,
    /// What the file holds, filled in after parsing.
    #[serde(skip)]
    pub content: Arc<[u8]>,
}

/// The verdict that a study must get.
#[derive(Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Expect {
    /// The claim is refuted.
    Fail,
    /// The study cannot judge.
    Inconclusive,
    /// The scene has no equilibrium, or none that double precision can tell.
    Refused,
}

/// A claim of a study's own.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawClaim {
    /// One line.
    pub statement: String,
    /// How it is judged.
    pub kind: ClaimKind,
    /// What it judges: `strain`, `energy`, `h1`, `l2`, `pressure_l2`, `pressure_dual`, `penetration_l2`, `contact_set`, `energy_gap`, `b_over_h2`, `solution_h1`, `ledger`, `splitting`, `kkt`, of a lemma `boundary_l2` or `constant`, of a formula `half_width`, `peak_pressure`, `force` or `formula`.
    pub norm: Spanned<String>,
    /// What must hold for it to apply.
    #[serde(default)]
    pub hypotheses: Vec<String>,
    /// The paper's bound on the rate.
    pub paper: Option<Finite>,
    /// Today's bound.
    pub today: Option<Finite>,
    /// The rate that the regularity suggests.
    pub expected: Option<Finite>,
    /// Where statement and bounds come from.
    #[serde(default)]
    pub sources: Vec<String>,
}
