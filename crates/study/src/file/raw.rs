//! The study file as it is written: one struct per table, field by field as `studies/README.md` documents them.
//!
//! No `flatten` and no `untagged`: both lose line and column and let misspelt keys pass.

use super::expected::ExpectedRate;
use super::fixed::Fixed;
use super::number::{Finite, NumberOrText, OrNone};
use super::splitting::RawSplitting;
use crate::record::ClaimKind;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::Arc;
use toml::Spanned;

/// Two coordinates.
pub type RawPoint = Fixed<Finite, 2>;
/// Two components, each an expression.
pub type RawField = Fixed<Spanned<String>, 2>;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawStudy {
    pub id: Spanned<String>,
    pub title: String,
    pub question: String,
    pub setup: String,
    pub refuted_by: String,
    pub claim: Option<Spanned<String>>,
    pub own_claim: Option<Spanned<RawClaim>>,
    pub expect: Option<Expect>,
    pub inconclusive_at_quick: Option<String>,
    pub parameters: Option<BTreeMap<String, Finite>>,
    pub mesh: Option<RawMesh>,
    pub body: Option<Vec<Spanned<RawBody>>>,
    pub boundary: Option<Vec<RawBoundary>>,
    pub contact: Option<RawContact>,
    pub slide: Option<Spanned<RawSlide>>,
    pub curve: Option<Vec<Spanned<RawCurve>>>,
    pub discretisation: Option<Spanned<RawDiscretisation>>,
    pub exact: Option<Spanned<RawExact>>,
    pub formula: Option<Spanned<RawFormula>>,
    pub lemma: Option<Spanned<RawLemma>>,
    pub family: Option<Spanned<RawFamily>>,
    pub levels: Option<RawLevels>,
    pub reference: Option<Spanned<RawReference>>,
    pub solver: Option<RawSolver>,
    pub splitting: Option<Spanned<RawSplitting>>,
    pub gates: Option<Spanned<RawGates>>,
    pub expected: Option<Spanned<RawExpected>>,
    #[serde(default)]
    pub case: Vec<RawCase>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawCase {
    pub name: Spanned<String>,
    pub expect: Option<Expect>,
    pub inconclusive_at_quick: Option<String>,
    pub parameters: Option<BTreeMap<String, Finite>>,
    pub mesh: Option<RawMesh>,
    pub body: Option<Vec<Spanned<RawBody>>>,
    pub boundary: Option<Vec<RawBoundary>>,
    pub contact: Option<RawContact>,
    pub slide: Option<Spanned<RawSlide>>,
    pub curve: Option<Vec<Spanned<RawCurve>>>,
    pub discretisation: Option<Spanned<RawDiscretisation>>,
    pub exact: Option<Spanned<RawExact>>,
    pub formula: Option<Spanned<RawFormula>>,
    pub lemma: Option<Spanned<RawLemma>>,
    pub family: Option<Spanned<RawFamily>>,
    pub levels: Option<RawLevels>,
    pub reference: Option<Spanned<RawReference>>,
    pub solver: Option<RawSolver>,
    pub splitting: Option<Spanned<RawSplitting>>,
    pub gates: Option<Spanned<RawGates>>,
    pub expected: Option<Spanned<RawExpected>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawMesh {
    pub file: Spanned<String>,
    /// What the file holds, filled in after parsing.
    #[serde(skip)]
    pub content: Arc<[u8]>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Expect {
    Fail,
    Inconclusive,
    Refused,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawClaim {
    pub statement: String,
    pub kind: ClaimKind,
    pub norm: Spanned<String>,
    #[serde(default)]
    pub hypotheses: Vec<String>,
    pub paper: Option<Finite>,
    pub today: Option<Finite>,
    pub expected: Option<Finite>,
    #[serde(default)]
    pub sources: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawBody {
    pub name: Spanned<String>,
    pub material: Spanned<RawMaterial>,
    pub rectangle: Option<Spanned<Fixed<RawPoint, 2>>>,
    pub divisions: Option<Spanned<Fixed<usize, 2>>>,
    pub blocks: Option<Spanned<Vec<RawBlock>>>,
    pub physical: Option<Spanned<String>>,
    pub force: Option<RawField>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawBlock {
    pub corners: Spanned<Fixed<RawPoint, 4>>,
    pub divisions: Option<Spanned<Fixed<usize, 2>>>,
    pub curves: Option<Fixed<Spanned<String>, 4>>,
    pub grading: Option<Spanned<Fixed<Finite, 2>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawMaterial {
    pub lame: Option<Fixed<Finite, 2>>,
    pub young: Option<Spanned<Finite>>,
    pub poisson: Option<Spanned<Finite>>,
    pub plane: Option<Spanned<PlaneName>>,
    pub orthotropic: Option<RawOrthotropic>,
    pub matrix: Option<Fixed<Fixed<Finite, 3>, 3>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawOrthotropic {
    pub moduli: Fixed<Finite, 3>,
    pub ratios: Fixed<Finite, 3>,
    pub shear: Finite,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlaneName {
    Strain,
    Stress,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawBoundary {
    pub body: Spanned<String>,
    pub name: Spanned<String>,
    pub along: Option<Spanned<Vec<RawPoint>>>,
    pub physical: Option<Spanned<String>>,
    #[serde(default)]
    pub curves: Vec<Spanned<String>>,
    pub condition: Spanned<ConditionName>,
    pub value: Option<Spanned<RawField>>,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum ConditionName {
    Fixed,
    Sliding,
    Traction,
    Free,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawContact {
    pub along: Option<Spanned<Vec<RawPoint>>>,
    #[serde(default)]
    pub curves: Vec<Spanned<String>>,
    pub gap: Option<Spanned<Fixed<Spanned<String>, 2>>>,
    pub physical: Option<Spanned<Vec<Fixed<Spanned<String>, 2>>>>,
    pub direction: Option<Spanned<RawPoint>>,
    pub initial_gap: Option<Spanned<String>>,
    #[serde(default)]
    pub symmetric: bool,
    #[serde(default)]
    pub bilateral: Vec<Spanned<Fixed<RawPoint, 2>>>,
}

impl RawContact {
    /// Where the zone is said to be.
    pub fn span(&self) -> Option<std::ops::Range<usize>> {
        let along = self.along.as_ref().map(Spanned::span);
        along.or(self.gap.as_ref().map(Spanned::span)).or(self.physical.as_ref().map(Spanned::span))
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawSlide {
    pub body: Spanned<String>,
    pub along: Spanned<Fixed<RawPoint, 2>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawCurve {
    pub name: Spanned<String>,
    pub circle: Option<Spanned<RawCircle>>,
    pub graph: Option<Spanned<RawGraph>>,
    pub through: Option<Spanned<Vec<RawPoint>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawCircle {
    pub centre: RawPoint,
    pub radius: Finite,
    pub from: Finite,
    pub to: Finite,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawGraph {
    pub xi: Spanned<String>,
    pub from: Finite,
    pub to: Finite,
    pub direction: Option<RawPoint>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawDiscretisation {
    pub element: Option<ElementName>,
    pub geometry: Option<GeometryName>,
    pub normals: Option<NormalsName>,
    pub skew: Option<Spanned<Finite>>,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum ElementName {
    Physical,
    Isoparametric,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum GeometryName {
    Exact,
    Chords,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum NormalsName {
    True,
    Averaged,
    Chord,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawExact {
    pub builtin: Option<Spanned<String>>,
    pub first: Option<RawField>,
    pub second: Option<RawField>,
    pub traces: Option<Spanned<RawTraces>>,
    #[serde(default)]
    pub singular: Vec<RawPoint>,
    #[serde(default)]
    pub breaks: Vec<Fixed<RawPoint, 2>>,
    #[serde(default)]
    pub switches: Vec<RawPoint>,
    pub materials: Option<Spanned<Fixed<RawLame, 2>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawTraces {
    pub lemma: Spanned<TraceLemma>,
    pub w: RawField,
    pub a: RawField,
    pub p: Spanned<String>,
    pub f: Option<Spanned<RawField>>,
    pub centre: Option<Spanned<RawPoint>>,
    pub radius: Option<Spanned<Finite>>,
    pub middle: Option<Spanned<Finite>>,
    pub cutoff: Option<RawField>,
    #[serde(default)]
    pub switches: Vec<Finite>,
    #[serde(default)]
    pub singular: Vec<Finite>,
    #[serde(default)]
    pub breaks: Vec<Finite>,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum TraceLemma {
    Line,
    Arc,
    Graph,
}

impl TraceLemma {
    /// As it is written in the file.
    pub fn word(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Arc => "arc",
            Self::Graph => "graph",
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawFormula {
    pub force: Option<Spanned<NumberOrText>>,
    pub half_width: Option<Spanned<NumberOrText>>,
    pub peak_pressure: Option<Spanned<NumberOrText>>,
    pub pressure: Option<Spanned<String>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawLame {
    pub lame: Fixed<Finite, 2>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawLemma {
    pub kind: LemmaName,
    pub semi_axes: Option<Spanned<Fixed<Finite, 2>>>,
    pub function: Option<Spanned<String>>,
    pub side: Option<Spanned<SideName>>,
    pub interval: Option<Spanned<Fixed<Finite, 2>>>,
    pub norms: Option<Spanned<NormsName>>,
    pub seed: Option<Spanned<u64>>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LemmaName {
    BoundaryInterpolation,
    InverseInequality,
    Strip,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SideName {
    Inside,
    Outside,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum NormsName {
    Seminorms,
    FullRight,
    Full,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawFamily {
    pub name: FamilyName,
    pub seed: Option<Spanned<u64>>,
    pub amount: Option<Spanned<Finite>>,
    pub coarse: Option<Spanned<CoarseName>>,
    pub towards: Option<Spanned<RawPoint>>,
    pub strength: Option<Spanned<Finite>>,
    pub direction: Option<Spanned<usize>>,
    pub triangles: Option<Spanned<TrianglesName>>,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum TrianglesName {
    Right,
    Obtuse,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum CoarseName {
    Perturbed,
    Delaunay,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum FamilyName {
    Structured,
    CrissCross,
    UnionJack,
    Perturbed,
    Refined,
    Delaunay,
    Graded,
    Degenerate,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawLevels {
    pub quick: Option<Spanned<Vec<usize>>>,
    pub full: Option<Spanned<Vec<usize>>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawReference {
    pub kind: ReferenceName,
    pub quick: Option<Spanned<usize>>,
    pub full: Option<Spanned<usize>>,
    pub project: Option<Spanned<bool>>,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum ReferenceName {
    Exact,
    Overkill,
    None,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawSolver {
    pub name: Option<SolverName>,
    pub tolerance: Option<Spanned<Finite>>,
    pub crossover: Option<bool>,
    pub max_steps: Option<Spanned<usize>>,
    pub start_slide: Option<Spanned<Finite>>,
    pub second: Option<Spanned<SolverName>>,
    pub accuracy: Option<Spanned<Finite>>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SolverName {
    Condensed,
    Monotone,
    InteriorPoint,
    Multigrid,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawGates {
    pub rate_tolerance: Option<Spanned<Finite>>,
    pub ceiling: Option<Spanned<OrNone>>,
    pub exact_tolerance: Option<Spanned<Finite>>,
    pub fall: Option<Spanned<Finite>>,
    pub spread: Option<Spanned<Finite>>,
    pub constant: Option<Spanned<Finite>>,
    pub share: Option<Spanned<Finite>>,
    pub fixed_quadrature: Option<Spanned<bool>>,
    pub reason: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RawExpected {
    pub rate: Option<ExpectedRate>,
    pub paper: Option<OrNone>,
    pub today: Option<OrNone>,
    #[serde(default)]
    pub asymptotic_only: bool,
    pub borderline: Option<bool>,
    pub reason: Option<String>,
}
