//! Reasons not to judge at all: broken numbers, unfinished solves, broken budgets, unrefined meshes.
//!
//! A reference that comes too close to the measured error takes its level out of the fit and no more: that happens to
//! the finest levels of every overkill study. An algebraic, quadrature or geometry error above its share is our own
//! fault, and then the other levels are not to be trusted either.

use super::{JudgeInput, exclude};
use crate::finite;
use crate::record::{Level, RecordError};
use crate::study::Gates;

/// Largest scaled penetration, tension and complementarity of a finished solve.
const CERTIFICATE: f64 = 1e-6;

/// Rounding in `two_way`, relative to `‖u‖²_A / A(e,e)` where that exceeds 1: the energies whose difference is `A(e,e)`
/// carry the rounding of their assembly.
const TWO_WAY_ROUNDING: f64 = 1e-11;

/// Every reason, level by level.
pub fn all(input: &JudgeInput) -> Vec<String> {
    if input.levels.is_empty() {
        return vec!["no levels were measured".into()];
    }
    let levels = input.levels.iter().flat_map(|l| of_level(l, input.gates));
    levels.chain(unrefined(input.levels)).collect()
}

fn of_level(level: &Level, gates: &Gates) -> Vec<String> {
    if let Some(number) = broken_number(level) {
        return vec![number];
    }
    [unfinished(level), uncertified(level), broken_budget(level, gates), two_way(level)].into_iter().flatten().collect()
}

pub(super) fn broken_number(level: &Level) -> Option<String> {
    match finite::check(level) {
        Err(RecordError::NonFinite { path, value }) => Some(format!("level {}: {path} is {value}", level.level)),
        _ => None,
    }
}

pub(super) fn unfinished(level: &Level) -> Option<String> {
    let solver = &level.solver;
    (!solver.solved).then(|| {
        let steps = solver.iterations;
        format!("level {}: {} did not finish ({} after {steps} iterations)", level.level, solver.name, solver.status)
    })
}

/// The certificate is recomputed from the raw data; a solver's own word is not enough.
fn uncertified(level: &Level) -> Option<String> {
    let k = &level.kkt;
    let parts = [("penetration", k.penetration), ("tension", k.tension), ("complementarity", k.complementarity)];
    let (part, value) = parts.into_iter().find(|(_, value)| *value > CERTIFICATE)?;
    level.solver.solved.then(|| {
        format!("level {}: scaled {part} {value:.1e}, a finished solve has at most {CERTIFICATE:.0e}", level.level)
    })
}

fn broken_budget(level: &Level, gates: &Gates) -> Option<String> {
    let (part, share) = exclude::broken_parts(level, gates).find(|(part, _)| *part != "reference")?;
    Some(format!("level {}: {}", level.level, exclude::over_budget(part, share, gates)))
}

/// `A(e,e)` by quadrature and by energies must agree to twice the shares of quadrature and algebra in its root. A share
/// that nobody measured counts as zero.
fn two_way(level: &Level) -> Option<String> {
    let difference = level.two_way?;
    let budget = level.budget.quadrature.unwrap_or(0.0) + level.budget.algebraic.unwrap_or(0.0);
    let allowed = 2.0 * budget + TWO_WAY_ROUNDING * energy_ratio(level).max(1.0);
    (difference.abs() > allowed).then(|| {
        format!(
            "level {}: A(e,e) by quadrature and by energies differ by {difference:.1e} (allowed {allowed:.1e})",
            level.level
        )
    })
}

/// `‖u‖²_A / A(e,e)`; `‖u‖²_A = −2 L(u)` where only the energy is known.
fn energy_ratio(level: &Level) -> f64 {
    let size = level.solution_energy.map_or(2.0 * level.energy.abs(), |norm| norm * norm);
    // a zero error leaves nothing to compare: NaN and ∞ are turned into "anything goes"
    level.errors.energy.map_or(1.0, |e| if e > 0.0 { size / (e * e) } else { f64::INFINITY })
}

/// Meshes that occur twice, and mesh sizes that do not fall.
pub(super) fn unrefined(levels: &[Level]) -> Vec<String> {
    let mut found = Vec::new();
    for (k, fine) in levels.iter().enumerate().skip(1) {
        if let Some(same) = levels[..k].iter().find(|l| l.mesh_hash == fine.mesh_hash) {
            found.push(format!("levels {} and {} have the same mesh ({})", same.level, fine.level, fine.mesh_hash));
        } else if fine.h >= levels[k - 1].h {
            let before = &levels[k - 1];
            found.push(format!("level {}: h = {:.4e} after {:.4e}: no refinement", fine.level, fine.h, before.h));
        }
    }
    found
}
