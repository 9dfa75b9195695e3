//! A solved level against a discrete reference that is not nested above it: both functions are evaluated at points of the
//! reference mesh, each in the element that holds the point.
//!
//! `K_h ⊄ K_ref` and `V_h ⊄ V_ref`, so neither the identity behind `two_way` nor the ledger holds: both stay empty.

use super::parts::{differences, dual_norm, set_errors, share};
use super::{Solved, Task, algebraic_error};
use crate::record::{Budget, Level};
use crate::reference::located::Located;
use crate::reference::overkill::Overkill;
use crate::run::contact::ContactState;
use crate::run::overlay::{self, Zone};
use signorini_contact::Vec2;
use signorini_contact::mesh::Mesh;

impl Task<'_> {
    pub(super) fn fill_from_located(
        &self,
        level: &mut Level,
        reference: &Overkill,
        mesh: &Mesh,
        solved: &Solved,
        coarse_load: &[Vec2],
    ) {
        let (discrete, solution) = (&solved.discrete, &solved.solution);
        let located = Located::new(reference, mesh, &self.scene.materials, &solution.displacement);
        let fine_mesh = reference.hierarchy.finest();
        let fine_state = ContactState::new(fine_mesh, &reference.discrete, &reference.solution);
        let contact = overlay::against_reference(
            &self.scene.contact,
            &Zone { mesh, state: &solved.state },
            &Zone { mesh: fine_mesh, state: &fine_state },
        );
        let gap = solution.energy - reference.solution.energy;
        set_errors(&mut level.errors, &located.error, &contact, located.interpolation.energy_norm(), gap);
        level.switch_sides = Some(contact.switch_sides);
        let load_change = dual_norm(discrete, &differences(&discrete.load, coarse_load));
        let (e, size) = (located.error.energy_norm(), reference.solution.strain_energy.sqrt());
        level.budget = Budget {
            algebraic: share(algebraic_error(discrete, solution), e, size),
            quadrature: share(load_change + located.quadrature, e, size),
            // with chords the bodies of level and reference differ; by how much is not known here
            geometry: (!self.scene.discretisation.chords).then_some(0.0),
            reference: None,
            unresolved: share(located.unresolved.energy_norm(), e, size),
        };
    }
}
