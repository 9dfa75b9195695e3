//! Families of triangulations: level → hierarchy and certificate.
//!
//! | family | level with `n` cells | nested |
//! | --- | --- | --- |
//! | structured, criss-cross | the coarsest mesh, refined red; a fresh mesh where `n` is not `2^k` times its cells | by refinement |
//! | union-jack | a fresh mesh | no |
//! | perturbed | a fresh structured mesh, moved at random | no |
//! | refined | one irregular coarse mesh, made here or read from a file, refined red | yes |
//! | delaunay | an independent Delaunay mesh | no |
//! | graded | an independent Delaunay mesh with sides that shrink towards a point | no |
//! | degenerate | a fresh mesh of cells ever flatter: its smallest angle falls like `h` | no |
//!
//! On bodies with curved sides no family is nested, since new nodes go to the curves; only `refined` is made by refinement
//! there. The levels of `structured` are mapped anew, each numbered like a refinement of the one below.

use signorini_contact::Point;
use signorini_contact::mesh::blocks::Pattern;

mod cut;
mod degenerate;
pub mod delaunay;
mod imported;
mod level;
mod perturb;
pub(crate) mod random;
#[cfg(test)]
mod tests;
mod unstructured;

pub use degenerate::Degenerate;
pub use level::{Domain, Level, build_level, build_reference, refinements};

/// Which family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Family {
    /// Right triangles, diagonal from lower left to upper right.
    Structured,
    /// Each cell cut by both diagonals.
    CrissCross,
    /// Diagonals alternate like a chessboard.
    UnionJack,
    /// `Structured` with nodes moved at random; angles guarded.
    Perturbed {
        /// Seed of the random moves.
        seed: u64,
        /// Largest move as a share of the cell, below 0.5.
        amount: f64,
    },
    /// Red refinement of one irregular coarse mesh.
    Refined {
        /// Seed of the coarse mesh.
        seed: u64,
        /// Largest move as a share of the coarse cell.
        amount: f64,
    },
    /// Red refinement of one Delaunay mesh; on curved bodies strongly regular with `β = 2` on every level.
    RefinedDelaunay {
        /// Seed of the coarse mesh.
        seed: u64,
    },
    /// An independent Delaunay mesh on each level.
    Delaunay {
        /// Seed of the meshes.
        seed: u64,
    },
    /// The same with sides that shrink towards a point: regular, not quasi-uniform.
    Graded {
        /// Seed of the meshes.
        seed: u64,
        /// The point.
        towards: Point,
        /// `γ` of the side length `h (max(r, h)/R)^γ`, between 0 and 1.
        strength: f64,
    },
    /// Red refinement of the mesh that a file holds.
    Imported,
    /// Cells squeezed in one direction the more the finer they are: no regular family.
    Degenerate(Degenerate),
}

impl Family {
    /// The name in study files and records.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Structured => "structured",
            Self::CrissCross => "criss-cross",
            Self::UnionJack => "union-jack",
            Self::Perturbed { .. } => "perturbed",
            Self::Refined { .. } | Self::RefinedDelaunay { .. } | Self::Imported => "refined",
            Self::Delaunay { .. } => "delaunay",
            Self::Graded { .. } => "graded",
            Self::Degenerate(_) => "degenerate",
        }
    }

    /// The seed of a random family, 0 where nothing is random.
    pub fn seed(&self) -> u64 {
        match *self {
            Self::Perturbed { seed, .. }
            | Self::Refined { seed, .. }
            | Self::RefinedDelaunay { seed }
            | Self::Delaunay { seed }
            | Self::Graded { seed, .. } => seed,
            _ => 0,
        }
    }

    /// Whether, on bodies with straight sides, levels are refinements of the coarsest mesh, so that coarse fields can be
    /// prolonged.
    pub fn is_nested(&self) -> bool {
        matches!(self, Self::Structured | Self::CrissCross) || self.is_refined()
    }

    /// Whether every level is a refinement of the coarsest mesh, on curved bodies too.
    pub fn is_refined(&self) -> bool {
        matches!(self, Self::Refined { .. } | Self::RefinedDelaunay { .. } | Self::Imported)
    }

    /// How the cells of a fresh mesh are cut.
    fn pattern(&self) -> Pattern {
        match self {
            Self::Structured | Self::Perturbed { .. } | Self::Refined { .. } => Pattern::Structured,
            Self::RefinedDelaunay { .. } | Self::Delaunay { .. } | Self::Graded { .. } | Self::Imported => {
                Pattern::Structured
            }
            Self::CrissCross => Pattern::CrissCross,
            Self::UnionJack => Pattern::UnionJack,
            Self::Degenerate(d) => d.pattern(),
        }
    }

    /// Largest move as a share of the cell; `None` for a family that moves nothing.
    fn amount(&self) -> Option<f64> {
        match *self {
            Self::Perturbed { amount, .. } | Self::Refined { amount, .. } => Some(amount),
            _ => None,
        }
    }
}
