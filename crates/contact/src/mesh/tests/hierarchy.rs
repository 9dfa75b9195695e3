use super::build::check_contact;
use super::{PATTERNS, area, kinked, square, squares};
use crate::Vec2;
use crate::geometry::Point;
use crate::mesh::blocks::{Pattern, triangulate};
use crate::mesh::{Body, Hierarchy, Mesh};
use std::collections::{BTreeMap, BTreeSet};

fn refined(coarse: Mesh, steps: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(coarse);
    (0..steps).for_each(|_| hierarchy.refine());
    hierarchy
}

/// Sides of all triangles, lower node first.
fn edges(mesh: &Mesh) -> BTreeSet<[u32; 2]> {
    let sides = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    sides.map(|[a, b]| [a.min(b), a.max(b)]).collect()
}

/// Triangles as sorted lattice points of spacing `1 / n`, body by body: free of numbering and rounding.
fn geometry(mesh: &Mesh, n: usize) -> BTreeSet<(Body, [[i64; 2]; 3])> {
    let place = |p: Point| [p.x, p.y].map(|x| (x * 2.0 * n as f64).round() as i64);
    let all = (0..mesh.triangles.len()).map(|t| {
        let mut corners = mesh.corners(t).map(place);
        corners.sort_unstable();
        (mesh.body(t), corners)
    });
    all.collect()
}

#[test]
fn refining_structured_gives_structured() {
    for n in [1, 3, 4] {
        let hierarchy = refined(squares(n, Pattern::Structured).build().unwrap(), 2);
        for (k, mesh) in hierarchy.levels().iter().enumerate() {
            let direct = squares(n << k, Pattern::Structured).build().unwrap();
            assert_eq!(geometry(mesh, n << k), geometry(&direct, n << k));
            assert_eq!(mesh.sides.len(), direct.sides.len());
            let (q, d) = (mesh.quality(), direct.quality());
            assert!((q.h - d.h).abs() + (q.min_angle - d.min_angle).abs() < 1e-12);
        }
    }
}

/// A refined criss-cross has the nodes and the shapes of the twice finer one, but half of its short diagonals turned.
#[test]
fn refining_criss_cross_keeps_nodes_and_shapes() {
    let n = 2;
    let hierarchy = refined(squares(n, Pattern::CrissCross).build().unwrap(), 1);
    let fine = hierarchy.finest();
    let direct = squares(2 * n, Pattern::CrissCross).build().unwrap();
    let places = |m: &Mesh| -> BTreeSet<_> {
        m.points.iter().map(|p| [p.x, p.y].map(|x| (x * 4.0 * n as f64) as i64)).collect()
    };
    assert_eq!(places(fine), places(&direct));
    assert_eq!(fine.triangles.len(), direct.triangles.len());
    assert!((fine.quality().h - direct.quality().h).abs() < 1e-15);
    assert!((fine.quality().min_angle - 45.0).abs() < 1e-12);
    let kept = geometry(fine, 2 * n).intersection(&geometry(&direct, 2 * n)).count();
    assert_eq!(kept, direct.triangles.len() / 2);
}

/// Numbering: the new nodes on macro-sides come first and in order; each lies in the middle of its parents.
#[test]
fn new_nodes_are_midpoints_in_the_stated_order() {
    let hierarchy = refined(kinked(1, Pattern::UnionJack).build().unwrap(), 3);
    let macro_edges: Vec<_> = edges(&hierarchy.levels()[0]).into_iter().collect();
    assert!(hierarchy.parents(0).is_empty());
    for k in 1..=3 {
        let (coarse, fine) = (&hierarchy.levels()[k - 1], &hierarchy.levels()[k]);
        assert_eq!(fine.points[..coarse.points.len()], coarse.points);
        let parents = hierarchy.parents(k);
        let distinct: BTreeSet<_> = parents.iter().copied().collect();
        assert_eq!(distinct, edges(coarse), "one new node on each side");
        assert_eq!(parents.len(), distinct.len());
        let pieces = 1 << (k - 1);
        for (e, &[a, b]) in macro_edges.iter().enumerate() {
            let [a, b] = [a, b].map(|i| coarse.points[i as usize]);
            for j in 0..pieces {
                let x = fine.points[coarse.points.len() + e * pieces + j];
                let s = (j as f64 + 0.5) / pieces as f64;
                assert!((x - (a + s * (b - a))).norm() < 1e-15, "level {k}, side {e}, piece {j}");
            }
        }
        for (i, &[a, b]) in parents.iter().enumerate() {
            let node = coarse.points.len() + i;
            assert!(a < b);
            assert_eq!(2.0 * fine.points[node], coarse.points[a as usize] + coarse.points[b as usize]);
            assert_eq!(fine.node_bodies[node], coarse.node_bodies[b as usize]);
        }
    }
}

