//! Must-fail twins: a defect planted in the contact constraints of an otherwise healthy run has to turn its verdict.
//!
//! Each defect goes in where a real one would, between mesh and basis, and everything after it is the ordinary run:
//! solve, measurement, ledger, verdict. The healthy twin passes on the same levels.

use super::level::Task;
use super::{Profile, RunSettings, conclude, measure_level};
use crate::file::Library;
use crate::file::library::shipped;
use crate::record::{Outcome, Reference, StudyRecord};
use crate::study::Study;
use signorini_contact::mesh::Mesh;
use signorini_contact::solver::Settings;
use signorini_contact::zone::{Constraint, Zone};

/// How the contact zone of a mesh is constrained.
type Constrain = fn(&Mesh) -> Zone;

fn study(id: &str) -> Study {
    let library: Library = shipped();
    library.select(&[id.to_owned()]).unwrap()[0].load().unwrap()
}

/// Runs one case with constraints of the given making on the given levels.
fn run(id: &str, case: &str, cells: &[usize], constrain: Constrain) -> StudyRecord {
    let study = study(id);
    let case = study.cases.iter().find(|c| c.name == case).unwrap();
    let task = Task { constrain, ..Task::new(case, case.scene().unwrap(), cells, Settings::default()) };
    let levels = (0..cells.len()).map(|k| measure_level(&task, None, k).unwrap().0).collect();
    let settings =
        RunSettings { profile: Profile::Quick, levels: None, solver: None, partial: None, keep: Default::default() };
    conclude(&study, case, &settings, levels, Reference::Exact, None).unwrap()
}

/// The energy errors of a record.
fn errors(record: &StudyRecord) -> Vec<f64> {
    record.levels.iter().map(|l| l.errors.energy.unwrap()).collect()
}

/// Puts one constraint in the place of the two at each corner.
fn merge(mesh: &Mesh, one: fn([&Constraint; 2]) -> Constraint) -> Zone {
    let mut zone = Zone::new(mesh);
    for pair in &mut zone.pairs {
        if let [a, b] = &pair.constraints[..] {
            pair.constraints = vec![one([a, b])];
        }
    }
    zone.side_ends.iter_mut().flatten().for_each(|(_, constraint)| *constraint = 0);
    zone
}

/// Keeps the normal of the left flank only.
fn first_alone(mesh: &Mesh) -> Zone {
    merge(mesh, |[a, b]| Constraint { mass: a.mass + b.mass, ..*a })
}

/// Keeps the normal of the right flank only.
fn last_alone(mesh: &Mesh) -> Zone {
    merge(mesh, |[a, b]| Constraint { mass: a.mass + b.mass, ..*b })
}

/// `n¹ + n²`, normalised.
fn average(mesh: &Mesh) -> Zone {
    merge(mesh, |[a, b]| Constraint { normal: (a.normal + b.normal).normalize(), mass: a.mass + b.mass, ..*a })
}

/// `h¹ n¹ + h² n²`, normalised: the normal that a boundary integral would give.
fn weighted_average(mesh: &Mesh) -> Zone {
    merge(mesh, |[a, b]| Constraint {
        normal: (a.mass * a.normal + b.mass * b.normal).normalize(),
        mass: a.mass + b.mass,
        ..*a
    })
}

/// `n·d ≥ 0` in place of `n·d ≤ 0`: the bodies may overlap and not part.
fn swapped_sign(mesh: &Mesh) -> Zone {
    let mut zone = Zone::new(mesh);
    zone.pairs.iter_mut().flat_map(|p| &mut p.constraints).for_each(|c| c.normal = -c.normal);
    zone
}

const PATCH: [usize; 3] = [4, 8, 16];

#[test]
fn both_corner_patches_pass_with_both_constraints() {
    for case in ["patch-1", "patch-2"] {
        let record = run("corner-patch", case, &PATCH, Zone::new);
        assert_eq!(record.verdict.outcome, Outcome::Pass, "{case}: {:?}", record.verdict.reasons);
        assert!(errors(&record).iter().all(|e| *e < 1e-12), "{case}: {:?}", errors(&record));
    }
}

