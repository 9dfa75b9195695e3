//! `[exact.traces]`: what good tables mean, and where bad ones are wrong.

use super::malformed::GOOD;
use crate::exact::{Exact, Polynomial};
use crate::study::{Case, ReferencePlan, Study};
use signorini_contact::{Body, Point, material::Lame};
use std::path::Path;
use std::sync::Arc;

const LINE: &str = r#"
[parameters]
s = 0.408248290463863

[exact.traces]
lemma = "line"
w = ["cos(2*x)/20 + 0.6*pos(x - s)^3", "cos(2*x)/20 - 0.4*pos(x - s)^3"]
a = ["sin(2*x)/10", "-x^2/20"]
p = "-6*pos(s - x)^2"
cutoff = ["1 - y", "1 + y"]
switches = [0.408248290463863]
breaks = [0.408248290463863]
"#;

const ARC: &str = r#"
[exact.traces]
lemma = "arc"
centre = [0, -1]
radius = 2
middle = 1.5
w = ["0.1 - pos(theta - 1)^3", "0.1"]
a = ["0", "cos(theta)"]
p = "-pos(1 - theta)^2"
switches = [1]
"#;

const GRAPH: &str = r#"
[exact.traces]
lemma = "graph"
f = ["eta^2/4", "-eta^2/8"]
w = ["0", "3*eta^2/8"]
a = ["0", "0"]
p = "-1"
singular = [0.5]
"#;

/// The small study with isotropic bodies and an exact solution.
fn text(exact: &str) -> String {
    let isotropic = GOOD.replacen("{ young = 1.0, poisson = 0.3 }", "{ lame = [1.5, 1] }", 1).replacen(
        "{ matrix = [[3, 1, 0], [1, 3, 0], [0, 0, 1]] }",
        "{ lame = [3, 2] }",
        1,
    );
    isotropic.replacen("[levels]", &format!("{}\n[levels]", exact.trim()), 1)
}

fn parse(exact: &str) -> Result<Case, crate::file::StudyError> {
    Study::parse(&text(exact), Path::new("small.toml")).map(|s| s.cases[0].clone())
}

fn solution(exact: &str) -> Arc<dyn Exact> {
    let case = parse(exact).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(case.reference, ReferencePlan::Exact);
    case.scene().unwrap().exact.as_ref().unwrap().solution.clone()
}

#[test]
fn traces_on_a_line_are_the_built_in_p() {
    let exact = solution(LINE);
    let lame = [Lame { lambda: 1.5, mu: 1.0 }, Lame { lambda: 3.0, mu: 2.0 }];
    let built = Polynomial::new(3.0, 2.0, lame).unwrap();
    for (body, x, y) in [(Body::First, 0.7, 0.3), (Body::First, 0.2, 0.9), (Body::Second, 0.6, -0.2)] {
        let difference = exact.value(body, Point::new(x, y)) - built.value(body, Point::new(x, y));
        assert!(difference.norm() < 1e-14, "{body:?}: {difference:?}");
    }
    assert!((exact.switch_points()[0].x - 0.408).abs() < 1e-3);
    // Breaks leave both bodies.
    let line = exact.break_lines()[0];
    assert!(line.a.y < -1.0 && line.b.y > 1.0, "{line:?}");
}

#[test]
fn the_documented_table_is_this_one() {
    let readme = include_str!("../../../../../studies/README.md");
    let table = LINE.split_once("[exact.traces]").unwrap().1;
    assert!(readme.contains(&format!("[exact.traces]{table}")));
}

#[test]
fn traces_on_an_arc_and_on_graphs_have_their_traces() {
    let arc = solution(ARC);
    let on = |theta: f64| Point::new(2.0 * theta.cos(), 2.0 * theta.sin() - 1.0);
    for theta in [-1.5f64, 0.3, 1.2, 4.5] {
        let e = Point::new(theta.cos(), theta.sin());
        let expected = 0.1 - (theta - 1.0).max(0.0).powi(3);
        assert!((arc.value(Body::First, on(theta)).dot(&e) - expected).abs() < 1e-13, "{theta}");
        let along = arc.value(Body::Second, on(theta)).dot(&Point::new(-e.y, e.x));
        assert!((along - theta.cos()).abs() < 1e-13, "{theta}");
    }
    assert!((arc.switch_points()[0] - on(1.0)).norm() < 1e-15);

    let graph = solution(GRAPH);
    assert!((graph.value(Body::Second, Point::new(-0.02, 0.4)) - Point::new(0.06, 0.0)).norm() < 1e-15);
    assert_eq!(graph.singular_points(), [Point::new(0.0625, 0.5), Point::new(-0.03125, 0.5)]);
}

