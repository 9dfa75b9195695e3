//! Cases that are to be refused: scenes without equilibrium.

use super::{CaseRun, Profile, RunSettings, cells_of, conclude, level_without_solve};
use crate::error::RunError;
use crate::record::{Outcome, Reference, Refusal, Verdict};
use crate::run::partial::Partial;
use crate::study::{Case, Scene, Study};
use signorini_contact::Error;

/// Tries every level up to the solve. The case passes if each of them is refused because there is no equilibrium.
///
/// # Errors
/// Whatever else is wrong with the scene: a case that is refused for another reason says nothing.
pub fn run_refused(study: &Study, case: &Case, scene: &Scene, settings: &RunSettings) -> Result<CaseRun, RunError> {
    let refusal = refusal(case, scene, cells_of(case, settings))?;
    let mut record = conclude(study, case, settings, Vec::new(), Reference::None, None)?;
    record.verdict = judge(&refusal);
    record.refusal = Some(refusal);
    Ok(CaseRun { record, times: Vec::new(), reference_times: None, fields: Vec::new(), kept: Partial::none() })
}

/// What [`check_case`](super::check_case) is for a case that is to be refused; `None` for any other.
///
/// # Errors
/// As [`run_case`](super::run_case).
pub fn check_refusal(case: &Case, profile: Profile) -> Result<Option<Refusal>, RunError> {
    let cells = if profile == Profile::Quick { &case.quick } else { &case.full };
    case.scene().filter(|_| case.refused).map(|scene| refusal(case, scene, cells)).transpose()
}

/// What the program says of the levels with these mesh parameters.
fn refusal(case: &Case, scene: &Scene, cells: &[usize]) -> Result<Refusal, RunError> {
    let mut refusal = Refusal { message: None, levels: cells.len(), refused: 0 };
    for index in 0..cells.len() {
        match level_without_solve(case, scene, cells, index) {
            Ok(_) => {}
            Err(RunError::Contact(Error::Solvability(message))) => {
                refusal.refused += 1;
                refusal.message.get_or_insert(message);
            }
            Err(other) => return Err(other),
        }
    }
    Ok(refusal)
}

fn judge(refusal: &Refusal) -> Verdict {
    let Refusal { message, levels, refused } = refusal;
    match message {
        Some(message) if refused == levels => {
            let reason = format!("refused on every level, as it should be: {message}");
            Verdict { outcome: Outcome::Pass, reasons: vec![reason] }
        }
        _ => {
            let reason = format!("it was to be refused, and {} of {levels} levels were accepted", levels - refused);
            Verdict { outcome: Outcome::Fail, reasons: vec![reason] }
        }
    }
}
