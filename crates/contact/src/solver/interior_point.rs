//! Clarabel's interior point on the same problem: an independent second opinion.
//!
//! Its relative gap is in effect absolute while the objective is below 1, and its feasibility tolerance is absolute
//! while the data are. So the problem is posed in `y = x/α` with the objective divided by `β`, where `α = max|x|` and
//! `β = |energy|` at the solution:
//!
//! ```text
//! min ½ yᵀ(α²/β K)y − (α/β f)ᵀy   subject to   y_c + s = g/α,  s ≥ 0
//! ```
//!
//! Both are guessed first, and measured and set right when the guess was off.

use super::compress::{Numbering, UpperTriangle};
use super::condensed::finish;
use super::crossover::crossover;
use super::kernel::{anchors, impose_conditions, start};
use super::{QpSolution, Settings, Status};
use crate::qp::{BoundQp, energy, largest, residual};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, SupportedConeT};

/// Further solves with corrected scales, at most.
const RESCALINGS: usize = 2;
/// The scales stand if the energy and the size found, over `β` and `α`, lie between these.
const FAIR_SCALE: [f64; 2] = [0.1, 1e3];

/// Solves the problem by interior point, and polishes the active set found if the settings ask for it.
pub fn solve(qp: &BoundQp, settings: &Settings) -> QpSolution {
    let mut answer = QpSolution::unsolved(qp, Status::NotPositiveDefinite);
    let Some(held) = anchors(&qp.kernel) else {
        return answer;
    };
    let mut removed = vec![false; qp.matrix.dimension()];
    held.iter().for_each(|&i| removed[i] = true);
    let start = start(qp, &held, settings.start_slide);
    let problem = Problem::new(qp, &removed, &start);
    problem.solve(settings, &mut answer);
    if answer.status == Status::NotPositiveDefinite {
        return answer;
    }
    if !settings.crossover {
        if impose_conditions(qp, &mut answer.x).is_none() {
            answer.status = Status::NotPositiveDefinite;
        }
        return answer;
    }
    if let Some(active) = crossover(qp, &removed, &start, &mut answer) {
        finish(qp, &active, &mut answer);
    }
    answer
}

/// `α` and `β`.
#[derive(Clone, Copy, Debug)]
struct Scales {
    size: f64,
    energy: f64,
}

/// The problem without the held unknowns.
struct Problem<'a> {
    qp: &'a BoundQp,
    numbering: Numbering,
    matrix: CscMatrix<f64>,
    /// `x_0`: the held unknowns at their value, zero elsewhere.
    start: &'a [f64],
    /// `f − K x_0`.
    load: Vec<f64>,
}

impl<'a> Problem<'a> {
    fn new(qp: &'a BoundQp, removed: &[bool], start: &'a [f64]) -> Self {
        let numbering = Numbering::new(removed);
        let triangle = UpperTriangle::new(&qp.matrix, &numbering);
        let n = numbering.kept.len();
        let (column_start, rows) = (triangle.column_start, triangle.rows);
        let matrix = CscMatrix::new(n, n, column_start, rows, triangle.values);
        Self { qp, numbering, matrix, start, load: residual(qp, start) }
    }

    /// Solves, and once more with better scales where the result shows that they were wrong.
    fn solve(&self, settings: &Settings, answer: &mut QpSolution) {
        let mut scales = self.first_scales();
        for _ in 0..=RESCALINGS {
            self.solve_scaled(settings, scales, answer);
            let energy = energy(self.qp, &answer.x).abs();
            let size = largest(&answer.x);
            let fair = |ratio: f64| ratio > FAIR_SCALE[0] && ratio < FAIR_SCALE[1];
            let done = fair(energy / scales.energy) && fair(size / scales.size);
            if done || !(energy > 0.0 && size > 0.0) {
                break;
            }
            scales = Scales { size, energy };
        }
    }

    /// The scales of the minimiser of the free problem along `D⁻¹f`, or of the bounds if there is no load.
    fn first_scales(&self) -> Scales {
        let load = &self.qp.load;
        let diagonal = |i: usize| self.qp.matrix.diagonal_block(i / 2)[3 * (i % 2)];
        let direction: Vec<f64> =
            (0..load.len()).map(|i| if diagonal(i) > 0.0 { load[i] / diagonal(i) } else { 0.0 }).collect();
        let work: f64 = load.iter().zip(&direction).map(|(f, d)| f * d).sum();
        // ½ dᵀKd
        let stiffness = energy(self.qp, &direction) + work;
        if work > 0.0 && stiffness > 0.0 {
            let length = 0.5 * work / stiffness;
            return Scales { size: length * largest(&direction), energy: 0.5 * length * work };
        }
        let bounds: Vec<f64> = self.qp.bounds.iter().map(|b| b.upper).collect();
        let size = if largest(&bounds) > 0.0 { largest(&bounds) } else { 1.0 };
        let stiffness = self.qp.matrix.norm_inf().max(f64::MIN_POSITIVE);
        Scales { size, energy: stiffness * size * size }
    }

    fn solve_scaled(&self, settings: &Settings, scales: Scales, answer: &mut QpSolution) {
        let Scales { size, energy } = scales;
        let mut matrix = self.matrix.clone();
        matrix.nzval.iter_mut().for_each(|k| *k *= size * size / energy);
        let mut load = self.numbering.gather(&self.load);
        load.iter_mut().for_each(|f| *f *= -size / energy);
        let upper: Vec<f64> = self.qp.bounds.iter().map(|b| b.upper / size).collect();
        let cones = [NonnegativeConeT(upper.len())];
        let cones: &[SupportedConeT<f64>] = if upper.is_empty() { &[] } else { &cones };
        let options = options(settings.tolerance);
        let mut solver = DefaultSolver::new(&matrix, &load, &self.selection(), &upper, cones, options)
            .expect("matrices and vectors of matching sizes");
        solver.solve();
        let solution = &solver.solution;
        let y: Vec<f64> = solution.x.iter().map(|y| y * size).collect();
        self.numbering.scatter(&y, &mut answer.x);
        answer.x.iter_mut().zip(self.start).for_each(|(x, start)| *x += start);
        answer.multipliers = solution.z.iter().map(|z| z * energy / size).collect();
        let steps = solution.iterations as usize;
        answer.iterations += steps;
        // one factorisation per step and one for the start
        answer.factorizations += steps + 1;
        answer.status = status(solution.status, answer.iterations);
    }

    /// The matrix of `y ↦ y_c`.
    fn selection(&self) -> CscMatrix<f64> {
        let (m, n) = (self.qp.bounds.len(), self.numbering.kept.len());
        let mut start = Vec::with_capacity(n + 1);
        let mut next = 0;
        start.push(0);
        for full in &self.numbering.kept {
            next += usize::from(next < m && self.qp.bounds[next].dof == *full);
            start.push(next);
        }
        CscMatrix::new(m, n, start, (0..m).collect(), vec![1.0; m])
    }
}

/// Clarabel's settings: silent, one thread, the same tolerance for gap and feasibility.
fn options(tolerance: f64) -> DefaultSettings<f64> {
    DefaultSettings {
        verbose: false,
        max_threads: 1,
        tol_gap_abs: tolerance,
        tol_gap_rel: tolerance,
        tol_feas: tolerance,
        presolve_enable: false,
        ..DefaultSettings::default()
    }
}

/// What the end of the interior point means for us. The problem always has feasible points.
fn status(status: SolverStatus, steps: usize) -> Status {
    match status {
        SolverStatus::Solved => Status::Converged { steps },
        SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible => Status::NotPositiveDefinite,
        _ => Status::IterationLimit { steps },
    }
}
