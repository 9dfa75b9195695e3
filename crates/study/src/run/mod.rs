//! From a study to its records: every level of every case solved, measured, fitted and judged.
//!
//! Levels and cases are independent of one another, so they run side by side; the results are put together in the
//! order of the file, so the records do not depend on the number of threads.

mod alone;
mod check;
pub(crate) mod contact;
mod contact_width;
mod corners;
#[cfg(test)]
mod hard_tests;
mod level;
mod overlay;
mod partial;
mod processor;
mod profile;
mod reference;
mod refusal;
mod refused;
mod schedule;
mod settings;
mod slide;
mod solver;
mod step;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tied;
pub mod timing;
#[cfg(test)]
mod twins;
mod zone_ledger;

use crate::error::RunError;
use crate::exact::verify;
use crate::extrapolation;
use crate::fields::Fields;
use crate::lemma::Lemma;
use crate::rate;
use crate::record::{Level, Reference, SCHEMA, StudyRecord, ZoneProfile};
use crate::reference::overkill::Overkill;
use crate::study::{Case, ReferencePlan, Scene, Study, Subject};
use crate::verdict::{self, JudgeInput};
pub use alone::{Alone, Constraints};
use check::check_level as level_without_solve;
pub use check::{CheckedLevel, check_case, check_corners};
use corners::corners_of;
use level::Task;
use partial::Partial;
pub use partial::tidy;
use rayon::prelude::*;
pub use refusal::check_refusal;
pub use schedule::each_case;
pub use settings::{Profile, RunSettings};
use settings::{cells_of, profile_name, reference_cells, solver_settings};
pub use signorini_contact::solver::Method;
pub use solver::Solver;
pub use step::{Step, work};
use step::{Steps, stepped};
use timing::{LevelTimes, Stopwatch};

