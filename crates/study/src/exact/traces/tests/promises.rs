//! What the lemmas promise on the contact line, for traces, lines and materials without any symmetry.

use super::*;
use crate::exact::Exact;
use crate::exact::derived::{stress, traction};
use signorini_contact::{Body, Material, Vec2};

fn materials(lame: [Lame; 2]) -> [Material; 2] {
    lame.map(|l| Material::lame(l.lambda, l.mu).unwrap())
}

/// Traces with `#` for the parameter of the line.
const W: [&str; 2] = ["0.3*exp(#/2) - sin(3*#)", "0.2 - #^3/4 + cos(#)"];
const A: [&str; 2] = ["#/(2 + #^2)", "tanh(2*#) + 0.1"];
const STRESS: &str = "-2*pos(0.4 - #)^2 + 0.3*cos(5*#)";

fn made(line: LineText, cutoff: Option<[&str; 2]>, lame: [Lame; 2]) -> Traces {
    let all = [W[0], W[1], A[0], A[1], STRESS].map(|text| text.replace('#', line.parameter()));
    let texts = TraceTexts { line, w: [&all[0], &all[1]], a: [&all[2], &all[3]], p: &all[4], cutoff };
    traces(&texts, &[], lame)
}

fn by_hand(body: Body, t: f64) -> [f64; 3] {
    let p = -2.0 * (0.4 - t).max(0.0).powi(2) + 0.3 * (5.0 * t).cos();
    match body {
        Body::First => [0.3 * (t / 2.0).exp() - (3.0 * t).sin(), t / (2.0 + t * t), p],
        Body::Second => [0.2 - t * t * t / 4.0 + t.cos(), (2.0 * t).tanh() + 0.1, p],
    }
}

fn parameters(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..40).map(move |i| from + (to - from) * (f64::from(i) + 0.37) / 40.0)
}

fn small(error: f64, scale: f64, what: &str) {
    assert!(error.abs() <= 1e-12 * (1.0 + scale), "{what}: {error:e}");
}

#[test]
fn a_straight_line_has_trace_and_stress() {
    for cutoff in [None, Some(["2 + x - y", "3*y + 2 + sin(x)"])] {
        let exact = made(LineText::Straight, cutoff, ODD);
        for (body, x) in parameters(-1.0, 1.0).flat_map(|x| Body::BOTH.map(|b| (b, x))) {
            let (at, [w, a, p]) = (Point::new(x, 0.0), by_hand(body, x));
            let t = stress(&exact, &materials(ODD)[body.index()], body, at);
            small((exact.value(body, at) - Vec2::new(a, w)).norm(), 1.0, "trace");
            small(t[2], t[0].abs(), "τ_12");
            small(t[1] - p, t[0].abs(), "τ_22");
        }
    }
}

/// Circles of any centre and radius, and a contact zone across the angle π.
#[test]
fn an_arc_has_trace_and_stress() {
    let pi = std::f64::consts::PI;
    for (centre, radius, middle) in [((0.0, 0.0), 1.0, 0.0), ((0.7, -1.1), 2.5, 0.3), ((-3.0, 0.2), 0.25, 3.0)] {
        let centre = Point::new(centre.0, centre.1);
        let cutoff = Some(["9 - x + y*y/3", "8 + x*x + y"]);
        for lame in [[SOFT, STIFF], ODD] {
            let exact = made(LineText::Arc { centre, radius, middle }, cutoff, lame);
            for (body, theta) in
                parameters(middle - 0.7 * pi, middle + 0.7 * pi).flat_map(|t| Body::BOTH.map(|b| (b, t)))
            {
                let e = Vec2::new(theta.cos(), theta.sin());
                let along = Vec2::new(-e.y, e.x);
                let (at, [w, a, p]) = (centre + radius * e, by_hand(body, theta));
                let force = traction(&exact, &materials(lame)[body.index()], body, at, e);
                let scale = exact.jet(body, at).gradient.iter().flatten().fold(a.abs(), |m, g| m.max(g.abs()));
                small((exact.value(body, at) - w * e - a * along).norm(), scale, "trace");
                small(force.dot(&along), scale, "τ_rθ");
                small(force.dot(&e) - p, scale, "τ_rr");
            }
        }
    }
}

