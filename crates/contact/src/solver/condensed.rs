//! The contact problem at the price of one linear solve: condensation on the bounded components, an active set on the
//! dense problem, back-substitution, refinement.
//!
//! ```text
//! min ½ x_cᵀ S x_c − bᵀ x_c   subject to   x_c ≤ g
//! ```

use super::active_set::{DenseSolution, PrimalDual, primal_dual};
use super::dense::DenseQp;
use super::kernel::{anchors, impose_conditions, start};
use super::monotone::{Monotone, monotone};
use super::schur::Condensation;
use super::{Method, QpSolution, Settings, Status};
use crate::qp::{BoundQp, backward_error, residual, row_size};

/// Corrections by the residual after the first solve, at most.
const REFINEMENTS: usize = 3;
/// A refinement has to gain this factor to be followed by another.
const WORTHWHILE: f64 = 0.25;
/// Multipliers below this multiple of the terms of their row, `(|K||x| + |f|)_c`, are rounding.
const ROUNDING: f64 = 1e-15;

/// The problem condensed on its bounded components: factored, not yet solved.
pub struct Condensed<'a> {
    qp: &'a BoundQp,
    /// Nothing where the matrix is not positive definite on the free components.
    parts: Option<Parts>,
}

struct Parts {
    condensation: Condensation,
    dense: DenseQp,
    /// Unknowns held in place of the kernel.
    held: Vec<usize>,
}

impl<'a> Condensed<'a> {
    /// Factors and condenses.
    pub fn new(qp: &'a BoundQp) -> Self {
        Self { qp, parts: Parts::new(qp) }
    }

    /// The problem.
    pub fn qp(&self) -> &BoundQp {
        self.qp
    }

    /// Active set, back-substitution, refinement.
    pub fn solve(self, settings: &Settings) -> QpSolution {
        let mut answer = QpSolution::unsolved(self.qp, Status::NotPositiveDefinite);
        answer.factorizations = 1;
        let Some(Parts { condensation, mut dense, held }) = self.parts else {
            return answer;
        };
        let start = start(self.qp, &held, settings.start_slide);
        let load = residual(self.qp, &start);
        if settings.start_slide != 0.0 && !held.is_empty() {
            dense.load = condensation.reduced_load(&dense.matrix, &load);
        }
        let (status, solution) = match settings.method {
            Method::Monotone => solve_monotone(&dense, &mut answer.history),
            _ => solve_dense(&dense, settings, &mut answer.history),
        };
        answer.iterations = answer.history.len();
        if let Some(solution) = solution {
            let expansion = Expansion { qp: self.qp, condensation, dense, solution, held, start, load };
            answer.x = expansion.refined();
            answer.status = status;
            finish(self.qp, &expansion.solution.active, &mut answer);
        }
        answer
    }
}

impl Parts {
    fn new(qp: &BoundQp) -> Option<Self> {
        let held = anchors(&qp.kernel)?;
        let condensation = Condensation::new(qp, &held).ok()?;
        let matrix = condensation.schur_complement();
        let dense = DenseQp {
            load: condensation.reduced_load(&matrix, &qp.load),
            upper: qp.bounds.iter().map(|b| b.upper).collect(),
            matrix,
        };
        Some(Self { condensation, dense, held })
    }
}

/// Restores `p(x) = 0` and recomputes the multipliers of the active bounds from the unreduced system: `λ_c = (f − Kx)_c`
/// where positive beyond rounding.
pub(super) fn finish(qp: &BoundQp, active: &[bool], answer: &mut QpSolution) {
    if impose_conditions(qp, &mut answer.x).is_none() {
        answer.status = Status::NotPositiveDefinite;
        return;
    }
    let reaction = residual(qp, &answer.x);
    for (k, bound) in qp.bounds.iter().enumerate() {
        let dof = bound.dof as usize;
        let value = reaction[dof];
        let presses = active[k] && value > ROUNDING * row_size(qp, &answer.x, dof);
        answer.multipliers[k] = if presses { value } else { 0.0 };
    }
}

