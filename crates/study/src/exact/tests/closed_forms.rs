//! Gap, contact stress and boundary values in closed form; verification of every built-in.

use super::*;
use crate::exact::derived::{contact_stress, jump, stress};
use crate::exact::verify::verify;
use signorini_contact::{Body, Vec2};

const DOWN: Vec2 = Vec2::new(0.0, -1.0);

#[test]
fn every_solution_on_squares_passes_verification() {
    for lame in PAIRS {
        for (name, list) in ON_SQUARES {
            let exact = made(name, list, lame);
            let v =
                verify(&*exact, &materials(lame), &line()).unwrap_or_else(|e| panic!("{name} {list:?} {lame:?}: {e}"));
            assert_eq!(v.points, 257);
            assert!(v.stress > 0.0 && v.displacement > 0.0, "{name}: {v:?}");
            assert!(v.tangential < 1e-12 && v.reaction < 1e-12, "{name}: {v:?}");
        }
    }
}

#[test]
fn both_patches_pass_on_their_corners() {
    for lame in PAIRS {
        for (patch, left) in [(1, -1.0), (2, -3.0)] {
            let exact = made(&format!("corner-patch-{patch}"), &[], lame);
            let contact = corner(patch);
            let v = verify(&*exact, &materials(lame), &contact).unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(v.points, 2 * 257);
            for (side, expected) in [(0, left), (1, -1.0)] {
                let (a, b) = (contact.corners()[side], contact.corners()[side + 1]);
                let n = signorini_contact::geometry::right_normal(a, b);
                let at = 0.3 * a + 0.7 * b;
                let t = contact_stress(&*exact, &materials(lame)[0], at, n);
                assert!((t - expected).abs() < 1e-14, "patch {patch}: {t}");
                assert!(jump(&*exact, at, n).abs() < 1e-15);
            }
        }
    }
}

/// Gap and contact stress on the line against their formulas, at points on both sides of the switch.
fn compare(exact: &dyn Exact, lame: [Lame; 2], forms: impl Fn(f64) -> (f64, f64), what: &str) {
    for i in 0..101 {
        let x = (f64::from(i) + 0.37) / 101.0;
        let at = Point::new(x, 0.0);
        let (gap, pressing) = forms(x);
        let g = -jump(exact, at, DOWN);
        let t = contact_stress(exact, &materials(lame)[0], at, DOWN);
        assert!((g - gap).abs() < 1e-12, "{what} at {x}: gap {g} ≠ {gap}");
        let near = 1e-12 * (1.0 + pressing.abs());
        assert!((t - pressing).abs() < near, "{what} at {x}: {t} ≠ {pressing}");
    }
}

#[test]
fn gap_and_contact_stress_are_the_stated_ones() {
    let s = 1.0 / 6.0f64.sqrt();
    for lame in PAIRS {
        for (k, m) in [(3.0, 2.0), (4.0, 3.0), (2.6, 1.6)] {
            let p = made("P", &[("k", k), ("m", m)], lame);
            let forms = |x| (positive(x - s, k), -6.0 * positive(s - x, m));
            compare(&*p, lame, forms, "P");
        }
        for alpha in [0.4, 1.0, 1.5] {
            let r = made("R", &[("alpha", alpha)], lame);
            let forms = |x| (0.4 * positive(x - s, alpha), -2.0 * positive(s - x, alpha - 1.0));
            compare(&*r, lame, forms, "R");
        }
    }
    let w = made("W", &[], [SOFT, STIFF]);
    let forms = |x| (0.7 * positive(x - s, 1.5), -positive(s - x, 0.5));
    compare(&*w, [SOFT, STIFF], forms, "W");
}

