//! Meshes, references, solvers.

use super::RawPoint;
use crate::file::number::Finite;
use crate::file::spanned::Spanned;
use schemars::JsonSchema;
use serde::Deserialize;

/// A family of triangulations.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawFamily {
    /// Which one; default `structured`.
    pub name: FamilyName,
    /// Of `perturbed`, `refined` and `delaunay`.
    pub seed: Option<Spanned<u64>>,
    /// Of `perturbed` and `refined`: the largest move of a node as a share of its cell, below 0.5.
    pub amount: Option<Spanned<Finite>>,
    /// Of `refined`: the mesh that it starts from; default `perturbed`.
    pub coarse: Option<Spanned<CoarseName>>,
    /// Of `graded`: the point towards which sides shorten.
    pub towards: Option<Spanned<RawPoint>>,
    /// Of `graded`: γ in sides of about h (r/R)^γ at the distance r; of `degenerate`: cells along `direction`, as a multiple of n.
    pub strength: Option<Spanned<Finite>>,
    /// Of `degenerate`: 1 along corner 1 → 2 of a block, 2 along 1 → 4.
    pub direction: Option<Spanned<usize>>,
    /// Of `degenerate`: which triangles.
    pub triangles: Option<Spanned<TrianglesName>>,
}

/// Triangles of degenerate meshes.
#[derive(Clone, Copy, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum TrianglesName {
    /// Right triangles.
    Right,
    /// Every other row moved by half a cell, largest angle towards 180°.
    Obtuse,
}

/// What a refined family starts from.
#[derive(Clone, Copy, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum CoarseName {
    /// A perturbed mesh.
    Perturbed,
    /// A strongly regular Delaunay mesh.
    Delaunay,
}

/// A family of triangulations.
#[derive(Clone, Copy, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum FamilyName {
    /// Right triangles, one diagonal.
    Structured,
    /// Four triangles to a cell.
    CrissCross,
    /// Alternating diagonals.
    UnionJack,
    /// Inner nodes moved at random.
    Perturbed,
    /// Red refinement of an irregular mesh.
    Refined,
    /// An independent Delaunay mesh on each level.
    Delaunay,
    /// Finer towards a point.
    Graded,
    /// Cells that become flatter as they become finer: breaks the hypothesis of a regular family.
    Degenerate,
}

/// Cells per unit on each level, coarsest first.
#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawLevels {
    /// Of the quick profile.
    pub quick: Option<Spanned<Vec<usize>>>,
    /// Of the full profile.
    pub full: Option<Spanned<Vec<usize>>>,
}

/// What errors are measured against.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawReference {
    /// Which reference.
    pub kind: ReferenceName,
    /// Of `overkill`: its cells per unit in the quick profile; default 256.
    pub quick: Option<Spanned<usize>>,
    /// In the full profile; default 1024.
    pub full: Option<Spanned<usize>>,
    /// Whether to measure how far the reference is from K_h.
    pub project: Option<Spanned<bool>>,
}

/// A reference.
#[derive(Clone, Copy, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum ReferenceName {
    /// The exact solution.
    Exact,
    /// The discrete solution on a finer mesh.
    Overkill,
    /// None: energies and residuals alone.
    None,
}

/// How the levels are solved.
#[derive(Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawSolver {
    /// Which solver; default: by size.
    pub name: Option<SolverName>,
    /// Of `interior-point`; default 1e-11.
    pub tolerance: Option<Spanned<Finite>>,
    /// Of `interior-point`: whether to solve on the active set that it found; default true.
    pub crossover: Option<bool>,
    /// Most steps; default 50.
    pub max_steps: Option<Spanned<usize>>,
    /// Where a body may slide: the value at which one component is held while solving, which must not change the answer; default 0.
    pub start_slide: Option<Spanned<Finite>>,
    /// Another solver, asked on every level and compared.
    pub second: Option<Spanned<SolverName>>,
    /// Of `multigrid`: the share of the estimated discretisation error at which it stops; default 0, all that double precision gives.
    pub accuracy: Option<Spanned<Finite>>,
}

/// A solver.
#[derive(Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SolverName {
    /// One factorisation, then an active set on the contact unknowns.
    Condensed,
    /// The same, with an energy that falls in every step.
    Monotone,
    /// Clarabel with crossover.
    InteriorPoint,
    /// Nested multigrid over the levels of the family.
    Multigrid,
}
