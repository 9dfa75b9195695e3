//! Curves, gaps and discretisations of study files: what is read, and what is refused where.

use crate::study::{Normals, Study};
use signorini_contact::ContactLine;
use signorini_contact::element::CurvedElement;
use std::path::Path;

const ARC: &str = include_str!("../../../../../studies/theorem-3-3.toml");
const GAP: &str = include_str!("../../../../../studies/theorem-3-4.toml");

/// The study of the text with its first `from` replaced; `Err` holds the message with its place.
fn edited(text: &str, from: &str, to: &str) -> Result<Study, String> {
    assert!(text.contains(from), "{from}");
    let name = if text == ARC { "theorem-3-3.toml" } else { "theorem-3-4.toml" };
    Study::parse(&text.replacen(from, to, 1), Path::new(name)).map_err(|e| e.to_string())
}

#[test]
fn an_arc_becomes_the_common_zone_and_a_gap_the_two_faces() {
    let arc = edited(ARC, "[contact]", "[contact]").unwrap();
    let scene = arc.cases[0].scene().unwrap();
    let ContactLine::Common(path) = &scene.contact else { panic!("{:?}", scene.contact) };
    assert!(path.is_curved() && scene.discretisation.element == CurvedElement::Physical);
    assert!(scene.bodies[1].blocks.iter().all(|b| b.curves[3].is_some() && b.curves[0].is_none()));

    let gap = edited(GAP, "[contact]", "[contact]").unwrap();
    let scene = gap.cases[0].scene().unwrap();
    assert!(scene.contact.direction().is_some());
    assert_eq!(scene.discretisation.element, CurvedElement::Isoparametric { skew: 0.0 });
}

#[test]
fn a_discretisation_other_than_the_papers_is_taken_and_changes_the_fingerprint() {
    let plain = edited(ARC, "[contact]", "[contact]").unwrap();
    let text = "[discretisation]\nelement = \"isoparametric\"\nskew = 0.3\nnormals = \"averaged\"\n\n[contact]";
    let other = edited(ARC, "[contact]", text).unwrap();
    let scene = other.cases[0].scene().unwrap();
    assert_eq!(scene.discretisation.element, CurvedElement::Isoparametric { skew: 0.3 });
    assert_eq!(scene.discretisation.normals, Normals::Averaged);
    assert_ne!(plain.cases[0].fingerprint(), other.cases[0].fingerprint());
    let moved = edited(ARC, "radius = 1,", "radius = 1.0000000000001,").unwrap();
    assert_ne!(plain.cases[0].fingerprint(), moved.cases[0].fingerprint());
}

#[test]
fn what_makes_no_sense_is_refused_with_its_place() {
    let table = [
        (ARC, "curves = [\"arc\"]", "curves = [\"ark\"]", "there is no curve `ark`"),
        (ARC, "curves = [\"arc\"]", "curves = [\"\", \"arc\"]", "2 curves for 1 segments"),
        (ARC, "radius = 1,", "radius = 0,", "a circle of radius 0"),
        (ARC, "to = 90", "to = 0", "from 0° to 0°"),
        (ARC, "radius = 1,", "radius = 1.1,", "away from curve `arc`"),
        (
            ARC,
            "circle = {",
            "through = [[0, 0], [1, 1]]\ncircle = {",
            "needs exactly one of `circle`, `graph`, `through`",
        ),
        (
            ARC,
            "circle = { centre = [0, 0], radius = 1, from = 0, to = 90 }",
            "through = [[1, 0], [1, 0]]",
            "of a spline are 0 apart",
        ),
        (ARC, "name = \"arc\"", "name = \"\"", "is empty or used twice"),
        (ARC, "[contact]", "[discretisation]\nskew = 0.3\n\n[contact]", "skew = 0.3 needs isoparametric elements"),
        (ARC, "along = [[1, 0], [0, 1]]\ncurves = [\"arc\"]", "", "needs either `along` or `gap`"),
        (ARC, "curves = [\"arc\"]", "direction = [1, 0]", "`direction` belongs to a `gap`"),
        (GAP, "xi = \"eta^2/4 + eta^3/20\"", "xi = \"eta^2/4 + etta\"", "etta"),
        (GAP, "xi = \"eta^2/4 + eta^3/20\"", "xi = \"log(eta)\"", "at eta ="),
        (GAP, "gap = [\"right face\", \"left face\"]", "gap = [\"left face\", \"right face\"]", "lies on no side"),
        (GAP, "[contact]", "[contact]\ndirection = [2, 0]", "of length 2"),
        (GAP, "[contact]", "[discretisation]\nnormals = \"chord\"\n\n[contact]", "`normals` across a gap"),
    ];
    for (text, from, to, words) in table {
        let message = match edited(text, from, to) {
            Ok(_) => panic!("accepted {to}"),
            Err(message) => message,
        };
        // file:line:column
        assert!(message.contains(words) && message.contains(".toml:"), "{to}: {message}");
    }
}
