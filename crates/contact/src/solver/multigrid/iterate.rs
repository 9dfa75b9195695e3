//! One iteration on one level: the cycle as preconditioner of an energy minimisation within the bounds.

use super::coarsest::frozen_dofs;
use super::cycle::{Cycle, Grid};
use super::sweep::{Direction, Limits};
use super::vector::{self, dot};
use crate::qp::Bound;

/// Two directions closer than this to parallel are one.
const PARALLEL: f64 = 1e-12;
/// Work on a motion below this share of its terms is none.
const BALANCED: f64 = 1e-10;
/// Contacts that a lifted body may meet one after the other before it rests: one for each motion of two bodies.
const MOTIONS: usize = 6;

/// An iteration on one level.
pub struct Iteration<'a, 'l> {
    grid: &'l Grid<'a>,
    level: usize,
    load: &'l [f64],
    /// The iterate, within its bounds.
    pub x: Vec<f64>,
    /// `r = f − Kx`, by recurrence.
    rest: Vec<f64>,
    /// `z` and `Kz`: what sweeps and cycle propose.
    change: Vec<f64>,
    change_image: Vec<f64>,
    /// `p` and `Kp`: the last step.
    step: Vec<f64>,
    step_image: Vec<f64>,
    /// Whether the active set rested in the last step, so that it may be used again.
    remembers: bool,
    /// Matrix entries visited on this level so far.
    pub visited: usize,
}

/// What an iteration did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// How much the energy fell.
    pub decrease: f64,
    /// Bounds that are active now.
    pub active: usize,
}

impl<'a, 'l> Iteration<'a, 'l> {
    /// Starts from `x`, which is within its bounds.
    pub fn new(grid: &'l Grid<'a>, level: usize, load: &'l [f64], x: Vec<f64>) -> Self {
        let zeros = || vec![0.0; x.len()];
        let (rest, change, change_image, step, step_image) = (zeros(), zeros(), zeros(), zeros(), zeros());
        let mut iteration =
            Self { grid, level, load, x, rest, change, change_image, step, step_image, remembers: false, visited: 0 };
        iteration.refresh();
        iteration
    }

    /// Computes the residual anew and forgets the last step.
    pub fn refresh(&mut self) {
        self.grid.residual(self.load, &self.x, &mut self.rest);
        self.visited += self.grid.entries();
        self.remembers = false;
    }

    /// `½ xᵀKx − fᵀx = −½ (f + r)ᵀx`.
    pub fn energy(&self) -> f64 {
        -0.5 * (dot(self.load, &self.x) + dot(&self.rest, &self.x))
    }

    /// The size of the energy's terms, `½ |fᵀx|`.
    pub fn size(&self) -> f64 {
        0.5 * dot(self.load, &self.x).abs()
    }

    /// One iteration: five products' worth on this level, coarse levels included.
    pub fn advance(&mut self, cycle: &mut Cycle) -> Progress {
        let before = active(&self.grid.bounds, &self.x);
        self.change.copy_from_slice(&self.x);
        let limits = Limits::Bounds(&self.grid.bounds);
        self.grid.sweep(Direction::Forward, limits, self.load, &mut self.x);
        let face = self.correct(cycle);
        self.grid.sweep(Direction::Backward, limits, self.load, &mut self.x);
        let after = active(&self.grid.bounds, &self.x);
        // z = x − x_0, and x = x_0 again
        vector::add(&mut self.x, -1.0, &self.change);
        std::mem::swap(&mut self.x, &mut self.change);
        self.grid.matrix().apply(&self.change, &mut self.change_image);
        self.visited += 3 * self.grid.entries();
        let rested = before == face && face == after;
        let decrease = self.minimise(rested, &after);
        self.remembers = rested;
        Progress { decrease, active: after.iter().filter(|a| **a).count() }
    }

