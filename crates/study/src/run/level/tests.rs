//! The discrete reference: against itself, against energies and against the exact solution.

use super::*;
use crate::sample;

const CELLS: [usize; 2] = [4, 8];

fn task(case: &Case) -> Task<'_> {
    Task::new(case, case.scene().unwrap(), &CELLS, case.solver)
}

/// Zero in the nodes of `Γ_u`, anything elsewhere.
fn variation(task: &Task, mesh: &Mesh) -> Vec<Vec2> {
    let mut w: Vec<Vec2> =
        (0..mesh.points.len()).map(|i| 1e-4 * Vec2::new((2.0 * i as f64).sin(), (i as f64).cos())).collect();
    let supports = task.scene.supports();
    for side in mesh.sides.iter().filter(|s| supports[s.part as usize] == Support::Fixed) {
        side.nodes.iter().for_each(|&i| w[i as usize] = Vec2::zeros());
    }
    w
}

#[test]
fn a_reference_has_no_error_against_itself() {
    let case = sample::case("theorem-3-1-smooth", "structured-overkill");
    let (reference, _) = task(&case).overkill(16).unwrap();
    let materials = &case.scene().unwrap().materials;
    assert_eq!(reference.error(materials, &reference.solution.displacement).energy, 0.0);
    assert_eq!(reference.contact_work(&reference.solution.displacement), 0.0);
    // its interpolant agrees with it at the coarse nodes and nowhere else
    let u_i = reference.prolong(1, reference.interpolant(1));
    assert_eq!(
        u_i[..reference.interpolant(1).len()],
        reference.solution.displacement[..reference.interpolant(1).len()]
    );
    assert!(reference.error(materials, &u_i).energy > 1e-6);
}

/// `A(e,e) = 2(L(v) − L(u_ref)) − 2(A(u_ref,w) − f(w))` for any field `v = u_ref − e` that respects the supports.
#[test]
fn errors_from_energies_are_those_of_the_strains() {
    let case = sample::case("theorem-3-1-smooth", "structured-overkill");
    let task = task(&case);
    let (reference, _) = task.overkill(16).unwrap();
    let fine = reference.hierarchy.finest();
    let w = variation(&task, fine);
    let v: Vec<Vec2> = reference.solution.displacement.iter().zip(&w).map(|(u, w)| u + w).collect();
    let by_strains = reference.error(&case.scene().unwrap().materials, &v).energy;
    let work: f64 = reference.discrete.load.iter().zip(&v).map(|(f, v)| f.dot(v)).sum();
    let energy = 0.5 * signorini_contact::norm::of_linear(fine, &case.scene().unwrap().materials, &v).energy - work;
    let by_energies = 2.0 * (energy - reference.solution.energy) - 2.0 * reference.contact_work(&v);
    assert!((by_strains / by_energies - 1.0).abs() < 1e-10, "{by_strains} {by_energies}");
    // the contact forces have their share in it
    assert!(reference.contact_work(&v).abs() > 1e-3 * by_strains);
}

/// On nested meshes the squares add, for a variational inequality nearly: `e² ≈ e_overkill² + e_ref²`.
#[test]
fn errors_against_both_references_differ_by_that_of_the_discrete_one() {
    let case = sample::case("theorem-3-1-smooth", "structured-overkill");
    let exact = case.scene().unwrap().exact.as_ref().unwrap();
    let cells = [4, 32];
    let task = Task::new(&case, case.scene().unwrap(), &cells, case.solver);
    let energy = |index| task.against_exact(exact, index).unwrap().0.errors.energy.unwrap();
    let (coarse, own) = (energy(0), energy(1));
    let short = Task::new(&case, case.scene().unwrap(), &cells[..1], case.solver);
    let (reference, _) = short.overkill(32).unwrap();
    let (level, _) = short.against_overkill(&reference, Some(0), 0).unwrap();
    let measured = level.errors.energy.unwrap();
    let sum = measured.hypot(own);
    assert!((sum / coarse - 1.0).abs() < 2e-3 && own < 0.2 * coarse, "{coarse} {measured} {own}");
    let allowed = 2.0 * level.budget.quadrature.unwrap() + 1e-9;
    assert!(level.two_way.unwrap() < allowed && allowed < 1e-3, "{:?} {allowed}", level.two_way);
    assert_eq!(level.ledger.unwrap().holds, Some(true));
}

#[test]
fn shares_of_rounding_are_no_numbers() {
    assert_eq!(parts::share(1e-20, 1e-15, 1.0), None);
    assert_eq!(parts::share(1e-6, 1e-3, 1.0), Some(1e-3));
}

#[test]
fn the_ledger_holds_is_doubtful_or_broken_by_its_tolerance() {
    let holds = |lhs| parts::ledger(lhs, [1.0, 0.3, 0.2], 1e-6, 1.0).holds;
    assert_eq!(holds(1.5 + 0.9e-6), Some(true));
    assert_eq!(holds(1.5 + 5e-6), None);
    assert_eq!(holds(1.5 + 2e-5), Some(false));
}

/// Two intervals from the same end differ by the distance of their other ends, however each was measured.
#[test]
fn one_switch_point_is_off_by_the_length_that_the_contact_sets_differ_in() {
    let case = sample::case("theorem-3-1-natural", "structured");
    let exact = case.scene().unwrap().exact.as_ref().unwrap();
    let by_exact = [0, 1].map(|index| task(&case).against_exact(exact, index).unwrap().0);
    let case = sample::case("theorem-3-1-natural", "structured-overkill");
    let (reference, _) = task(&case).overkill(32).unwrap();
    let by_overkill = [0, 1].map(|index| task(&case).against_overkill(&reference, Some(index), index).unwrap().0);
    for level in by_exact.iter().chain(&by_overkill) {
        let (position, length) = (level.errors.switch_position.unwrap(), level.errors.contact_set.unwrap());
        assert!(position > 1e-3 && (position - length).abs() < 1e-12, "n = {}: {position} {length}", level.cells);
    }
}
