//! Nested multigrid for the bound-constrained problem: `O(N)` time and memory.
//!
//! ```text
//! coarsest level     solved exactly (condensed)
//! each finer level   starts from the prolongation, brought within its bounds
//!   one iteration    forward nonlinear Gauss–Seidel: each slot, each pair, to its minimum within the bounds
//!                    freeze the components on their bounds; V-cycle for the linear problem on that face
//!                    correction, brought within the bounds; line search if that changed it
//!                    backward nonlinear Gauss–Seidel
//!                    z = all of this; minimise the energy over span{z, last step} (while the active set rests), else along z
//! ```
//!
//! The iteration is conjugate gradients preconditioned by one V-cycle where the active set rests, and lowers the energy in every
//! step where it does not. Coarse functions lose what they are on frozen components (*truncation*): one that keeps nothing is
//! frozen itself; for the few at the ends of contact that keep a part, the coarse matrices are changed in place.
//!
//! R. Kornhuber, *Adaptive monotone multigrid methods for nonlinear variational problems* (1997); C. Gräser, R. Kornhuber,
//! *Multigrid methods for obstacle problems* (2009).

mod block;
mod coarsest;
mod cycle;
mod iterate;
mod motion;
mod nested;
mod order;
mod sweep;
#[cfg(test)]
mod tests;
mod transfer;
mod truncate;
mod vector;

pub use order::{Order, Slots};
pub use transfer::{SpecialRow, Transfer};

use super::{QpSolution, Settings};
use crate::qp::{Bound, BoundQp};
use crate::sparse::BlockMatrix;

/// Slots that were declared independent but are not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "slot {slot} may not be visited beside slot {other}: they lie in different parts and share an element, or one is there twice"
)]
pub struct Disorder {
    /// A slot of one part.
    pub slot: u32,
    /// The slot it meets.
    pub other: u32,
}

/// A level below the finest.
pub struct CoarseLevel<'a> {
    /// The matrix in this level's own basis; where spaces are nested, `PᵀKP`.
    pub matrix: BlockMatrix,
    /// The bounds on this level's components, by ascending dof.
    pub bounds: Vec<Bound>,
    /// Slots of contact pairs, which are relaxed together.
    pub pairs: Vec<[u32; 2]>,
    /// The order of a sweep.
    pub order: Order,
    /// To the next finer level.
    pub transfer: Transfer<'a>,
}

/// The levels below a problem, and what sweeps on its own level have to know.
pub struct Levels<'a> {
    /// From the coarsest to the last but the finest; none means that the problem is solved directly.
    pub coarse: Vec<CoarseLevel<'a>>,
    /// Slots of contact pairs on the finest level.
    pub pairs: Vec<[u32; 2]>,
    /// The order of a sweep on the finest level.
    pub order: Order,
    /// On the coarsest level, the rigid motions that the supports leave free, contact aside.
    pub motions: Vec<Vec<f64>>,
}

/// When the iteration ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accuracy {
    /// The algebraic error is this share of the estimated discretisation error, in the energy norm.
    Discretisation(f64),
    /// Nothing is left to gain in double precision.
    Floor,
}

/// Solves by nested iteration over the levels.
pub(super) fn solve(qp: &BoundQp, levels: Levels, settings: &Settings) -> QpSolution {
    nested::solve(qp, levels, settings)
}
