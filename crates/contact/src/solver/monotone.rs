//! A feasible method that lowers the energy in every step: the refuge when the primal–dual active set cycles, or when
//! one of its sets leaves the body free to move.
//!
//! ```text
//! repeat
//!     face:    minimise on { x_i = g_i for active i }; on the way, bounds that are hit become active
//!     release: if some active multiplier is negative, one projected Gauss–Seidel sweep, then a new face
//! ```
//!
//! Each minimum on a face lies strictly below the one before, so no face returns and the method is finite. Where the
//! face matrix is singular (the contact on this face does not hold the body) a proximal step takes its place; if
//! nothing stops a motion that gains energy, there is no minimum.

use super::active_set::{DenseSolution, face_minimiser};
use super::dense::{DenseQp, Face};

/// How the method ended.
#[derive(Clone, Debug)]
pub enum Monotone {
    /// Solved.
    Solved(DenseSolution),
    /// The energy falls without end along an admissible motion.
    Unbounded,
    /// Too many steps; the last iterate, which is feasible.
    StepLimit(DenseSolution),
}

/// Minimises from the projection of `start` on the bounds; records the sizes of the active sets of the faces minimised.
pub fn monotone(qp: &DenseQp, start: &[f64], history: &mut Vec<usize>) -> Monotone {
    let mut state = State::new(qp, start);
    loop {
        state.sweep();
        let mut active = state.binding();
        let Some(face) = state.minimise_on_face(&mut active) else {
            return Monotone::Unbounded;
        };
        history.push(active.iter().filter(|a| **a).count());
        let optimal = state.is_optimal(&active);
        if optimal || state.out_of_steps() {
            // the descent ends within rounding of its steps; the minimum on the last face has that of its data alone
            let x = if face.is_singular() { state.x } else { face_minimiser(qp, &active, &face) };
            let solution = DenseSolution { x, active, face, steps: state.steps };
            return if optimal { Monotone::Solved(solution) } else { Monotone::StepLimit(solution) };
        }
    }
}

/// A feasible point.
struct State<'a> {
    qp: &'a DenseQp,
    x: Vec<f64>,
    /// `b − Sx`.
    residual: Vec<f64>,
    tolerance: f64,
    steps: usize,
}

impl<'a> State<'a> {
    fn new(qp: &'a DenseQp, start: &[f64]) -> Self {
        let project = |(x, g): (&f64, &f64)| x.min(*g);
        let x: Vec<f64> = start.iter().zip(&qp.upper).map(project).collect();
        Self { residual: qp.residual(&x), tolerance: qp.tolerance(&x), qp, x, steps: 0 }
    }

    /// One projected Gauss–Seidel sweep: each component minimises the energy on its own, within its bound.
    fn sweep(&mut self) {
        for i in 0..self.qp.len() {
            let stiffness = self.qp.matrix[(i, i)];
            let room = self.qp.upper[i] - self.x[i];
            let step = match self.residual[i] {
                r if stiffness > 0.0 => (r / stiffness).min(room),
                r if r > 0.0 => room,
                _ => 0.0,
            };
            // A multiplier of rounding size releases nothing.
            if step != 0.0 && self.residual[i].abs() > self.tolerance {
                self.x[i] = if step == room { self.qp.upper[i] } else { self.x[i] + step };
                let column = self.qp.column(i);
                let residual = self.residual.iter_mut().zip(column);
                residual.for_each(|(r, s)| *r -= s * step);
            }
        }
        self.refresh();
    }

    /// Components at their bound that the energy presses against it, or at least does not pull away.
    fn binding(&self) -> Vec<bool> {
        let at_bound = |i: usize| self.x[i] >= self.qp.upper[i];
        (0..self.qp.len()).map(|i| at_bound(i) && self.residual[i] >= -self.tolerance).collect()
    }