#[test]
fn cells_have_the_stated_gap_and_contact_stress() {
    let forms = |xi: f64| {
        let p = if xi < 0.43 { -3000.0 * (xi * (0.43 - xi)).powi(2) } else { 0.0 };
        let g = if xi > 0.43 { 400.0 * ((xi - 0.43) * (1.0 - xi)).powi(3) } else { 0.0 };
        (g, p)
    };
    let n = 7.0f64;
    let many = made("many-switches", &[("cells", n)], PAIRS[2]);
    let repeated = |x: f64| {
        let (g, p) = forms((x * n).fract());
        (g * n.powf(-1.5), p * n.powf(-0.5))
    };
    compare(&*many, PAIRS[2], repeated, "many switches");

    let tiles = made("tiles", &[("beta", 0.6), ("tiles", 5.0)], PAIRS[2]);
    // Summed over all five tiles, none of them looked up.
    let summed = |x: f64| {
        let mut sum = (0.0, 0.0);
        for j in 0..5 {
            let d = 0.25 / 2.0f64.powi(j);
            let xi = (x - 1.0 / 6.0f64.sqrt() - d) / d;
            if xi > 0.0 && xi < 1.0 {
                let weight = 1.5 * (f64::from(j) + 1.0).powf(-0.6);
                let (g, p) = forms(xi);
                sum = (sum.0 + weight * d * g, sum.1 + weight * p);
            }
        }
        sum
    };
    compare(&*tiles, PAIRS[2], summed, "tiles");
}

#[test]
fn solutions_on_squares_vanish_on_the_outer_sides() {
    for (name, list) in ON_SQUARES {
        let exact = made(name, list, PAIRS[0]);
        for i in 0..=20 {
            let x = f64::from(i) / 20.0;
            let above = exact.value(Body::First, Point::new(x, 1.0));
            let below = exact.value(Body::Second, Point::new(x, -1.0));
            assert_eq!((above.norm(), below.norm()), (0.0, 0.0), "{name} at {x}");
        }
    }
}

#[test]
fn a_negative_zero_does_not_turn_a_body_over() {
    for (name, list) in ON_SQUARES {
        let exact = made(name, list, PAIRS[0]);
        for body in Body::BOTH {
            for x in [0.1, 0.3, 0.7] {
                let plus = exact.jet(body, Point::new(x, 0.0));
                let minus = exact.jet(body, Point::new(x, -0.0));
                assert_eq!(plus, minus, "{name} at {x}");
            }
        }
    }
}

#[test]
fn values_at_the_switch_point_itself_are_finite() {
    let s = Point::new(1.0 / 6.0f64.sqrt(), 0.0);
    for (name, list) in [("W", vec![]), ("R", vec![("alpha", 0.4)]), ("P", vec![])] {
        let exact = made(name, &list, PAIRS[0]);
        for body in Body::BOTH {
            let u = exact.value(body, s);
            assert!(u.iter().all(|c| c.is_finite()) && u.norm() > 0.01, "{name}: {u:?}");
        }
    }
    let jet = made("W", &[], PAIRS[0]).jet2(Body::First, s);
    assert!(jet.gradient.iter().flatten().all(|d| d.is_finite()));
    assert!(jet.hessian[0][0][0].is_infinite(), "the blow-up is not hidden");
}

/// `∫ |∇∇u_N|²` over both bodies by a midpoint rule that sees every cell with the same points.
#[test]
fn many_switches_keep_their_second_seminorm() {
    let seminorm = |n: f64| {
        let exact = made("many-switches", &[("cells", n)], PAIRS[0]);
        let (per_cell, rows) = (60, 60);
        let mut sum = 0.0;
        for i in 0..per_cell * n as usize {
            for j in 0..rows {
                let x = (i as f64 + 0.5) / (per_cell as f64 * n);
                let y = (j as f64 + 0.5) / (rows as f64 * n);
                for (body, y) in [(Body::First, y), (Body::Second, -y)] {
                    let h = exact.jet2(body, Point::new(x, y)).hessian;
                    sum += h.iter().flatten().flatten().map(|d| d * d).sum::<f64>();
                }
            }
        }
        (sum / (per_cell as f64 * n) / (rows as f64 * n)).sqrt()
    };
    let reference = seminorm(1.0);
    assert!(reference > 1.0);
    for n in [2.0, 5.0] {
        let ratio = seminorm(n) / reference;
        assert!((ratio - 1.0).abs() < 1e-9, "N = {n}: {ratio}");
    }
}

#[test]
fn the_natural_singularity_opens_as_the_constants_say() {
    let s = 1.0 / 6.0f64.sqrt();
    for lame in PAIRS {
        let w = crate::exact::Natural::new(lame);
        let factor = w.gap_factor();
        let forms = |x| (factor * positive(x - s, 1.5), -positive(s - x, 0.5));
        compare(&w, lame, forms, "W");
    }
    assert!((crate::exact::Natural::new(PAIRS[0]).gap_factor() - 0.7).abs() < 1e-15);
}

