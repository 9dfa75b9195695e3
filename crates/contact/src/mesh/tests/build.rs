use super::{PATTERNS, area, kinked, squares};
use crate::geometry::{Point, right_normal, twice_area};
use crate::mesh::blocks::Pattern;
use crate::mesh::{Body, Mesh};

/// Counts of two `n × n` squares, known in closed form.
#[test]
fn two_squares_have_the_known_counts() {
    for n in [1, 2, 5] {
        for pattern in PATTERNS {
            let mesh = squares(n, pattern).build().unwrap();
            let (cut, centres) = if pattern == Pattern::CrissCross { (4, n * n) } else { (2, 0) };
            assert_eq!(mesh.points.len(), 2 * ((n + 1) * (n + 1) + centres));
            assert_eq!(mesh.triangles.len(), 2 * cut * n * n);
            assert_eq!(mesh.first_triangles, cut * n * n);
            assert_eq!(mesh.contact.len(), n);
            assert_eq!(mesh.sides.len(), 6 * n);
            let sides = [0, 1, 2, 3].map(|p| mesh.sides.iter().filter(|s| s.part == p).count());
            assert_eq!(sides, [n, n, n, 3 * n]);
            assert!(mesh.node_bodies.is_sorted());
        }
    }
}

#[test]
fn areas_add_up() {
    for pattern in PATTERNS {
        let mesh = kinked(5, pattern).build().unwrap();
        // Trapezia: ½(1.3 + 1.5) + ½(1.5 + 1) and ½(1.2 + 1) + ½(1 + 1.5).
        assert!((area(&mesh, Body::First) - 2.65).abs() < 1e-14);
        assert!((area(&mesh, Body::Second) - 2.35).abs() < 1e-14);
    }
}

/// Boundary sides keep their body on the left, lie on their part and belong to their triangle.
#[test]
fn boundary_sides_are_oriented() {
    let mesh = kinked(3, Pattern::UnionJack).build().unwrap();
    for side in &mesh.sides {
        let triangle = mesh.triangles[side.triangle as usize];
        let inner = triangle.into_iter().find(|i| !side.nodes.contains(i)).unwrap();
        let [a, b, c] = [side.nodes[0], side.nodes[1], inner].map(|i| mesh.points[i as usize]);
        assert!(twice_area(a, b, c) > 0.0);
        let body = mesh.parts[side.part as usize].body;
        assert_eq!(mesh.body(side.triangle as usize), body);
        assert_eq!(side.nodes.map(|i| mesh.node_bodies[i as usize]), [body; 2]);
        let outer = [a.x.abs(), b.x.abs()] == [1.0; 2] || a.y == b.y && [1.5, -1.0].contains(&a.y);
        assert!(outer, "{a} {b}");
    }
}

pub fn check_contact(mesh: &Mesh, polyline: &[Point]) {
    let mut last = (0, polyline[0]);
    for side in &mesh.contact {
        for (f, s) in side.first.into_iter().zip(side.second) {
            assert_eq!(mesh.points[f as usize], mesh.points[s as usize]);
            assert_eq!([f, s].map(|i| mesh.node_bodies[i as usize]), Body::BOTH);
        }
        let [a, b] = side.first.map(|i| mesh.points[i as usize]);
        assert!((a - last.1).norm() < 1e-15, "a gap before {a}");
        assert!(side.segment == last.0 || side.segment == last.0 + 1 && a == polyline[side.segment as usize]);
        // The side points along its segment, Ω' on the left.
        let k = side.segment as usize;
        assert!((right_normal(a, b) - right_normal(polyline[k], polyline[k + 1])).norm() < 1e-12);
        last = (side.segment, b);
    }
    assert!((last.1 - polyline[polyline.len() - 1]).norm() < 1e-15);
}

#[test]
fn contact_sides_follow_the_polyline() {
    for pattern in PATTERNS {
        let scene = kinked(4, pattern);
        let mesh = scene.clone().build().unwrap();
        assert_eq!(mesh.contact.len(), 8);
        check_contact(&mesh, &scene.contact);
    }
}

/// The order of the triangles in a body, and where its nodes are numbered from, leave the contact zone as it is.
#[test]
fn contact_sides_do_not_depend_on_the_numbering() {
    let scene = kinked(3, Pattern::Structured);
    let mesh = scene.clone().build().unwrap();
    let mut turned = scene;
    for body in &mut turned.bodies {
        body.triangles.reverse();
        body.points.reverse();
        let last = body.points.len() as u32 - 1;
        body.triangles.iter_mut().for_each(|t| *t = t.map(|i| last - i));
    }
    let places = |mesh: &Mesh| -> Vec<_> {
        mesh.contact.iter().map(|c| (c.first.map(|i| mesh.points[i as usize]), c.segment)).collect()
    };
    assert_eq!(places(&mesh), places(&turned.build().unwrap()));
}

/// Partners that differ by rounding are made equal; `Ω'` decides.
#[test]
fn partners_coincide_to_the_last_bit() {
    let mut scene = squares(3, Pattern::Structured);
    let moved = scene.bodies[1].points.iter().position(|p| p.y == 0.0 && p.x > 0.0).unwrap();
    scene.bodies[1].points[moved] += Point::new(3e-16, -2e-16);
    let contact = scene.contact.clone();
    check_contact(&scene.build().unwrap(), &contact);
}
