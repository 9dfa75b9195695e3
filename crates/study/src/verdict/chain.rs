//! The chain of energies: where `K_h ⊂ K_{h/2} ⊂ K`, `L(u) ≤ L(u_{h/2}) ≤ L(u_h)`.
//!
//! Each discrete solution minimises over a larger set than the one before, so a rise beyond what quadrature, algebra and rounding
//! may do to an energy is an error somewhere: of the solver, of the loads, or of a discrete set that is no part of `K`.

use super::JudgeInput;
use crate::record::Level;

/// Rounding of an energy, as a share of `A(u,u)`.
const ROUNDING: f64 = 1e-12;

/// Levels on which the energy rises, or falls below that of the reference, as sentences.
pub(super) fn broken(input: &JudgeInput) -> Vec<String> {
    let usable: Vec<&Level> = input.usable().collect();
    let risen = usable.windows(2).filter_map(|pair| rise(pair[0], pair[1]));
    risen.chain(usable.iter().filter_map(|l| below_reference(l))).collect()
}

/// How many pairs of levels the chain was checked on.
pub(super) fn links(input: &JudgeInput) -> usize {
    let usable: Vec<&Level> = input.usable().collect();
    usable.windows(2).filter(|pair| is_link(pair[0], pair[1])).count()
}

fn is_link(coarse: &Level, fine: &Level) -> bool {
    // `nested` speaks of the level just before
    let follows = fine.nested && fine.level == coarse.level + 1;
    follows && [coarse, fine].iter().all(|l| l.inside == Some(true))
}

fn rise(coarse: &Level, fine: &Level) -> Option<String> {
    let rise = fine.energy - coarse.energy;
    (is_link(coarse, fine) && rise > tolerance(coarse) + tolerance(fine)).then(|| {
        format!("level {}: L(u_h) rises by {rise:.2e} above that of the level before, though K_2h ⊂ K_h", fine.level)
    })
}

/// A level with a ledger has a reference whose set holds its own.
fn below_reference(level: &Level) -> Option<String> {
    let gap = level.errors.energy_gap.filter(|_| level.inside == Some(true) && level.ledger.is_some())?;
    (gap < -tolerance(level))
        .then(|| format!("level {}: L(u_h) is {:.2e} below L(u), though K_h ⊂ K", level.level, -gap))
}

/// What an energy may be off by: rounding, and `2 e² ` times the shares of quadrature and algebra in the error `e`.
fn tolerance(level: &Level) -> f64 {
    let size = level.solution_energy.unwrap_or_else(|| (2.0 * level.energy.abs()).sqrt());
    let share = level.budget.quadrature.unwrap_or(0.0) + level.budget.algebraic.unwrap_or(0.0);
    let error = level.errors.energy.unwrap_or(0.0);
    ROUNDING * size * size + 2.0 * share * error * error
}
