//! The discrete reference in a record: what it is, and how much of the measured errors is its own.

use super::contact::ContactState;
use super::level::{Task, certificate};
use super::profile;
use crate::error::RunError;
use crate::rate;
use crate::record::{Level, Reference, ZoneProfile};
use crate::reference::overkill::Overkill;
use crate::study::{Case, ReferencePlan, Scene};

/// The entry of the record.
pub fn describe(case: &Case, overkill: Option<&Overkill>) -> Reference {
    let Some(overkill) = overkill else {
        return if case.reference == ReferencePlan::Exact { Reference::Exact } else { Reference::None };
    };
    Reference::Overkill {
        h: overkill.hierarchy.finest().quality().h,
        dofs: overkill.discrete.dofs(),
        energy: overkill.solution.energy,
        estimated_error: None,
        stationarity: certificate(&overkill.discrete, &overkill.solution).stationarity,
        solver: overkill.solution.raw.method.name().to_owned(),
    }
}

/// Pressure and gap along the zone of the reference.
pub fn zone(scene: &Scene, overkill: &Overkill) -> Option<ZoneProfile> {
    let Overkill { hierarchy, discrete, solution } = overkill;
    let mesh = hierarchy.finest();
    let state = ContactState::new(mesh, discrete, solution);
    profile::measure(scene, mesh, discrete, solution, &state, true).profile
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
/// writes each level's share.
///
/// With `w = u_h − I u_h`, `I` the interpolant on the reference mesh, and `e_ref = ‖u − u_ref‖_A`,
///
/// ```text
/// ‖u − u_h‖² = ‖u_ref − u_h‖² + e_ref² + 2A(u − u_ref, u_ref − I u_h) − 2A(u − u_ref, w)
/// ```
///
/// `u_ref − I u_h` lies in the reference's space, to which its error is orthogonal, for a variational inequality nearly. So the
/// share is about `½(e_ref/e)²` on nested meshes, where `w = 0` and the squares add, and at most `½(e_ref/e)² + e_ref ‖w‖/e²`
/// elsewhere; by the triangle inequality never more than `e_ref/e`.
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
        let unresolved = level.budget.unresolved.unwrap_or(0.0);
        level.budget.reference = level.errors.energy.filter(|e| *e > 0.0).map(|e| contamination(own / e, unresolved));
    }
}

/// The share of the measured error that an error of the reference of `own` times that size may have.
fn contamination(own: f64, unresolved: f64) -> f64 {
    f64::min(0.5 * own * own + own * unresolved, own)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    /// Levels and a reference of `L = −½ + ½e²`, `e = 0.3 h`, with the reference at an eighth of the finest `h`.
    fn synthetic(reference_energy: f64) -> (Vec<Level>, Reference) {
        let mut levels = sample::levels(4, |h| 0.3 * h);
        for level in &mut levels {
            level.energy = -0.5 + 0.5 * (0.3 * level.h).powi(2);
        }
        let h = levels[3].h / 8.0;
        let solver = "condensed".into();
        let reference = Reference::Overkill {
            h,
            dofs: 1,
            energy: reference_energy,
            estimated_error: None,
            stationarity: 0.0,
            solver,
        };
        (levels, reference)
    }

    fn contaminated(energy: f64) -> (f64, f64) {
        let (mut levels, mut reference) = synthetic(energy);
        contaminate(&mut levels, &mut reference);
        let Reference::Overkill { estimated_error: Some(own), .. } = reference else { panic!("no estimate") };
        (own, levels[3].budget.reference.unwrap())
    }

    #[test]
    fn curve_and_energies_find_the_same_error_of_the_reference() {
        let own = 0.3 * 0.125 / 64.0;
        let (estimate, share) = contaminated(-0.5 + 0.5 * own * own);
        assert!((estimate / own - 1.0).abs() < 1e-9, "{estimate} {own}");
        // ½ (1/8)² on the finest level
        assert!((share - 0.5 / 64.0).abs() < 1e-9);
    }

    #[test]
    fn the_worse_of_the_two_estimates_counts() {
        let own = 0.3 * 0.125 / 64.0;
        // a reference energy that is too low leaves a larger gap to the levels, hence a larger extrapolated error
        let (estimate, _) = contaminated(-0.5 - 5e-6);
        let finest = 64.0 * own / 8.0;
        let extrapolated = f64::sqrt((finest * finest + 1e-5) / 63.0);
        assert!((estimate / extrapolated - 1.0).abs() < 1e-9 && estimate > 1.2 * own, "{estimate} {extrapolated}");
        // too high a one says nothing; the curve then decides
        assert!((contaminated(-0.5 + 1e-6).0 / own - 1.0).abs() < 1e-9);
    }

    /// `½(e_ref/e)² + (e_ref/e)(‖w‖/e)`, as long as the triangle inequality does not say less.
    #[test]
    fn what_the_reference_cannot_hold_adds_to_its_share() {
        let share = |unresolved| {
            let (mut levels, mut reference) = synthetic(-0.5 + 0.5 * (0.3 * 0.125 / 64.0_f64).powi(2));
            levels[3].budget.unresolved = unresolved;
            contaminate(&mut levels, &mut reference);
            levels[3].budget.reference.unwrap()
        };
        assert!((share(Some(0.4)) - (0.5 / 64.0 + 0.4 / 8.0)).abs() < 1e-9);
        assert!((share(Some(3.0)) - 0.125).abs() < 1e-9);
        assert_eq!(share(Some(0.0)), share(None));
    }

    #[test]
    fn an_exact_reference_contaminates_nothing() {
        let mut levels = sample::levels(4, |h| 0.3 * h);
        let before = levels.clone();
        contaminate(&mut levels, &mut Reference::Exact);
        assert_eq!(levels, before);
    }
}
