//! Both curved elements by property, bulging and bitten, on a circle and on a graph: nodality, partition of unity, gradients
//! against differences, exact areas, rigid motions without energy, linear functions reproduced.

use super::*;
use crate::geometry::{CircularArc, Curve, Graph, GraphFn};
use crate::material::{Plane, contract};
use std::sync::Arc;

const ELEMENTS: [CurvedElement; 3] =
    [CurvedElement::Physical, CurvedElement::Isoparametric { skew: 0.0 }, CurvedElement::Isoparametric { skew: 0.2 }];

fn circle() -> CircularArc {
    CircularArc { centre: Point::zeros(), radius: 1.0, from: 0.2, to: 1.1 }
}

fn graph() -> Graph {
    let function: GraphFn = Arc::new(|y: f64| [y.sin(), y.cos(), -y.sin()]);
    Graph { function, name: "sin".into(), direction: Vec2::x(), from: 0.5, to: 1.3 }
}

/// A triangle on the left (bulging) or on the right (bitten) of a convex arc, each with every choice of the apex.
fn triangles(curve: &dyn Curve) -> Vec<CurvedTriangle<'_>> {
    let mut all = Vec::new();
    for (outside, span) in [(0.0, [0.0, 0.7]), (1.0, [0.7, 0.0])] {
        let middle = curve.point(0.4);
        let apex_point = middle + (outside * 2.0 - 1.0) * 0.9 * curve.normal(0.4);
        let from_apex = [apex_point, curve.point(span[0]), curve.point(span[1])];
        for apex in 0..3 {
            let corners = [0, 1, 2].map(|c| from_apex[(c + 3 - apex) % 3]);
            all.extend(ELEMENTS.map(|element| CurvedTriangle { corners, apex, curve, span, element }));
        }
    }
    all
}

fn each(mut check: impl FnMut(&CurvedTriangle)) {
    triangles(&circle()).iter().for_each(&mut check);
    triangles(&graph()).iter().for_each(&mut check);
}

