//! A solved level against a discrete reference on a nested finer mesh: errors, ledger and budget.

use super::parts::{differences, dual_norm, ledger, relative_difference, set_errors, share};
use super::{Solved, Task, algebraic_error, residual_work};
use crate::record::{Budget, Level};
use crate::reference::overkill::Overkill;
use crate::run::contact::{self, ContactState};
use signorini_contact::Vec2;
use signorini_contact::mesh::Mesh;

impl Task<'_> {
    /// Fills the level in and gives `A(e,e)`.
    pub(super) fn fill_from_overkill(
        &self,
        level: &mut Level,
        reference: &Overkill,
        at: usize,
        mesh: &Mesh,
        solved: &Solved,
        coarse_load: &[Vec2],
    ) -> f64 {
        let materials = &self.scene.materials;
        let (discrete, solution) = (&solved.discrete, &solved.solution);
        let fine_mesh = reference.hierarchy.finest();
        // one field on the reference mesh at a time: it may be the largest thing there is
        let (interpolation, b) = {
            let u_i = reference.prolong(at, reference.interpolant(at));
            (reference.error(materials, &u_i), reference.contact_work(&u_i))
        };
        let v = reference.prolong(at, &solution.displacement);
        let error = reference.error(materials, &v);
        let fine_state = ContactState::new(fine_mesh, &reference.discrete, &reference.solution);
        let contact = contact::against_reference(mesh, &solved.state, fine_mesh, &fine_state);
        let gap = solution.energy - reference.solution.energy;
        set_errors(&mut level.errors, &error, &contact, interpolation.energy_norm(), gap);
        level.switch_sides = Some(contact.switch_sides);
        // A(e,e) = 2(L(u_h) − L(u_ref)) − 2 (A(u_ref,w) − f(w)),  w = u_h − u_ref
        let by_energies = 2.0 * gap - 2.0 * reference.contact_work(&v);
        level.two_way = relative_difference(error.energy, by_energies, reference.solution.strain_energy);
        // nested constraint sets leave nothing between the nodes but rounding
        let c = self.scene.initial_gap.as_ref().map_or(0.0, |_| reference.penetration_work(&v));
        let work = |load: &[Vec2], u: &[Vec2]| load.iter().zip(u).map(|(f, u)| f.dot(u)).sum::<f64>();
        let load_gap = (work(&discrete.load, &solution.displacement) - work(&reference.discrete.load, &v)).abs();
        let load_change = dual_norm(discrete, &differences(&discrete.load, coarse_load));
        let left = residual_work(discrete, solution, reference.interpolant(at));
        let delta = left + load_gap + 1e-14 * reference.solution.strain_energy;
        level.ledger = Some(ledger(
            0.5 * error.energy,
            [0.5 * interpolation.energy, b, c],
            delta,
            reference.solution.strain_energy,
        ));
        let (e, size) = (error.energy_norm(), reference.solution.strain_energy.sqrt());
        level.budget = Budget {
            algebraic: share(algebraic_error(discrete, solution), e, size),
            quadrature: share(load_change + load_gap / e.max(f64::MIN_POSITIVE), e, size),
            geometry: Some(0.0),
            reference: None,
            unresolved: None,
        };
        error.energy
    }
}
