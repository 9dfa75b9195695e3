//! Whole runs with bilateral parts and sliding bodies: uniqueness up to the slide, and the defects that must turn a verdict or
//! be refused.

use super::level::Task;
use super::{Profile, RunSettings, Unwatched, conclude, measure_level, run_case};
use crate::error::RunError;
use crate::file::library::shipped;
use crate::record::{Outcome, Reference, StudyRecord};
use crate::study::{Case, PartCondition, Scene, Study};
use signorini_contact::{Body, Point, Vec2};
use std::sync::Arc;

const QUICK: RunSettings =
    RunSettings { profile: Profile::Quick, levels: None, solver: None, partial: None, keep: crate::fields::Keep::None };

fn study(id: &str) -> Study {
    shipped().select(&[id.to_owned()]).unwrap()[0].load().unwrap()
}

fn case<'a>(study: &'a Study, name: &str) -> &'a Case {
    study.cases.iter().find(|c| c.name == name).unwrap()
}

/// The levels of a case with other bilateral pieces than the study's, judged by the claim of Remark 3.3. The exact solution is
/// not verified again.
fn tied(id: &str, name: &str, cells: &[usize], pieces: &[usize]) -> Result<StudyRecord, RunError> {
    let mut study = study(id);
    study.claim = self::study("remark-3-3").claim;
    let mut case = case(&study, name).clone();
    case.bounds = study.claim.bounds.clone();
    let mut scene = case.scene().unwrap().clone();
    scene.bilateral = pieces.to_vec();
    let task = Task::new(&case, &scene, cells, case.solver);
    let levels: Result<Vec<_>, RunError> = (0..cells.len()).map(|k| Ok(measure_level(&task, None, k)?.0)).collect();
    conclude(&study, &case, &QUICK, levels?, Reference::Exact, None)
}

fn run(study: &Study, case: &Case, levels: usize) -> Result<StudyRecord, String> {
    let settings = RunSettings { levels: Some(levels), ..QUICK };
    run_case(study, case, &settings, &Unwatched).map(|r| r.record).map_err(|e| e.to_string())
}

/// The healthy twin passes, the other one fails and is far off.
fn assert_caught(sound: &StudyRecord, wrong: &StudyRecord) {
    assert_eq!(sound.verdict.outcome, Outcome::Pass, "{:?}", sound.verdict.reasons);
    assert_eq!(wrong.verdict.outcome, Outcome::Fail, "{:?}", wrong.verdict.reasons);
    assert!(wrong.levels.iter().all(|l| l.solver.solved));
    let [right, far] = [sound, wrong].map(|r| r.levels[3].errors.h1.unwrap());
    assert!(far > 2.0 * right, "{far} {right}");
}

/// Tension cut off on the arc: the inner body still finds an equilibrium, and it is another one.
#[test]
fn without_its_bilateral_part_the_arc_opens_where_it_should_pull() {
    let cells = [4, 8, 16, 32];
    let sound = tied("remark-3-5", "arc", &cells, &[0]).unwrap();
    let cut = tied("remark-3-5", "arc", &cells, &[]).unwrap();
    assert!(cut.levels.iter().all(|l| l.kkt.bilateral.is_none()));
    assert_caught(&sound, &cut);
}

#[test]
fn a_bilateral_part_in_the_wrong_place_fails() {
    let cells = [8, 16, 32, 64];
    let sound = tied("remark-3-3", "structured", &cells, &[0]).unwrap();
    assert_caught(&sound, &tied("remark-3-3", "structured", &cells, &[0, 1]).unwrap());
}

#[test]
fn without_its_bilateral_part_the_body_on_the_slanted_line_is_pushed_away() {
    let refused = tied("remark-3-3", "structured", &[8], &[]).unwrap_err().to_string();
    assert!(refused.contains("no solution") && refused.contains("translation of Ω'' along (1, 0)"), "{refused}");
}

/// Tension up to 2.4 is found on the tied part, and its total: `∫ p ds` over `0 < s < √1.09/4`.
#[test]
fn the_forces_of_the_bilateral_part_are_those_of_the_closed_form() {
    let record = tied("remark-3-3", "structured", &[16, 32, 64], &[0]).unwrap();
    let stretch = 1.09f64.sqrt();
    let (end, tied) = (0.375f64.sqrt() * stretch, 0.25 * stretch);
    // midpoints: −∫ p = 30 ∫ (s_0 − s)² (s − 0.2) ds
    let n = 4000;
    let at = |k: i32| (f64::from(k) + 0.5) / f64::from(n) * tied;
    let pressed: f64 = (0..n).map(|k| 30.0 * (end - at(k)).powi(2) * (at(k) - 0.2) * tied / f64::from(n)).sum();
    let found: Vec<f64> = record.levels.iter().map(|l| l.kkt.bilateral.as_ref().unwrap().force).collect();
    let wrong: Vec<f64> = found.iter().map(|f| (f - pressed).abs()).collect();
    assert!(wrong[2] < 0.03 * pressed.abs() && wrong[2] < wrong[1] && wrong[1] < wrong[0], "{found:?} {pressed}");
    let last = record.levels[2].kkt.bilateral.as_ref().unwrap();
    assert!(last.constraints == 17 && last.jump < 1e-14 && last.tension > 2.2, "{last:?}");
}

