//! A solve that can be trusted: it ends, its certificate is clean, another solver agrees, and on nested meshes the energy falls.
//!
//! What a backward stable solve leaves grows with the number of unknowns, and what rounding of the data alone does to the
//! energy with the cancellation in it. The bounds grow with them, and with nothing else:
//!
//! | residual | bound |
//! | --- | --- |
//! | stationarity | `1e-15 · dofs`, at least 1e-13 |
//! | stationarity row by row | 1e-11: refinement brings it to rounding, unless the condition leaves no digits for it |
//! | penetration, tension, complementarity | `1e-12` |
//! | `|L(u₁) − L(u₂)| / ½A(u,u)` | `δ = 1e-10 + 100 · 2^{-53} · cancellation` |
//! | constraints that press in one answer and are open in the other | 0 |
//! | rise of the energy on a nested mesh over `½A(u,u)` | `δ`, and twice the share of the quadrature |

use super::{JudgeInput, doubt, fail, inconclusive, pass};
use crate::record::{Level, SecondOpinion, Verdict};

/// Stationarity per unknown.
const STATIONARITY: f64 = 1e-15;
/// Stationarity row by row.
const ROW_BY_ROW: f64 = 1e-11;
/// Stationarity of the smallest problems.
const LEAST_STATIONARITY: f64 = 1e-13;
/// Penetration, tension and complementarity.
const RESIDUAL: f64 = 1e-12;
/// Difference of two energies without cancellation.
const ENERGY: f64 = 1e-10;
/// Units of roundoff per unit of cancellation.
const ROUNDOFFS: f64 = 100.0;

/// Rule of the kind `certificate`. An unfinished solve refutes the claim, a missing second opinion leaves it open.
pub(super) fn judge(input: &JudgeInput) -> Verdict {
    if input.levels.is_empty() {
        return inconclusive(vec!["no levels were measured".into()]);
    }
    let mut failures: Vec<String> = input.levels.iter().flat_map(of_level).collect();
    failures.extend(input.levels.windows(2).filter_map(|w| rise([&w[0], &w[1]])));
    if !failures.is_empty() {
        return fail(failures);
    }
    let mut doubts = doubt::unrefined(input.levels);
    let alone = input.levels.iter().filter(|l| l.second.is_none());
    doubts.extend(alone.map(|l| format!("level {}: nobody else was asked", l.level)));
    if !doubts.is_empty() {
        return inconclusive(doubts);
    }
    pass(vec![words(input.levels)])
}

/// Everything wrong with one level.
fn of_level(level: &Level) -> Vec<String> {
    let unusable = doubt::broken_number(level).or_else(|| doubt::unfinished(level));
    if let Some(reason) = unusable {
        return vec![reason];
    }
    let mut found = residuals(level);
    found.extend(level.second.iter().flat_map(|s| disagreement(level.level, s)));
    found
}

fn residuals(level: &Level) -> Vec<String> {
    let k = &level.kkt;
    let stationarity = f64::max(LEAST_STATIONARITY, STATIONARITY * level.dofs as f64);
    let bounds = [
        ("stationarity", k.stationarity, stationarity),
        ("stationarity row by row", k.componentwise.unwrap_or(0.0), ROW_BY_ROW),
        ("penetration", k.penetration, RESIDUAL),
        ("tension", k.tension, RESIDUAL),
        ("complementarity", k.complementarity, RESIDUAL),
    ];
    let broken = bounds.into_iter().filter(|(_, value, bound)| value > bound);
    broken
        .map(|(part, value, bound)| {
            format!("level {}: scaled {part} {value:.1e}, a finished solve has at most {bound:.1e}", level.level)
        })
        .collect()
}

fn disagreement(level: usize, second: &SecondOpinion) -> Vec<String> {
    let name = &second.name;
    if !second.solved {
        return vec![format!("level {level}: {name}, asked second, did not finish ({})", second.status)];
    }
    let mut found = Vec::new();
    let allowed = tolerance(second);
    if second.energy_difference > allowed {
        let difference = second.energy_difference;
        found.push(format!(
            "level {level}: the energy of {name} differs by {difference:.1e} of ½A(u,u), more than {allowed:.1e}"
        ));
    }
    if second.active_difference > 0 {
        let n = second.active_difference;
        found.push(format!("level {level}: {n} constraints press in one answer and are open in that of {name}"));
    }
    found
}

/// `δ`.
fn tolerance(second: &SecondOpinion) -> f64 {
    ENERGY + ROUNDOFFS * 0.5 * f64::EPSILON * second.cancellation
}

/// A nested level whose energy lies above the one before.
fn rise([coarse, fine]: [&Level; 2]) -> Option<String> {
    let next = fine.second.as_ref()?;
    let holds_the_coarse = fine.nested && coarse.inside == Some(true);
    if !(holds_the_coarse && coarse.solver.solved && fine.solver.solved) {
        return None;
    }
    let size = 0.5 * fine.solution_energy?.powi(2);
    let quadrature = fine.budget.quadrature.unwrap_or(0.0) * fine.errors.energy.unwrap_or(0.0) * fine.solution_energy?;
    let (rise, allowed) = (fine.energy - coarse.energy, tolerance(next) * size + 2.0 * quadrature);
    (rise > allowed).then(|| {
        format!(
            "level {}: the energy rises by {:.1e} of ½A(u,u), though the mesh refines the one before (allowed {:.1e})",
            fine.level,
            rise / size,
            allowed / size
        )
    })
}

/// What was found, in one sentence.
fn words(levels: &[Level]) -> String {
    let largest = |of: fn(&Level) -> f64| levels.iter().map(of).fold(0.0, f64::max);
    let second =
        |of: fn(&SecondOpinion) -> f64| levels.iter().filter_map(|l| l.second.as_ref()).map(of).fold(0.0, f64::max);
    let name = levels.iter().find_map(|l| l.second.as_ref()).map_or("", |s| s.name.as_str());
    format!(
        "solved on {} levels; stationarity at most {:.1e}, row by row {:.1e}; {name} agrees to {:.1e} in energy and {:.1e} in \
         displacement",
        levels.len(),
        largest(|l| l.kkt.stationarity),
        largest(|l| l.kkt.componentwise.unwrap_or(0.0)),
        second(|s| s.energy_difference),
        second(|s| s.displacement_difference),
    )
}
