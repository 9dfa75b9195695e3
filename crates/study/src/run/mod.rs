//! From a study to its records: every level of every case solved, measured, fitted and judged.
//!
//! Levels and cases are independent of one another, so they run side by side; the results are put together in the
//! order of the file, so the records do not depend on the number of threads.

mod check;
mod contact;
mod level;
mod partial;
mod reference;
pub mod timing;

use crate::error::RunError;
use crate::exact::verify;
use crate::rate;
use crate::record::{Level, Reference, SCHEMA, StudyRecord};
use crate::reference::overkill::Overkill;
use crate::study::{Case, ReferencePlan, Study};
use crate::verdict::{self, JudgeInput};
pub use check::{CheckedLevel, check_case};
use level::Task;
use partial::Partial;
use rayon::prelude::*;
pub use signorini_contact::solver::Method;
use signorini_contact::solver::Settings;
use std::path::PathBuf;
use timing::LevelTimes;

/// How large the meshes are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// All studies together in well under a minute.
    Quick,
    /// The published tables.
    Full,
}

/// What the command line asks of a run.
#[derive(Clone, Debug)]
pub struct RunSettings {
    /// The sizes.
    pub profile: Profile,
    /// This many levels from the coarsest, instead of the profile's own number.
    pub levels: Option<usize>,
    /// A method in place of the study's own, with the study's other settings.
    pub solver: Option<Method>,
    /// Where unfinished cases keep their finished levels; nothing is kept without it.
    pub partial: Option<PathBuf>,
}

/// Who is told how far a run has come.
pub trait Watch: Sync {
    /// A level, or the reference, is done.
    fn level_done(&self, _study: &str, _case: &str, _level: usize) {}
}

/// Nobody is told.
pub struct Unwatched;

impl Watch for Unwatched {}

/// A record and, apart from it, the times of its levels.
pub struct CaseRun {
    /// The result.
    pub record: StudyRecord,
    /// One entry per level.
    pub times: Vec<LevelTimes>,
    /// The reference solve.
    pub reference_times: Option<LevelTimes>,
}

/// Runs every case of a study.
///
/// # Errors
/// The first case, in file order, whose input is meaningless.
pub fn run_study(study: &Study, settings: &RunSettings, watch: &dyn Watch) -> Result<Vec<CaseRun>, RunError> {
    let runs: Vec<_> = study.cases.par_iter().map(|case| run_case(study, case, settings, watch)).collect();
    runs.into_iter().collect()
}

/// Runs one case.
///
/// # Errors
/// Meaningless input: an exact solution that breaks its contact conditions, a load without equilibrium, …
pub fn run_case(study: &Study, case: &Case, settings: &RunSettings, watch: &dyn Watch) -> Result<CaseRun, RunError> {
    verify_exact(case)?;
    let cells = cells_of(case, settings);
    let task = Task { case, cells, settings: solver_settings(case, settings) };
    let partial = Partial::open(study, case, settings, &task)?;
    let overkill = solve_reference(&task, settings)?;
    if overkill.is_some() {
        watch.level_done(&study.id, &case.name, cells.len());
    }
    let measure = |index: usize| {
        let measured = partial.level(index, || measure_level(&task, overkill.as_ref().map(|(o, _)| o), index));
        watch.level_done(&study.id, &case.name, index);
        measured
    };
    let measured: Result<Vec<_>, RunError> =
        (0..cells.len()).into_par_iter().map(measure).collect::<Vec<_>>().into_iter().collect();
    let (levels, times): (Vec<Level>, Vec<LevelTimes>) = measured?.into_iter().unzip();
    let reference = reference::describe(case, overkill.as_ref().map(|(o, _)| o), &task);
    let record = conclude(study, case, settings, levels, reference);
    partial.close();
    Ok(CaseRun { record, times, reference_times: overkill.map(|(_, t)| t) })
}

/// How many times [`Watch::level_done`] will be called for a study: its levels, and one for each reference.
pub fn work(study: &Study, settings: &RunSettings) -> usize {
    let of = |case: &Case| {
        cells_of(case, settings).len() + usize::from(matches!(case.reference, ReferencePlan::Overkill { .. }))
    };
    study.cases.iter().map(of).sum()
}

