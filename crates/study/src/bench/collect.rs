//! From outcomes to the record of a study.

use super::curve::{growth, seconds_to, targets};
use super::job::{Outcome, Product, Task, TimedLevel};
use super::measure::Repeated;
use super::plan::{Size as PlannedSize, Subject, linear_solver, most_unknowns};
use super::record::{BenchStudy, ErrorSource, LeftOut, Linear, Measured, Seconds, Size, SolverCurve};
use super::spread::Spread;
use crate::extrapolation;
use crate::record::Level;
use crate::run::Solver;
use crate::study::ReferencePlan;

/// Largest share of an error that the uncertainty of the extrapolated energy may make.
const SHARE: f64 = 0.1;
/// Largest share of a measured error that a solver may have left undone; beyond it its seconds are not those of a solution.
const UNSOLVED: f64 = 0.05;

/// Outcomes by study, level and task.
pub(super) struct Sorted<'a>(pub &'a [Repeated]);

impl<'a> Sorted<'a> {
    fn find(&self, subject: &Subject, size: &PlannedSize, task: &Task) -> Option<&'a Repeated> {
        self.0.iter().find(|r| {
            let job = &r.job;
            job.task == *task && job.cells == size.cells && job.study == subject.name && job.case == subject.case().name
        })
    }
}

impl Repeated {
    fn levels<'a>(&'a self) -> Vec<&'a TimedLevel> {
        let level = |o: &'a Outcome| if let Outcome::Level(l) = o { Some(&**l) } else { None };
        self.outcomes.iter().filter_map(level).collect()
    }

    fn products(&self) -> Vec<Product> {
        self.outcomes.iter().filter_map(|o| if let Outcome::Product(p) = o { Some(*p) } else { None }).collect()
    }

    /// Why there is nothing to show: the job failed, or its level was not solved, in the solver's words or by the residual.
    fn fault(&self) -> Option<String> {
        let unsolved = || self.levels().iter().find(|l| !l.level.solver.solved).map(|l| l.level.solver.status.clone());
        let shares = self.levels().into_iter().filter_map(|l| l.level.budget.algebraic);
        let undone = || {
            let share = shares.reduce(f64::max).filter(|s| *s > UNSOLVED)?;
            let [share, most] = [share, UNSOLVED].map(|s| 100.0 * s);
            Some(format!(
                "algebraic error is {share:.1} % of the measured error in one of the rounds, more than {most:.1} %"
            ))
        };
        self.failure.clone().or_else(unsolved).or_else(undone)
    }
}

/// Energies that errors are measured from, where there is no exact solution.
struct Limit {
    energy: f64,
    uncertainty: f64,
}

pub(super) fn study_record(subject: &Subject, sizes: &[PlannedSize], solvers: &[Solver], all: &Sorted) -> BenchStudy {
    let exact = subject.case().reference == ReferencePlan::Exact;
    let limit = if exact { None } else { limit(subject, sizes, solvers, all) };
    let mut curves: Vec<SolverCurve> = solvers.iter().map(|s| curve(subject, sizes, s, all, limit.as_ref())).collect();
    let errors = curves.iter().flat_map(|c| &c.runs).filter_map(|r| r.relative_error);
    let targets = targets(errors);
    curves.iter_mut().for_each(|c| c.seconds_to_target = to_targets(c, &targets));
    BenchStudy {
        study: subject.study.id_of_file().to_owned(),
        case: subject.case().name.clone(),
        title: subject.study.title.clone(),
        family: subject.case().family_name().to_owned(),
        error: match (exact, &limit) {
            (true, _) => ErrorSource::Exact,
            (false, Some(_)) => ErrorSource::Energies,
            (false, None) => ErrorSource::None,
        },
        sizes: sizes.iter().enumerate().map(|(k, s)| size(subject, k, s, solvers, all)).collect(),
        targets,
        solvers: curves,
        changed: subject.case().changed.clone(),
    }
}

/// The first solved level of a size, under any of the solvers.
fn any_level<'a>(subject: &Subject, size: &PlannedSize, solvers: &[Solver], all: &Sorted<'a>) -> Option<&'a Level> {
    let mut found = solvers.iter().filter_map(|s| all.find(subject, size, &Task::Contact(s.clone())));
    found.find_map(|r| r.levels().first().map(|l| &l.level).filter(|l| l.solver.solved))
}

fn limit(subject: &Subject, sizes: &[PlannedSize], solvers: &[Solver], all: &Sorted) -> Option<Limit> {
    let levels: Vec<Level> = sizes.iter().filter_map(|s| any_level(subject, s, solvers, all).cloned()).collect();
    let found = extrapolation::of(&levels)?;
    Some(Limit { energy: found.energy, uncertainty: found.uncertainty })
}

fn size(subject: &Subject, level: usize, size: &PlannedSize, solvers: &[Solver], all: &Sorted) -> Size {
    let solved = any_level(subject, size, solvers, all);
    let products = all.find(subject, size, &Task::Product).map(Repeated::products).unwrap_or_default();
    Size {
        level,
        cells: *size.cells.last().unwrap_or(&0),
        h: solved.map(|l| l.h),
        dofs: solved.map_or(size.dofs, |l| l.dofs),
        product: Spread::of(products.iter().map(|p| p.seconds)),
        matrix_bytes: products.first().map(|p| p.matrix_bytes),
    }
}