/// The primal–dual active set, and the monotone method if it stops short. No solution if there is no minimum.
fn solve_dense(dense: &DenseQp, settings: &Settings, history: &mut Vec<usize>) -> (Status, Option<DenseSolution>) {
    let (cycle, x) = match primal_dual(dense, settings.max_steps, history) {
        PrimalDual::Solved(solution) => {
            let steps = solution.steps;
            return (Status::Converged { steps }, Some(solution));
        }
        PrimalDual::Stopped { cycle, x } => (cycle, x),
    };
    match monotone(dense, &x, history) {
        Monotone::Solved(solution) => {
            let steps = solution.steps;
            (Status::Rescued { cycle, steps }, Some(solution))
        }
        Monotone::StepLimit(solution) => {
            let steps = history.len();
            (Status::IterationLimit { steps }, Some(solution))
        }
        Monotone::Unbounded => (Status::NotPositiveDefinite, None),
    }
}

/// The monotone method from the bounds themselves, its own start.
fn solve_monotone(dense: &DenseQp, history: &mut Vec<usize>) -> (Status, Option<DenseSolution>) {
    match monotone(dense, &dense.upper, history) {
        Monotone::Solved(solution) => (Status::Converged { steps: solution.steps }, Some(solution)),
        Monotone::StepLimit(solution) => (Status::IterationLimit { steps: solution.steps }, Some(solution)),
        Monotone::Unbounded => (Status::NotPositiveDefinite, None),
    }
}

/// From the bounded components back to all.
struct Expansion<'a> {
    qp: &'a BoundQp,
    condensation: Condensation,
    dense: DenseQp,
    solution: DenseSolution,
    /// Unknowns held in place of the kernel.
    held: Vec<usize>,
    /// `x_0`: the held unknowns at their value, zero elsewhere.
    start: Vec<f64>,
    /// `f − K x_0`.
    load: Vec<f64>,
}

impl Expansion<'_> {
    /// The full solution, corrected as long as this reduces the residual, row by row: in the largest row alone, a soft body or a
    /// small load would go uncorrected beside a stiff or a large one.
    fn refined(&self) -> Vec<f64> {
        let mut x = self.expand(&self.load, &self.dense.load, &self.solution.x);
        x.iter_mut().zip(&self.start).for_each(|(x, start)| *x += start);
        self.put_on_bounds(&mut x);
        let mut rest = self.free_residual(&x);
        let mut error = backward_error(self.qp, &x, &rest);
        for _ in 0..REFINEMENTS {
            let mut better = self.correction(&rest);
            better.iter_mut().zip(&x).for_each(|(d, x)| *d += x);
            self.put_on_bounds(&mut better);
            let next = self.free_residual(&better);
            let after = backward_error(self.qp, &better, &next);
            let improves = after < error;
            let worthwhile = after <= WORTHWHILE * error;
            if improves {
                (x, rest, error) = (better, next, after);
            }
            if !worthwhile {
                break;
            }
        }
        x
    }

    /// All components from the bounded ones; the multipliers are `λ = b − S x_c` on the active bounds.
    fn expand(&self, load: &[f64], reduced: &[f64], bounded: &[f64]) -> Vec<f64> {
        let mut multipliers = self.dense.residual_of(reduced, bounded);
        for (multiplier, active) in multipliers.iter_mut().zip(&self.solution.active) {
            *multiplier *= f64::from(u8::from(*active));
        }
        self.condensation.back_substitute(load, bounded, &multipliers)
    }

    /// The solution of the linear problem on the face, with the residual as load and zero on the active bounds.
    fn correction(&self, rest: &[f64]) -> Vec<f64> {
        let reduced = self.condensation.reduced_load(&self.dense.matrix, rest);
        let bounded = self.solution.face.solve(&reduced);
        self.expand(rest, &reduced, &bounded)
    }

    /// `f − Kx` without the components that carry a reaction: held unknowns and active bounds.
    fn free_residual(&self, x: &[f64]) -> Vec<f64> {
        let mut rest = residual(self.qp, x);
        self.held.iter().for_each(|&i| rest[i] = 0.0);
        self.for_each_active(|dof, _| rest[dof] = 0.0);
        rest
    }

    /// `x_c = g` exactly on the active bounds.
    fn put_on_bounds(&self, x: &mut [f64]) {
        self.for_each_active(|dof, upper| x[dof] = upper);
    }

    fn for_each_active(&self, mut visit: impl FnMut(usize, f64)) {
        for (bound, active) in self.qp.bounds.iter().zip(&self.solution.active) {
            if *active {
                visit(bound.dof as usize, bound.upper);
            }
        }
    }
}
