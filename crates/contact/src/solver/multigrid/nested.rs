//! Nested iteration: from the coarsest level to the finest, each start the prolongation of the level below.

use super::cycle::{Cycle, Grid};
use super::iterate::{Iteration, active};
use super::{Accuracy, Levels};
use crate::qp::BoundQp;
use crate::solver::kernel::anchors;
use crate::solver::{Method, Prepared, QpSolution, Settings, Status, condensed};

/// Iterations on the finest level, at most.
const MOST: usize = 1000;
/// Iterations on a level below the finest, at most, and the share of its discretisation error that is enough there.
const MOST_BELOW: usize = 6;
const BELOW: f64 = 0.2;
/// The residual is computed anew after so many iterations.
const REFRESH: usize = 10;
/// A decrease below this share of the energy cannot be told from rounding.
const FLOOR: f64 = 1e-25;
/// Below this share it is rounding if it does not fall quickly any more.
const NEAR_FLOOR: f64 = 1e-20;
const STALLS: f64 = 0.3;
/// Where the energy falls by less than this factor from step to step, coarse levels are visited and swept twice as often.
const SLOW: f64 = 0.25;

/// Solves by nested iteration; the certificate of the answer is not computed here.
pub fn solve(qp: &BoundQp, mut levels: Levels, settings: &Settings) -> QpSolution {
    let motions = std::mem::take(&mut levels.motions);
    let grids = Grid::all(qp, levels);
    let mut loads = loads(&grids, qp);
    let mut run = Run {
        cycle: Cycle::new(&grids, &motions),
        grids: &grids,
        visited: 0,
        work: 0,
        distance: None,
        history: Vec::new(),
    };
    let Some((first, start)) = run.start(qp, &loads, settings) else {
        return QpSolution::unsolved(qp, Status::NotPositiveDefinite);
    };
    let finest = grids.len() - 1;
    let (mut x, mut energy) = (start.x, None);
    let mut ended = Some(start.iterations);
    if first == finest {
        run.history = start.history;
    }
    for level in first + 1..=finest {
        let below = energy.unwrap_or_else(|| crate::qp::energy_of(&grids[first].matrix(), load(&loads, qp, first), &x));
        let start = prolonged(&grids, level, &x);
        let aim = if level == finest { settings.accuracy } else { Accuracy::Discretisation(BELOW) };
        let most = if level == finest { MOST } else { MOST_BELOW };
        // a coarse load goes with its level: the finest one needs the room
        let own = loads.get_mut(level).map(std::mem::take);
        let mut iteration = Iteration::new(&grids[level], level, own.as_deref().unwrap_or(&qp.load), start);
        ended = run.iterate(&mut iteration, below, aim, most, level == finest);
        energy = Some(iteration.energy());
        if level == finest && (ended.is_none() || run.distance.is_none()) {
            run.is_close(&mut iteration, true, 0.0);
        }
        run.visited += iteration.visited;
        x = iteration.x;
    }
    let mut answer = QpSolution::unsolved(qp, Status::IterationLimit { steps: MOST });
    answer.x = x;
    answer.iterations = ended.unwrap_or(MOST);
    if let Some(steps) = ended {
        answer.status = Status::Converged { steps };
    }
    answer.factorizations = 1 + run.cycle.factorizations();
    answer.work = run.work as f64 / grids[finest].entries() as f64;
    answer.history = run.history;
    answer.distance = run.distance;
    let on_bound = active(&qp.bounds, &answer.x);
    condensed::finish(qp, &on_bound, &mut answer);
    answer
}

struct Run<'a> {
    grids: &'a [Grid<'a>],
    cycle: Cycle<'a>,
    visited: usize,
    /// Matrix entries visited until the answer was there; what confirms it is not counted.
    work: usize,
    distance: Option<f64>,
    history: Vec<usize>,
}

