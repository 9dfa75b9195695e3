//! Solvers of the bound-constrained problem. They know [`BoundQp`](crate::qp::BoundQp) and nothing else.

/// Which algorithm solves the problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// One sparse factorisation, then an active set on the Schur complement of the bounded components.
    Condensed,
    /// Clarabel's interior point, then crossover.
    InteriorPoint,
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
}

impl Default for Settings {
    fn default() -> Self {
        Self { method: Method::Condensed, max_steps: 50, tolerance: 1e-11, crossover: true }
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
        matches!(self, Self::Converged { .. } | Self::Rescued { .. })
    }
}

/// The answer of a solver.
#[derive(Clone, Debug)]
pub struct QpSolution {
    /// The minimiser, of length `K.dimension()`.
    pub x: Vec<f64>,
    /// The multiplier `λ ≥ 0` of each bound, in the order of [`BoundQp::bounds`](crate::qp::BoundQp::bounds).
    pub multipliers: Vec<f64>,
    /// How it ended.
    pub status: Status,
    /// Active-set or interior-point iterations.
    pub iterations: usize,
    /// Sparse factorisations.
    pub factorizations: usize,
}