#[test]
fn hats_are_nodal_sum_to_one_and_their_gradients_to_zero() {
    each(|t| {
        let node = |rho: f64, tau: f64, k: usize| {
            let p = t.at(rho, tau);
            let corner = (t.apex + k) % 3;
            assert!((p.x - t.corners[corner]).norm() < 1e-14, "{t:?}");
            assert!((0..3).all(|c| (p.hats[c] - f64::from(u8::from(c == corner))).abs() < 1e-14), "{t:?}");
        };
        node(0.0, 0.3, 0);
        node(1.0, 0.0, 1);
        node(1.0, 1.0, 2);
        t.points(&mut |p, w| {
            assert!(w > 0.0 && (p.hats.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            assert!(p.gradients.iter().sum::<Vec2>().norm() < 1e-12);
        });
    });
}

#[test]
fn gradients_are_those_of_differences_along_the_map() {
    let step = 1e-6;
    each(|t| {
        for (rho, tau) in [(0.3, 0.2), (0.7, 0.9), (0.95, 0.5)] {
            let p = t.at(rho, tau);
            for (dr, dt) in [(step, 0.0), (0.0, step)] {
                let (left, right) = (t.at(rho - dr, tau - dt), t.at(rho + dr, tau + dt));
                for k in 0..3 {
                    let rise = right.hats[k] - left.hats[k];
                    assert!((rise - p.gradients[k].dot(&(right.x - left.x))).abs() < 1e-10, "{t:?}");
                }
            }
            let by = |dr: f64, dt: f64| (t.at(rho + dr, tau + dt).x - t.at(rho - dr, tau - dt).x) / (2.0 * step);
            let jacobian = crate::geometry::cross(by(step, 0.0), by(0.0, step));
            assert!((jacobian - p.jacobian).abs() < 1e-8, "{t:?}: {jacobian} {}", p.jacobian);
        }
    });
}

#[test]
fn traces_are_those_of_the_map_at_the_arc() {
    each(|t| {
        for tau in [0.0, 0.13, 0.5, 0.92, 1.0] {
            let p = t.at(1.0, tau);
            let share = t.curve.foot(p.x);
            let s = (share - t.span[0]) / (t.span[1] - t.span[0]);
            assert!((0..3).all(|k| (t.trace(s)[k] - p.hats[k]).abs() < 1e-12), "{t:?}: {:?} {:?}", t.trace(s), p.hats);
        }
    });
    // linear in the parameter for Zlámal's element; the physical one sees its apex
    let circle = circle();
    let bulging = &triangles(&circle)[..2];
    assert!(bulging[0].trace(0.5)[bulging[0].apex] < -0.01);
    assert_eq!(bulging[1].trace(0.25), [0.0, 0.75, 0.25]);
}

/// The area between a chord and its arc: `½ (φ − sin φ)` on the unit circle, `φ` the angle.
#[test]
fn areas_are_exact() {
    let (circle, angle) = (circle(), 0.7 * 0.9);
    for t in triangles(&circle) {
        let [s, a, b] = t.from_apex();
        let segment = 0.5 * (angle - f64::sin(angle)) * if t.span[0] < t.span[1] { 1.0 } else { -1.0 };
        let exact = 0.5 * twice_area(s, a, b) + segment;
        assert!((t.area() - exact).abs() < 1e-15, "{} {exact}", t.area());
        let mut by_points = 0.0;
        t.points(&mut |_, w| by_points += w);
        // the skew makes the map less smooth, its area is the same
        assert!((by_points - exact).abs() < 2e-14, "{t:?}: {by_points} {exact}");
    }
}

#[test]
fn rigid_motions_carry_no_energy_and_linear_functions_are_reproduced_where_they_should() {
    let material = Material::isotropic(1.0, 0.3, Plane::Strain).unwrap();
    each(|t| {
        let force = |u: [Vec2; 3], i: usize| -> Vec2 {
            let row = t.stiffness_row(&material, i);
            (0..3)
                .map(|k| Vec2::new(row[k][0] * u[k].x + row[k][1] * u[k].y, row[k][2] * u[k].x + row[k][3] * u[k].y))
                .sum()
        };
        let translation = [Vec2::new(0.3, -0.8); 3];
        assert!((0..3).all(|i| force(translation, i).norm() < 1e-13));
        let rotation = t.corners.map(|x| Vec2::new(-x.y, x.x));
        let linear = t.corners.map(|x| Vec2::new(0.3 * x.x - 0.2 * x.y, 0.1 * x.x + 0.7 * x.y));
        let (g, _) = gradients(t.corners);
        let strain = linear_strain(&g, linear);
        let energy: f64 = (0..3).map(|i| linear[i].dot(&force(linear, i))).sum();
        let exact = t.area() * contract(material.stress(strain), strain);
        let spin = (0..3).map(|i| force(rotation, i).norm()).fold(0.0, f64::max);
        match t.element {
            // linear functions of x are in the space: patch test to rounding
            CurvedElement::Physical => assert!(spin < 1e-13 && (energy - exact).abs() < 1e-13 * exact),
            // they are not in Zlámal's space, whose interpolant departs by the size of the bump
            CurvedElement::Isoparametric { .. } => assert!(spin > 1e-3 && (energy - exact).abs() > 1e-5),
        }
    });
}

#[test]
fn an_apex_too_near_to_the_arc_makes_the_element_fold() {
    let circle = circle();
    let span = [0.7, 0.0];
    let (a, b) = (circle.point(span[0]), circle.point(span[1]));
    let bitten = |height: f64| {
        let apex = circle.point(0.35) + height * circle.normal(0.35);
        CurvedTriangle { corners: [apex, a, b], apex: 0, curve: &circle, span, element: CurvedElement::Physical }
    };
    assert!(bitten(0.5).least_jacobian() > 0.5);
    // the tangents at the ends meet at 1/cos(0.315) − 1 = 0.052 above the circle: below that the apex does not see the arc
    assert!(bitten(0.06).least_jacobian() > 0.0 && bitten(0.045).least_jacobian() < 0.0);
}

/// From `x` back to the hat functions: the same as where `x` came from, near the apex, near the arc and on it.
#[test]
fn a_point_leads_back_to_its_coordinates() {
    each(|t| {
        for rho in [1e-6, 0.2, 0.7, 0.999, 1.0] {
            for tau in [0.0, 1e-5, 0.3, 0.8, 0.9999] {
                let p = t.at(rho, tau);
                let (hats, gradients) = t.evaluate(p.x);
                assert!((0..3).all(|k| (hats[k] - p.hats[k]).abs() < 1e-13), "{t:?} {rho} {tau}: {hats:?} {p:?}");
                let scale = p.gradients.iter().map(|g| g.norm()).fold(1.0, f64::max);
                // the bump's quotient by 1 − t loses digits towards t = 1
                let digits = 1e-13 + 1e-15 / (1.0 - rho * tau);
                assert!((0..3).all(|k| (gradients[k] - p.gradients[k]).norm() < digits * scale), "{t:?} {rho} {tau}");
                assert!(t.excess(p.x) < 1e-15, "{t:?} {rho} {tau}");
            }
        }
    });
}

/// Star coordinates are those of the physical element's map, and say how far a point lies beyond the arc.
#[test]
fn a_point_beyond_the_arc_is_outside_by_its_distance_along_the_ray() {
    each(|t| {
        let (apex, gamma) = (t.corners[t.apex], t.arc(0.37).0);
        for beyond in [-0.05, -1e-9, 1e-9, 0.03] {
            let x = gamma + beyond * (gamma - apex).normalize();
            let (rho, tau) = t.star(x);
            assert!((tau - 0.37).abs() < 1e-14 && (rho - 1.0).signum() == beyond.signum(), "{t:?} {rho} {tau}");
            assert!((t.excess(x) - beyond).abs() < 1e-15, "{t:?}: {} {beyond}", t.excess(x));
        }
        // beside the straight sides
        let beside = apex + 1.01 * (t.at(0.5, 0.0).x - apex) - 0.01 * (t.at(0.5, 1.0).x - apex);
        assert!(t.excess(beside) > 1e-3);
    });
}
