//! Solvers of the bound-constrained problem. They know [`BoundQp`] and nothing else.
//!
//! [`solve`] chooses by [`Settings::method`]. In reading order: [`cholesky`] (the sparse factor), `schur` (condensation),
//! `dense` (the problem on the bounded components), `active_set` and its refuge `monotone`, `condensed` (all of these
//! together); `interior_point` and `crossover`, which share nothing with them but the sparse factor; `kernel` (two-sided
//! motions), for both; [`multigrid`] over the levels of a hierarchy.

mod active_set;
pub mod cholesky;
mod compress;
mod condensed;
mod crossover;
mod dense;
mod describe;
mod foreign;
mod interior_point;
mod kernel;
mod monotone;
pub mod multigrid;
mod ordering;
mod schur;

#[cfg(test)]
mod tests;

use crate::qp::BoundQp;
pub use foreign::adopt;
pub use multigrid::Accuracy;
use multigrid::Levels;

/// Solves the problem with the method that the settings name.
///
/// The time and memory of [`Method::Condensed`] are those of one sparse Cholesky factorisation, plus `16 m²` bytes and
/// some dense factorisations for `m` bounds. An answer with an entry that is not finite never counts as solved,
/// nor does one of a problem with a bound that is none: leave absent bounds out.
pub fn solve(qp: &BoundQp, settings: &Settings) -> QpSolution {
    Prepared::new(qp, settings.method).solve(settings)
}

/// A problem after the work that does not depend on which bounds are active, so that set-up and solve can be told apart.
pub struct Prepared<'a>(Preparation<'a>);

enum Preparation<'a> {
    Condensed(Box<condensed::Condensed<'a>>),
    InteriorPoint(&'a BoundQp),
    Multigrid(&'a BoundQp, Levels<'a>),
}

impl<'a> Prepared<'a> {
    /// `condensed`, `monotone`: the sparse factorisation and the Schur complement. `interior-point` has nothing to prepare.
    /// `multigrid` without coarser levels is a direct solution: see [`Prepared::with_levels`].
    pub fn new(qp: &'a BoundQp, method: Method) -> Self {
        Self(match method {
            Method::Automatic | Method::Condensed | Method::Monotone | Method::Multigrid => {
                Preparation::Condensed(Box::new(condensed::Condensed::new(qp)))
            }
            Method::InteriorPoint => Preparation::InteriorPoint(qp),
        })
    }

    /// Prepares [`Method::Multigrid`]: the levels are all it needs.
    pub fn with_levels(qp: &'a BoundQp, levels: Levels<'a>) -> Self {
        Self(Preparation::Multigrid(qp, levels))
    }

    fn qp(&self) -> &BoundQp {
        match &self.0 {
            Preparation::Multigrid(qp, _) => qp,
            Preparation::Condensed(condensed) => condensed.qp(),
            Preparation::InteriorPoint(qp) => qp,
        }
    }

    fn method(&self, settings: &Settings) -> Method {
        match self.0 {
            Preparation::Multigrid(..) => Method::Multigrid,
            Preparation::InteriorPoint(_) => Method::InteriorPoint,
            Preparation::Condensed(_) if settings.method == Method::Monotone => Method::Monotone,
            Preparation::Condensed(_) => Method::Condensed,
        }
    }

    /// Solves; [`Settings::method`] is the one that was prepared.
    pub fn solve(self, settings: &Settings) -> QpSolution {
        let bounds_are_finite = self.qp().bounds.iter().all(|b| b.upper.is_finite());
        let method = self.method(settings);
        let mut answer = match self.0 {
            Preparation::Condensed(condensed) => condensed.solve(settings),
            Preparation::InteriorPoint(qp) => interior_point::solve(qp, settings),
            Preparation::Multigrid(qp, levels) => multigrid::solve(qp, levels, settings),
        };
        answer.method = method;
        let mut entries = answer.x.iter().chain(&answer.multipliers);
        let is_finite = entries.all(|v| v.is_finite()) && bounds_are_finite;
        if answer.status.is_solved() && !is_finite {
            answer.status = Status::IterationLimit { steps: answer.iterations };
        }
        answer
    }
}

/// Unknowns from which on multigrid is faster than a factorisation, where there is a hierarchy.
pub const MULTIGRID_FROM: usize = 50_000;

/// Which algorithm solves the problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// [`Condensed`](Self::Condensed) below [`MULTIGRID_FROM`] unknowns, above [`Multigrid`](Self::Multigrid) if there are coarser
    /// levels.
    Automatic,
    /// One sparse factorisation, then an active set on the Schur complement of the bounded components.
    Condensed,
    /// The same condensation, but from the start the method that lowers the energy in every step.
    Monotone,
    /// Clarabel's interior point, then crossover.
    InteriorPoint,
    /// Nested multigrid over the levels of a hierarchy.
    Multigrid,
}

