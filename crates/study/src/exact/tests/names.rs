//! The registry: names, parameters, ranges and their messages.

use super::*;
use crate::exact::{BUILT_INS, Expressions, sobolev_order};

fn message(name: &str, list: &[(&str, f64)]) -> String {
    match built_in(name, &parameters(list), PAIRS[0]) {
        Ok(_) => panic!("{name} {list:?} is accepted"),
        Err(text) => text,
    }
}

#[test]
fn every_listed_solution_can_be_built() {
    for b in BUILT_INS {
        let alpha = parameters(&[("alpha", 1.5)]);
        let given = if b.name.ends_with('R') { alpha } else { BTreeMap::new() };
        assert!(built_in(b.name, &given, PAIRS[0]).is_ok(), "{}", b.name);
        for p in b.parameters {
            assert!(p.meaning.contains(p.name) || p.meaning.contains("exponent"));
        }
    }
}

#[test]
fn mistakes_are_named_with_what_is_allowed() {
    for (name, list, part) in [
        ("p", &[][..], "did you mean P? known: P, W, R"),
        ("tile", &[], "did you mean tiles?"),
        ("R", &[], "parameter alpha is missing; allowed: alpha"),
        ("R", &[("alhpa", 1.0)], "did you mean alpha?"),
        ("R", &[("alpha", 2.0)], "alpha = 2 must satisfy 0 < alpha < 2"),
        ("R", &[("alpha", f64::NAN)], "alpha = NaN"),
        ("W", &[("alpha", 1.0)], "no parameters are allowed"),
        ("P", &[("k", 2.0)], "k = 2 must satisfy 2 < k ≤ 12"),
        ("P", &[("m", 13.0)], "1 < m ≤ 12"),
        ("many-switches", &[("cells", 2.5)], "be whole"),
        ("many-switches", &[("cells", 0.0)], "1 ≤ cells"),
        ("tiles", &[("tiles", 3.0), ("smallest", 0.1)], "exclude each other"),
        ("tiles", &[("tiles", 25.0)], "1 ≤ tiles ≤ 24"),
        ("tiles", &[("smallest", 1e-9)], "≤ smallest"),
        ("tiles", &[("power", 0.5)], "0.5 < power ≤ 2"),
        ("arcp", &[], "did you mean arcP?"),
        ("arcP", &[("alpha", 1.0)], "no parameters are allowed"),
        ("arcR", &[], "parameter alpha is missing; allowed: alpha"),
        ("arcR", &[("alpha", 2.5)], "alpha = 2.5 must satisfy 0 < alpha < 2"),
        ("graphP", &[("gap", 3.0)], "gap = 3 must satisfy 0 ≤ gap ≤ 2 and be whole"),
        ("graphP", &[("gap", 0.5)], "be whole"),
        ("graphR", &[("gap", 1.0)], "parameter alpha is missing"),
        ("graphR", &[("alpha", 0.0)], "alpha = 0 must satisfy 0 < alpha < 2"),
        ("graphR", &[("alpha", 1.0), ("shape", 1.0)], "unknown parameter shape"),
    ] {
        let text = message(name, list);
        assert!(text.contains(part), "{name} {list:?}: {text}");
    }
}

#[test]
fn the_smallest_admissible_mesh_size_gives_an_admissible_number_of_tiles() {
    made("tiles", &[("smallest", 1e-6)], PAIRS[0]);
    made("tiles", &[("smallest", 1.0)], PAIRS[0]);
}

#[test]
fn sobolev_orders_follow_the_parameters() {
    for (name, list, s) in [
        ("P", &[][..], Some(2.5)),
        ("P", &[("k", 2.75)], Some(2.25)),
        ("P", &[("k", 5.0), ("m", 3.0)], Some(3.5)),
        ("W", &[], Some(2.5)),
        ("R", &[("alpha", 0.5)], Some(1.5)),
        ("many-switches", &[], Some(2.5)),
        ("tiles", &[], Some(2.0)),
        ("tiles", &[("power", 1.5)], Some(2.5)),
        ("corner-patch-1", &[], None),
        ("arcP", &[], Some(2.5)),
        ("arcR", &[("alpha", 0.75)], Some(1.75)),
        ("graphP", &[("gap", 2.0)], Some(2.5)),
        ("graphR", &[("alpha", 1.5)], Some(2.5)),
    ] {
        assert_eq!(sobolev_order(name, &parameters(list)), Ok(s), "{name}");
    }
    assert!(sobolev_order("Q", &BTreeMap::new()).is_err());
}

#[test]
fn a_wrong_component_is_named() {
    let error = Expressions::parse([["x", "y"], ["x", "yy"]], &BTreeMap::new()).unwrap_err();
    let shown = error.to_string();
    assert!(shown.starts_with("u_2 of Ω'': unknown name `yy`"), "{shown}");
}
