//! The shipped studies parse, resolve and say what the theory says.

use crate::claim::catalogue::{Standing, catalogue};
use crate::exact::sobolev_order;
use crate::family::{Family, build_level};
use crate::file::library::{EVERYTHING, shipped};
use crate::file::{Group, LibraryError, find_studies};
use crate::record::{ClaimKind, Outcome};
use crate::sample::study as load;
use crate::study::{Case, Normals, ReferencePlan, Study};
use signorini_contact::element::CurvedElement;
use signorini_contact::geometry::right_normal;
use signorini_contact::solver::Method;
use signorini_contact::{Body, Point};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn case<'a>(study: &'a Study, name: &str) -> &'a Case {
    study.cases.iter().find(|c| c.name == name).unwrap_or_else(|| panic!("{} has no case {name}", study.id))
}

#[test]
fn every_file_on_disk_is_embedded_word_for_word_and_resolves() {
    let disk = find_studies(&root());
    let embedded = shipped();
    let ids = |l: &crate::file::Library| l.sources.iter().map(|s| (s.group, s.id.clone())).collect::<Vec<_>>();
    assert!(disk.folder.is_some() && embedded.folder.is_none());
    assert_eq!(ids(&disk), ids(&embedded));
    for (a, b) in disk.sources.iter().zip(&embedded.sources) {
        let (a, b) = (a.load().unwrap_or_else(|e| panic!("{e}")), b.load().unwrap_or_else(|e| panic!("{e}")));
        let prints = |s: &Study| s.cases.iter().map(Case::fingerprint).collect::<Vec<_>>();
        assert_eq!((prints(&a), a.question.clone()), (prints(&b), b.question.clone()));
        assert!([&a.question, &a.setup, &a.refuted_by].iter().all(|t| t.len() > 20), "{}", a.id);
    }
}

/// Controls judge no claim: they are built to be refused.
#[test]
fn every_claim_that_can_be_judged_has_a_shipped_study() {
    let judged: BTreeSet<String> = shipped()
        .sources
        .iter()
        .filter(|s| s.group != Group::Controls)
        .map(|s| s.load().unwrap_or_else(|e| panic!("{e}")).claim.id)
        .collect();
    for entry in catalogue() {
        assert_eq!(judged.contains(entry.id), entry.standing == Standing::Landed, "{}: {:?}", entry.id, entry.standing);
    }
}

#[test]
fn fingerprints_of_shipped_cases_differ() {
    let studies: Vec<Study> = shipped().sources.iter().map(|s| s.load().unwrap()).collect();
    let prints: Vec<String> = studies.iter().flat_map(|s| &s.cases).map(Case::fingerprint).collect();
    assert_eq!(prints.iter().collect::<BTreeSet<_>>().len(), prints.len());
}

#[test]
fn the_cases_are_those_of_the_plan() {
    let five = ["structured", "perturbed", "refined", "structured-overkill", "refined-overkill"];
    let seven = [&five[..3], &["delaunay", "graded"], &five[3..]].concat();
    let plan: &[(&str, &[&str])] = &[
        ("theorem-3-1-smooth", &seven),
        ("theorem-3-1-natural", &five),
        ("lemma-2-1", &["structured", "perturbed", "kinked"]),
        ("corner-patch", &["patch-1", "patch-2"]),
        ("remark-3-2a", &["alpha-1.75", "tiles"]),
        ("remark-3-2b", &["tiles", "alpha-1.5", "alpha-1.05", "alpha-0.75", "alpha-0.5"]),
        ("many-switches", &["n-1", "n-2", "n-4", "n-8", "n-16", "n-32", "n-64"]),
        ("two-squares", &["two-squares"]),
        ("theorem-3-2", &["flat-punch", "tilted-punch", "l-shape", "kinked", "clamped-at-contact"]),
        ("theorem-3-5", &["jumping-load", "notch"]),
        ("lemma-3-1", &["flat-punch", "l-shape"]),
        ("lemma-3-5", &["convex", "concave"]),
        ("lemma-3-6", &["smooth", "rough"]),
        ("lemma-3-2", &["disc-alpha-1", "disc-alpha-1.5", "disc-alpha-0.75", "ellipse-alpha-1.05", "ellipse-smooth"]),
        ("lemma-3-3", &["lemma-3-3"]),
        ("lemma-3-3-full", &["full-right", "full"]),
        ("hertz", &["load-64", "load-16", "load-4", "load-1", "two-cylinders"]),
        ("pin-in-hole", &["load-1", "load-10"]),
        ("pin-imported", &["pin-imported"]),
        ("dovetail", &["dovetail"]),
        ("remark-3-1", &["mean-zero", "slide-3", "slide-minus-2-perturbed"]),
        ("remark-3-3", &["structured", "perturbed", "delaunay"]),
        ("remark-3-5", &["arc", "arc-perturbed"]),
        ("remark-3-6", &["smooth", "smooth-perturbed"]),
        ("remark-3-7", &["start-0", "start-1", "perturbed"]),
        ("lemma-3-4", &["disc-bulging", "disc-bitten", "ellipse-bulging", "ellipse-bitten"]),
    ];
    for (id, cases) in plan {
        assert_eq!(load(id).cases.iter().map(|c| c.name.as_str()).collect::<Vec<_>>(), *cases, "{id}");
    }
}