/// The table, what is replaced, by what, and where and how the reader complains.
type Row = (&'static str, &'static str, &'static str, &'static str, &'static str);

#[rustfmt::skip]
const TABLE: &[Row] = &[
    // expressions
    (LINE, "\"-x^2/20\"", "\"-theta^2/20\"", "theta", "unknown name `theta`"),
    (LINE, "cos(2*x)/20 - ", "cos(2*y)/20 - ", "y)/20", "unknown name `y`"),
    (LINE, "\"-6*pos(s - x)^2\"", "\"-6*pos(s - x^2\"", "(s - x^2", "never closed"),
    (LINE, "\"1 + y\"", "\"1 + eta\"", "eta", "unknown name `eta`"),
    (ARC, "\"cos(theta)\"", "\"cos(x)\"", "x)", "unknown name `x`"),
    (GRAPH, "\"eta^2/4\"", "\"eta^2/4 + y\"", "y\"", "unknown name `y`"),
    // lists and numbers
    (LINE, "a = [\"sin(2*x)/10\", \"-x^2/20\"]", "a = [\"0\"]", "[\"0\"]", "invalid length 1, expected 2 entries"),
    (LINE, "breaks = [0.408248290463863]", "breaks = [[0, 1]]", "[0, 1]]", "expected a number"),
    (ARC, "centre = [0, -1]", "centre = [0]", "[0]\nradius", "invalid length 1, expected 2 entries"),
    (ARC, "radius = 2", "radius = 0", "0\nmiddle", "the radius 0 must be positive"),
    (ARC, "middle = 1.5", "middle = nan", "nan", "NaN is not a finite number"),
    // what belongs to which lemma
    (LINE, "\"line\"", "\"lines\"", "\"lines\"", "unknown variant `lines`"),
    (LINE, "cutoff", "f = [\"0\", \"0\"]\ncutoff", "[\"0\", \"0\"]", "`f` belongs to the graph lemma, not to the line lemma"),
    (LINE, "cutoff", "radius = 1\ncutoff", "1\ncutoff", "`radius` belongs to the arc lemma"),
    (GRAPH, "p = \"-1\"", "p = \"-1\"\ncentre = [0, 0]", "[0, 0]\nsingular", "`centre` belongs to the arc lemma"),
    (GRAPH, "p = \"-1\"", "p = \"-1\"\nmiddle = 0", "0\nsingular", "`middle` belongs to the arc lemma"),
    (ARC, "radius = 2\n", "", "\"arc\"", "the arc lemma needs `centre` and `radius`"),
    (ARC, "centre = [0, -1]\n", "", "\"arc\"", "the arc lemma needs `centre` and `radius`"),
    (GRAPH, "f = [\"eta^2/4\", \"-eta^2/8\"]\n", "", "\"graph\"", "the graph lemma needs `f`"),
    (LINE, "p = \"-6*pos(s - x)^2\"\n", "", "[exact.traces]", "missing field `p`"),
    (LINE, "cutoff", "slip = 3\ncutoff", "slip", "unknown field `slip`"),
    // what stands beside it
    (LINE, "[exact.traces]", "[exact]\nbuiltin = \"P\"\n[exact.traces]", "[exact]", "`first` and `second`, or `traces`"),
    (LINE, "[exact.traces]", "[exact]\nfirst = [\"0\", \"0\"]\nsecond = [\"0\", \"0\"]\n[exact.traces]", "[exact]", "or `traces`"),
    (LINE, "[exact.traces]", "[exact]\nswitches = [[0.4, 0]]\n[exact.traces]", "[exact.traces]", "knows its own singular points"),
];

#[test]
fn every_error_names_its_place_and_a_next_step() {
    let wrong: Vec<String> = TABLE.iter().filter_map(|row| checked(row).err()).collect();
    assert!(wrong.is_empty(), "{} of {}:\n\n{}", wrong.len(), TABLE.len(), wrong.join("\n\n"));
}

fn checked((good, old, new, place, complaint): &Row) -> Result<(), String> {
    assert_eq!(good.matches(old).count(), 1, "{old:?} must stand once in the good table");
    let table = good.replacen(old, new, 1);
    let whole = text(&table);
    let e = parse(&table).err().ok_or(format!("accepted: {new:?}"))?;
    let start = whole.find(table.trim()).ok_or("the table is not in the text")?;
    let at = start + whole[start..].find(place).ok_or(format!("{place:?} is not in the text with {new:?}"))?;
    let before = &whole[..at];
    let expected = (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1);
    let seen = e.position.as_ref().map(|p| (p.line, p.column));
    let good = e.message.contains(complaint) && seen == Some(expected) && !e.next.is_empty();
    if good { Ok(()) } else { Err(format!("{new:?} should complain of {complaint:?} at {expected:?}:\n{e}")) }
}

/// The lemmas are those of isotropic bodies.
#[test]
fn an_anisotropic_body_is_refused() {
    let whole = GOOD.replacen("[levels]", &format!("{}\n[levels]", GRAPH.trim()), 1);
    let e = Study::parse(&whole, Path::new("small.toml")).err().unwrap();
    assert!(e.message.contains("isotropic bodies only"), "{e}");
    assert!(e.position.unwrap().source.contains("lemma = \"graph\""));
}

#[test]
fn the_fingerprint_sees_every_entry() {
    let print = |table: &str| parse(table).unwrap_or_else(|e| panic!("{e}")).fingerprint();
    for (good, old, new) in [
        (LINE, "0.6*pos", "0.7*pos"),
        (LINE, "\"-x^2/20\"", "\"-x^2/21\""),
        (LINE, "-6*pos", "-7*pos"),
        (LINE, "\"1 + y\"", "\"1 + y/2\""),
        (LINE, "cutoff = [\"1 - y\", \"1 + y\"]\n", ""),
        (LINE, "switches = [0.408248290463863]", "switches = [0.4]"),
        (LINE, "breaks = [0.408248290463863]", "breaks = [0.4]"),
        (ARC, "centre = [0, -1]", "centre = [0, -2]"),
        (ARC, "radius = 2", "radius = 3"),
        (ARC, "middle = 1.5", "middle = 1"),
        (GRAPH, "-eta^2/8", "-eta^2/9"),
        (GRAPH, "singular = [0.5]", "singular = [0.25]"),
        (GRAPH, "singular = [0.5]", "switches = [0.5]"),
        (GRAPH, "singular = [0.5]", "breaks = [0.5]"),
    ] {
        assert_eq!(good.matches(old).count(), 1, "{old:?} must stand once");
        assert_ne!(print(&good.replacen(old, new, 1)), print(good), "{new}");
    }
    assert_eq!(print(&GRAPH.replacen("p = ", "# a remark\np = ", 1)), print(GRAPH));
}
