use super::{kinked, points, square, squares};
use crate::mesh::blocks::{Pattern, triangulate};
use crate::mesh::hash::Fnv1a;
use crate::mesh::quality::largest_cotangent;
use crate::mesh::{Body, Mesh};

#[test]
fn squares_have_known_quality() {
    let root2 = std::f64::consts::SQRT_2;
    for n in [1, 3, 8] {
        let side = 1.0 / n as f64;
        let table =
            [(Pattern::Structured, root2 * side), (Pattern::UnionJack, root2 * side), (Pattern::CrissCross, side)];
        for (pattern, h) in table {
            let q = squares(n, pattern).build().unwrap().quality();
            assert!((q.h - h).abs() < 1e-15, "{pattern:?} {q:?}");
            assert!((q.min_angle - 45.0).abs() < 1e-12, "{pattern:?} {q:?}");
            assert!((q.side_ratio - root2).abs() < 1e-13, "{pattern:?} {q:?}");
        }
    }
}

#[test]
fn angles_of_known_triangles() {
    let root3 = 3.0_f64.sqrt();
    let angle = |xy| f64::atan2(1.0, largest_cotangent(points(xy))).to_degrees();
    assert!((angle([[0.0, 0.0], [2.0, 0.0], [1.0, root3]]) - 60.0).abs() < 1e-12);
    assert!((angle([[0.0, 0.0], [0.0, -1.0], [root3, 0.0]]) - 30.0).abs() < 1e-12);
    assert_eq!(angle([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]]), 0.0, "clockwise");
    assert_eq!(angle([[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), 0.0, "flat");
}

/// The longest and the shortest side may belong to different bodies.
#[test]
fn the_side_ratio_spans_both_bodies() {
    let mut scene = squares(2, Pattern::Structured);
    let upper = super::QuadBlock { cells: [2, 10], ..square([0.0, 0.0], 1) };
    scene.bodies[0] = triangulate(&[upper], Pattern::Structured).unwrap();
    let q = scene.build().unwrap().quality();
    // Longest: a diagonal of Ω'', √½; shortest: an upright side of Ω', 1/10.
    assert!((q.side_ratio - 50.0_f64.sqrt()).abs() < 1e-12);
}

/// Published values of FNV-1a with 64 bits.
#[test]
fn fnv_matches_its_published_values() {
    let table = [("", 0xcbf29ce484222325), ("a", 0xaf63dc4c8601ec8c), ("foobar", 0x85944171f73967e8)];
    for (text, value) in table {
        let mut hash = Fnv1a::default();
        hash.bytes(text.as_bytes());
        assert_eq!(hash.0, value, "{text}");
    }
}

/// The value was computed by a second program from the description alone.
#[test]
fn hashes_are_stable() {
    assert_eq!(squares(2, Pattern::Structured).build().unwrap().hash(), "6f34566395359f58");
}

#[test]
fn the_hash_sees_every_change() {
    let mesh = kinked(2, Pattern::Structured).build().unwrap();
    assert_eq!(mesh.hash(), mesh.clone().hash());
    let changes: [fn(&mut Mesh); 12] = [
        |m| m.points[3].x += f64::EPSILON,
        |m| m.points.swap(0, 1),
        |m| m.node_bodies[0] = Body::Second,
        |m| m.triangles[1].rotate_left(1),
        |m| m.triangles.swap(0, 1),
        |m| m.first_triangles -= 1,
        |m| m.sides[0].part += 1,
        |m| m.sides[0].triangle += 1,
        |m| m.parts[0].name.push('x'),
        |m| m.parts[0].body = Body::Second,
        |m| m.contact[0].segment += 1,
        |m| m.contact[1].second[0] += 1,
    ];
    for (k, change) in changes.into_iter().enumerate() {
        let mut other = mesh.clone();
        change(&mut other);
        assert_ne!(other.hash(), mesh.hash(), "change {k}");
    }
}