/// The exponent that a study expects is `min(1, s − 1)` for the regularity `s` that its solution has in theory.
#[test]
fn expected_rates_follow_from_the_regularity() {
    let solution = |id: &str, case: &str| match (id, case) {
        ("bent-regularity", "arc") => Some("arcR"),
        ("bent-regularity", _) => Some("graphR"),
        ("bent-strong-regularity", _) => Some("arcP"),
        ("theorem-3-1-smooth" | "wrong-mu" | "loose-solver" | "same-mesh-twice" | "too-few-levels", _) => Some("P"),
        ("theorem-3-1-natural", _) => Some("W"),
        (_, "tiles") => Some("tiles"),
        ("remark-3-2a" | "remark-3-2b" | "fixed-quadrature", _) => Some("R"),
        ("theorem-3-3", c) if c.starts_with("alpha") => Some("arcR"),
        ("theorem-3-3" | "averaged-normals" | "chords" | "chord-normals", _) => Some("arcP"),
        ("theorem-3-4", c) if c.starts_with("alpha") => Some("graphR"),
        ("theorem-3-4" | "skewed-parameter", _) => Some("graphP"),
        ("remark-3-1" | "remark-3-7" | "slide-without-p", _) => Some("slide"),
        ("remark-3-3", _) => Some("bilateral"),
        _ => None,
    };
    let mut seen = 0;
    for study in shipped().sources.iter().map(|s| s.load().unwrap()) {
        for c in &study.cases {
            let Some(name) = solution(&study.id, &c.name) else { continue };
            let s = sobolev_order(name, &c.parameters).unwrap().unwrap();
            assert_eq!(c.bounds.expected, Some((s - 1.0).min(1.0)), "{} {}", study.id, c.name);
            seen += 1;
        }
    }
    assert_eq!(seen, 64);
}

/// On a boundary the trace of `H^{1+α−δ}` is approximated like `h^{min(2, α + 1/2)}`; smooth functions like `h²`.
#[test]
fn expected_rates_on_the_boundary_follow_from_the_regularity() {
    for c in load("lemma-3-2").cases {
        let expected = c.parameters.get("alpha").map_or(2.0, |alpha| (alpha + 0.5).min(2.0));
        assert_eq!(c.bounds.expected, Some(expected), "{}", c.name);
        // the paper asks for H²
        assert_eq!(c.bounds.paper, (expected >= 1.5).then_some(1.5), "{}", c.name);
    }
}

#[test]
fn bounds_come_from_the_catalogue_unless_a_case_has_none() {
    let study = load("remark-3-2b");
    let b = |name: &str| case(&study, name).bounds.clone();
    assert_eq!((b("alpha-1.05").paper, b("alpha-1.05").today), (Some(0.75), Some(1.0)));
    assert_eq!((b("alpha-0.5").paper, b("alpha-0.5").today, b("alpha-0.5").expected), (None, None, Some(0.5)));
}

#[test]
fn overkill_cases_measure_against_finer_meshes() {
    let study = load("theorem-3-1-natural");
    let c = case(&study, "refined-overkill");
    assert_eq!(c.reference, ReferencePlan::Overkill { quick: 256, full: 1024 });
    assert_eq!((c.quick.as_slice(), c.family), (&[8, 16, 32, 64][..], Family::Refined { seed: 1, amount: 0.3 }));
    let exact = case(&study, "perturbed");
    assert_eq!((exact.quick.last(), exact.full.last()), (Some(&128), Some(&512)));
}

