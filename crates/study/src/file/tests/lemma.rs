//! Studies with a table `[lemma]`: what they mean, and malformed ones.

use crate::lemma::Lemma;
use crate::lemma::domain::Side;
use crate::study::{ReferencePlan, Study, Subject};
use std::path::Path;

/// A small good study; every malformed one replaces one piece of it.
const GOOD: &str = r#"id = "small"
title = "t"
question = "q"
setup = "s"
refuted_by = "r"
claim = "lemma-3-4"

[lemma]
kind = "strip"
semi_axes = [1.5, 1]
side = "outside"

[levels]
quick = [4, 8, 16]
"#;

fn parse(text: &str) -> Result<Study, crate::file::StudyError> {
    Study::parse(text, Path::new("small.toml"))
}

#[test]
fn a_lemma_stands_in_the_place_of_a_scene() {
    let case = parse(GOOD).unwrap().cases.remove(0);
    assert!(case.scene().is_none() && case.reference == ReferencePlan::None);
    assert_eq!((case.family_name(), case.gates.ceiling, case.quick.len()), ("refined", None, 3));
    let Subject::Lemma(Lemma::Strip(domain)) = case.subject else { panic!("no strip") };
    assert_eq!((domain.ellipse.semi_axes, domain.side), ([1.5, 1.0], Side::Outside));
}

#[test]
fn functions_know_x_y_r_and_the_parameters() {
    let lemma = "kind = \"boundary-interpolation\"\nsemi_axes = [1, 1]\nfunction = \"r^alpha + x*y\"";
    let text = GOOD
        .replace("kind = \"strip\"\nsemi_axes = [1.5, 1]\nside = \"outside\"", lemma)
        .replace("lemma-3-4", "lemma-3-2")
        .replace("[levels]", "[parameters]\nalpha = 2\n[levels]");
    let case = parse(&text).unwrap_or_else(|e| panic!("{e}")).cases.remove(0);
    assert_eq!(case.reference, ReferencePlan::Exact);
    let Subject::Lemma(Lemma::BoundaryInterpolation { function, .. }) = &case.subject else { panic!("no function") };
    let x = signorini_contact::Point::new(0.3, 0.4);
    let known = (x - function.origin).norm_squared() + 0.3 * 0.4;
    assert!((function.value(x) - known).abs() < 1e-15);
    // an angle of 20° on the disc: one third of the side of a hexagon
    assert!((function.angle - std::f64::consts::PI / 9.0).abs() < 1e-14);
}

#[test]
fn the_fingerprint_sees_what_is_measured() {
    let print = |old: &str, new: &str| parse(&GOOD.replacen(old, new, 1)).unwrap().cases[0].fingerprint();
    let original = print("x", "x");
    assert_eq!(print("title = \"t\"", "title = \"u\""), original);
    for (old, new) in [("1.5, 1]", "1.5, 1.25]"), ("outside", "inside"), ("[4, 8, 16]", "[4, 8]")] {
        assert_ne!(print(old, new), original, "{new}");
    }
}

#[test]
fn every_error_names_its_place_and_a_next_step() {
    let strip = "kind = \"strip\"\nsemi_axes = [1.5, 1]\nside = \"outside\"";
    let function = "kind = \"boundary-interpolation\"\nsemi_axes = [1, 1]\nfunction = \"r + z\"";
    let interval = "kind = \"inverse-inequality\"\ninterval = [1, 1]\nnorms = \"full\"\nseed = 1";
    let no_seed = "kind = \"inverse-inequality\"\ninterval = [0, 1]\nnorms = \"full\"";
    // what is replaced, by what; the place in the new text and the complaint
    let table = [
        ("\"strip\"", "\"stripe\"", "\"stripe\"", "unknown variant `stripe`"),
        ("\"outside\"", "\"around\"", "\"around\"", "unknown variant `around`"),
        ("[1.5, 1]", "[1, 1.5]", "[1, 1.5]", "0 < b ≤ a ≤ 3 b must hold"),
        ("[1.5, 1]", "[4, 1]", "[4, 1]", "semi-axes 4 and 1"),
        ("[1.5, 1]", "[0, 0]", "[0, 0]", "semi-axes 0 and 0"),
        ("semi_axes = [1.5, 1]\n", "", "[lemma]", "needs `semi_axes`"),
        ("side = \"outside\"\n", "", "[lemma]", "needs `side`"),
        ("side = \"outside\"", "side = \"outside\"\nseed = 1", "1\n\n[levels]", "`seed` says nothing"),
        (strip, function, "z\"\n", "expression `r + z`"),
        (strip, interval, "[1, 1]\nnorms", "has no length"),
        (strip, no_seed, "[lemma]", "needs `seed`"),
        ("[4, 8, 16]", "[4, 8, 12]", "[4, 8, 12]", "level 12: the coarse sides are halved"),
        ("[levels]", "[contact]\nalong = [[0, 0], [1, 0]]\n[levels]", "[[0, 0]", "[contact] beside [lemma]"),
        ("[levels]", "[exact]\nbuiltin = \"P\"\n[levels]", "[exact]", "[exact] beside [lemma]"),
        ("[levels]", "[family]\nname = \"structured\"\n[levels]", "[family]", "[family] beside [lemma]"),
        ("lemma-3-4", "lemma-3-2", "\"small\"", "judges `boundary_l2`, and this lemma measures `constant`"),
    ];
    for (old, new, place, complaint) in table {
        assert_eq!(GOOD.matches(old).count(), 1, "{old}");
        let text = GOOD.replacen(old, new, 1);
        let e = parse(&text).err().unwrap_or_else(|| panic!("accepted: {new}"));
        let at = text.find(place).unwrap_or_else(|| panic!("{place} is not in the text"));
        let line = text[..at].matches('\n').count() + 1;
        assert!(e.message.contains(complaint), "{new}: {e}");
        assert!(e.position.as_ref().is_some_and(|p| p.line == line) && !e.next.is_empty(), "{new}: {e}");
    }
}

#[test]
fn a_contact_problem_has_no_constant_of_a_lemma() {
    let text = super::malformed::GOOD.replacen("theorem-3-1", "lemma-3-4", 1);
    let e = parse(&text).err().unwrap();
    assert!(e.message.contains("which only a lemma measures"), "{e}");
}