#[test]
fn two_graphs_have_trace_and_stress() {
    let f = ["0.6 + sin(eta)/2 + eta^3/5", "-0.3*exp(eta) - eta^2"];
    let [value, slope] = [
        |body: Body, y: f64| match body {
            Body::First => 0.6 + y.sin() / 2.0 + y.powi(3) / 5.0,
            Body::Second => -0.3 * y.exp() - y * y,
        },
        |body: Body, y: f64| match body {
            Body::First => y.cos() / 2.0 + 0.6 * y * y,
            Body::Second => -0.3 * y.exp() - 2.0 * y,
        },
    ];
    for cutoff in [None, Some(["4 - x + y/3", "5 + x"])] {
        for lame in [[SOFT, STIFF], ODD] {
            let exact = made(LineText::Graph { f }, cutoff, lame);
            for (body, y) in parameters(-1.0, 1.0).flat_map(|y| Body::BOTH.map(|b| (b, y))) {
                let (at, [w, a, p]) = (Point::new(value(body, y), y), by_hand(body, y));
                // τ (1, −F)ᵀ
                let across = Vec2::new(1.0, -slope(body, y));
                let force = traction(&exact, &materials(lame)[body.index()], body, at, across);
                let scale = exact.jet(body, at).gradient.iter().flatten().fold(a.abs(), |m, g| m.max(g.abs()));
                small((exact.value(body, at) - Vec2::new(w, a)).norm(), scale, "trace");
                small(force.x - p, scale, "force along ξ");
                small(force.y, scale, "force along η");
            }
        }
    }
}

/// `u(x) = v((x − c)/R)` has stresses `1/R` times those of `v`.
#[test]
fn a_larger_circle_is_the_unit_circle_seen_closer() {
    let (centre, radius) = (Point::new(0.4, -2.0), 3.5);
    let unit = traces(&TraceTexts { cutoff: None, ..ARC }, &[], ODD);
    let p = format!("({})/3.5", ARC.p);
    let line = LineText::Arc { centre, radius, middle: 0.0 };
    let large = traces(&TraceTexts { line, p: &p, cutoff: None, ..ARC }, &[], ODD);
    for body in Body::BOTH {
        for (x, y) in [(0.9, 0.3), (0.5, 1.2), (0.3, -0.6)] {
            let near = unit.jet(body, Point::new(x, y));
            let far = large.jet(body, centre + radius * Point::new(x, y));
            assert!((near.value - far.value).norm() < 1e-14);
            for (a, b) in near.gradient.iter().flatten().zip(far.gradient.iter().flatten()) {
                assert!((a - radius * b).abs() < 1e-13, "{a} ≠ {radius} · {b}");
            }
        }
    }
}

#[test]
fn the_cutoff_clamps_each_body_where_it_vanishes() {
    let arc = traces(&ARC, &[], [SOFT, STIFF]);
    for (body, at) in [(Body::First, (0.1, 0.4)), (Body::Second, (2.0, 0.3)), (Body::Second, (1.1, 2.0))] {
        assert!(arc.value(body, Point::new(at.0, at.1)).norm() < 1e-15);
        let bare = traces(&TraceTexts { cutoff: None, ..ARC }, &[], [SOFT, STIFF]);
        assert!(bare.value(body, Point::new(at.0, at.1)).norm() > 1e-3);
    }
}

#[test]
fn points_and_breaks_lie_where_the_parameter_says() {
    let near = |a: Point, x: f64, y: f64| assert!((a - Point::new(x, y)).norm() < 1e-15, "{a:?} ≠ ({x}, {y})");

    let centre = Point::new(1.0, 2.0);
    let mut arc = made(LineText::Arc { centre, radius: 2.0, middle: 0.0 }, None, ODD);
    let quarter = std::f64::consts::FRAC_PI_2;
    (arc.switches, arc.singular, arc.breaks, arc.reach) = (vec![quarter], vec![0.0], vec![quarter], 5.0);
    near(arc.switch_points()[0], 1.0, 4.0);
    near(arc.singular_points()[0], 3.0, 2.0);
    let ray = arc.break_lines()[0];
    near(ray.a, 1.0, 2.0);
    near(ray.b, 1.0, 9.0);

    let mut graph = made(LineText::Graph { f: ["1 + eta", "-eta^2"] }, None, ODD);
    (graph.switches, graph.singular, graph.breaks, graph.reach) = (vec![0.5], vec![0.5], vec![0.5], 3.0);
    near(graph.switch_points()[0], 1.5, 0.5);
    let both = graph.singular_points();
    assert_eq!(both.len(), 2);
    near(both[1], -0.25, 0.5);
    let level = graph.break_lines()[0];
    near(level.a, -3.25, 0.5);
    near(level.b, 4.5, 0.5);
}