#[test]
fn two_starts_of_the_slide_end_in_the_same_solution() {
    let study = study("remark-3-7");
    let [a, b] = ["start-0", "start-1"].map(|name| run(&study, case(&study, name), 3).unwrap());
    for (a, b) in a.levels.iter().zip(&b.levels) {
        let size = a.solution_h1.unwrap();
        for (x, y) in [
            (a.errors.h1.unwrap(), b.errors.h1.unwrap()),
            (a.errors.l2.unwrap(), b.errors.l2.unwrap()),
            (size, b.solution_h1.unwrap()),
            (a.energy, b.energy),
        ] {
            assert!((x - y).abs() <= 1e-11 * size, "level {}: {x:e} {y:e}", a.level);
        }
    }
}

#[test]
fn a_load_that_does_not_balance_on_the_slide_is_refused_by_name() {
    let study = study("remark-3-7");
    let mut pushed = case(&study, "start-0").clone();
    let crate::study::Subject::Contact(scene) = &mut pushed.subject else { panic!("a contact problem") };
    let exact = scene.exact.clone().unwrap();
    scene.body_force[1] = Some(Arc::new(move |x: Point, _| exact.body_force(Body::Second, x) + Vec2::new(0.5, 0.0)));
    let refused = run(&study, &pushed, 2).unwrap_err();
    assert!(refused.contains("no equilibrium") && refused.contains("translation of Ω'' along (1, 0)"), "{refused}");
    assert!(refused.contains("resultant 5.000000e-1"), "{refused}");
}

/// The sliding body against a solution with another slide: the strain does not see it, so only a norm that does is refused.
#[test]
fn a_reference_with_another_slide_is_refused_where_the_norm_sees_it() {
    let slid = study("remark-3-1");
    assert!(run(&slid, case(&slid, "slide-3"), 2).is_ok());
    let mut seen = slid.clone();
    seen.claim.norm = "h1".into();
    let refused = run(&seen, case(&seen, "slide-3"), 2).unwrap_err();
    assert!(refused.contains("p(u) = ∫ u_t ds = 3.0000") && refused.contains("`h1`"), "{refused}");
}

/// Whether a resultant `(F_1, F_2, M)` is borne by contact forces at the abscissae `xs` of the bowl `y = x²/2`: `(F_1/W, −M/W)` in
/// the convex hull of the points `(x, x + x³/2)`, asked of its support lines.
fn is_borne([f1, f2, m]: [f64; 3], xs: &[f64]) -> bool {
    let (x, y) = (-f1 / f2, m / f2);
    (0..7200).all(|k| {
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 7200.0).sin_cos();
        let reach = xs.iter().map(|x| cos * x + sin * (x + x.powi(3) / 2.0)).fold(f64::NEG_INFINITY, f64::max);
        cos * x + sin * y <= reach + 1e-12
    })
}

/// `(∫P_1, ∫P_2, ∫x P_2 − y P_1)` of the traction on the part named `top`.
fn resultant(scene: &Scene) -> [f64; 3] {
    let part = scene.parts.iter().find(|p| p.name == "top").unwrap();
    let PartCondition::Traction(Some(load)) = &part.condition else { panic!("no load on the top") };
    let n = 1000;
    let mut sums = [0.0; 3];
    for k in 0..n {
        let x = Point::new(-1.0 + 2.0 * (f64::from(k) + 0.5) / f64::from(n), 1.5);
        let p = load(x, Vec2::y()) * (2.0 / f64::from(n));
        (sums[0], sums[1], sums[2]) = (sums[0] + p.x, sums[1] + p.y, sums[2] + x.x * p.y - x.y * p.x);
    }
    sums
}

#[test]
fn a_load_that_the_bowl_bears_is_refused_on_the_meshes_whose_nodes_do_not() {
    let study = study("nodes-hold-less");
    let case = &study.cases[0];
    let load = resultant(case.scene().unwrap());
    let nodes = |n: usize| (0..=2 * n).map(|k| -1.0 + k as f64 / n as f64).collect::<Vec<f64>>();
    assert!(is_borne(load, &nodes(5000)), "K has a solution");
    let borne: Vec<bool> = case.quick.iter().map(|n| is_borne(load, &nodes(*n))).collect();
    assert_eq!(
        (case.quick.as_slice(), borne.as_slice()),
        (&[2, 4, 8, 16, 32][..], &[false, false, true, true, true][..])
    );
    let record = run(&study, case, 4).unwrap();
    assert_eq!(record.levels.iter().map(|l| l.cells).collect::<Vec<_>>(), [8, 16]);
    assert_eq!(record.verdict.outcome, Outcome::Inconclusive);
    for (k, n) in [(0, 2), (1, 4)] {
        let head = format!("level {k} (n = {n}) is refused: no solution: the load pushes a body away by the");
        assert!(record.verdict.reasons[k].starts_with(&head) && record.notes.contains(&record.verdict.reasons[k]));
    }
    // alone, the coarse levels have nothing to show
    assert!(run(&study, case, 2).unwrap_err().contains("rotation of Ω'"));
}
