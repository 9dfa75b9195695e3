//! Bilateral parts and the condition on a slide, as study files state them.

use crate::sample;
use crate::study::Study;
use signorini_contact::{Body, Point};
use std::path::Path;

fn text(id: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../studies/{id}.toml"));
    std::fs::read_to_string(file).unwrap()
}

fn read(id: &str, old: &str, new: &str) -> Result<Study, String> {
    let text = text(id);
    assert!(text.contains(old), "{old}");
    Study::parse(&text.replacen(old, new, 1), Path::new(&format!("{id}.toml"))).map_err(|e| format!("{e}"))
}

const TIED: &str = "[[[0, 0], [0.25, 0.075]]]";

fn pieces(new: &str) -> (Vec<Point>, Vec<usize>) {
    let study = read("remark-3-3", TIED, new).unwrap_or_else(|e| panic!("{e}"));
    let scene = study.cases[0].scene().unwrap();
    (scene.contact.corners(), scene.bilateral.clone())
}

#[test]
fn the_zone_is_cut_where_a_bilateral_part_ends() {
    let on = |xs: &[f64]| xs.iter().map(|x| Point::new(*x, 0.3 * x)).collect::<Vec<_>>();
    let same = |a: &[Point], b: &[Point]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).norm() < 1e-15);
    for (new, corners, tied) in [
        (TIED, &[0.0, 0.25, 1.0][..], &[0][..]),
        ("[[[0.25, 0.075], [0, 0]]]", &[0.0, 0.25, 1.0], &[0]),
        ("[[[0, 0], [1, 0.3]]]", &[0.0, 1.0], &[0]),
        ("[[[0.5, 0.15], [0.75, 0.225]], [[0, 0], [0.25, 0.075]]]", &[0.0, 0.25, 0.5, 0.75, 1.0], &[0, 2]),
        // parts that share an end, and parts that overlap
        ("[[[0.25, 0.075], [0.5, 0.15]], [[0.5, 0.15], [1, 0.3]]]", &[0.0, 0.25, 0.5, 1.0], &[1, 2]),
        ("[[[0, 0], [0.5, 0.15]], [[0.25, 0.075], [0.75, 0.225]]]", &[0.0, 0.25, 0.5, 0.75, 1.0], &[0, 1, 2]),
        ("[]", &[0.0, 1.0], &[]),
    ] {
        let (found, bilateral) = pieces(new);
        assert!(same(&found, &on(corners)), "{new}: {found:?}");
        assert_eq!(bilateral, tied, "{new}");
    }
}

#[test]
fn an_arc_is_cut_on_the_arc() {
    let scene = sample::case("remark-3-5", "arc").scene().unwrap().clone();
    assert_eq!((scene.contact.corners().len(), scene.bilateral.as_slice()), (3, &[0][..]));
    let lengths: Vec<f64> = scene.contact.pieces().iter().map(|[p, _]| p.length()).collect();
    let eighth = std::f64::consts::FRAC_PI_8;
    assert!((lengths[0] - eighth).abs() < 1e-12 && (lengths[1] - 3.0 * eighth).abs() < 1e-12, "{lengths:?}");
    assert!(scene.contact.pieces().iter().all(|[p, _]| p.curve().is_some()));
}

#[test]
fn bilateral_parts_that_make_no_sense_are_refused_with_their_place() {
    for (new, part) in [
        ("[[[0, 0], [0.25, 0.08]]]", "the end (0.25, 0.08) of a bilateral part is not on the contact zone"),
        ("[[[0, 0], [0, 0]]]", "a bilateral part of no length"),
        ("[[[0, 0], [0.25, 0.075], [1, 0.3]]]", "invalid length 3, expected 2 entries"),
    ] {
        let message = read("remark-3-3", TIED, new).err().unwrap();
        assert!(message.contains(part) && message.contains("remark-3-3.toml:"), "{message}");
    }
    let across = text("theorem-3-4").replacen("gap = [", "bilateral = [[[0, 0], [1, 0]]]\ngap = [", 1);
    let message = Study::parse(&across, Path::new("theorem-3-4.toml")).err().unwrap().to_string();
    assert!(message.contains("`bilateral` across a `gap`"), "{message}");
}

/// An end that is no node of some mesh is named when that mesh is made.
#[test]
fn an_end_that_is_no_node_is_named() {
    let study = read("remark-3-3", TIED, "[[[0, 0], [0.3, 0.09]]]").unwrap();
    let case = &study.cases[0];
    let error = crate::family::build_level(&case.family, &case.scene().unwrap().domain(), &[8], 0).err().unwrap();
    assert!(error.to_string().contains("the point (0.3, 0.09) of the contact polyline is not a node"), "{error}");
}

#[test]
fn the_condition_on_a_slide_names_a_body_and_a_part_of_its_boundary() {
    let condition = sample::case("remark-3-7", "start-1").scene().unwrap().slide.unwrap();
    assert_eq!(
        (condition.body, condition.along.a, condition.along.b),
        (Body::Second, Point::new(0.0, -1.0), Point::new(1.0, -1.0))
    );
    assert_eq!(sample::case("remark-3-7", "start-1").solver.start_slide, 1.0);
    let stated = "[slide]\nbody = \"lower\"\nalong = [[0, -1], [1, -1]]";
    for (new, part) in [
        ("[slide]\nbody = \"lowr\"\nalong = [[0, -1], [1, -1]]", "did you mean `lower`?"),
        ("[slide]\nbody = \"lower\"\nalong = [[0, -1], [0, -1]]", "has no length"),
        ("[slide]\nbody = \"lower\"\nalong = [[0, -1], [1, -2]]", "(1, -2) lies on no side of body `lower`"),
        ("[slide]\nbody = \"lower\"", "missing field `along`"),
    ] {
        let message = read("remark-3-7", stated, new).err().unwrap();
        assert!(message.contains(part), "{message}");
    }
    let beside = text("lemma-3-3") + "\n" + stated;
    let message = Study::parse(&beside, Path::new("lemma-3-3.toml")).err().unwrap().to_string();
    assert!(message.contains("[slide] beside [lemma]"), "{message}");
}

/// Only what departs from the ordinary is named in the text that a fingerprint hashes.
#[test]
fn fingerprints_of_other_studies_do_not_know_of_slides() {
    let plain = sample::case("theorem-3-1-smooth", "structured").canonical.clone();
    assert!(!plain.contains("slide") && !plain.contains("bilateral"));
    assert!(plain.contains("solver: Settings { method: Automatic, max_steps: 50, tolerance: 1e-11, crossover: true }"));
    let slid = sample::case("remark-3-7", "start-1").canonical.clone();
    assert!(slid.contains("start_slide: 1.0") && slid.contains("slide: SlideCondition"));
    assert!(sample::case("remark-3-3", "structured").canonical.contains("bilateral pieces: [0]"));
}
