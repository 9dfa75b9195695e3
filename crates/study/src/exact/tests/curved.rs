//! The solutions on the arc and on the graphs: contact conditions, boundary values, and what they declare.

use super::*;
use crate::exact::derived::{contact_stress_at, jump_at, stress};
use crate::exact::verify::{Condition, VerifyError, Zone, verify};
use signorini_contact::geometry::{CircularArc, Graph, LinePoint, SharedCurve};
use signorini_contact::{Body, Path, Vec2};

#[test]
fn every_solution_on_curves_passes_verification() {
    for lame in PAIRS {
        for (name, list) in ON_CURVES {
            let exact = made(name, list, lame);
            let v = verify(&*exact, &materials(lame), &zone(name, list))
                .unwrap_or_else(|e| panic!("{name} {list:?} {lame:?}: {e}"));
            assert_eq!(v.points, 257);
            assert!(v.stress > 0.5 && v.displacement > 0.01, "{name}: {v:?}");
            let residuals = [v.tangential, v.reaction, v.penetration, v.tension, v.complementarity];
            assert!(residuals.iter().all(|r| *r < 1e-13), "{name} {list:?}: {v:?}");
        }
    }
}

/// The points of a zone with one piece, and the angle or height of each.
fn places(name: &str, zone: &ContactLine) -> Vec<(LinePoint, f64)> {
    let pieces = zone.pieces();
    let [first, second] = &pieces[0];
    let place = |i: u32| {
        let point = LinePoint::new([first, second], zone.direction(), (f64::from(i) + 0.37) / 101.0);
        let at = point.at[0];
        (point, if name.starts_with("arc") { at.y.atan2(at.x) } else { at.y })
    };
    (0..101).map(place).collect()
}

#[test]
fn gap_and_contact_force_are_the_stated_ones() {
    for lame in PAIRS {
        for (name, list) in ON_CURVES {
            let exact = made(name, list, lame);
            for (point, s) in places(name, &zone(name, list)) {
                let (gap, force) = gap_and_force(name, list, s);
                let g = point.gap - jump_at(&*exact, &point);
                let t = contact_stress_at(&*exact, &materials(lame)[0], &point);
                assert!((g - gap).abs() < 1e-13, "{name} {list:?} at {s}: gap {g} ≠ {gap}");
                assert!((t - force).abs() < 1e-12 * (1.0 + force.abs()), "{name} {list:?} at {s}: {t} ≠ {force}");
            }
        }
    }
}

/// `τ_rr = p`, `τ_rθ = 0` on the arc, and `τ (1, −F)ᵀ = (p, 0)ᵀ` on both graphs, with normals computed here.
#[test]
fn tractions_on_the_curves_have_the_stated_components() {
    for (name, list) in ON_CURVES {
        let exact = made(name, list, PAIRS[2]);
        for (point, s) in places(name, &zone(name, list)) {
            let (_, p) = gap_and_force(name, list, s);
            for body in Body::BOTH {
                let tau = stress(&*exact, &materials(PAIRS[2])[body.index()], body, point.at[body.index()]);
                let (normal, expected) = if name.starts_with("arc") {
                    let e_r = Vec2::new(s.cos(), s.sin());
                    (e_r, p * e_r)
                } else {
                    (Vec2::new(1.0, -shape(list).boundary(body, s)[1]), p * Vec2::x())
                };
                let t = Vec2::new(tau[0] * normal.x + tau[2] * normal.y, tau[2] * normal.x + tau[1] * normal.y);
                let error = (t - expected).norm();
                assert!(error < 1e-12 * (1.0 + p.abs()), "{name} {list:?} {body:?} at {s}: {error:e}");
            }
        }
    }
}

#[test]
fn solutions_on_curves_vanish_where_the_bodies_are_held() {
    for (name, list) in ON_CURVES {
        let exact = made(name, list, PAIRS[0]);
        for i in 0..=20 {
            let t = f64::from(i) / 20.0;
            let held: Vec<(Body, Point)> = if name.starts_with("arc") {
                let outer = [Point::new(2.0, 2.0 * t), Point::new(2.0 * t, 2.0)];
                let inner = Point::new(0.5 * t, 0.5 - 0.5 * t);
                vec![(Body::First, inner), (Body::Second, outer[0]), (Body::Second, outer[1])]
            } else {
                let y = 2.0 * t - 1.0;
                vec![(Body::First, Point::new(2.0, y)), (Body::Second, Point::new(-2.0, y))]
            };
            for (body, at) in held {
                let u = exact.value(body, at).norm();
                assert!(u < 1e-16, "{name} {list:?} {body:?} at {at:?}: {u:e}");
            }
        }
    }
}

