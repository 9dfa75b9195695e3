//! What the command line asks of a run, and what that means for a case.

use super::Solver;
use crate::fields::Keep;
use crate::study::{Case, ReferencePlan};
use signorini_contact::solver::Settings;
use std::path::PathBuf;

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
    /// A solver in place of the study's own, with the study's other settings.
    pub solver: Option<Solver>,
    /// Where unfinished cases keep their finished levels; nothing is kept without it.
    pub partial: Option<PathBuf>,
    /// Which levels keep their fields.
    pub keep: Keep,
}

/// The mesh parameters of a case under these settings, coarsest first.
pub(super) fn cells_of<'a>(case: &'a Case, settings: &RunSettings) -> &'a [usize] {
    let all = if settings.profile == Profile::Quick { &case.quick } else { &case.full };
    &all[..settings.levels.unwrap_or(all.len()).min(all.len())]
}

/// The study's solver settings, with the run's method if it names one.
pub(super) fn solver_settings(case: &Case, settings: &RunSettings) -> Settings {
    Settings { method: settings.solver.as_ref().and_then(Solver::own).unwrap_or(case.solver.method), ..case.solver }
}

/// The mesh parameter of a case's overkill reference.
pub(super) fn reference_cells(case: &Case, settings: &RunSettings) -> Option<usize> {
    match case.reference {
        ReferencePlan::Overkill { quick, full } => Some(if settings.profile == Profile::Quick { quick } else { full }),
        _ => None,
    }
}

pub(super) fn profile_name(settings: &RunSettings) -> &'static str {
    match (settings.levels, settings.profile) {
        (Some(_), _) => "custom",
        (None, Profile::Quick) => "quick",
        (None, Profile::Full) => "full",
    }
}