/// Who is told how far a run has come, and may stop it.
pub trait Watch: Sync {
    /// A level, or the reference, is begun.
    fn begun(&self, _step: &Step<'_>) {}

    /// It is done.
    fn done(&self, _step: &Step<'_>) {}

    /// Whether the run is to stop: asked before each step. Steps that have begun are finished and kept.
    fn stops(&self) -> bool {
        false
    }
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
    /// The fields of the levels that keep theirs, coarsest first.
    pub fields: Vec<Fields>,
    kept: Partial,
}

impl CaseRun {
    /// The record is on disk: the levels kept for a resumption may go.
    pub fn is_written(&self) {
        self.kept.discard();
    }
}

/// Runs one case.
///
/// # Errors
/// Meaningless input: an exact solution that breaks its contact conditions, a load without equilibrium, …
pub fn run_case(study: &Study, case: &Case, settings: &RunSettings, watch: &dyn Watch) -> Result<CaseRun, RunError> {
    match &case.subject {
        Subject::Contact(scene) if case.refused => refusal::run_refused(study, case, scene, settings),
        Subject::Contact(scene) => run_contact(study, case, scene, settings, watch),
        Subject::Lemma(lemma) => run_lemma(study, case, lemma, settings, watch),
    }
}

/// Measures a lemma on every level.
fn run_lemma(
    study: &Study,
    case: &Case,
    lemma: &Lemma,
    settings: &RunSettings,
    watch: &dyn Watch,
) -> Result<CaseRun, RunError> {
    let cells = cells_of(case, settings);
    let steps = Steps::of(study, case, settings);
    let measure = |index: usize| {
        stepped(watch, &steps.level(index), || {
            let mut clock = Stopwatch::start();
            let level = lemma.measure(cells, index)?;
            clock.lap(|t| &mut t.error);
            Ok((level, clock.finish()))
        })
    };
    let (levels, times) = side_by_side(cells.len(), measure)?;
    let reference = if case.reference == ReferencePlan::Exact { Reference::Exact } else { Reference::None };
    let record = conclude(study, case, settings, levels, reference, None)?;
    Ok(CaseRun { record, times, reference_times: None, fields: Vec::new(), kept: Partial::none() })
}

/// Measures all levels, each by itself; the first error in their order.
fn side_by_side(
    levels: usize,
    measure: impl Fn(usize) -> Result<(Level, LevelTimes), RunError> + Sync + Send,
) -> Result<(Vec<Level>, Vec<LevelTimes>), RunError> {
    let measured: Result<Vec<_>, RunError> =
        (0..levels).into_par_iter().map(measure).collect::<Vec<_>>().into_iter().collect();
    Ok(measured?.into_iter().unzip())
}

fn run_contact(
    study: &Study,
    case: &Case,
    scene: &Scene,
    settings: &RunSettings,
    watch: &dyn Watch,
) -> Result<CaseRun, RunError> {
    verify_exact(case, scene)?;
    slide::verify(scene, &study.claim.norm)?;
    let cells = cells_of(case, settings);
    let external = match &settings.solver {
        Some(Solver::External(external)) => Some(external.for_case(&study.id, &case.name)),
        _ => None,
    };
    let task = Task {
        keep: settings.keep.clone(),
        external,
        ..Task::new(case, scene, cells, solver_settings(case, settings))
    };
    // what another program answers may have changed with the program
    let keeps = task.external.is_none();
    let partial = if keeps { Partial::open(study, case, settings, &task)? } else { Partial::none() };
    let steps = Steps::of(study, case, settings);
    let overkill = solve_reference(&task, settings, watch, &steps)?;
    let measure = |index: usize| {
        let measured = || measure_level(&task, overkill.as_ref().map(|(o, _)| o), index);
        stepped(watch, &steps.level(index), || partial.level(index, measured))
    };
    let measured: Vec<_> = (0..cells.len()).into_par_iter().map(measure).collect();
    let refused::Parted { solved, refused } = refused::part(measured, cells)?;
    let (mut levels, times): (Vec<Level>, Vec<LevelTimes>) = solved.into_iter().unzip();
    let fields = levels.iter_mut().filter_map(|level| level.fields.take()).map(|f| *f).collect();
    let fields = settings.keep.finally(fields);
    let reference = reference::describe(case, overkill.as_ref().map(|(o, _)| o));
    let zone = overkill.as_ref().and_then(|(o, _)| reference::zone(scene, o));
    let mut record = conclude(study, case, settings, levels, reference, zone)?;
    record.verdict = refused::doubted(record.verdict, &refused);
    record.notes.extend(refused.into_iter().chain(level::bilateral::note(&record.levels)));
    Ok(CaseRun { record, times, reference_times: overkill.map(|(_, t)| t), fields, kept: partial })
}

/// Pointwise verification of the exact solution, before any mesh. A solution built for other materials is a planted
/// defect and is verified in its own.
fn verify_exact(case: &Case, scene: &Scene) -> Result<(), RunError> {
    let Some(exact) = &scene.exact else {
        return if case.reference == ReferencePlan::Exact {
            Err(RunError::Study(format!(
                "case '{}' measures against an exact solution, but its scene has none; add [exact] or set reference = \"overkill\"",
                case.name
            )))
        } else {
            Ok(())
        };
    };
    verify::verify_tied(exact.solution.as_ref(), &exact.materials, &scene.contact, &scene.bilateral)
        .map(|_| ())
        .map_err(|e| RunError::Exact(e.to_string()))
}

fn solve_reference(
    task: &Task,
    settings: &RunSettings,
    watch: &dyn Watch,
    steps: &Steps,
) -> Result<Option<(Overkill, LevelTimes)>, RunError> {
    let Some(cells) = reference_cells(task.case, settings) else { return Ok(None) };
    stepped(watch, &steps.reference(cells), || task.overkill(cells)).map(Some)
}

fn measure_level(task: &Task, overkill: Option<&Overkill>, index: usize) -> Result<(Level, LevelTimes), RunError> {
    match (&task.case.reference, overkill, &task.scene.exact) {
        (ReferencePlan::Exact, _, Some(exact)) => task.against_exact(exact, index),
        (ReferencePlan::Overkill { .. }, Some(reference), _) => {
            let nested = task.scene.domain().nests(&task.case.family);
            let at = nested.then(|| reference::place_in_hierarchy(task, reference, index)).transpose()?;
            task.against_overkill(reference, at, index)
        }
        _ => task.without_reference(index),
    }
}

/// Contamination, exclusion, rates and verdict: everything that needs all levels together. `of_reference` is the contact zone of a
/// discrete reference.
fn conclude(
    study: &Study,
    case: &Case,
    settings: &RunSettings,
    mut levels: Vec<Level>,
    mut reference: Reference,
    of_reference: Option<ZoneProfile>,
) -> Result<StudyRecord, RunError> {
    let claim = &study.claim;
    if !case.projects {
        reference::contaminate(&mut levels, &mut reference);
    }
    let zone = levels.last_mut().and_then(|level| level.contact.as_mut()?.profile.take());
    verdict::exclude_levels(&mut levels, &case.gates);
    let mut rates = rate::all(&levels, &claim.norm);
    if let Some(rate) = rates.get_mut(&claim.norm).filter(|_| case.borderline) {
        rate.log_alternatives = rate::log_alternatives(&levels, &claim.norm, rate);
    }
    let corners = corners_of(case, cells_of(case, settings), of_reference.as_ref().or(zone.as_ref()))?;
    let bounds = corners::bounds(case, &corners);
    let verdict = verdict::judge(&JudgeInput {
        kind: claim.kind,
        norm: &claim.norm,
        levels: &levels,
        bounds: &bounds,
        gates: &case.gates,
        expected_is_asymptotic: case.expected_is_asymptotic,
    });
    let extrapolation = extrapolation::of(&levels);
    let notes = notes(case, &levels);
    let quick = settings.profile == Profile::Quick;
    Ok(StudyRecord {
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
        hypotheses: claim.hypotheses.clone(),
        kind: claim.kind,
        norm: claim.norm.clone(),
        family: case.family_name().to_owned(),
        reference,
        profile: profile_name(settings).to_owned(),
        seed: case.seed(),
        levels,
        rates,
        bounds,
        verdict,
        expect: case.expect,
        expected_inconclusive: case.inconclusive_at_quick.clone().filter(|_| quick),
        notes,
        zone,
        corners,
        extrapolation,
        refusal: None,
        changed: case.changed.clone(),
    })
}

/// The case's own remarks and the warnings of its levels, repeated ones once.
fn notes(case: &Case, levels: &[Level]) -> Vec<String> {
    let warnings = levels.iter().flat_map(|l| l.warnings.iter().cloned());
    let mut notes: Vec<String> = case.notes.iter().cloned().chain(warnings).collect();
    notes.dedup();
    notes
}