/// Parts cover the boundary, blocks fit, contact nodes match: the mesh builder sees to all of it.
#[test]
fn every_scene_can_be_meshed_and_its_angles_are_not_small() {
    for study in shipped().sources.iter().map(|s| s.load().unwrap()) {
        for c in &study.cases {
            let (Some(scene), cells) = (c.scene(), &c.quick[..1]) else { continue };
            let level = build_level(&c.family, &scene.domain(), cells, 0)
                .unwrap_or_else(|e| panic!("{} {}: {e}", study.id, c.name));
            // a perturbed mesh promises half of the angle that the mapped grid has, or 20°
            let bound = match c.family {
                Family::Perturbed { .. } => {
                    let grid = build_level(&Family::Structured, &scene.domain(), cells, 0).unwrap();
                    f64::min(20.0, 0.5 * grid.quality.min_angle)
                }
                // this one is there to have small angles
                Family::Degenerate(_) => 1.0,
                // meshes that no estimate allows
                _ if study.id == "hard-angles" => 1.0,
                _ if study.id == "hard-slender" => 7.0,
                _ => 10.0,
            };
            let angle = level.quality.min_angle;
            assert!(angle > bound - 1e-9, "{} {}: {angle}°, {bound}° promised", study.id, c.name);
        }
    }
}

/// The corner of each patch lies on both bodies, and the exact jump does not penetrate on either flank.
#[test]
fn corner_patches_press_on_both_flanks() {
    let study = load("corner-patch");
    assert_eq!(study.claim.kind, ClaimKind::Exact);
    for c in &study.cases {
        let exact = c.scene().unwrap().exact.as_ref().unwrap();
        assert_eq!(c.scene().unwrap().contact.corners()[1], Point::new(0.0, 0.0));
        for w in c.scene().unwrap().contact.corners().windows(2) {
            // Ω' on the left of the polyline, so its outward normal is on the right.
            let n = right_normal(w[0], w[1]);
            let x = 0.3 * w[0] + 0.7 * w[1];
            let jump = exact.solution.value(Body::First, x) - exact.solution.value(Body::Second, x);
            assert!(n.dot(&jump).abs() < 1e-14 && n.y < 0.0, "{}: {jump:?}", c.name);
        }
    }
}

#[test]
fn two_squares_has_its_published_load() {
    let study = load("two-squares");
    let scene = study.cases[0].scene().unwrap();
    let top = scene.parts.iter().find(|p| p.name == "top").unwrap();
    let crate::study::PartCondition::Traction(Some(load)) = &top.condition else { panic!("no load on the top") };
    let t = load(Point::new(0.4, 1.0), Point::new(0.0, 1.0));
    assert!(t.x == 0.0 && (t.y + 0.1 * (1.0 - 1.75 * 0.4)).abs() < 1e-16);
    assert!(study.cases[0].expected_is_asymptotic && study.cases[0].notes.iter().any(|n| n.contains("corner")));
}

#[test]
fn controls_plant_their_defects_and_say_what_they_expect() {
    let expect = |id: &str| load(id).cases[0].expect;
    let doubted = [
        "wrong-mu",
        "same-mesh-twice",
        "loose-solver",
        "fixed-quadrature",
        "too-few-levels",
        "roaming-switch",
        "chords",
        "nodes-hold-less",
    ];
    let refuted = [
        "averaged-normals",
        "chord-normals",
        "skewed-parameter",
        "hertz-plane-stress",
        "outside-k",
        "degenerate",
        "slide-without-p",
    ];
    assert_eq!(shipped().group(Group::Controls).count(), doubted.len() + refuted.len());
    for (ids, outcome) in [(&doubted[..], Outcome::Inconclusive), (&refuted, Outcome::Fail)] {
        for id in ids {
            assert_eq!(expect(id), Some(outcome), "{id}");
        }
    }
    let planted = |id: &str| load(id).cases[0].scene().unwrap().discretisation;
    assert!(planted("chords").chords && planted("chord-normals").normals == Normals::Chord);
    assert!(matches!(planted("skewed-parameter").element, CurvedElement::Isoparametric { skew } if skew > 0.5));
    let wrong = &load("wrong-mu").cases[0];
    assert_ne!(wrong.scene().unwrap().materials[1], wrong.scene().unwrap().exact.as_ref().unwrap().materials[1]);
    assert_eq!(load("same-mesh-twice").cases[0].quick, [16; 5]);
    assert_eq!(load("too-few-levels").cases[0].full.len(), 3);
    assert!(load("fixed-quadrature").cases[0].fixed_quadrature);
    let loose = load("loose-solver").cases[0].solver;
    assert_eq!((loose.method, loose.tolerance, loose.crossover), (Method::InteriorPoint, 1e-2, false));
    let healthy = shipped().sources.into_iter().filter(|s| s.group != Group::Controls);
    assert!(healthy.into_iter().all(|s| s.load().unwrap().cases.iter().all(|c| c.expect.is_none())));
}

