//! The discrete reference in a record: what it is, and how much of the measured errors is its own.

use super::level::{Task, certificate};
use crate::error::RunError;
use crate::rate;
use crate::record::{Level, Reference};
use crate::reference::overkill::Overkill;
use crate::study::{Case, ReferencePlan};

/// The entry of the record.
pub fn describe(case: &Case, overkill: Option<&Overkill>, task: &Task) -> Reference {
    let Some(overkill) = overkill else {
        return if case.reference == ReferencePlan::Exact { Reference::Exact } else { Reference::None };
    };
    Reference::Overkill {
        h: overkill.hierarchy.finest().quality().h,
        dofs: overkill.discrete.dofs(),
        energy: overkill.solution.energy,
        estimated_error: None,
        stationarity: certificate(&overkill.discrete, &overkill.solution).stationarity,
        solver: task.settings.method.name().to_owned(),
    }
}

/// Where a study level stands in the reference's hierarchy: the mesh with the same number of nodes, which is then the
/// very same mesh.
pub fn place_in_hierarchy(task: &Task, overkill: &Overkill, index: usize) -> Result<usize, RunError> {
    let (coarsest, cells) = (task.cells[0], task.cells[index]);
    let at = (cells / coarsest).ilog2() as usize;
    if coarsest << at != cells || at + 1 >= overkill.hierarchy.levels().len() {
        return Err(RunError::Reference(format!(
            "level {index} with n = {cells} is no refinement of n = {coarsest} below the reference mesh; \
             let every level be the coarsest times a power of two, and the reference finer than all of them"
        )));
    }
    Ok(at)
}

/// Estimates the reference's own error from its place on the fitted curve and from its energy, the larger of the two, and
/// writes each level's share: about `½(e_ref/e)²`, since on nested meshes the squares add.
pub fn contaminate(levels: &mut [Level], reference: &mut Reference) {
    let Reference::Overkill { h, energy, estimated_error, .. } = reference else { return };
    let Some(fit) = rate::all(levels, "energy").remove("energy") else { return };
    let on_curve = (fit.intercept + fit.slope * h.ln()).exp();
    let by_energy = levels.last().map_or(0.0, |finest| {
        // L_c − L_∞ ≈ C h_c^{2r} on both meshes: L_ref − L_∞ = (L_c − L_ref)/((h_c/h_ref)^{2r} − 1), and e² = 2(L − L_∞).
        let ratio = (finest.h / *h).powf(2.0 * fit.slope) - 1.0;
        (2.0 * (finest.energy - *energy) / ratio).max(0.0).sqrt()
    });
    let own = on_curve.max(by_energy);
    *estimated_error = Some(own);
    for level in levels {
        level.budget.reference = level.errors.energy.filter(|e| *e > 0.0).map(|e| 0.5 * (own / e).powi(2));
    }
}
