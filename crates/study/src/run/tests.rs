//! The contact zone in records: sums, scaling and limits that hold without any reference.

use super::*;
use crate::record::{PressureSource, ZoneProfile};
use crate::sample;
use crate::store::scratch::Scratch;
use std::path::PathBuf;

fn run(id: &str, case: &str, levels: usize, partial: Option<PathBuf>) -> StudyRecord {
    let study = sample::study(id);
    let case = study.cases.iter().find(|c| c.name == case).unwrap();
    let settings =
        RunSettings { profile: Profile::Quick, levels: Some(levels), solver: None, partial, keep: Default::default() };
    run_case(&study, case, &settings, &Unwatched).unwrap().record
}

/// `Σ p_i m_i` with the lumped masses of the coordinates.
fn sum(zone: &ZoneProfile) -> f64 {
    let sides = zone.coordinate.windows(2).zip(zone.pressure.windows(2));
    sides.map(|(x, p)| 0.5 * (x[1] - x[0]) * (p[0] + p[1])).sum()
}

#[test]
fn the_profile_carries_the_load() {
    let record = run("hertz", "load-4", 1, None);
    let zone = record.zone.as_ref().unwrap();
    // half of the load per length 0.004 rests on half of the zone
    assert!((sum(zone) - 0.002).abs() < 1e-14, "{}", sum(zone));
    assert!(zone.across_gap && zone.symmetric && zone.coordinate[0] == 0.0);
    assert!((zone.coordinate.last().unwrap() - 1.0).abs() < 1e-14);
    for ((x, p), (gap, pressure)) in zone.coordinate.iter().zip(&zone.points).zip(zone.gap.iter().zip(&zone.pressure)) {
        assert!((x - p[0]).abs() < 1e-14 && (p[1] - (2.0 - (4.0 - x * x).sqrt())).abs() < 1e-14);
        assert!(*gap >= -1e-16 && *pressure >= 0.0 && gap * pressure < 1e-16, "{x}: {gap} {pressure}");
    }
    let reference = zone.reference.as_ref().unwrap();
    assert_eq!(reference.source, PressureSource::Formula);
    // p0 = √(P E*/(π R)) at the axis
    assert!((reference.pressure[0].unwrap() - (0.004 / (2.0 * std::f64::consts::PI)).sqrt()).abs() < 1e-15);
    let contact = record.levels[0].contact.as_ref().unwrap();
    assert!((contact.force - 0.004).abs() < 1e-14 && contact.profile.is_none());
    assert!(record.levels[0].errors.force.unwrap().abs() < 1e-11);
}

/// What Hertz neglects falls with the load: on the second mesh the peak pressure of the largest load is off by 0.7 %, that
/// of a quarter of it by less than half as much, and of a sixteenth by less again.
#[test]
fn the_difference_from_hertz_falls_with_the_load() {
    let peak = |case| run("hertz", case, 2, None).levels[1].errors.peak_pressure.unwrap().abs();
    let [large, middle, small] = ["load-64", "load-16", "load-4"].map(peak);
    assert!((0.005..0.01).contains(&large) && middle < 0.5 * large && small < 0.6 * middle, "{large} {middle} {small}");
}

/// A contact that recedes from full conformity is homogeneous in the load.
#[test]
fn a_pin_presses_on_the_same_arc_whatever_the_load() {
    let zone = |case| run("pin-in-hole", case, 1, None);
    let (one, ten) = (zone("load-1"), zone("load-10"));
    let widths = [&one, &ten].map(|r| r.levels[0].contact.as_ref().unwrap().half_width);
    assert!((widths[1] / widths[0] - 1.0).abs() < 1e-11 && (1.4..1.55).contains(&widths[0]), "{widths:?}");
    let (a, b) = (one.zone.unwrap(), ten.zone.unwrap());
    let largest = b.pressure.iter().copied().fold(0.0, f64::max);
    for (p, q) in a.pressure.iter().zip(&b.pressure) {
        assert!((10.0 * p - q).abs() < 1e-11 * largest && (*p > 0.0) == (*q > 0.0), "{p} {q}");
    }
    // the vertical part of the pressure bears the weight of half a pin, P/2 = 0.005; at the nodes to the order of h²
    let mass = |i: usize| 0.5 * (a.coordinate[(i + 1).min(a.coordinate.len() - 1)] - a.coordinate[i.saturating_sub(1)]);
    let lift: f64 = (0..a.pressure.len()).map(|i| -a.points[i][1] * a.pressure[i] * mass(i)).sum();
    assert!((lift / 0.005 - 1.0).abs() < 3e-3, "{lift}");
}

#[test]
fn an_exact_solution_gives_the_pressure_to_compare_with() {
    let zone = run("theorem-3-1-smooth", "structured", 2, None).zone.unwrap();
    let reference = zone.reference.unwrap();
    assert_eq!(reference.source, PressureSource::Exact);
    // p = 6 (s − x)²₊ with s = 1/√6
    for (x, p) in zone.coordinate.iter().zip(&reference.pressure) {
        let p = p.unwrap();
        assert!((p - 6.0 * (1.0 / 6f64.sqrt() - x).max(0.0).powi(2)).abs() < 1e-13, "{x}: {p}");
    }
    assert!(!zone.across_gap && !zone.symmetric && zone.coordinate.len() == 17);
}

