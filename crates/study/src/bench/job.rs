//! One measurement, carried out alone in its process.

use super::bandwidth::bandwidth;
use crate::change::Changes;
use crate::error::RunError;
use crate::record::Level;
use crate::run::timing::LevelTimes;
use crate::run::{Alone, Constraints, Solver};
use crate::study::{Case, Study};
use serde::{Deserialize, Serialize};
use signorini_contact::sparse::BlockMatrix;
use std::hint::black_box;
use std::time::Instant;

/// What to measure, in words that another process understands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Job {
    /// Id or path of the study; empty for what needs none.
    pub study: String,
    /// Name of the case.
    pub case: String,
    /// Cells of the levels, from the coarsest of the family to the one to compute.
    pub cells: Vec<usize>,
    /// What to do there.
    pub task: Task,
    /// What options change of the study.
    #[serde(default, skip_serializing_if = "Changes::is_none")]
    pub changes: Changes,
}

impl Job {
    /// The one that needs no study.
    pub(super) fn of_machine() -> Self {
        let (study, case, changes) = (String::new(), String::new(), Changes::default());
        Self { study, case, cells: Vec::new(), task: Task::Bandwidth, changes }
    }
}

/// The sorts of measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Task {
    /// The contact problem under that solver.
    Contact(Solver),
    /// The linear problem with every pair tied.
    Linear(Solver),
    /// Products with the stiffness matrix.
    Product,
    /// The triad; study, case and cells say nothing.
    Bandwidth,
}

/// What a job measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// A level was solved.
    Level(Box<TimedLevel>),
    /// Products were made.
    Product(Product),
    /// Bytes per second of the triad: one thread, all threads.
    Bandwidth([f64; 2]),
}

/// A level of a run and what it took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimedLevel {
    /// The level, without its contact zone.
    pub level: Level,
    /// Products with the finest matrix that the iteration took, coarser levels counted by their size; none for direct solvers.
    pub work: Option<f64>,
    /// Wall seconds of the phases, in the order of [`LevelTimes::PHASES`].
    pub wall: [f64; 5],
    /// Processor seconds of the phases, all threads together.
    pub processor: Option<[f64; 5]>,
    /// Largest resident memory of the process.
    pub peak_bytes: Option<u64>,
}

/// Products with a stiffness matrix.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Product {
    /// Wall seconds of one, the median of many.
    pub seconds: f64,
    /// Bytes of the stored matrix.
    pub matrix_bytes: u64,
}

/// Wall seconds that the products together take at least.
const PRODUCTS_FOR: f64 = 0.1;
/// Fewest products.
const PRODUCTS: usize = 7;

/// Carries a job out; `load` reads its study, with what options change of it.
///
/// # Errors
/// Those of `load`, turned into `E`, and of the level.
pub fn carry_out<E: From<RunError>>(job: &Job, load: impl Fn(&Job) -> Result<Study, E>) -> Result<Outcome, E> {
    if job.task == Task::Bandwidth {
        return Ok(Outcome::Bandwidth(bandwidth()));
    }
    let study = load(job)?;
    Ok(on_level(job, &study)?)
}

fn on_level(job: &Job, study: &Study) -> Result<Outcome, RunError> {
    let missing = || RunError::Study(format!("study '{}' has no contact problem named '{}'", study.id, job.case));
    let case = study.cases.iter().find(|c| c.name == job.case).ok_or_else(missing)?;
    let scene = case.scene().ok_or_else(missing)?;
    let alone = Alone { case, scene, cells: &job.cells };
    let level = |solver: &Solver, constraints| {
        let (level, times) = alone.run(&for_case(solver, study, case), constraints)?;
        Ok(Outcome::Level(Box::new(timed(level, &times))))
    };
    match &job.task {
        Task::Contact(solver) => level(solver, Constraints::OfScene),
        Task::Linear(solver) => level(solver, Constraints::AllBilateral),
        Task::Product | Task::Bandwidth => Ok(Outcome::Product(products(&alone.matrix()?))),
    }
}

/// The solver, another program with the folders of the case.
fn for_case(solver: &Solver, study: &Study, case: &Case) -> Solver {
    match solver {
        Solver::External(external) => Solver::External(external.for_case(&study.id, &case.name)),
        own => own.clone(),
    }
}

fn timed(mut level: Level, times: &LevelTimes) -> TimedLevel {
    level.contact = None;
    let (processor, peak_bytes) = (times.processor, times.peak_bytes);
    TimedLevel { work: level.solver.work, level, wall: times.phases(), processor, peak_bytes }
}

fn products(matrix: &BlockMatrix) -> Product {
    let x = vec![1.0; matrix.dimension()];
    let mut y = vec![0.0; matrix.dimension()];
    let begin = Instant::now();
    let mut seconds = Vec::new();
    while seconds.len() < PRODUCTS || begin.elapsed().as_secs_f64() < PRODUCTS_FOR {
        let start = Instant::now();
        matrix.apply(black_box(&x), &mut y);
        seconds.push(start.elapsed().as_secs_f64());
        black_box(&mut y);
    }
    seconds.sort_by(f64::total_cmp);
    Product { seconds: seconds[seconds.len() / 2], matrix_bytes: matrix.bytes() as u64 }
}