/// Planted at the corner: name, defect, energy errors in patch 1 and patch 2.
fn corner_defects() -> Vec<(&'static str, [Vec<f64>; 2])> {
    let defects: [(&str, Constrain); 4] =
        [("first", first_alone), ("last", last_alone), ("average", average), ("weighted", weighted_average)];
    let both = |constrain| ["patch-1", "patch-2"].map(|case| judged(case, constrain));
    defects.map(|(name, constrain)| (name, both(constrain))).to_vec()
}

/// The energy errors; the verdict is demanded to follow them.
fn judged(case: &str, constrain: Constrain) -> Vec<f64> {
    let record = run("corner-patch", case, &PATCH, constrain);
    let errors = errors(&record);
    let wanted = if errors.iter().all(|e| *e < 1e-12) { Outcome::Pass } else { Outcome::Fail };
    assert_eq!(record.verdict.outcome, wanted, "{case}: {:?}", record.verdict.reasons);
    errors
}

#[test]
fn every_treatment_of_a_corner_by_one_normal_is_caught_by_a_patch() {
    for (name, [patch_1, patch_2]) in corner_defects() {
        // The length-weighted average is the one that patch 1 cannot see.
        let seen = patch_1.iter().all(|e| *e > 1e-3);
        assert_eq!(seen, name != "weighted", "{name}: {patch_1:?}");
        assert!(patch_2.iter().all(|e| *e > 1e-2), "{name}: {patch_2:?}");
        // They all converge like h, so no rate would have told.
        assert!(patch_2.windows(2).all(|e| (1.9..2.1).contains(&(e[0] / e[1]))), "{name}: {patch_2:?}");
    }
}

#[test]
fn the_errors_of_the_wrong_corners_are_those_of_an_independent_program() {
    let known = [("last", [0.55, 0.28, 0.14]), ("average", [0.27, 0.13, 0.064])];
    for (name, [_, patch_2]) in corner_defects() {
        let Some((_, known)) = known.iter().find(|(k, _)| *k == name) else { continue };
        // Its triangles are others, so the constants agree only roughly.
        assert!(patch_2.iter().zip(known).all(|(e, k)| (e / k - 1.0).abs() < 0.1), "{name}: {patch_2:?} {known:?}");
    }
}

/// Chords in place of arcs: the strips between them are seen in their own column, and they alone are enough to refuse the
/// measurement.
#[test]
fn chords_are_seen_in_the_column_of_the_geometry() {
    let record = run("chords", "chords", &[8, 16, 32, 64], Zone::new);
    assert_eq!(record.verdict.outcome, Outcome::Inconclusive, "{:?}", record.verdict.reasons);
    for level in &record.levels {
        let share = level.budget.geometry.unwrap();
        assert!((0.1..0.2).contains(&share), "level {}: {share}", level.level);
        let said = |r: &String| r.starts_with(&format!("level {}: geometry error", level.level));
        assert!(record.verdict.reasons.iter().any(said), "{:?}", record.verdict.reasons);
    }
    let exact = run("theorem-3-3", "structured", &[8, 16], Zone::new);
    assert!(exact.levels.iter().all(|l| l.budget.geometry == Some(0.0)));
}

#[test]
fn a_swapped_sign_of_the_gap_breaks_the_ledger_though_the_solver_is_content() {
    let levels = [8, 16, 32, 64];
    let healthy = run("theorem-3-1-smooth", "structured", &levels, Zone::new);
    assert_eq!(healthy.verdict.outcome, Outcome::Pass, "{:?}", healthy.verdict.reasons);

    let record = run("theorem-3-1-smooth", "structured", &levels, swapped_sign);
    assert_eq!(record.verdict.outcome, Outcome::Fail, "{:?}", record.verdict.reasons);
    for level in &record.levels {
        // The certificate vouches for the problem that was solved, and the identity behind `two_way` holds for any field.
        assert!(level.kkt.penetration < 1e-12 && level.kkt.tension < 1e-12 && level.two_way < Some(1e-8));
        assert_eq!(level.ledger.as_ref().map(|l| l.holds), Some(Some(false)), "level {}", level.level);
    }
    let reasons = record.verdict.reasons.join("\n");
    assert!(reasons.contains("½A(e,e) ≤ a + b + c is broken") && reasons.contains("too slow"), "{reasons}");
}
