//! Levels mapped anew: the fresh mesh itself, under other numbers, and refusals of everything that is no such mesh.

use super::curved::{disc, gap};
use super::{PATTERNS, quarter_disc, squares};
use crate::Point;
use crate::element::CurvedElement;
use crate::mesh::blocks::Pattern;
use crate::mesh::{Hierarchy, Mesh};

/// Levels of `n`, `2n`, … cells.
fn mapped(mesh: impl Fn(usize) -> Mesh, n: usize, steps: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(mesh(n));
    (1..=steps).for_each(|step| hierarchy.refine_onto(&mesh(n << step)).unwrap());
    hierarchy
}

type Scene = (&'static str, fn(usize) -> Mesh);

fn curved() -> [Scene; 4] {
    [
        ("disc", disc),
        ("gap", gap),
        ("exact", |n| quarter_disc(n, CurvedElement::default())),
        ("isoparametric", |n| quarter_disc(n, CurvedElement::Isoparametric { skew: 0.0 })),
    ]
}

/// Everything in a mesh by places instead of numbers, to the last bit, in an order of its own.
fn by_places(mesh: &Mesh) -> Vec<String> {
    let place = |i: u32| format!("{:?}{:?}", mesh.node_bodies[i as usize], mesh.points[i as usize]);
    let corners = |t: usize| {
        let mut corners = mesh.triangles[t].map(place);
        let first = (0..3).min_by_key(|&i| corners[i].clone()).unwrap();
        corners.rotate_left(first);
        format!("{:?} {corners:?}", mesh.body(t))
    };
    let curves = mesh.curved.sides.iter().map(|s| {
        let apex = place(mesh.triangles[s.triangle as usize][usize::from(s.apex)]);
        let curve = mesh.curved.curves[usize::from(s.curve)].describe();
        format!("{} {apex} {curve} {:?} {:?}", corners(s.triangle as usize), s.span, mesh.curved.element)
    });
    let sides = mesh.sides.iter().map(|s| {
        format!("{:?} {} {:?}", s.nodes.map(place), corners(s.triangle as usize), mesh.parts[usize::from(s.part)])
    });
    let mut all: Vec<String> = (0..mesh.triangles.len()).map(corners).chain(curves).chain(sides).collect();
    all.sort();
    // the contact zone has its order
    all.extend(mesh.contact.iter().map(|c| {
        let triangles = c.triangles.map(|t| corners(t as usize));
        format!("{:?} {:?} {triangles:?} {}", c.first.map(place), c.second.map(place), c.segment)
    }));
    all
}

#[test]
fn the_level_is_the_fresh_mesh_under_other_numbers() {
    for (name, mesh) in curved() {
        for n in [1, 3] {
            let hierarchy = mapped(mesh, n, 3);
            for (k, level) in hierarchy.levels().iter().enumerate() {
                let fresh = mesh(n << k);
                assert!(by_places(level) == by_places(&fresh), "{name}, {n} cells, level {k}");
                assert!(level.curved.sides.is_sorted_by_key(|s| s.triangle));
                assert_eq!((&level.direction, &level.shapes), (&fresh.direction, &None));
            }
        }
    }
}

#[test]
fn numbers_and_parents_are_those_of_the_refinement() {
    for (name, mesh) in curved() {
        let hierarchy = mapped(mesh, 2, 2);
        let mut plain = Hierarchy::new(mesh(2));
        (0..2).for_each(|_| plain.refine());
        for k in 0..=2 {
            assert_eq!(hierarchy.parents(k), plain.parents(k), "{name}");
            let (level, refined) = (&hierarchy.levels()[k], &plain.levels()[k]);
            assert_eq!((&level.triangles, &level.contact), (&refined.triangles, &refined.contact), "{name}");
            // nodes of the level below stay; not all new ones lie where the refinement puts them
            let old = hierarchy.levels()[k.saturating_sub(1)].points.len();
            assert_eq!(level.points[..old], hierarchy.levels()[k.saturating_sub(1)].points[..old], "{name}");
            assert_eq!(level.points == refined.points, k == 0, "{name}");
        }
    }
}

#[test]
fn on_squares_it_is_refinement() {
    let hierarchy = mapped(|n| squares(n, Pattern::Structured).build().unwrap(), 3, 3);
    let mut plain = Hierarchy::new(squares(3, Pattern::Structured).build().unwrap());
    (0..3).for_each(|_| plain.refine());
    for (level, refined) in hierarchy.levels().iter().zip(plain.levels()) {
        let apart = level.points.iter().zip(&refined.points).map(|(x, y)| (x - y).norm());
        assert!(apart.fold(0.0, f64::max) < 1e-15);
        let refined = Mesh { points: level.points.clone(), shapes: None, ..refined.clone() };
        assert!(*level == refined);
    }
}

/// What is said of `fresh` above the disc with two cells, which stays alone.
fn refusal(fresh: &Mesh) -> String {
    let mut hierarchy = Hierarchy::new(disc(2));
    let error = hierarchy.refine_onto(fresh).unwrap_err().to_string();
    assert!(hierarchy.levels().len() == 1 && hierarchy.finest() == &disc(2));
    error
}

#[test]
fn other_meshes_are_refused() {
    let spoilt = |spoil: fn(&mut Mesh)| {
        let mut fresh = disc(4);
        spoil(&mut fresh);
        refusal(&fresh)
    };
    let cases = [
        ("the same mesh", refusal(&disc(2)), "0 new nodes"),
        ("three times the cells", refusal(&disc(6)), "the old node 0 alone"),
        ("four times the cells", refusal(&disc(8)), "beside the new node at"),
        ("other nodes", refusal(&disc(3)), "is no node of the finer one"),
        ("a moved node", spoilt(|m| m.points[0] += Point::new(1e-9, 0.0)), "node 0 of Ω' at (0.5, 0) is no node"),
        ("a node of the other body", spoilt(|m| m.node_bodies.swap(0, 60)), "is no node"),
        ("a triangle twice", spoilt(|m| m.triangles[3] = m.triangles[2]), "triangles"),
        ("a part of another name", spoilt(|m| m.parts[0].name = "other".into()), "boundary parts"),
        ("a side of another part", spoilt(|m| m.sides[3].part = 1), "boundary parts"),
        ("a zone in another order", spoilt(|m| m.contact.swap(0, 1)), "contact zones"),
        ("a side off its curve", spoilt(|m| m.curved.sides.truncate(3)), "curved sides"),
        ("another element", spoilt(|m| m.curved.element = CurvedElement::Isoparametric { skew: 0.0 }), "curved sides"),
        ("no curve of that kind", spoilt(|m| m.curved.curves = gap(1).curved.curves), "another curve"),
    ];
    for (what, error, expected) in cases {
        assert!(error.contains(expected) && error.contains("mapped anew"), "{what}: {error}");
    }
}

#[test]
fn patterns_that_do_not_repeat_are_refused() {
    for pattern in PATTERNS {
        let mesh = |n| squares(n, pattern).build().unwrap();
        let refined = Hierarchy::new(mesh(2)).refine_onto(&mesh(4));
        assert_eq!(refined.is_ok(), pattern == Pattern::Structured, "{pattern:?}");
        assert!(refined.is_ok() || refined.unwrap_err().to_string().contains("pattern"), "{pattern:?}");
    }
}
