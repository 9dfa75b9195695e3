//! The terms on the zone against sums over equal steps of the angle or of `η`, with the solution's own closed forms and the
//! discrete displacement found by point location: no view of a side, no quadrature rule in common.

use super::*;
use crate::family::build_level;
use crate::sample;
use signorini_contact::Body;
use signorini_contact::mesh::locate::Locator;

/// Equal steps over the zone.
const STEPS: usize = 40_000;

/// `u_I` and a nodal field that is neither small nor smooth.
fn fields(exact: &ExactScene, mesh: &Mesh) -> [Vec<Vec2>; 2] {
    let at = |i: usize| exact.solution.value(mesh.node_bodies[i], mesh.points[i]);
    let wave = |i: usize| 0.01 * Vec2::new((7.0 * i as f64).sin(), (3.0 + 5.0 * i as f64).cos());
    let nodes = 0..mesh.points.len();
    [nodes.clone().map(at).collect(), nodes.map(|i| at(i) + wave(i)).collect()]
}

fn with_ledger(study: &str, case: &str, check: impl FnOnce(&ExactScene, &Mesh, [&[Vec2]; 2], ZoneLedger)) {
    let case = sample::case(study, case);
    let scene = case.scene().unwrap();
    let level = build_level(&case.family, &scene.domain(), &[6], 0).unwrap();
    let (mesh, exact) = (level.hierarchy.finest(), scene.exact.as_ref().unwrap());
    let [u_i, u_h] = fields(exact, mesh);
    let ledger = ZoneLedger::new(exact, mesh, &u_i, &u_h, &scene.cubature(1, false));
    check(exact, mesh, [&u_i, &u_h], ledger);
}

fn value(locator: &Locator, body: Body, x: Vec2, field: &[Vec2]) -> Vec2 {
    let found = locator.locate(body, x);
    let nodes = locator.mesh().triangles[found.triangle];
    (0..3).map(|k| found.hats[k] * field[nodes[k] as usize]).sum()
}

fn close(found: f64, sum: f64, tolerance: f64, what: &str) {
    assert!((found - sum).abs() <= tolerance * sum.abs(), "{what}: {found:e} against {sum:e}");
}

#[test]
fn on_an_arc_c_and_its_parts_are_those_of_a_sum_over_the_angle() {
    with_ledger("theorem-3-3", "structured", |_, mesh, [_, u_h], ledger| {
        let locator = Locator::new(mesh);
        let sides = mesh.contact.len();
        let width = std::f64::consts::FRAC_PI_2 / STEPS as f64;
        let normal = |angle: f64| Vec2::new(angle.cos(), angle.sin());
        let jump = |angle: f64| {
            let x = normal(angle);
            x.dot(&(value(&locator, Body::First, x, u_h) - value(&locator, Body::Second, x, u_h)))
        };
        let (mut c, mut square) = (0.0, 0.0);
        for k in 0..STEPS {
            let angle = (k as f64 + 0.5) * width;
            // the chord of the side, and the foot of the point on it
            let step = std::f64::consts::FRAC_PI_2 / sides as f64;
            let side = (angle / step).floor();
            let ends = [side * step, (side + 1.0) * step];
            let s = 0.5 + 0.5 * (angle - 0.5 * (ends[0] + ends[1])).sin() / (0.5 * step).sin();
            let nodal = (1.0 - s) * jump(ends[0]) + s * jump(ends[1]);
            let stress = -4.0 * (0.9 - angle).max(0.0).powi(2);
            c += width * stress * (nodal - jump(angle));
            square += width * (nodal - jump(angle)).powi(2);
        }
        close(ledger.c, c, 1e-4, "c");
        close(ledger.parts["nodal_minus_jump"], square.sqrt(), 1e-4, "‖Φ − U_h‖");
        let [d, n] = ["jump_minus_chord", "nodal_minus_chord"].map(|k| ledger.parts[k]);
        assert!(d > 0.0 && n > 0.0 && ledger.parts["nodal_minus_jump"] <= d + n);
    });
}

#[test]
fn across_a_gap_c_and_the_split_of_b_are_those_of_a_sum_over_eta() {
    with_ledger("theorem-3-4", "convex-structured", |_, mesh, [u_i, u_h], ledger| {
        let locator = Locator::new(mesh);
        let sides = mesh.contact.len();
        let (c1, c2) = (1.0 / 5.0f64.sqrt(), 1.0 / 3.0f64.sqrt());
        let width = 2.0 / STEPS as f64;
        let faces = |y: f64| [y * y / 4.0 + y.powi(3) / 20.0, -3.0 * y * y / 20.0];
        let gap = |y: f64| faces(y)[0] - faces(y)[1];
        // W = v''_ξ − v'_ξ
        let closing = |y: f64, v: &[Vec2]| {
            let [right, left] = faces(y);
            value(&locator, Body::Second, Vec2::new(left, y), v).x
                - value(&locator, Body::First, Vec2::new(right, y), v).x
        };
        let (mut c, mut b, mut interpolation) = (0.0, [0.0; 2], 0.0);
        for k in 0..STEPS {
            let y = -1.0 + (k as f64 + 0.5) * width;
            let stress = -12.0 * ((y + c1) * (c2 - y)).max(0.0).powi(2);
            let side = ((y + 1.0) / 2.0 * sides as f64).floor();
            let end = |i: f64| -1.0 + 2.0 * (side + i) / sides as f64;
            let switches = [-c1, c2].iter().any(|s| (end(0.0)..end(1.0)).contains(s));
            c -= width * stress * (closing(y, u_h) - gap(y)).max(0.0);
            b[usize::from(switches)] += width * stress * (closing(y, u_i) - gap(y));
            let t = (y - end(0.0)) / (end(1.0) - end(0.0));
            interpolation += width * ((1.0 - t) * gap(end(0.0)) + t * gap(end(1.0)) - gap(y)).powi(2);
        }
        assert!(ledger.c > 0.0);
        close(ledger.c, c, 1e-3, "c");
        close(ledger.parts["b_gap"], b[0], 1e-3, "b on full sides");
        close(ledger.parts["b_switch"], b[1], 1e-3, "b on switch sides");
        close(ledger.parts["gap_interpolation"], interpolation.sqrt(), 1e-4, "‖ε_I − ε‖");
    });
}