#[test]
fn values_at_the_switch_point_itself_are_finite() {
    for (name, list) in ON_CURVES {
        let exact = made(name, list, PAIRS[0]);
        for (point, body) in exact.singular_points().into_iter().zip(Body::BOTH) {
            let u = exact.value(body, point);
            assert!(u.iter().all(|c| c.is_finite()) && u.norm() > 0.01, "{name}: {u:?}");
        }
    }
}

#[test]
fn what_quadrature_must_know_is_declared_on_curves() {
    let on_arc = Point::new(0.9f64.cos(), 0.9f64.sin());
    let p = made("arcP", &[], PAIRS[0]);
    assert!(p.singular_points().is_empty());
    assert_eq!(p.switch_points(), [on_arc]);
    let ray = p.break_lines()[0];
    // It passes both ends of the bodies, on x + y = 1/2 and on y = 2.
    assert!((ray.a.x + ray.a.y) < 0.5 && ray.b.y > 2.0 && ray.distance(on_arc) < 1e-15);
    let r = made("arcR", &[("alpha", 1.5)], PAIRS[0]);
    assert_eq!((r.singular_points(), r.break_lines().len()), (vec![on_arc], 0));

    let (low, high) = (-1.0 / 5.0f64.sqrt(), 1.0 / 3.0f64.sqrt());
    for (index, shape) in GapShape::ALL.into_iter().enumerate() {
        let gap = ("gap", index as f64);
        let on = |body, y| Point::new(shape.boundary(body, y)[0], y);
        let p = made("graphP", &[gap], PAIRS[0]);
        assert_eq!(p.switch_points(), [on(Body::First, low), on(Body::First, high)]);
        let lines: Vec<(Vec2, Vec2)> = p.break_lines().iter().map(|l| (l.a, l.b)).collect();
        assert_eq!(lines, [low, high].map(|y| (Point::new(-2.0, y), Point::new(2.0, y))));
        let r = made("graphR", &[("alpha", 1.5), gap], PAIRS[0]);
        assert_eq!(r.singular_points(), Body::BOTH.map(|b| on(b, high)));
        assert_eq!(r.switch_points(), [on(Body::First, high)]);
    }
}

/// Second derivatives jump across the declared lines and nowhere else along the zone.
#[test]
fn second_derivatives_jump_across_the_break_lines_only() {
    let across = |exact: &dyn Exact, body, at: Point, step: Vec2| {
        let (h, k) = (exact.jet2(body, at + step).hessian, exact.jet2(body, at - step).hessian);
        h.iter().flatten().flatten().zip(k.iter().flatten().flatten()).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()))
    };
    let on_ray = |exact: &dyn Exact, body, r: f64, theta: f64| {
        let e = Vec2::new(theta.cos(), theta.sin());
        across(exact, body, r * e, 1e-9 * signorini_contact::geometry::tangent_of(e))
    };
    let p = made("arcP", &[], PAIRS[0]);
    for (body, r) in [(Body::First, 0.8), (Body::Second, 1.2)] {
        assert!(on_ray(&*p, body, r, 0.9) > 0.1);
        assert!(on_ray(&*p, body, r, 0.7) < 1e-6 && on_ray(&*p, body, r, 1.2) < 1e-6);
    }
    let g = made("graphP", &[], PAIRS[0]);
    for (body, x) in [(Body::First, 0.7), (Body::Second, -0.7)] {
        let jump = |y| across(&*g, body, Point::new(x, y), 1e-9 * Vec2::y());
        assert!(jump(-1.0 / 5.0f64.sqrt()) > 0.1 && jump(1.0 / 3.0f64.sqrt()) > 0.1);
        assert!(jump(-0.8) < 1e-6 && jump(0.1) < 1e-6 && jump(0.9) < 1e-6);
    }
}

