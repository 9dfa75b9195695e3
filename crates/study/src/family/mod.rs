//! Families of triangulations: level → hierarchy and certificate.
//!
//! | family | level with `n` cells | nested |
//! | --- | --- | --- |
//! | structured, criss-cross | the coarsest mesh, refined red; a fresh mesh where `n` is not `2^k` times its cells | by refinement |
//! | union-jack | a fresh mesh | no |
//! | perturbed | a fresh structured mesh, moved at random | no |
//! | refined | one irregular coarse mesh, refined red | yes |

use signorini_contact::mesh::blocks::Pattern;

pub mod delaunay;
mod level;
mod perturb;
mod random;
#[cfg(test)]
mod tests;

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
}

impl Family {
    /// The name in study files and records.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Structured => "structured",
            Self::CrissCross => "criss-cross",
            Self::UnionJack => "union-jack",
            Self::Perturbed { .. } => "perturbed",
            Self::Refined { .. } => "refined",
        }
    }

    /// The seed of a random family, 0 where nothing is random.
    pub fn seed(&self) -> u64 {
        match *self {
            Self::Perturbed { seed, .. } | Self::Refined { seed, .. } => seed,
            _ => 0,
        }
    }

    /// Whether, on bodies with straight sides, levels are refinements of the coarsest mesh, so that coarse fields can be
    /// prolonged.
    pub fn is_nested(&self) -> bool {
        matches!(self, Self::Structured | Self::CrissCross | Self::Refined { .. })
    }

    /// Whether every level is a refinement of the coarsest mesh, on curved bodies too.
    pub fn is_refined(&self) -> bool {
        matches!(self, Self::Refined { .. })
    }

    /// How the cells of a fresh mesh are cut.
    fn pattern(&self) -> Pattern {
        match self {
            Self::Structured | Self::Perturbed { .. } | Self::Refined { .. } => Pattern::Structured,
            Self::CrissCross => Pattern::CrissCross,
            Self::UnionJack => Pattern::UnionJack,
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