/// Without the factor `χ` and the smooth part, W is in equilibrium: near the switch point the body force stays far below
/// `r^{−1/2}`, the size of each of its terms.
#[test]
fn the_singular_part_of_w_needs_no_load() {
    let s = 1.0 / 6.0f64.sqrt();
    let w = made("W", &[], PAIRS[2]);
    let materials = materials(PAIRS[2]);
    for (dx, dy) in [(1e-6, 1e-6), (-1e-6, 1e-6), (-2e-6, 1e-7)] {
        for (body, y) in [(Body::First, dy), (Body::Second, -dy)] {
            let at = Point::new(s + dx, y);
            let material = &materials[body.index()];
            let force = crate::exact::derived::body_force(&*w, material, body, at).norm();
            let h = w.jet2(body, at).hessian;
            let term = h.iter().flatten().flatten().fold(0.0, |m: f64, d| m.max(d.abs()));
            assert!(force < 3.0 && term > 50.0, "{body:?}: {force} {term}");
        }
    }
}

#[test]
fn stress_of_a_patch_is_constant() {
    let exact = made("corner-patch-2", &[], PAIRS[2]);
    for body in Body::BOTH {
        let t = stress(&*exact, &materials(PAIRS[2])[body.index()], body, Point::new(0.3, -0.8));
        for (a, b) in t.into_iter().zip([-2.0, -2.0, -1.0]) {
            assert!((a - b).abs() < 1e-14);
        }
    }
}

#[test]
fn the_dropped_tail_is_measured() {
    let tiles = |n: f64| crate::exact::Tiles::new(1.0, 1.0, n, PAIRS[0]).unwrap();
    // Σ_{j≥J} ((j+1)^{−1} 2^{−j})² / Σ_{j≥0}, for J = 1: the whole sum is 4 Li_2(1/4), its first term 1.
    let dilogarithm: f64 = (1..60).map(|k| 0.25f64.powi(k) / f64::from(k * k)).sum();
    let expected = (1.0 - 1.0 / (4.0 * dilogarithm)).sqrt();
    assert!((tiles(1.0).dropped_share() - expected).abs() < 1e-14);
    assert!(tiles(12.0).dropped_share() < 1e-4);
    let notes = made("tiles", &[("smallest", 0.125)], PAIRS[0]).notes();
    // 2^{−j}/4 < 1/64 first at j = 5.
    assert!(notes[0].contains("after 6 tiles"), "{notes:?}");
}

#[test]
fn what_quadrature_must_know_is_declared() {
    let s = 1.0 / 6.0f64.sqrt();
    let p = made("P", &[], PAIRS[0]);
    assert!(p.singular_points().is_empty());
    let line = p.break_lines()[0];
    assert_eq!((line.a, line.b), (Point::new(s, -1.0), Point::new(s, 1.0)));
    assert_eq!(made("R", &[("alpha", 1.5)], PAIRS[0]).singular_points().len(), 1);

    let many = made("many-switches", &[("cells", 3.0)], PAIRS[0]);
    let xs: Vec<f64> = many.switch_points().iter().map(|p| p.x).collect();
    let expected = [0.43 / 3.0, 1.0 / 3.0, 1.43 / 3.0, 2.0 / 3.0, 2.43 / 3.0];
    assert_eq!(xs.len(), expected.len());
    for (a, b) in xs.iter().zip(expected) {
        assert!((a - b).abs() < 1e-15);
    }
    // the switch points, and the two edges y = ±1/N of the strip that carries the cells
    let breaks = many.break_lines();
    assert_eq!(breaks.len(), 2 + 5);
    let edges: Vec<f64> = breaks.iter().filter(|l| l.a.y == l.b.y).map(|l| l.a.y).collect();
    assert_eq!(edges, [1.0 / 3.0, -1.0 / 3.0]);
    let tiles = made("tiles", &[("tiles", 3.0)], PAIRS[0]);
    assert_eq!(tiles.break_lines().len(), 7);
    assert_eq!(tiles.switch_points().len(), 6);
}