/// Hard studies ask for a second opinion in every case, and some of their scenes have no solution.
#[test]
fn hard_cases_are_confirmed_or_refused() {
    let studies: Vec<Study> = shipped().group(Group::Hard).map(|s| s.load().unwrap()).collect();
    assert!(studies.iter().all(|s| s.claim.kind == ClaimKind::Certificate));
    let cases: Vec<&Case> = studies.iter().flat_map(|s| &s.cases).collect();
    assert!(cases.iter().all(|c| c.second.is_some_and(|second| second != c.solver.method)));
    let refused: Vec<&str> = cases.iter().filter(|c| c.refused).map(|c| c.name.as_str()).collect();
    let expected =
        ["inside-1e-12", "edge", "outside-1e-8", "outside", "pulled-off", "drift-1e-8", "slope-1e-9", "own-load-1e-12"];
    assert_eq!(refused, expected);
}

#[test]
fn names_select_studies() {
    let library = shipped();
    let ids = |names: &[&str]| {
        let names: Vec<String> = names.iter().map(|n| n.to_string()).collect();
        library.select(&names).map(|s| s.into_iter().map(|s| s.id).collect::<Vec<_>>())
    };
    let controls = library.group(Group::Controls).count();
    assert_eq!(ids(&[]).unwrap().len(), library.group(Group::Standard).count());
    assert_eq!(ids(&["controls"]).unwrap().len(), controls);
    assert_eq!(ids(&[EVERYTHING]).unwrap().len(), library.sources.len());
    assert_eq!(ids(&["two-squares", "controls", "wrong-mu", "two-squares"]).unwrap().len(), 1 + controls);
    assert_eq!(ids(&["my/own.toml"]).unwrap(), ["own"]);
    assert!(ids(&["hard"]).unwrap().iter().all(|id| id.starts_with("hard-")));
    let Err(LibraryError::Unknown { hint, .. }) = ids(&["two-sqaures"]) else { panic!("accepted") };
    assert_eq!(hint, "did you mean `two-squares`?");
}

#[test]
fn studies_are_found_from_below_and_shipped_ones_elsewhere() {
    let below = find_studies(&root().canonicalize().unwrap().join("crates/study/src"));
    assert!(below.folder.unwrap().ends_with("studies"));
    assert_eq!(find_studies(Path::new("/proc")).folder, None);
}

/// `b = ∫ T_n [u_I]_n ds` of one cell, by the midpoint rule from the traces `p` and `g` of the many-switches cell, over
/// `h² = 2/n²`: its largest value is the constant of the study's gate.
#[test]
fn the_constant_of_many_switches_is_that_of_one_cell() {
    const SIGMA: f64 = 0.43;
    let pressure = |t: f64| if t < SIGMA { 3000.0 * (t * (SIGMA - t)).powi(2) } else { 0.0 };
    let gap = |t: f64| if t > SIGMA { 400.0 * ((t - SIGMA) * (1.0 - t)).powi(3) } else { 0.0 };
    let constant = |n: u32| {
        let side = 1.0 / f64::from(n);
        let points = (0..4000).map(|i| (f64::from(i) + 0.5) / 4000.0);
        let b: f64 = points
            .map(|x| {
                let left = (x / side).floor() * side;
                let share = (x - left) / side;
                pressure(x) * (gap(left) * (1.0 - share) + gap(left + side) * share) / 4000.0
            })
            .sum();
        b / (2.0 * side * side)
    };
    let largest = [1, 2, 4, 8, 16, 32].map(constant).into_iter().fold(0.0, f64::max);
    for c in load("many-switches").cases {
        let stated = c.gates.constant.unwrap();
        assert!((largest / stated - 1.0).abs() < 0.01, "{}: {largest} {stated}", c.name);
    }
}

#[test]
fn a_case_may_take_the_exact_solution_back() {
    let study = shipped().select(&["lemma-2-1".into()]).unwrap()[0].load().unwrap();
    let has_exact = |name: &str| study.cases.iter().find(|c| c.name == name).unwrap().scene().unwrap().exact.is_some();
    assert!(has_exact("structured") && has_exact("perturbed") && !has_exact("kinked"));
}

/// Two lemmas speak of the distance of a given displacement, and the theorems beside them of solutions.
#[test]
fn only_the_lemmas_of_density_project() {
    for study in shipped().sources.iter().map(|s| s.load().unwrap()) {
        let projects = ["lemma-3-1", "lemma-3-5"].contains(&study.id.as_str());
        assert!(study.cases.iter().all(|c| c.projects == projects), "{}", study.id);
    }
}