    /// `√(rᵀBr)` with the residual computed anew and one linear cycle `B ≈ K⁻¹` on the face of the bounds that press. The cycle
    /// contracts, so this is the distance to the minimiser on that face within a factor near 1.
    pub fn distance(&mut self, cycle: &mut Cycle) -> f64 {
        self.refresh();
        let presses = |b: &Bound| self.x[b.dof as usize] == b.upper && self.rest[b.dof as usize] > 0.0;
        let face: Vec<bool> = self.grid.bounds.iter().map(presses).collect();
        frozen_dofs(&self.grid.bounds, &face).into_iter().for_each(|i| self.rest[i] = 0.0);
        cycle.freeze(self.level, &face);
        let limits = Limits::Frozen(&face);
        self.change.fill(0.0);
        self.grid.sweep(Direction::Forward, limits, &self.rest, &mut self.change);
        self.grid.residual(&self.rest, &self.change, &mut self.change_image);
        cycle.correct(self.level, &face, &mut self.change_image);
        vector::add(&mut self.change, 1.0, &self.change_image);
        self.grid.sweep(Direction::Backward, limits, &self.rest, &mut self.change);
        self.visited += 3 * self.grid.entries();
        dot(&self.rest, &self.change).max(0.0).sqrt()
    }

    /// The coarse correction on the face of the current point, which it returns.
    fn correct(&mut self, cycle: &mut Cycle) -> Vec<bool> {
        self.grid.residual(self.load, &self.x, &mut self.change_image);
        self.visited += self.grid.entries();
        let mut face = active(&self.grid.bounds, &self.x);
        cycle.freeze(self.level, &face);
        if cycle.has_motions() {
            self.rest_on_contact(cycle, &mut face);
        }
        cycle.correct(self.level, &face, &mut self.change_image);
        let correction = &mut self.change_image;
        if !clip(&self.grid.bounds, &self.x, correction) {
            vector::add(&mut self.x, 1.0, correction);
            return face;
        }
        // the active set changes, so the last step is of no use any more and lends its room
        self.remembers = false;
        self.grid.residual(self.load, &self.x, &mut self.step);
        let slope = dot(correction, &self.step);
        self.grid.matrix().apply(correction, &mut self.step);
        let curvature = dot(correction, &self.step);
        self.visited += 2 * self.grid.entries();
        let length = if slope > 0.0 { f64::min(slope / curvature, 1.0) } else { 0.0 };
        vector::add(&mut self.x, length, correction);
        if length == 1.0 {
            land(&self.grid.bounds, &mut self.x);
        }
        face
    }

    /// Moves a body that its contacts do not hold along the force on it until it meets the next one, as often as it takes.
    /// `change_image` is the residual; rigid motions leave it as it is.
    fn rest_on_contact(&mut self, cycle: &mut Cycle, face: &mut Vec<bool>) {
        for _ in 0..MOTIONS {
            let mut motion = vec![0.0; self.x.len()];
            let mut pushed = false;
            for free in cycle.free_motions(self.level) {
                let terms = || free.iter().zip(&self.change_image).map(|(y, r)| y * r);
                let work: f64 = terms().sum();
                if work.abs() > BALANCED * terms().map(f64::abs).sum::<f64>() {
                    pushed = true;
                    vector::add(&mut motion, work / dot(&free, &free), &free);
                }
            }
            let blocking = self.grid.bounds.iter().zip(&*face).filter(|(b, f)| !**f && motion[b.dof as usize] > 0.0);
            let room = |b: &Bound| (b.upper - self.x[b.dof as usize]) / motion[b.dof as usize];
            let Some((length, dof, upper)) =
                blocking.map(|(b, _)| (room(b), b.dof, b.upper)).min_by(|a, b| a.0.total_cmp(&b.0))
            else {
                return;
            };
            if !pushed {
                return;
            }
            self.remembers = false;
            vector::add(&mut self.x, length, &motion);
            land(&self.grid.bounds, &mut self.x);
            self.x[dof as usize] = upper;
            *face = active(&self.grid.bounds, &self.x);
            cycle.freeze(self.level, face);
        }
    }

    /// The step of least energy along `z`, or within `span{z, p}`; `after` is the active set at the end of `z`.
    fn minimise(&mut self, rested: bool, after: &[bool]) -> f64 {
        let slope = dot(&self.change, &self.rest);
        let curvature = dot(&self.change, &self.change_image);
        if !(slope > 0.0 && curvature > 0.0) {
            self.remembers = false;
            return 0.0;
        }
        if rested && self.remembers {
            let old = [dot(&self.step, &self.rest), dot(&self.step, &self.step_image)];
            let cross = dot(&self.change, &self.step_image);
            let least = plane([slope, old[0]], [curvature, cross, old[1]]);
            if let Some((lengths, decrease)) = least.filter(|(lengths, _)| self.is_within(*lengths)) {
                self.take(lengths);
                return decrease;
            }
        }
        let length = self.length(rested, slope, curvature);
        self.take([length, 0.0]);
        if length >= 1.0 {
            for (bound, _) in self.grid.bounds.iter().zip(after).filter(|(_, a)| **a) {
                self.x[bound.dof as usize] = bound.upper;
            }
        }
        length * (slope - 0.5 * length * curvature)
    }

