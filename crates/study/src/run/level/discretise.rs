//! The discrete problem of a scene: its constraints as the study ties, bends and fixes them.

use super::defects::with_normals;
use crate::study::Scene;
use signorini_contact::problem::{Discrete, Problem};
use signorini_contact::zone::Zone;
use signorini_contact::{Error, Vec2};

impl Scene {
    /// The problem with nodal loads and with the constraints of `zone`: those on the bilateral part made bilateral, and the
    /// study's condition on a slide in the place of the program's.
    ///
    /// # Errors
    /// A load without equilibrium, contradicting supports, a condition that fixes no slide.
    pub(crate) fn discretise(&self, problem: &Problem, load: Vec<Vec2>, mut zone: Zone) -> Result<Discrete, Error> {
        zone.make_bilateral(problem.mesh, &self.bilateral);
        let zone = with_normals(zone, problem.mesh, &self.discretisation);
        let mut discrete = problem.discretise_zone(load, zone)?;
        if let Some(condition) = &self.slide {
            discrete.fix_slide(problem.mesh, condition)?;
        }
        Ok(discrete)
    }
}