fn curve(
    subject: &Subject,
    sizes: &[PlannedSize],
    solver: &Solver,
    all: &Sorted,
    limit: Option<&Limit>,
) -> SolverCurve {
    let (mut runs, mut left_out, mut dofs) = (Vec::new(), Vec::new(), Vec::new());
    let linear_solver = linear_solver(solver);
    for (level, size) in sizes.iter().enumerate() {
        let Some(repeated) = all.find(subject, size, &Task::Contact(solver.clone())) else {
            left_out.push(LeftOut::by_limit(level, most_unknowns(solver)));
            continue;
        };
        let linear = linear_solver.clone().and_then(|l| all.find(subject, size, &Task::Linear(l)));
        match (repeated.fault(), measured(level, &repeated.levels(), limit)) {
            (None, Some(run)) => {
                dofs.push(repeated.levels()[0].level.dofs);
                runs.push(with_linear(run, linear));
            }
            (fault, _) => left_out.push(LeftOut { level, reason: fault.unwrap_or_else(|| "no time measured".into()) }),
        }
    }
    let grown = |of: fn(&Seconds) -> Spread| -> Vec<(usize, f64)> {
        dofs.iter().zip(&runs).map(|(n, r): (&usize, &Measured)| (*n, of(&r.wall).median)).collect()
    };
    SolverCurve {
        solver: solver.name().to_owned(),
        linear_solver: linear_solver.map(|l| l.name().to_owned()),
        growth_total: growth(&grown(|s| s.total)),
        growth_system: growth(&grown(|s| s.system)),
        seconds_to_target: Vec::new(),
        runs,
        left_out,
    }
}

fn measured(level: usize, rounds: &[&TimedLevel], limit: Option<&Limit>) -> Option<Measured> {
    let first = rounds.first()?;
    let processor: Option<Vec<[f64; 5]>> = rounds.iter().map(|r| r.processor).collect();
    let peaks: Option<Vec<f64>> = rounds.iter().map(|r| r.peak_bytes.map(|b| b as f64)).collect();
    let error = error_of(&first.level, limit);
    let size = first.level.solution_energy.filter(|s| *s > 0.0);
    let solver = &first.level.solver;
    Some(Measured {
        level,
        status: solver.status.clone(),
        iterations: solver.iterations,
        factorizations: solver.factorizations,
        work: first.work,
        error,
        relative_error: error.zip(size).map(|(e, s)| e / s),
        wall: seconds(&rounds.iter().map(|r| r.wall).collect::<Vec<_>>())?,
        processor: processor.and_then(|p| seconds(&p)),
        peak_bytes: peaks.and_then(Spread::of),
        linear: None,
        closed: closed(&first.level),
    })
}

/// Share of the constraints that press.
fn closed(level: &Level) -> Option<f64> {
    (level.constraints > 0).then(|| level.active as f64 / level.constraints as f64)
}

/// The measured error, or `√(2(L(u_h) − L*))` where the uncertainty of `L*` does not show in it.
fn error_of(level: &Level, limit: Option<&Limit>) -> Option<f64> {
    let Some(limit) = limit else { return level.errors.energy.filter(|e| *e > 0.0) };
    let square = 2.0 * (level.energy - limit.energy);
    // δe/e = δL/e²
    (square > 0.0 && limit.uncertainty <= SHARE * square).then(|| square.sqrt())
}

fn seconds(rounds: &[[f64; 5]]) -> Option<Seconds> {
    let over = |f: fn(&[f64; 5]) -> f64| Spread::of(rounds.iter().map(f));
    Some(Seconds {
        mesh: over(|p| p[0])?,
        assembly: over(|p| p[1])?,
        setup: over(|p| p[2])?,
        solve: over(|p| p[3])?,
        error: over(|p| p[4])?,
        system: over(|p| p[2] + p[3])?,
        solution: over(|p| p[..4].iter().sum())?,
        total: over(|p| p.iter().sum())?,
    })
}

/// The run beside the linear problem on its mesh.
fn with_linear(run: Measured, linear: Option<&Repeated>) -> Measured {
    let Some(linear) = linear.filter(|l| l.fault().is_none()) else { return run };
    let found = measured(run.level, &linear.levels(), None).and_then(|tied| {
        let wall = tied.wall.system;
        let processor = tied.processor.map(|p| p.system);
        let over = |contact: Spread, linear: Spread| (linear.median > 0.0).then(|| contact.median / linear.median);
        Some(Linear {
            iterations: tied.iterations,
            work: tied.work,
            wall,
            processor,
            ratio: over(run.wall.system, wall)?,
            ratio_processor: run.processor.zip(processor).and_then(|(c, l)| over(c.system, l)),
        })
    });
    Measured { linear: found, ..run }
}

fn to_targets(curve: &SolverCurve, targets: &[f64]) -> Vec<Option<f64>> {
    let points: Vec<(f64, f64)> =
        curve.runs.iter().filter_map(|r| Some((r.relative_error?, r.wall.solution.median))).collect();
    targets.iter().map(|t| seconds_to(&points, *t)).collect()
}
