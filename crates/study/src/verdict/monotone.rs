//! Energies on nested sets of admissible displacements cannot rise: `K_{2h} ⊂ K_h` gives `L(u_h) ≤ L(u_{2h})`.

use super::inconclusive;
use crate::record::{Level, Outcome, Verdict};

/// Rounding of an energy, relative to `A(u,u)`.
const ROUNDING: f64 = 1e-10;

/// Levels whose energy exceeds that of the level before by more than rounding and the quadrature of the loads can.
pub fn rising_energies(levels: &[Level]) -> Vec<String> {
    let rises = |pair: &&[Level]| {
        let (coarse, fine) = (&pair[0], &pair[1]);
        fine.nested && fine.energy - coarse.energy > allowance(coarse) + allowance(fine)
    };
    let words = |pair: &[Level]| {
        let (level, rise) = (pair[1].level, pair[1].energy - pair[0].energy);
        format!("level {level}: the energy rises by {rise:.1e} on a nested mesh, where it can only fall")
    };
    levels.windows(2).filter(rises).map(words).collect()
}

/// `1e-10 A(u,u) + 2 q √A(u,u)` with the error `q` of the loads in the dual energy norm.
fn allowance(level: &Level) -> f64 {
    let size = level.solution_energy.unwrap_or(0.0);
    let loads = level.budget.quadrature.zip(level.errors.energy).map_or(0.0, |(share, e)| share * e);
    ROUNDING * size * size + 2.0 * loads * size
}

/// The verdict, unless there are doubts that turn it inconclusive.
pub fn with_doubts(verdict: Verdict, doubts: Vec<String>) -> Verdict {
    if doubts.is_empty() || verdict.outcome != Outcome::Pass {
        return verdict;
    }
    inconclusive(doubts.into_iter().chain(verdict.reasons).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn levels(rise: f64) -> Vec<Level> {
        let mut levels = sample::levels(4, |h| h);
        levels.iter_mut().for_each(|l| l.energy = -0.5 + 0.5 * l.h * l.h);
        levels[2].energy = levels[1].energy + rise;
        levels
    }

    #[test]
    fn a_rise_on_nested_meshes_is_doubted_and_rounding_is_not() {
        let pass = || Verdict { outcome: Outcome::Pass, reasons: vec!["fine".into()] };
        let doubts = rising_energies(&levels(1e-3));
        assert!(doubts.len() == 1 && doubts[0].contains("level 2"), "{doubts:?}");
        assert_eq!(with_doubts(pass(), doubts).outcome, Outcome::Inconclusive);
        assert!(rising_energies(&levels(1e-11)).is_empty());
        assert_eq!(with_doubts(pass(), Vec::new()), pass());
        let mut fresh = levels(1e-3);
        fresh.iter_mut().for_each(|l| l.nested = false);
        assert!(rising_energies(&fresh).is_empty());
    }
}