/// The finest level waits in a file for the rest of its case, and its profile with it.
#[test]
fn a_profile_survives_an_interrupted_run() {
    let root = Scratch::new("profile");
    let first = run("hertz", "load-4", 1, Some(root.0.clone()));
    // the case is not declared written, so its level is kept and read back
    let kept = std::fs::read_dir(&root.0).unwrap().count();
    let again = run("hertz", "load-4", 1, Some(root.0.clone()));
    assert_eq!(kept, 1);
    assert!(again.zone.is_some() && again == first);
}

/// L(u) of P(3,2) is known: the limit of the energies finds it within its uncertainty, and bounds the errors from above.
#[test]
fn the_limit_of_the_energies_is_that_of_the_exact_solution() {
    let record = run("theorem-3-1-smooth", "structured", 4, None);
    let found = record.extrapolation.expect("nested levels");
    let exact = record.levels[3].energy - record.levels[3].errors.energy_gap.unwrap();
    assert!((found.energy - exact).abs() < 2.0 * found.uncertainty, "{found:?} {exact}");
    assert!((found.reference_above.unwrap() - (exact - found.energy)).abs() < 1e-15);
    // the coarsest level, n = 8, is left out of the limit and decides on the uncertainty: a fifth of the smallest A(e,e)
    let smallest = record.levels[3].errors.energy.unwrap();
    assert!(found.uncertainty < 0.2 * smallest * smallest, "{found:?}");
    assert!((found.rate - 1.0).abs() < 0.03, "{}", found.rate);
    for (level, bound) in record.levels.iter().zip(&found.bounds) {
        let (e, bound) = (level.errors.energy.unwrap(), bound.unwrap());
        assert!(e < bound && e > 0.97 * bound, "{e} {bound}");
    }
    assert!(record.corners.is_empty(), "the exact solution decides the regularity");
}

/// Energies of meshes that are not nested, or of data that are interpolated, need not fall to `L(u)` from above.
#[test]
fn only_nested_sets_are_extrapolated() {
    assert!(run("theorem-3-1-smooth", "perturbed", 4, None).extrapolation.is_none());
    assert!(run("corner-patch", "patch-1", 4, None).extrapolation.is_none());
}

/// Three levels below a reference of 32 cells.
fn small(id: &str, case: &str, projects: bool) -> StudyRecord {
    let study = sample::study(id);
    let mut case = study.cases.iter().find(|c| c.name == case).unwrap().clone();
    (case.projects, case.quick) = (projects, vec![4, 8, 16]);
    case.reference = ReferencePlan::Overkill { quick: 32, full: 32 };
    let settings =
        RunSettings { profile: Profile::Quick, levels: None, solver: None, partial: None, keep: Default::default() };
    run_case(&study, &case, &settings, &Unwatched).unwrap().record
}

/// The projection is the best approximation from `K_h`, so no worse than the interpolant, and its energy gives its distance a
/// second time. The discrete solution of the scene itself is no projection: it is farther away.
#[test]
fn a_projection_is_the_nearest_of_all() {
    let projected = small("lemma-3-1", "flat-punch", true);
    for level in &projected.levels {
        let (e, interpolation) = (level.errors.energy.unwrap(), level.errors.interpolation.unwrap());
        assert!(e <= interpolation && level.two_way.unwrap() < 1e-9, "{e} {interpolation} {:?}", level.two_way);
        assert!((2.0 * level.errors.energy_gap.unwrap() - e * e).abs() < 1e-9 * e * e && level.ledger.is_none());
    }
    let solved = small("lemma-3-1", "flat-punch", false);
    for (near, far) in projected.levels.iter().zip(&solved.levels) {
        assert!(near.errors.energy.unwrap() < far.errors.energy.unwrap());
    }
}

/// The same against a closed form, across a gap.
#[test]
fn the_projection_of_a_closed_form_is_no_worse_than_its_interpolant() {
    let study = sample::study("theorem-3-4");
    let mut case = study.cases.iter().find(|c| c.name == "convex-structured").unwrap().clone();
    let settings =
        RunSettings { profile: Profile::Quick, levels: Some(2), solver: None, partial: None, keep: Default::default() };
    let solved = run_case(&study, &case, &settings, &Unwatched).unwrap().record;
    case.projects = true;
    let projected = run_case(&study, &case, &settings, &Unwatched).unwrap().record;
    for (near, far) in projected.levels.iter().zip(&solved.levels) {
        let e = near.errors.energy.unwrap();
        assert!(e <= near.errors.interpolation.unwrap() && e < far.errors.energy.unwrap(), "{e}");
        assert!((2.0 * near.errors.energy_gap.unwrap() / (e * e) - 1.0).abs() < 1e-5, "{near:?}");
    }
}

/// The corners of the scene become the expected rate.
#[test]
fn a_study_may_expect_what_its_corners_do() {
    let record = small("theorem-3-2", "tilted-punch", false);
    assert_eq!(record.bounds.expected, Some(crate::record::corner_rate(&record.corners)));
    assert!((record.bounds.expected.unwrap() - 0.7112).abs() < 1e-4, "{:?}", record.corners);
}
