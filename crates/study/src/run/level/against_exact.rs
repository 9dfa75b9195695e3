//! A solved level against the exact solution: errors, ledger and budget.

use super::defects::geometry_error;
use super::parts::{differences, dual_norm, ledger, relative_difference, set_errors, share};
use super::{Solved, Task, algebraic_error, residual_work};
use crate::record::{Budget, Ledger, Level};
use crate::reference::exact::{ErrorSquares, Integrals, Pair};
use crate::run::contact::ContactErrors;
use crate::run::zone_ledger::ZoneLedger;
use crate::study::ExactScene;
use signorini_contact::Vec2;
use signorini_contact::mesh::Mesh;
use signorini_contact::quadrature::Cubature;

/// Everything that turns a solved level into errors against the exact solution.
pub(super) struct ExactMeasurement<'a> {
    pub task: &'a Task<'a>,
    pub mesh: &'a Mesh,
    pub pair: &'a Pair,
    pub exact: &'a ExactScene,
    pub cubature: &'a Cubature,
    pub interpolant: &'a [Vec2],
    pub solved: &'a Solved,
}

impl ExactMeasurement<'_> {
    /// Fills the level in and gives `A(e,e)` by the two quadratures.
    pub fn fill(&self, level: &mut Level, contact: &ContactErrors) -> [f64; 2] {
        let materials = &self.task.scene.materials;
        let (discrete, solution) = (&self.solved.discrete, &self.solved.solution);
        let d = differences(self.interpolant, &solution.displacement);
        let Pair { base: by_base, fine: by_fine, .. } = self.pair;
        let ErrorSquares { fine, base_energy } = self.pair.error(self.mesh, materials, &d);
        set_errors(
            &mut level.errors,
            &fine,
            contact,
            by_fine.interpolation.energy_norm(),
            solution.energy - by_fine.energy,
        );
        level.switch_sides = Some(contact.switch_sides);
        let (load, solution_squares) = (differences(&by_fine.load, &by_base.load), &by_fine.solution);
        let [by_base, by_fine] = [by_base, by_fine].map(|i| self.error_from_energies(i));
        level.two_way = relative_difference(fine.energy, by_fine, solution_squares.energy);
        let (e, size) = (fine.energy_norm(), solution_squares.energy_norm());
        let load_change = dual_norm(discrete, &load);
        let energy_change = (by_fine - by_base).abs() / (2.0 * e.max(f64::MIN_POSITIVE));
        level.budget = Budget {
            algebraic: share(algebraic_error(discrete, solution), e, size),
            quadrature: share(load_change + energy_change + (e - base_energy.sqrt()).abs(), e, size),
            geometry: share(geometry_error(self.exact, materials, &self.task.scene.contact, self.mesh), e, size),
            reference: Some(0.0),
            unresolved: None,
        };
        level.ledger = Some(self.ledger(base_energy, fine.energy));
        [base_energy, fine.energy]
    }

    /// `A(e,e) = 2(L(u_h) − L(u)) − 2∫_{Γ_K} T_n [u_h]_n ds − 2∫_{Γ_u} τ(u)n·(u_h − u) ds`.
    fn error_from_energies(&self, with: &Integrals) -> f64 {
        let u = &self.solved.solution.displacement;
        let work: f64 = with.load.iter().zip(u).map(|(f, u)| f.dot(u)).sum();
        let energy = 0.5 * self.solved.solution.strain_energy - work;
        2.0 * (energy - with.energy) - 2.0 * with.contact_work(u) - 2.0 * with.reaction_work(u)
    }

    /// `½A(e,e) ≤ a + b + c` with `a = ½A(u−u_I, u−u_I)`, `b = ∫ T ([u_I]_n − ε) dμ`; `c` and the parts depend on the zone.
    fn ledger(&self, base_energy: f64, fine_energy: f64) -> Ledger {
        let Pair { base, fine, .. } = self.pair;
        let [b_base, b] = [base, fine].map(|i| i.contact_work(self.interpolant));
        let [a_base, a] = [base, fine].map(|i| 0.5 * i.interpolation.energy);
        let zone =
            ZoneLedger::new(self.exact, self.mesh, self.interpolant, &self.solved.solution.displacement, self.cubature);
        let change = 0.5 * (fine_energy - base_energy).abs() + (a - a_base).abs() + (b - b_base).abs();
        let left = residual_work(&self.solved.discrete, &self.solved.solution, self.interpolant);
        let ledger = ledger(0.5 * fine_energy, [a, b, zone.c], change + left + zone.delta, fine.solution.energy);
        Ledger { parts: zone.parts, ..ledger }
    }
}
