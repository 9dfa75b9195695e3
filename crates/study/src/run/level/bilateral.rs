//! The bilateral constraints of a solved level.

use crate::record::{BilateralRecord, Level};
use signorini_contact::problem::{Discrete, Solution};

/// Recomputed from the nodal displacements and the contact forces; nothing without a bilateral part. `size` is `max|u|`.
pub fn measure(discrete: &Discrete, solution: &Solution, size: f64) -> Option<BilateralRecord> {
    let held = &discrete.basis.held;
    let first = BilateralRecord { constraints: held.len(), ..Default::default() };
    let seen = held.iter().fold(first, |mut seen, held| {
        let pair = &discrete.zone.pairs[held.origin.pair];
        let constraint = &pair.constraints[held.origin.constraint];
        let [a, b] = [pair.first, pair.second].map(|i| solution.displacement[i as usize]);
        let jump = (constraint.normal.dot(&(a - b)) - constraint.gap).abs();
        let force = solution.contact_forces[held.origin.pair][held.origin.constraint];
        seen.jump = seen.jump.max(if size > 0.0 { jump / size } else { jump });
        seen.tension = seen.tension.max(-force / constraint.mass);
        seen.force += force;
        seen
    });
    (!held.is_empty()).then_some(seen)
}

/// What the reader of a record is told of the finest level.
pub fn note(levels: &[Level]) -> Option<String> {
    let finest = levels.last()?;
    let b = finest.kkt.bilateral.as_ref()?;
    Some(format!(
        "bilateral part on level {}: {} constraints, their force {:.4e} in total, largest tension {:.4e}, normal jump at most {:.1e} of \
         the largest displacement; the certificate's signs are asked of the other constraints",
        finest.level, b.constraints, b.force, b.tension, b.jump
    ))
}