    /// How far along `z`: to the minimum, but not out of the bounds; a step that closes pairs is taken whole where that lowers the
    /// energy, so that they sit on their bounds.
    fn length(&self, rested: bool, slope: f64, curvature: f64) -> f64 {
        let best = slope / curvature;
        let room = |b: &Bound| {
            let (x, z) = (self.x[b.dof as usize], self.change[b.dof as usize]);
            if z > 0.0 { (b.upper - x) / z } else { f64::INFINITY }
        };
        // the end of z is within the bounds, whatever rounding says
        let longest = self.grid.bounds.iter().map(room).fold(f64::INFINITY, f64::min).max(1.0);
        let lowers = slope > 0.5 * curvature;
        if !rested && best < 1.0 && lowers { 1.0 } else { best.min(longest) }
    }

    /// Whether `x + α z + β p` respects every bound.
    fn is_within(&self, [alpha, beta]: [f64; 2]) -> bool {
        self.grid.bounds.iter().all(|b| {
            let i = b.dof as usize;
            let change = alpha * self.change[i] + beta * self.step[i];
            change <= 0.0 || self.x[i] + change <= b.upper
        })
    }

    /// `p = α z + β p`, `x += p`, `r −= Kp`.
    fn take(&mut self, lengths: [f64; 2]) {
        vector::step(&mut self.step, lengths, &self.change, &mut self.x, 1.0);
        vector::step(&mut self.step_image, lengths, &self.change_image, &mut self.rest, -1.0);
        land(&self.grid.bounds, &mut self.x);
    }
}

/// The minimiser `(α, β)` over two directions with slopes `s` and curvatures `[zz, zp, pp]`, and the decrease there; nothing if the
/// directions are one.
fn plane([s, t]: [f64; 2], [zz, zp, pp]: [f64; 3]) -> Option<([f64; 2], f64)> {
    let determinant = zz * pp - zp * zp;
    if determinant.is_nan() || determinant <= PARALLEL * zz * pp {
        return None;
    }
    let (alpha, beta) = ((s * pp - t * zp) / determinant, (t * zz - s * zp) / determinant);
    Some(([alpha, beta], 0.5 * (alpha * s + beta * t)))
}

/// Shortens the components of a correction that would cross their bounds; whether there were any.
fn clip(bounds: &[Bound], x: &[f64], correction: &mut [f64]) -> bool {
    let mut clipped = false;
    for bound in bounds {
        let i = bound.dof as usize;
        if x[i] + correction[i] > bound.upper {
            correction[i] = bound.upper - x[i];
            clipped = true;
        }
    }
    clipped
}

/// Puts what rounding carried across its bound back on it.
fn land(bounds: &[Bound], x: &mut [f64]) {
    for bound in bounds {
        let x = &mut x[bound.dof as usize];
        *x = x.min(bound.upper);
    }
}

/// Which bounds are active: those whose component is exactly there.
pub fn active(bounds: &[Bound], x: &[f64]) -> Vec<bool> {
    bounds.iter().map(|b| x[b.dof as usize] == b.upper).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_is_searched_to_its_minimum() {
        let (slopes, curvatures) = ([2.0, -1.0], [3.0, 0.5, 2.0]);
        let energy = |a: f64, b: f64| {
            0.5 * (a * a * curvatures[0] + 2.0 * a * b * curvatures[1] + b * b * curvatures[2])
                - a * slopes[0]
                - b * slopes[1]
        };
        let ([a, b], decrease) = plane(slopes, curvatures).unwrap();
        assert!((energy(a, b) + decrease).abs() < 1e-15 && decrease > 0.0);
        for (da, db) in [(1e-3, 0.0), (-1e-3, 0.0), (0.0, 1e-3), (0.0, -1e-3)] {
            assert!(energy(a + da, b + db) > energy(a, b));
        }
        assert!(plane([1.0, 2.0], [1.0, 2.0, 4.0]).is_none(), "one direction twice");
    }
}