    /// Descends to the minimum on the face of the active components. Bounds that are hit join the face, so the descent
    /// has at most `m` truncated steps. `None` if the energy has no lower bound.
    fn minimise_on_face(&mut self, active: &mut [bool]) -> Option<Face> {
        loop {
            self.steps += 1;
            let face = Face::new(self.qp, active);
            if face.is_singular() && (self.is_stationary(active) || self.out_of_steps()) {
                return Some(face);
            }
            let direction = face.solve(&self.residual);
            let (hit, reach) = self.first_bound(&direction, active);
            if face.is_singular() && self.is_drift(&direction) {
                hit?;
                self.advance(&direction, reach, hit, active);
            } else if reach < 1.0 {
                self.advance(&direction, reach, hit, active);
            } else {
                self.advance(&direction, 1.0, None, active);
                if !face.is_singular() {
                    return Some(face);
                }
            }
        }
    }

    /// Whether a proximal step is in the main a motion without stiffness: `dᵀSd ≪ rᵀd`.
    fn is_drift(&self, direction: &[f64]) -> bool {
        let gain: f64 = self.residual.iter().zip(direction).map(|(r, d)| r * d).sum();
        self.qp.curvature(direction) < 1e-3 * gain
    }

    /// The free component that meets its bound first along `x + t d`, and at which `t`.
    fn first_bound(&self, direction: &[f64], active: &[bool]) -> (Option<usize>, f64) {
        let mut first = (None, f64::INFINITY);
        for i in (0..self.qp.len()).filter(|&i| !active[i] && direction[i] > 0.0) {
            let reach = (self.qp.upper[i] - self.x[i]) / direction[i];
            if reach < first.1 {
                first = (Some(i), reach);
            }
        }
        first
    }

    /// Takes the better of the straight step of the given length, which meets the bound `hit`, and of the full step
    /// projected on the bounds. Bounds that are met become active.
    fn advance(&mut self, direction: &[f64], length: f64, hit: Option<usize>, active: &mut [bool]) {
        let mut straight = self.along(direction, length);
        if let Some(i) = hit {
            straight[i] = self.qp.upper[i];
        }
        let projected = self.along(direction, length.max(1.0));
        let (gain, projected_gain) = (self.gain(&straight), self.gain(&projected));
        debug_assert!(gain >= -self.tolerance * distance(&straight, &self.x), "the energy rose by {}", -gain);
        self.x = if projected_gain > gain { projected } else { straight };
        for i in 0..self.qp.len() {
            active[i] |= direction[i] > 0.0 && self.x[i] >= self.qp.upper[i];
        }
        self.refresh();
    }

    /// `x + t d`, projected on the bounds.
    fn along(&self, direction: &[f64], t: f64) -> Vec<f64> {
        let point = self.x.iter().zip(direction).zip(&self.qp.upper);
        point.map(|((x, d), g)| (x + t * d).min(*g)).collect()
    }

    /// Energy won by going to `target`: `rᵀs − ½ sᵀSs`, `s = target − x`.
    fn gain(&self, target: &[f64]) -> f64 {
        let step: Vec<f64> = target.iter().zip(&self.x).map(|(a, b)| a - b).collect();
        let work: f64 = self.residual.iter().zip(&step).map(|(r, s)| r * s).sum();
        work - 0.5 * self.qp.curvature(&step)
    }

    /// A safeguard: fewer than ten steps are usual.
    fn out_of_steps(&self) -> bool {
        self.steps > 4 * self.qp.len() + 100
    }

    fn is_stationary(&self, active: &[bool]) -> bool {
        let rest = |i: &usize| !active[*i];
        (0..self.qp.len()).filter(rest).all(|i| self.residual[i].abs() <= 10.0 * self.tolerance)
    }

    fn is_optimal(&self, active: &[bool]) -> bool {
        let pressing = |i: usize| !active[i] || self.residual[i] >= -self.tolerance;
        (0..self.qp.len()).all(pressing)
    }

    fn refresh(&mut self) {
        self.residual = self.qp.residual(&self.x);
        self.tolerance = self.qp.tolerance(&self.x);
    }
}

/// `Σ |a_i − b_i|`.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).sum()
}