/// The mesh parameters of a case under these settings, coarsest first.
fn cells_of<'a>(case: &'a Case, settings: &RunSettings) -> &'a [usize] {
    let all = if settings.profile == Profile::Quick { &case.quick } else { &case.full };
    &all[..settings.levels.unwrap_or(all.len()).min(all.len())]
}

/// The study's solver settings, with the run's method if it names one.
fn solver_settings(case: &Case, settings: &RunSettings) -> Settings {
    Settings { method: settings.solver.unwrap_or(case.solver.method), ..case.solver }
}

/// Pointwise verification of the exact solution, before any mesh. A solution built for other materials is a planted
/// defect and is verified in its own.
fn verify_exact(case: &Case) -> Result<(), RunError> {
    let Some(exact) = &case.scene.exact else {
        return if case.reference == ReferencePlan::Exact {
            Err(RunError::Study(format!(
                "case '{}' measures against an exact solution, but its scene has none; add [exact] or set reference = \"overkill\"",
                case.name
            )))
        } else {
            Ok(())
        };
    };
    verify::verify(exact.solution.as_ref(), &exact.materials, &case.scene.contact)
        .map(|_| ())
        .map_err(|e| RunError::Exact(e.to_string()))
}

fn solve_reference(task: &Task, settings: &RunSettings) -> Result<Option<(Overkill, LevelTimes)>, RunError> {
    let ReferencePlan::Overkill { quick, full } = task.case.reference else { return Ok(None) };
    let cells = if settings.profile == Profile::Quick { quick } else { full };
    task.overkill(cells).map(Some)
}

fn measure_level(task: &Task, overkill: Option<&Overkill>, index: usize) -> Result<(Level, LevelTimes), RunError> {
    match (&task.case.reference, overkill, &task.case.scene.exact) {
        (ReferencePlan::Exact, _, Some(exact)) => task.against_exact(exact, index),
        (ReferencePlan::Overkill { .. }, Some(reference), _) => {
            let at = reference::place_in_hierarchy(task, reference, index)?;
            task.against_overkill(reference, at, index)
        }
        _ => task.without_reference(index),
    }
}

/// Contamination, exclusion, rates and verdict: everything that needs all levels together.
fn conclude(
    study: &Study,
    case: &Case,
    settings: &RunSettings,
    mut levels: Vec<Level>,
    mut reference: Reference,
) -> StudyRecord {
    let claim = &study.claim;
    reference::contaminate(&mut levels, &mut reference);
    verdict::exclude_levels(&mut levels, &case.gates);
    let rates = rate::all(&levels, &claim.norm);
    let verdict = verdict::judge(&JudgeInput {
        kind: claim.kind,
        norm: &claim.norm,
        levels: &levels,
        bounds: &case.bounds,
        gates: &case.gates,
        expected_is_asymptotic: case.expected_is_asymptotic,
    });
    let notes = notes(case, &levels);
    let quick = settings.profile == Profile::Quick;
    StudyRecord {
        schema: SCHEMA,
        study: study.id.clone(),
        case: case.name.clone(),
        several: study.cases.len() > 1,
        title: study.title.clone(),
        question: study.question.clone(),
        setup: study.setup.clone(),
        refuted_by: study.refuted_by.clone(),
        parameters: case.parameters.clone(),
        claim: claim.id.clone(),
        statement: claim.statement.clone(),
        kind: claim.kind,
        norm: claim.norm.clone(),
        family: case.family.name().to_owned(),
        reference,
        profile: profile_name(settings).to_owned(),
        seed: case.family.seed(),
        levels,
        rates,
        bounds: case.bounds.clone(),
        verdict,
        expect: case.expect,
        expected_inconclusive: case.inconclusive_at_quick.clone().filter(|_| quick),
        notes,
    }
}

/// The case's own remarks and the warnings of its levels, repeated ones once.
fn notes(case: &Case, levels: &[Level]) -> Vec<String> {
    let warnings = levels.iter().flat_map(|l| l.warnings.iter().cloned());
    let mut notes: Vec<String> = case.notes.iter().cloned().chain(warnings).collect();
    notes.dedup();
    notes
}

fn profile_name(settings: &RunSettings) -> &'static str {
    match (settings.levels, settings.profile) {
        (Some(_), _) => "custom",
        (None, Profile::Quick) => "quick",
        (None, Profile::Full) => "full",
    }
}
