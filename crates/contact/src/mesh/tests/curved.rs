//! Bodies with curved sides: a disc in a frame (one common arc) and two graphs across a gap.

use super::{part, points};
use crate::Point;
use crate::geometry::{CircularArc, ContactLine, Graph, GraphFn, Path, SharedCurve, Vec2, tangent_of};
use crate::mesh::blocks::{Pattern, QuadBlock, triangulate};
use crate::mesh::{Body, Hierarchy, Mesh, PartOutline};
use crate::zone::Zone;
use std::f64::consts::PI;
use std::sync::Arc;

fn quarter_circle() -> SharedCurve {
    Arc::new(CircularArc { centre: Point::zeros(), radius: 1.0, from: 0.0, to: 0.5 * PI })
}

/// `{x, y > 0, x + y > 1/2, r < 1}` inside, `(0, 2)²` minus the disc outside.
pub(super) fn disc(n: usize) -> Mesh {
    let arc = quarter_circle();
    let c = 0.5f64.sqrt();
    let block = |corners: [[f64; 2]; 4], cells, side: usize| {
        let mut curves: [Option<SharedCurve>; 4] = Default::default();
        curves[side] = Some(arc.clone());
        QuadBlock { curves, ..QuadBlock::straight(points(corners), cells) }
    };
    let inside = [block([[0.5, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.5]], [n, 2 * n], 1)];
    let outside = [
        block([[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [c, c]], [n, n], 3),
        block([[c, c], [2.0, 2.0], [0.0, 2.0], [0.0, 1.0]], [n, n], 3),
    ];
    let parts = [
        part(Body::First, "rest", [[0.0, 1.0], [0.0, 0.5], [0.5, 0.0], [1.0, 0.0]]),
        part(Body::Second, "rest", [[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 1.0]]),
    ];
    let bodies =
        [triangulate(&inside, Pattern::Structured).unwrap(), triangulate(&outside, Pattern::Structured).unwrap()];
    Mesh::build(bodies, &parts, &ContactLine::Common(Path::along(arc))).unwrap()
}

fn graph(a: f64, b: f64, from: f64) -> SharedCurve {
    let function: GraphFn = Arc::new(move |y| [a * y * y + b * y, 2.0 * a * y + b, 2.0 * a]);
    Arc::new(Graph { function, name: format!("{a} η² + {b} η"), direction: Vec2::x(), from, to: -from })
}

/// `x = y²/4 + y/20` on the right, `x = −3y²/20 + y/20` on the left, `|y| < 1`.
pub(super) fn gap(n: usize) -> Mesh {
    let (right, left) = (graph(0.25, 0.05, 1.0), graph(-0.15, 0.05, -1.0));
    let corner = |c: &SharedCurve, s: f64| [c.point(s).x, c.point(s).y];
    let [a, b] = [corner(&right, 1.0), corner(&right, 0.0)];
    let [c, d] = [corner(&left, 0.0), corner(&left, 1.0)];
    let block = |corners, side: usize, curve: &SharedCurve| {
        let mut curves: [Option<SharedCurve>; 4] = Default::default();
        curves[side] = Some(curve.clone());
        [QuadBlock { curves, ..QuadBlock::straight(points(corners), [n, n]) }]
    };
    let bodies = [
        triangulate(&block([a, [2.0, -1.0], [2.0, 1.0], b], 3, &right), Pattern::Structured).unwrap(),
        triangulate(&block([[-2.0, -1.0], c, d, [-2.0, 1.0]], 1, &left), Pattern::Structured).unwrap(),
    ];
    let parts = [
        part(Body::First, "rest", [a, [2.0, -1.0], [2.0, 1.0], b]),
        part(Body::Second, "rest", [d, [-2.0, 1.0], [-2.0, -1.0], c]),
    ];
    let line = ContactLine::Gap { curves: [right, left], direction: Vec2::x() };
    Mesh::build(bodies, &parts, &line).unwrap()
}

/// Areas of `Ω'` and `Ω''`, summed with a compensated sum: what is tested is the areas, not the rounding of the sum.
fn areas(mesh: &Mesh) -> [f64; 2] {
    Body::BOTH.map(|body| {
        let own = (0..mesh.triangles.len()).filter(|&t| mesh.body(t) == body).map(|t| mesh.area(t));
        let (sum, rest) = own.fold((0.0, 0.0), |(sum, rest): (f64, f64), area| {
            let next = sum + (area + rest);
            (next, (area + rest) - (next - sum))
        });
        sum + rest
    })
}

fn refined(mesh: Mesh, times: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh);
    (0..times).for_each(|_| hierarchy.refine());
    hierarchy
}

