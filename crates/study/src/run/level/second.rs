//! The second opinion: another solver on the same discrete problem.

use super::{Solved, Task, largest_component, prepared};
use crate::record::SecondOpinion;
use crate::study::Scene;
use signorini_contact::mesh::Hierarchy;
use signorini_contact::problem::{Discrete, Solution};
use signorini_contact::solver::Settings;
use signorini_contact::sparse::BlockMatrix;

/// A force below this share of the largest does not press, an opening below this share of the displacement is none.
const CLEAR: f64 = 1e-8;

impl Task<'_> {
    /// Asks the case's second solver, if it names one. The tolerances are those of a finished solve, whatever the first
    /// solver's were.
    pub(super) fn second_opinion(&self, hierarchy: &Hierarchy, solved: &Solved) -> Option<SecondOpinion> {
        let method = self.case.second?;
        let settings = Settings { method, max_steps: self.settings.max_steps, ..Settings::default() };
        Some(ask(&settings, self.scene, hierarchy, solved))
    }
}

fn ask(settings: &Settings, scene: &Scene, hierarchy: &Hierarchy, solved: &Solved) -> SecondOpinion {
    let (discrete, first) = (&solved.discrete, &solved.solution);
    let raw = prepared(settings.method, discrete, hierarchy, &scene.materials).solve(settings);
    let (status, is_solved, iterations) = (raw.status.to_string(), raw.status.is_solved(), raw.iterations);
    let second = discrete.recover(hierarchy.finest(), &scene.materials, raw);
    let size = largest_component(&first.displacement);
    let apart: Vec<_> = first.displacement.iter().zip(&second.displacement).map(|(a, b)| a - b).collect();
    SecondOpinion {
        name: settings.method.name().into(),
        status,
        solved: is_solved,
        iterations,
        energy_difference: relative((first.energy - second.energy).abs(), 0.5 * first.strain_energy),
        displacement_difference: relative(largest_component(&apart), size),
        active_difference: differently_active(discrete, [first, &second]),
        cancellation: relative(absolute_energy(&discrete.qp.matrix, &first.raw.x), first.strain_energy),
    }
}

/// 0 where both vanish, 1 where only the scale does.
fn relative(difference: f64, scale: f64) -> f64 {
    match scale > 0.0 {
        true => difference / scale,
        false => f64::from(u8::from(difference > 0.0)),
    }
}

/// Constraints that press in one answer and are open in the other, both clearly.
fn differently_active(discrete: &Discrete, answers: [&Solution; 2]) -> usize {
    let state = answers.map(|s| {
        let force = CLEAR * s.raw.multipliers.iter().fold(0.0, |m: f64, l| m.max(l.abs()));
        let opening = CLEAR * largest_component(&s.displacement);
        let at = |k: usize| {
            let bound = &discrete.qp.bounds[k];
            (s.raw.multipliers[k] > force, bound.upper - s.raw.x[bound.dof as usize] > opening)
        };
        (0..discrete.qp.bounds.len()).map(at).collect::<Vec<(bool, bool)>>()
    });
    let [first, second] = &state;
    first.iter().zip(second).filter(|(a, b)| (a.0 && b.1) || (b.0 && a.1)).count()
}

/// `Σ |x_i||K_ij||x_j|`.
fn absolute_energy(matrix: &BlockMatrix, x: &[f64]) -> f64 {
    let row = |i: usize| -> f64 {
        let sums = matrix.row(i).fold([0.0, 0.0], |s, (j, b)| {
            let (u, v) = (x[2 * j].abs(), x[2 * j + 1].abs());
            [s[0] + b[0].abs() * u + b[1].abs() * v, s[1] + b[2].abs() * u + b[3].abs() * v]
        });
        x[2 * i].abs() * sums[0] + x[2 * i + 1].abs() * sums[1]
    };
    (0..matrix.rows()).map(row).sum()
}
