//! Rounds over the jobs.

use super::collect::{Sorted, study_record};
use super::job::{Job, Outcome, Task};
use super::machine::Machine;
use super::plan::{Plan, jobs, sizes};
use super::record::{Bandwidth, BenchRecord, SCHEMA};
use super::spread::Spread;
use crate::error::RunError;
use crate::run::Solver;

/// A job and what became of it in each round.
pub(super) struct Repeated {
    pub job: Job,
    pub outcomes: Vec<Outcome>,
    /// Why the job cannot be done; it is not tried again.
    pub failure: Option<String>,
}

/// Measures everything. `run` carries a job out in a process of its own and says, if it could not, why; `planned` hears how
/// many calls of `run` there will be at most, before the first.
///
/// # Errors
/// Meaningless input. A job that fails is part of the record.
pub fn measure(
    plan: &Plan,
    planned: impl FnOnce(usize),
    mut run: impl FnMut(&Job) -> Result<Outcome, String>,
) -> Result<BenchRecord, RunError> {
    let mut all = vec![Repeated::new(Job::of_machine())];
    let mut levels = Vec::new();
    for subject in &plan.subjects {
        let sizes = sizes(subject, &plan.sizes)?;
        all.extend(sizes.iter().flat_map(|s| jobs(subject, s, &plan.solvers)).map(Repeated::new));
        levels.push(sizes);
    }
    planned(plan.repeat * all.len());
    for round in 0..plan.repeat {
        visit(&mut all, round % 2 == 1, &mut run);
    }
    let sorted = Sorted(&all);
    let studies = plan.subjects.iter().zip(&levels).map(|(s, sizes)| study_record(s, sizes, &plan.solvers, &sorted));
    Ok(BenchRecord {
        schema: SCHEMA,
        version: plan.version.clone(),
        machine: Machine::this(),
        threads: plan.threads,
        repeat: plan.repeat,
        bandwidth: bandwidth(&all[0].outcomes),
        studies: studies.collect(),
    })
}

/// One round, forwards or backwards, so that what comes first is not always the same.
fn visit(all: &mut [Repeated], backwards: bool, run: &mut impl FnMut(&Job) -> Result<Outcome, String>) {
    let count = all.len();
    for k in 0..count {
        let place = if backwards { count - 1 - k } else { k };
        if all[place].failure.is_none() && has_failed_coarser(all, &all[place].job) {
            all[place].failure = Some("not tried, since it failed on a coarser mesh".into());
        }
        let repeated = &mut all[place];
        if repeated.failure.is_none() {
            match run(&repeated.job) {
                Ok(outcome) => repeated.outcomes.push(outcome),
                Err(why) => repeated.failure = Some(why),
            }
        }
    }
}

/// Whether another program failed on a coarser mesh of the case: what it had no time or memory for there is not to be had here.
fn has_failed_coarser(all: &[Repeated], job: &Job) -> bool {
    let is_coarser = |r: &Repeated| {
        (&r.job.study, &r.job.case, &r.job.task) == (&job.study, &job.case, &job.task)
            && r.job.cells.len() < job.cells.len()
    };
    matches!(job.task, Task::Contact(Solver::External(_))) && all.iter().any(|r| r.failure.is_some() && is_coarser(r))
}

fn bandwidth(outcomes: &[Outcome]) -> Bandwidth {
    let of = |which: usize| {
        Spread::of(outcomes.iter().filter_map(|o| match o {
            Outcome::Bandwidth(found) => Some(found[which]),
            _ => None,
        }))
    };
    Bandwidth { one_thread: of(0), all_threads: of(1) }
}

impl Repeated {
    fn new(job: Job) -> Self {
        Self { job, outcomes: Vec::new(), failure: None }
    }
}