#[test]
fn areas_of_every_mesh_sum_to_the_exact_ones() {
    // a quarter disc minus a triangle, a square minus a quarter disc
    let exact = [0.25 * PI - 0.125, 4.0 - 0.25 * PI];
    for n in [1, 2, 3, 7] {
        for mesh in refined(disc(n), 3).levels() {
            let found = areas(mesh);
            assert!((0..2).all(|b| (found[b] - exact[b]).abs() < 1e-14 * 4.0), "{found:?} {exact:?}");
        }
    }
    // ∫ (2 − f') dη, ∫ (f'' + 2) dη
    let exact = [4.0 - 1.0 / 6.0, 4.0 - 0.1];
    for mesh in refined(gap(3), 3).levels() {
        let found = areas(mesh);
        assert!((0..2).all(|b| (found[b] - exact[b]).abs() < 1e-14 * 4.0), "{found:?} {exact:?}");
    }
}

#[test]
fn nodes_of_refined_meshes_lie_on_the_curve_and_partners_coincide() {
    let hierarchy = refined(disc(2), 3);
    for (level, mesh) in hierarchy.levels().iter().enumerate() {
        assert_eq!(mesh.contact.len(), 4 << level);
        assert_eq!(mesh.curved.sides.len(), 2 * mesh.contact.len());
        for side in &mesh.contact {
            for end in 0..2 {
                let [x, y] = [side.first, side.second].map(|s| mesh.points[s[end] as usize]);
                assert!(x == y && (x.norm() - 1.0).abs() < 1e-15);
            }
        }
        // every curved side belongs to the triangle that says so, and its parameters to its ends
        for (t, triangle) in mesh.curved_triangles() {
            assert!(mesh.curved.of(t).is_some());
            let [_, a, b] = triangle.from_apex();
            assert!((triangle.arc(0.0).0 - a).norm() < 1e-15 && (triangle.arc(1.0).0 - b).norm() < 1e-15);
        }
        assert!(mesh.curved.sides.is_sorted_by_key(|s| s.triangle));
    }
}

#[test]
fn normals_on_an_arc_are_those_of_the_circle_and_masses_sum_to_its_length() {
    let hierarchy = refined(disc(2), 1);
    let mesh = hierarchy.finest();
    let zone = Zone::new(mesh);
    assert_eq!(zone.pairs.len(), 9);
    let mut length = 0.0;
    for pair in &zone.pairs {
        let [constraint] = pair.constraints[..] else { panic!("one constraint at {pair:?}") };
        assert!((constraint.normal - mesh.points[pair.first as usize]).norm() < 1e-14);
        assert_eq!(constraint.gap, 0.0);
        length += constraint.mass;
    }
    assert!((length - 0.5 * PI).abs() < 1e-14);
}

#[test]
fn across_a_gap_partners_share_eta_and_constraints_know_the_gap() {
    let hierarchy = refined(gap(3), 2);
    let mesh = hierarchy.finest();
    let zone = Zone::new(mesh);
    assert_eq!(zone.pairs.len(), 13);
    for pair in &zone.pairs {
        let [x, y] = [pair.first, pair.second].map(|i| mesh.points[i as usize]);
        assert!((x.y - y.y).abs() < 1e-15);
        let [constraint] = pair.constraints[..] else { panic!("one constraint at {pair:?}") };
        assert_eq!(constraint.normal, Vec2::new(-1.0, 0.0));
        assert!((constraint.gap - 0.4 * x.y * x.y).abs() < 1e-15);
    }
    // measured in η
    assert!((zone.pairs.iter().map(|p| p.constraints[0].mass).sum::<f64>() - 2.0).abs() < 1e-14);
}

