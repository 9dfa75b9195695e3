//! What a file means once it is resolved, and which changes its fingerprint sees.

use super::malformed::GOOD;
use crate::family::Family;
use crate::study::{PartCondition, ReferencePlan, Study};
use signorini_contact::Point;
use signorini_contact::solver::{Method, Settings};
use std::path::Path;

fn parse(text: &str) -> Study {
    Study::parse(text, Path::new("small.toml")).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn defaults_are_the_documented_ones() {
    let study = parse(&GOOD.replacen("[levels]\nquick = [8, 16, 32, 64]\n", "", 1));
    let c = &study.cases[0];
    let solver = Settings { method: Method::Automatic, ..Settings::default() };
    assert_eq!((c.family, c.solver), (Family::Structured, solver));
    assert_eq!(c.reference, ReferencePlan::Overkill { quick: 256, full: 1024 });
    assert_eq!((c.quick.as_slice(), c.full.as_slice()), (&[8, 16, 32, 64][..], &[8, 16, 32, 64, 128][..]));
    assert_eq!(study.claim.id, "theorem-3-1");
    assert!(matches!(c.scene().unwrap().parts[0].condition, PartCondition::Fixed(None)));
    assert!(c.scene().unwrap().body_force[1].is_none() && c.scene().unwrap().exact.is_none());
}

#[test]
fn expressions_become_functions_of_point_and_normal() {
    let scene = parse(GOOD).cases[0].scene().unwrap().clone();
    let force = scene.body_force[0].as_ref().unwrap();
    assert_eq!(force(Point::new(0.5, 0.1), Point::zeros()), Point::new(0.0, 0.5f64.sin()));
    let PartCondition::Traction(Some(p)) = &scene.parts[1].condition else { panic!("no traction") };
    assert_eq!(p(Point::zeros(), Point::new(0.5, -3.0)), Point::new(0.0, -0.1 * 0.5));
}

#[test]
fn parameters_of_a_case_win_over_those_of_the_study() {
    let text = GOOD
        .replacen("\"sin(x)\"", "\"a + b\"", 1)
        .replacen("[levels]", "[parameters]\na = 1\nb = 2\n[levels]", 1)
        .replacen("name = \"two\"", "name = \"two\"\nparameters = { b = 10 }", 1);
    let study = parse(&text);
    let at =
        |i: usize| study.cases[i].scene().unwrap().body_force[0].as_ref().unwrap()(Point::zeros(), Point::zeros()).y;
    assert_eq!((at(0), at(1)), (3.0, 11.0));
    assert_eq!(study.cases[1].parameters["b"], 10.0);
}

#[test]
fn an_exact_solution_by_expressions_is_differentiated() {
    let exact = "[exact]\nfirst = [\"x*y\", \"y^2\"]\nsecond = [\"0\", \"k*x\"]\nswitches = [[0.5, 0]]\n\
        breaks = [[[0.5, -1], [0.5, 1]]]\n[parameters]\nk = 4\n[levels]";
    let study = parse(&GOOD.replacen("[levels]", exact, 1));
    let c = &study.cases[0];
    assert_eq!(c.reference, ReferencePlan::Exact, "the default where there is an exact solution");
    let solution = &c.scene().unwrap().exact.as_ref().unwrap().solution;
    let [first, second] = signorini_contact::Body::BOTH.map(|b| solution.jet(b, Point::new(2.0, 3.0)));
    assert_eq!((first.value, first.gradient), (Point::new(6.0, 9.0), [[3.0, 2.0], [0.0, 6.0]]));
    assert_eq!(second.gradient, [[0.0, 0.0], [4.0, 0.0]]);
    assert_eq!((solution.switch_points().len(), solution.break_lines().len()), (1, 1));
}

#[test]
fn a_wrong_expression_of_an_exact_solution_has_its_place() {
    let exact = "[exact]\nfirst = [\"x*y\", \"y^2\"]\nsecond = [\"0\", \"x + z\"]\n[levels]";
    let text = GOOD.replacen("[levels]", exact, 1);
    let p = Study::parse(&text, Path::new("small.toml")).err().unwrap().position.unwrap();
    let line = text.lines().position(|l| l.starts_with("second")).unwrap() + 1;
    assert_eq!((p.line, p.column), (line, "second = [\"0\", \"x + z".len()));
}

#[test]
fn the_fingerprint_sees_numbers_and_not_words() {
    let print = |old: &str, new: &str| {
        assert_eq!(GOOD.matches(old).count(), 1, "{old}");
        parse(&GOOD.replacen(old, new, 1)).cases[1].fingerprint()
    };
    let original = parse(GOOD).cases[1].fingerprint();
    assert_eq!(original.len(), 16);
    let words = [
        ("title = \"t\"", "title = \"another\""),
        ("question = \"q\"", "question = \"why?\""),
        ("name = \"bottom\"", "name = \"floor\""),
        ("young = 1.0", "young = 1"),
        ("[levels]", "# a remark\n\n[levels]"),
        ("name = \"two\"", "name = \"second\""),
    ];
    for (old, new) in words {
        assert_eq!(print(old, new), original, "{new}");
    }
    let numbers = [
        ("young = 1.0", "young = 1.0000000000000002"),
        ("sin(x)", "cos(x)"),
        ("-0.1*nx", "-0.2*nx"),
        ("condition = \"fixed\"", "condition = \"sliding\""),
        ("divisions = [1, 1]", "divisions = [1, 2]"),
        ("quick = [8, 16, 32, 64]", "quick = [8, 16, 32]"),
        ("seed = 1", "seed = 2"),
        ("amount = 0.2", "amount = 0.3"),
        ("[levels]", "[reference]\nkind = \"none\"\n[levels]"),
        ("[levels]", "[solver]\nmax_steps = 3\n[levels]"),
        ("[levels]", "[gates]\nfall = 0.8\nreason = \"r\"\n[levels]"),
        ("[levels]", "[expected]\nrate = 0.5\n[levels]"),
        ("[levels]", "[parameters]\na = 1\n[levels]"),
        ("claim = \"theorem-3-1\"", "claim = \"two-squares\""),
    ];
    for (old, new) in numbers {
        assert_ne!(print(old, new), original, "{new}");
    }
}
