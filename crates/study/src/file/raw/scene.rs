//! Bodies, boundary parts, the contact zone.

use super::{RawField, RawPoint};
use crate::file::fixed::Fixed;
use crate::file::number::Finite;
use crate::file::spanned::Spanned;
use schemars::JsonSchema;
use serde::Deserialize;

/// A body: a rectangle, blocks, or a group of the mesh file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawBody {
    /// For boundary parts and messages.
    pub name: Spanned<String>,
    /// Hooke's law.
    pub material: Spanned<RawMaterial>,
    /// Lower left and upper right corner.
    pub rectangle: Option<Spanned<Fixed<RawPoint, 2>>>,
    /// Of a rectangle: cells along its sides per unit of the level; default [1, 1].
    pub divisions: Option<Spanned<Fixed<usize, 2>>>,
    /// Convex quadrilaterals that share whole sides, in place of a rectangle.
    pub blocks: Option<Spanned<Vec<RawBlock>>>,
    /// Name of a physical group of the mesh file, in place of both.
    pub physical: Option<Spanned<String>>,
    /// Body force per area, two expressions in x, y; default: from the exact solution, else none.
    pub force: Option<RawField>,
}

/// A quadrilateral.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawBlock {
    /// Four points, counterclockwise.
    pub corners: Spanned<Fixed<RawPoint, 4>>,
    /// Cells along corner 1 → 2 and 1 → 4 per unit of the level; default [1, 1].
    pub divisions: Option<Spanned<Fixed<usize, 2>>>,
    /// Names of the curves of the sides 1 → 2, 2 → 3, 3 → 4, 4 → 1; "" is straight.
    pub curves: Option<Fixed<Spanned<String>, 4>>,
    /// How many times as long the last cell is as the first along corner 1 → 2 and 1 → 4; default [1, 1].
    pub grading: Option<Spanned<Fixed<Finite, 2>>>,
}

/// Hooke's law, by one of: `lame`; `young` and `poisson`; `orthotropic`; `matrix`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawMaterial {
    /// Lamé's constants [λ, μ], in plane strain.
    pub lame: Option<Fixed<Finite, 2>>,
    /// Young's modulus, positive.
    pub young: Option<Spanned<Finite>>,
    /// Poisson's ratio, above −1 and below 1/2.
    pub poisson: Option<Spanned<Finite>>,
    /// Plane strain (default) or plane stress.
    pub plane: Option<Spanned<PlaneName>>,
    /// Orthotropic along the axes.
    pub orthotropic: Option<RawOrthotropic>,
    /// Symmetric positive definite C in (τ11, τ22, τ12) = C (ε11, ε22, 2ε12).
    pub matrix: Option<Fixed<Fixed<Finite, 3>, 3>>,
}

/// Engineering constants along the axes.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawOrthotropic {
    /// E1, E2, E3.
    pub moduli: Fixed<Finite, 3>,
    /// ν12, ν13, ν23.
    pub ratios: Fixed<Finite, 3>,
    /// G12.
    pub shear: Finite,
}

/// What stays plane.
#[derive(Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PlaneName {
    /// No strain across the plane.
    Strain,
    /// No stress across the plane.
    Stress,
}

/// A part of a body's boundary.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawBoundary {
    /// Name of the body.
    pub body: Spanned<String>,
    /// Unique within the body.
    pub name: Spanned<String>,
    /// Path from corner to corner.
    pub along: Option<Spanned<Vec<RawPoint>>>,
    /// Name of a physical group of the mesh file, in place of `along`.
    pub physical: Option<Spanned<String>>,
    /// Names of the curves between the corners, in order; "", or nothing, is straight.
    #[serde(default)]
    pub curves: Vec<Spanned<String>>,
    /// What is given there.
    pub condition: Spanned<ConditionName>,
    /// Of `fixed`: two expressions in x, y; of `traction`: in x, y, nx, ny. Default: from the exact solution; without one a fixed part does not move.
    pub value: Option<Spanned<RawField>>,
}

/// What is given on a part of the boundary.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq)]
#[serde(rename_all = "kebab-case")]
pub enum ConditionName {
    /// The displacement.
    Fixed,
    /// No normal displacement, no tangential traction.
    Sliding,
    /// The traction.
    Traction,
    /// No traction.
    Free,
}

/// The contact zone: a path, a gap between two curves, or groups of the mesh file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawContact {
    /// Path with Ω' on its left and Ω'' on its right; a corner of it carries two constraints.
    pub along: Option<Spanned<Vec<RawPoint>>>,
    /// Names of the curves between its corners, in order; "", or nothing, is straight.
    #[serde(default)]
    pub curves: Vec<Spanned<String>>,
    /// In place of `along`: the curve of Ω' and that of Ω'', over the same interval of η.
    pub gap: Option<Spanned<Fixed<Spanned<String>, 2>>>,
    /// In place of `along`: pairs of physical groups of the mesh file, that of Ω' and that of Ω''.
    pub physical: Option<Spanned<Vec<Fixed<Spanned<String>, 2>>>>,
    /// Of a gap: e_ξ, of length 1, from Ω'' to Ω'; default [1, 0].
    pub direction: Option<Spanned<RawPoint>>,
    /// On a straight zone: an expression in x, y, the distance of the bodies along n before loading, negative if they overlap.
    pub initial_gap: Option<Spanned<String>>,
    /// Whether the scene is one half of a symmetric one; forces and widths are then reported for the whole.
    #[serde(default)]
    pub symmetric: bool,
    /// Parts of `along` where the bodies may slide but not part.
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

/// p(v) = ∫ v_t ds = 0 on a straight part of the boundary.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawSlide {
    /// The body on whose boundary the part lies.
    pub body: Spanned<String>,
    /// Its two ends, nodes of every mesh.
    pub along: Spanned<Fixed<RawPoint, 2>>,
}