/// Inside a macro-triangle the order is that of first visit, the same in all of them.
#[test]
fn inner_nodes_follow_the_paths() {
    let k = 2;
    let hierarchy = refined(squares(1, Pattern::Structured).build().unwrap(), k + 1);
    let (coarse, fine) = (&hierarchy.levels()[k], &hierarchy.levels()[k + 1]);
    let (paths, pieces) = (1 << (2 * k), 1 << k);
    let inside = 3 * pieces * (pieces - 1) / 2;
    let mut next = coarse.points.len() + edges(&hierarchy.levels()[0]).len() * pieces;
    for macro_triangle in 0..hierarchy.levels()[0].triangles.len() {
        let first = next;
        for t in macro_triangle * paths..(macro_triangle + 1) * paths {
            // Child 3 consists of the midpoints of sides 0, 1, 2.
            for node in fine.triangles[4 * t + 3] {
                assert!(node as usize <= next, "{node} before {next}");
                next += usize::from(node as usize == next);
            }
        }
        assert_eq!(next - first, inside);
    }
    assert_eq!(next, fine.points.len());
}

#[test]
fn children_lie_as_drawn() {
    let hierarchy = refined(kinked(2, Pattern::CrissCross).build().unwrap(), 2);
    for levels in hierarchy.levels().windows(2) {
        for t in 0..levels[0].triangles.len() {
            let c = levels[0].corners(t);
            let m = [0, 1, 2].map(|i| 0.5 * (c[(i + 1) % 3] + c[(i + 2) % 3]));
            assert_eq!(levels[1].corners(4 * t), [c[0], m[2], m[1]]);
            assert_eq!(levels[1].corners(4 * t + 1), [m[2], c[1], m[0]]);
            assert_eq!(levels[1].corners(4 * t + 2), [m[1], m[0], c[2]]);
            assert_eq!(levels[1].corners(4 * t + 3), m);
            assert_eq!(levels[0].body(t), levels[1].body(4 * t + 3));
        }
    }
}

/// What `Mesh::build` guarantees holds on every level: rebuilding from the bare triangulations gives the same boundary.
#[test]
fn refined_meshes_pass_all_checks_again() {
    for pattern in PATTERNS {
        let scene = kinked(1, pattern);
        let hierarchy = refined(scene.clone().build().unwrap(), 3);
        for mesh in hierarchy.levels() {
            let again = Mesh::build(split(mesh), &scene.parts, &scene.contact.clone().into()).unwrap();
            let place = |m: &Mesh, i: u32| [m.points[i as usize].x.to_bits(), m.points[i as usize].y.to_bits()];
            let sides = |m: &Mesh| -> BTreeMap<_, _> {
                let side = |s: &crate::mesh::BoundarySide| (s.nodes.map(|i| place(m, i)), (s.triangle, s.part));
                m.sides.iter().map(side).collect()
            };
            assert_eq!(sides(mesh), sides(&again));
            let contact =
                |m: &Mesh| -> Vec<_> { m.contact.iter().map(|c| (c.first.map(|i| place(m, i)), c.segment)).collect() };
            assert_eq!(contact(mesh), contact(&again));
            check_contact(mesh, &scene.contact);
            assert!((area(mesh, Body::First) - 2.65).abs() < 1e-13);
            assert!((area(mesh, Body::Second) - 2.35).abs() < 1e-13);
            // Two discs: V − E + F = 2.
            let euler = mesh.points.len() + mesh.triangles.len() - edges(mesh).len();
            assert_eq!(euler, 2);
        }
    }
}

/// The bodies of a mesh as bare triangulations.
fn split(mesh: &Mesh) -> [crate::mesh::Triangulation; 2] {
    let mut numbers = vec![0; mesh.points.len()];
    let mut bodies = [(); 2].map(|()| crate::mesh::Triangulation::default());
    for (i, &x) in mesh.points.iter().enumerate() {
        let body = &mut bodies[mesh.node_bodies[i].index()];
        numbers[i] = body.points.len() as u32;
        body.points.push(x);
    }
    for (t, triangle) in mesh.triangles.iter().enumerate() {
        let body = &mut bodies[mesh.body(t).index()];
        body.triangles.push(triangle.map(|i| numbers[i as usize]));
    }
    bodies
}

/// A boundary side is followed by its second half: order is kept along every polyline.
#[test]
fn boundary_sides_split_in_order() {
    let hierarchy = refined(kinked(2, Pattern::UnionJack).build().unwrap(), 2);
    for levels in hierarchy.levels().windows(2) {
        for (side, halves) in levels[0].sides.iter().zip(levels[1].sides.chunks(2)) {
            assert_eq!(halves[0].nodes[0], side.nodes[0]);
            assert_eq!(halves[0].nodes[1], halves[1].nodes[0]);
            assert_eq!(halves[1].nodes[1], side.nodes[1]);
            for half in halves {
                assert_eq!((half.part, half.triangle / 4), (side.part, side.triangle));
                let triangle = levels[1].triangles[half.triangle as usize];
                assert!(half.nodes.iter().all(|n| triangle.contains(n)));
            }
        }
    }
}