impl Method {
    /// The method that solves a problem of so many unknowns with so many coarser levels.
    pub fn for_problem(self, unknowns: usize, coarser_levels: usize) -> Self {
        match self {
            Self::Automatic if unknowns >= MULTIGRID_FROM && coarser_levels > 1 => Self::Multigrid,
            Self::Automatic => Self::Condensed,
            method => method,
        }
    }
}

/// Settings of a solve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The algorithm.
    pub method: Method,
    /// Largest number of active-set steps before the monotone fallback takes over.
    pub max_steps: usize,
    /// Interior point: relative tolerance on the duality gap and the residuals of the scaled problem.
    pub tolerance: f64,
    /// Interior point: whether the active set found is polished by an equality solve.
    pub crossover: bool,
    /// Where a body may slide both ways: the value at which one component for each such motion is held while solving. The
    /// conditions `p(x) = 0` move the solution afterwards, so the answer does not depend on it.
    pub start_slide: f64,
    /// Multigrid: when the iteration ends.
    pub accuracy: Accuracy,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            method: Method::Condensed,
            max_steps: 50,
            tolerance: 1e-11,
            crossover: true,
            start_slide: 0.0,
            accuracy: Accuracy::Floor,
        }
    }
}

/// How a solve ended. An answer, not an error.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// The active set repeated itself after this many steps: solved.
    Converged {
        /// Active-set (or interior-point) steps.
        steps: usize,
    },
    /// The primal–dual active set came back to an earlier set; the monotone fallback finished.
    Rescued {
        /// Length of the cycle (0: the step limit ended the first phase).
        cycle: usize,
        /// Steps of the fallback.
        steps: usize,
    },
    /// The answer was found elsewhere; see [`adopt`].
    Adopted,
    /// No answer of the wanted accuracy within the limit.
    IterationLimit {
        /// Steps taken.
        steps: usize,
    },
    /// The matrix is not positive definite on the free components.
    NotPositiveDefinite,
}

impl Status {
    /// Whether the answer may be used.
    pub fn is_solved(&self) -> bool {
        matches!(self, Self::Converged { .. } | Self::Rescued { .. } | Self::Adopted)
    }
}

/// The answer of a solver.
#[derive(Clone, Debug)]
pub struct QpSolution {
    /// The minimiser, of length `K.dimension()`.
    pub x: Vec<f64>,
    /// The multiplier `λ ≥ 0` of each bound, in the order of [`BoundQp::bounds`](crate::qp::BoundQp::bounds).
    pub multipliers: Vec<f64>,
    /// Who found it.
    pub method: Method,
    /// How it ended.
    pub status: Status,
    /// Active-set or interior-point iterations.
    pub iterations: usize,
    /// Sparse factorisations.
    pub factorizations: usize,
    /// Number of active bounds in each active-set step, crossover rounds included; in each iteration on the finest level.
    pub history: Vec<usize>,
    /// Multigrid: work in units of one product with the finest matrix, from the coarsest level on; 0 for direct methods.
    pub work: f64,
    /// Multigrid: an estimate of the distance to the minimiser in the energy norm, `√(rᵀBr)` with the residual `r` computed anew
    /// and one more cycle `B ≈ K⁻¹` on the final face.
    pub distance: Option<f64>,
}

impl QpSolution {
    /// No answer yet: everything zero.
    fn unsolved(qp: &BoundQp, status: Status) -> Self {
        Self {
            x: vec![0.0; qp.matrix.dimension()],
            multipliers: vec![0.0; qp.bounds.len()],
            method: Method::Condensed,
            status,
            iterations: 0,
            factorizations: 0,
            history: Vec::new(),
            work: 0.0,
            distance: None,
        }
    }
}