#[test]
fn views_of_a_contact_side_face_each_other() {
    for mesh in [disc(3), gap(3)] {
        for side in 0..mesh.contact.len() {
            let view = mesh.contact_view(side);
            for t in [0.0, 0.3, 1.0] {
                let point = view.at(t);
                match mesh.direction {
                    None => assert!((point.at[0] - point.at[1]).norm() < 1e-14),
                    Some(xi) => assert!((point.at[0] - point.at[1]).dot(&tangent_of(xi)).abs() < 1e-14),
                }
                let hats = view.sides.each_ref().map(|s| s.hats(t));
                assert!(hats.iter().all(|h| (h.iter().sum::<f64>() - 1.0).abs() < 1e-14));
                // the arc bulges out of Ω', where the apex has a negative share, and bites into Ω''
                let apex = hats.map(|h| h[2]);
                let inner = t > 0.0 && t < 1.0 && mesh.direction.is_none();
                assert!(!inner || (apex[0] < 0.0 && apex[1] > 0.0), "{apex:?}");
            }
            for (end, t) in [0.0, 1.0].into_iter().enumerate() {
                let [x, y] =
                    [mesh.contact[side].first, mesh.contact[side].second].map(|s| mesh.points[s[end] as usize]);
                assert!((view.at(t).at[0] - x).norm() < 1e-14 && (view.at(t).at[1] - y).norm() < 1e-14);
            }
        }
    }
}

#[test]
fn the_diameter_of_a_bulging_element_counts_and_chords_are_compared_with_straight_sides() {
    let mesh = disc(2);
    let quality = mesh.quality();
    let chord = 2.0 * f64::sin(PI / 16.0);
    let straight = quality.straight_over_chord.unwrap() * chord;
    assert!(quality.h >= straight && quality.straight_over_chord > Some(1.0));
    assert_eq!(super::squares(2, Pattern::Structured).build().unwrap().quality().straight_over_chord, None);
}

#[test]
fn two_curved_sides_in_one_triangle_are_refused() {
    // below its straight top a body is bounded by a circle; at the block's corner one triangle owns two sides on it
    let arc = CircularArc { centre: Point::zeros(), radius: 1.0, from: PI, to: 2.5 * PI };
    let (circle, c): (SharedCurve, f64) = (Arc::new(arc), 0.5f64.sqrt());
    let corners = [[-c, -c], [c, -c], [c, c], [-c, c]];
    let curves = [Some(circle.clone()), Some(circle.clone()), None, None];
    let first = QuadBlock { curves, ..QuadBlock::straight(points(corners), [2, 2]) };
    let second = QuadBlock::straight(points([[-c, c], [c, c], [c, 2.0], [-c, 2.0]]), [2, 2]);
    let bodies = [[first], [second]].map(|b| triangulate(&b, Pattern::Structured).unwrap());
    let along = Path {
        corners: points([corners[0], corners[1], corners[2]]).to_vec(),
        curves: vec![Some(circle.clone()), Some(circle)],
    };
    let parts = [
        PartOutline { body: Body::First, name: "arcs".into(), along },
        part(Body::First, "left", [corners[3], corners[0]]),
        part(Body::Second, "rest", [[c, c], [c, 2.0], [-c, 2.0], [-c, c]]),
    ];
    let line = ContactLine::polyline(points([corners[2], corners[3]]));
    let error = Mesh::build(bodies, &parts, &line).unwrap_err().to_string();
    assert!(error.contains("has two curved sides"), "{error}");
}