#[test]
fn every_gap_is_open_and_curved_as_its_name_says() {
    for shape in GapShape::ALL {
        let line = shape.contact_line();
        let [first, second] = &line.pieces()[0];
        let mut signs = Vec::new();
        for i in 0..=40 {
            let point = LinePoint::new([first, second], line.direction(), f64::from(i) / 40.0);
            let y = point.at[0].y;
            let [f, g] = Body::BOTH.map(|b| shape.boundary(b, y));
            let expected = [Point::new(f[0], y), Point::new(g[0], y)];
            assert!((point.at[0] - expected[0]).norm() + (point.at[1] - expected[1]).norm() < 1e-15);
            assert!(point.gap >= 0.0 && (point.gap - (f[0] - g[0])).abs() < 1e-15, "{shape:?} at {y}");
            // Each conormal is the outward normal of its own body, stretched from ds to dy.
            assert!((point.conormals[0] - Vec2::new(-1.0, f[1])).norm() < 1e-14);
            assert!((point.conormals[1] - Vec2::new(1.0, -g[1])).norm() < 1e-14);
            signs.push((f[2] - g[2]).signum());
            for body in Body::BOTH {
                let [after, at, before] = [y + 1e-4, y, y - 1e-4].map(|y| shape.boundary(body, y));
                assert!(((after[0] - before[0]) / 2e-4 - at[1]).abs() < 1e-8);
                assert!(((after[1] - before[1]) / 2e-4 - at[2]).abs() < 1e-8);
            }
        }
        let (up, down) = (signs.contains(&1.0), signs.contains(&-1.0));
        let expected = match shape {
            GapShape::Convex => (true, false),
            GapShape::Concave => (false, true),
            GapShape::BothSigns => (true, true),
        };
        assert_eq!((up, down), expected, "{shape:?}");
    }
}

fn refused(name: &str, lame: [signorini_contact::material::Lame; 2], contact: &ContactLine) -> VerifyError {
    let exact = made(name, &[], PAIRS[0]);
    verify(&*exact, &materials(lame), contact).expect_err("this solution does not belong to this zone")
}

#[test]
fn another_zone_is_refused_in_its_own_words() {
    let arc = |radius, from, to| {
        ContactLine::Common(Path::along(Arc::new(CircularArc { centre: Point::zeros(), radius, from, to })))
    };
    // The body on the wrong side, another circle, the chord.
    let right = std::f64::consts::FRAC_PI_2;
    assert_eq!(refused("arcP", PAIRS[0], &arc(1.0, right, 0.0)).condition, Condition::NoPenetration);
    refused("arcP", PAIRS[0], &arc(1.01, 0.0, right));
    let chord = ContactLine::polyline([Point::x(), Point::y()]);
    assert_eq!(refused("arcP", PAIRS[0], &chord).zone, Zone::Common);
    let materials = refused("arcP", PAIRS[1], &arc::contact_line());
    assert!(materials.to_string().contains("T'_n − T''_n = "), "{materials}");

    // The right body moved by 0.01 towards the left one.
    let ContactLine::Gap { curves: [_, left], direction } = GapShape::Convex.contact_line() else {
        panic!("graphs have a gap")
    };
    let moved: SharedCurve = Arc::new(Graph {
        function: Arc::new(|y| {
            let [f, slope, bend] = GapShape::Convex.boundary(Body::First, y);
            [f - 0.01, slope, bend]
        }),
        name: "moved".into(),
        direction,
        from: 1.0,
        to: -1.0,
    });
    let error = refused("graphP", PAIRS[0], &ContactLine::Gap { curves: [moved, left], direction });
    assert_eq!((error.condition, error.zone), (Condition::NoPenetration, Zone::Gap));
    assert!(error.to_string().contains("u''_ξ − u'_ξ − ε = "), "{error}");

    let materials = refused("graphP", PAIRS[1], &GapShape::Convex.contact_line());
    assert!(materials.to_string().contains("T'_ξ/cos α' + T''_ξ/cos α'' = "), "{materials}");
    // Another pair of graphs.
    refused("graphP", PAIRS[0], &GapShape::Concave.contact_line());
}