#[test]
fn linear_fields_are_prolonged_exactly() {
    let hierarchy = refined(kinked(2, Pattern::Structured).build().unwrap(), 3);
    let field = |p: &Point| Vec2::new(2.0 * p.x - 3.0 * p.y + 1.0, p.x + 0.25 * p.y);
    for from in 0..=3 {
        let coarse: Vec<_> = hierarchy.levels()[from].points.iter().map(field).collect();
        for to in from..=3 {
            let fine = hierarchy.prolong(from, to, &coarse);
            assert_eq!(fine.len(), hierarchy.levels()[to].points.len());
            for (value, x) in fine.iter().zip(&hierarchy.levels()[to].points) {
                assert!((value - field(x)).norm() < 1e-14);
            }
        }
    }
}

/// A coarse hat function prolonged twice is the same function: its values by barycentric coordinates.
#[test]
fn hat_functions_are_prolonged_as_functions() {
    let hierarchy = refined(squares(2, Pattern::UnionJack).build().unwrap(), 2);
    let (coarse, fine) = (&hierarchy.levels()[0], &hierarchy.levels()[2]);
    for node in [0, 4, 13] {
        let mut hat = vec![Vec2::zeros(); coarse.points.len()];
        hat[node] = Vec2::new(1.0, -2.0);
        let values = hierarchy.prolong(0, 2, &hat);
        for (t, triangle) in fine.triangles.iter().enumerate() {
            let macro_triangle = coarse.triangles[t >> 4];
            let [a, b, c] = coarse.corners(t >> 4);
            for &i in triangle {
                let x = fine.points[i as usize];
                let whole = crate::geometry::twice_area(a, b, c);
                let parts = [[x, b, c], [a, x, c], [a, b, x]];
                let share = parts.map(|[a, b, c]| crate::geometry::twice_area(a, b, c) / whole);
                let mine = macro_triangle.iter().position(|&m| m as usize == node);
                let exact = mine.map_or(0.0, |m| share[m]) * hat[node];
                assert!((values[i as usize] - exact).norm() < 1e-14);
            }
        }
    }
}

/// Coarse nodes and coarse sides (in two halves) are all found on the next level.
#[test]
fn levels_are_nested() {
    for pattern in PATTERNS {
        let hierarchy = refined(squares(2, pattern).build().unwrap(), 2);
        for k in 1..=2 {
            let old = hierarchy.levels()[k - 1].points.len() as u32;
            let fine = edges(&hierarchy.levels()[k]);
            for (i, &[a, b]) in hierarchy.parents(k).iter().enumerate() {
                let m = old + i as u32;
                assert!(fine.contains(&[a, m]) && fine.contains(&[b, m]));
            }
        }
    }
}

/// Several blocks and a body whose macro-sides run in all directions.
#[test]
fn a_single_macro_triangle_per_body_refines_alone() {
    let mut scene = squares(1, Pattern::Structured);
    for (body, y) in scene.bodies.iter_mut().zip([1.0, -1.0]) {
        *body = triangulate(&[square([0.0, 0.0], 1)], Pattern::Structured).unwrap();
        body.points.truncate(3);
        body.points[2] = Point::new(0.0, y);
        body.triangles = vec![if y > 0.0 { [0, 1, 2] } else { [2, 1, 0] }];
    }
    scene.parts = vec![
        super::part(Body::First, "legs", [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]),
        super::part(Body::Second, "legs", [[1.0, 0.0], [0.0, -1.0], [0.0, 0.0]]),
    ];
    let hierarchy = refined(scene.clone().build().unwrap(), 4);
    let fine = hierarchy.finest();
    // A triangle of 16 pieces per side has 17·18/2 nodes.
    assert_eq!(fine.points.len(), 2 * 17 * 18 / 2);
    assert_eq!(fine.triangles.len(), 2 * 256);
    check_contact(fine, &scene.contact);
}

/// `(Pᵀ f)·v = f·(P v)` for forces and fields without any symmetry.
#[test]
fn restriction_is_the_transpose_of_prolongation() {
    let hierarchy = refined(squares(2, Pattern::CrissCross).build().unwrap(), 2);
    let size = |level: usize| hierarchy.levels()[level].points.len();
    let field =
        |n: usize, a: f64| (0..n).map(|i| Vec2::new((a * i as f64).sin(), (1.0 + a * i as f64).cos())).collect();
    let dot = |a: &[Vec2], b: &[Vec2]| a.iter().zip(b).map(|(a, b)| a.dot(b)).sum::<f64>();
    for (from, to) in [(2, 0), (2, 1), (1, 0), (2, 2)] {
        let (forces, v): (Vec<Vec2>, Vec<Vec2>) = (field(size(from), 0.7), field(size(to), 1.3));
        let (left, right) = (hierarchy.restrict(from, to, &forces), hierarchy.prolong(to, from, &v));
        assert_eq!(left.len(), size(to));
        assert!((dot(&left, &v) - dot(&forces, &right)).abs() < 1e-12 * size(from) as f64, "{from} {to}");
    }
}