impl Run<'_> {
    /// The coarsest level on which the contact problem has a solution, and that solution. Curved bodies may lack one on a coarse mesh,
    /// whose nodes allow motions that the fine zone does not.
    fn start(&self, qp: &BoundQp, loads: &[Vec<f64>], settings: &Settings) -> Option<(usize, QpSolution)> {
        let settings = Settings { method: Method::Condensed, ..*settings };
        for (level, grid) in self.grids.iter().enumerate() {
            let answer = if level + 1 == self.grids.len() {
                Prepared::new(qp, Method::Condensed).solve(&settings)
            } else {
                Prepared::new(&coarse_problem(qp, grid, &loads[level])?, Method::Condensed).solve(&settings)
            };
            if answer.status.is_solved() {
                return Some((level, answer));
            }
        }
        None
    }

    /// Iterates until the aim is reached; how many iterations that took, or nothing.
    fn iterate(
        &mut self,
        iteration: &mut Iteration,
        below: f64,
        aim: Accuracy,
        most: usize,
        is_finest: bool,
    ) -> Option<usize> {
        let (mut last, mut last_ratio) = (f64::INFINITY, 0.0);
        for count in 1..=most {
            let progress = iteration.advance(&mut self.cycle);
            if is_finest {
                self.history.push(progress.active);
            }
            let decrease = progress.decrease;
            let ratio = if last.is_finite() && last > 0.0 { decrease / last } else { 1.0 / 16.0 };
            let size = iteration.size();
            if decrease <= FLOOR * size || (decrease <= NEAR_FLOOR * size && ratio > STALLS) {
                return Some(count);
            }
            if let Accuracy::Discretisation(share) = aim {
                // J_h − J is a third of what the energy fell by from the level below, at first order; less at lower order
                let error = (below - iteration.energy()) / 3.0;
                // with a decrease that shrinks like ρ, ρ/(1 − ρ) of the last one is still to come
                let slower = f64::max(ratio, last_ratio);
                let rest = if slower < 1.0 { decrease * slower / (1.0 - slower) } else { f64::INFINITY };
                let enough = share * share * error;
                if rest <= enough && self.is_close(iteration, is_finest, enough) {
                    return Some(count);
                }
            }
            if ratio > SLOW && last.is_finite() {
                self.cycle.work_harder();
            }
            (last, last_ratio) = (decrease, ratio);
            if count % REFRESH == 0 {
                iteration.refresh();
            }
        }
        None
    }
}

impl Run<'_> {
    /// Whether one more cycle on the residual confirms what the decreases say; asked on the finest level only.
    fn is_close(&mut self, iteration: &mut Iteration, is_finest: bool, enough: f64) -> bool {
        if !is_finest {
            return true;
        }
        self.work = self.visited + iteration.visited + self.cycle.visited;
        let distance = iteration.distance(&mut self.cycle);
        self.distance = Some(distance);
        let is_close = 0.5 * distance * distance <= enough;
        if !is_close {
            iteration.refresh();
        }
        is_close
    }
}

/// `P x` brought within the bounds; a component whose origins are all active stays closed.
fn prolonged(grids: &[Grid], level: usize, coarse: &[f64]) -> Vec<f64> {
    let grid = &grids[level];
    let mut x = vec![0.0; grid.dimension()];
    let Some(transfer) = &grid.transfer else { return x };
    transfer.prolong(coarse, &mut x);
    let below = &grids[level - 1];
    let closed = active(&below.bounds, coarse);
    let is_closed = |dof: u32| below.bounds.binary_search_by_key(&dof, |b| b.dof).map(|k| closed[k]);
    for bound in grid.bounds.iter() {
        let x = &mut x[bound.dof as usize];
        let mut origins = transfer.origins(bound.dof).into_iter().filter_map(|o| is_closed(o).ok()).peekable();
        let stays_closed = origins.peek().is_some() && origins.all(|closed| closed);
        *x = if stays_closed { bound.upper } else { x.min(bound.upper) };
    }
    x
}

/// The loads of the levels below the finest, `Pᵀ f`.
fn loads(grids: &[Grid], qp: &BoundQp) -> Vec<Vec<f64>> {
    let mut loads = vec![Vec::new(); grids.len() - 1];
    let mut fine = qp.load.clone();
    for level in (0..loads.len()).rev() {
        let grid = &grids[level + 1];
        let mut coarse = vec![0.0; grids[level].dimension()];
        if let Some(transfer) = &grid.transfer {
            transfer.restrict(&grid.matrix(), &mut fine, &mut coarse);
        }
        fine.clone_from(&coarse);
        loads[level] = coarse;
    }
    loads
}

fn load<'a>(loads: &'a [Vec<f64>], qp: &'a BoundQp, level: usize) -> &'a [f64] {
    loads.get(level).unwrap_or(&qp.load)
}

/// The problem of a coarse level. Its slides are held at one component each; where does not matter here.
fn coarse_problem(qp: &BoundQp, grid: &Grid, load: &[f64]) -> Option<BoundQp> {
    let kernel: Vec<Vec<f64>> = qp.kernel.iter().map(|y| y[..grid.dimension()].to_vec()).collect();
    let conditions = anchors(&kernel)?.into_iter().map(|i| vec![(i as u32, 1.0)]).collect();
    Some(BoundQp {
        matrix: grid.matrix().clone().into_owned(),
        load: load.to_vec(),
        bounds: grid.bounds.to_vec(),
        kernel,
        conditions,
    })
}
