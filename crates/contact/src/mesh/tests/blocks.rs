use super::{PATTERNS, block, points, square};
use crate::geometry::twice_area;
use crate::mesh::Triangulation;
use crate::mesh::blocks::{Pattern, QuadBlock, graded, triangulate};
use std::collections::BTreeSet;

fn area(mesh: &Triangulation) -> f64 {
    let corners = mesh.triangles.iter().map(|t| t.map(|i| mesh.points[i as usize]));
    corners.map(|[a, b, c]| 0.5 * twice_area(a, b, c)).sum()
}

fn edges(mesh: &Triangulation) -> BTreeSet<[u32; 2]> {
    let sides = mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    sides.map(|[a, b]| [a.min(b), a.max(b)]).collect()
}

#[test]
fn the_structured_square_is_numbered_row_by_row() {
    let mesh = triangulate(&[square([0.0, 0.0], 2)], Pattern::Structured).unwrap();
    let rows = points([
        [0.0, 0.0],
        [0.5, 0.0],
        [1.0, 0.0],
        [0.0, 0.5],
        [0.5, 0.5],
        [1.0, 0.5],
        [0.0, 1.0],
        [0.5, 1.0],
        [1.0, 1.0],
    ]);
    assert_eq!(mesh.points, rows);
    assert_eq!(mesh.triangles[..4], [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]]);
}

#[test]
fn union_jack_alternates_and_criss_cross_has_centres() {
    let jack = triangulate(&[square([0.0, 0.0], 2)], Pattern::UnionJack).unwrap();
    assert!(edges(&jack).is_superset(&[[0, 4], [2, 4], [4, 6], [4, 8]].into()));
    let cross = triangulate(&[square([0.0, 0.0], 1)], Pattern::CrissCross).unwrap();
    assert_eq!(cross.points[4], points([[0.5, 0.5]])[0]);
    assert_eq!(cross.triangles, [[0, 1, 4], [1, 3, 4], [3, 2, 4], [2, 0, 4]]);
}

/// An L of three blocks, the first turned by a quarter so that shared sides run against each other.
#[test]
fn glued_blocks_fill_their_body() {
    let blocks = [
        block([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]], [3, 2]),
        block([[1.0, 0.0], [2.0, -0.5], [2.0, 1.0], [1.0, 1.0]], [4, 3]),
        block([[0.0, 1.0], [1.0, 1.0], [0.5, 2.5], [0.0, 2.0]], [2, 5]),
    ];
    for pattern in PATTERNS {
        let mesh = triangulate(&blocks, pattern).unwrap();
        let cells = 6 + 12 + 10;
        let grid = 4 * 3 + 5 * 4 + 3 * 6 - 4 - 3;
        let (per_cell, centres) = if pattern == Pattern::CrissCross { (4, cells) } else { (2, 0) };
        assert_eq!(mesh.triangles.len(), per_cell * cells, "{pattern:?}");
        assert_eq!(mesh.points.len(), grid + centres, "{pattern:?}");
        // Euler's characteristic of a disc: V − E + F = 1.
        let euler = mesh.points.len() + mesh.triangles.len() - edges(&mesh).len();
        assert_eq!(euler, 1, "{pattern:?}");
        // Shoelace by hand: 1 + 1.25 + 1.
        assert!((area(&mesh) - 3.25).abs() < 1e-14, "{pattern:?}");
    }
}

/// By hand: g = 4 and two cells, (4^½ − 1)/(4 − 1) = 1/3, so the second cell is twice the first.
#[test]
fn graded_cells_grow_by_one_factor_and_nest() {
    assert!((graded(1, 2, 4.0) - 1.0 / 3.0).abs() < 1e-15);
    for g in [0.05, 1.0, 40.0] {
        let x: Vec<f64> = (0..=8).map(|i| graded(i, 8, g)).collect();
        assert_eq!((x[0], x[8]), (0.0, 1.0));
        let growth = g.powf(0.125);
        for w in x.windows(3) {
            assert!(((w[2] - w[1]) / (w[1] - w[0]) / growth - 1.0).abs() < 1e-12, "{g}: {w:?}");
        }
        assert!((0..=8).all(|i| graded(2 * i, 16, g) == x[i]), "{g}");
        // the same nodes seen from the other end
        assert!((0..=8).all(|i| (1.0 - graded(8 - i, 8, 1.0 / g) - x[i]).abs() < 1e-14), "{g}");
    }
}

#[test]
fn blocks_that_grade_a_shared_side_alike_are_glued() {
    let left = QuadBlock { grading: [0.25, 9.0], ..square([0.0, 0.0], 4) };
    // its direction 0 → 1 runs down the shared side
    let right =
        |g: f64| QuadBlock { grading: [g, 3.0], ..block([[1.0, 1.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0]], [4, 3]) };
    let mesh = triangulate(&[left.clone(), right(1.0 / 9.0)], Pattern::CrissCross).unwrap();
    assert_eq!(mesh.points.len(), 25 + 16 + 5 * 4 - 5 + 12);
    assert!((area(&mesh) - 2.0).abs() < 1e-14);
    let heights: Vec<f64> = mesh.points.iter().filter(|p| p.x == 1.0).map(|p| p.y).collect();
    assert_eq!(heights.len(), 5);
    assert!(heights[1] - heights[0] < 0.25 * (heights[4] - heights[3]), "{heights:?}");
    let error = triangulate(&[left, right(9.0)], Pattern::Structured).unwrap_err().to_string();
    assert!(error.contains("share the side from (1, 0) to (1, 1) but grade it by 9 and"), "{error}");
}

#[test]
fn bad_blocks_are_named() {
    let good = || square([0.0, 0.0], 2);
    let refused = [
        (vec![], "needs at least one block"),
        (vec![good(), block([[1.0, 0.0], [1.0, 1.0], [2.0, 1.0], [2.0, 0.0]], [2, 2])], "block 1 runs clockwise"),
        (
            vec![block([[0.0, 0.0], [1.0, 0.0], [0.2, 0.2], [0.0, 1.0]], [1, 1])],
            "block 0 is not convex: at its corner 2, (0.2, 0.2)",
        ),
        (
            vec![block([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0]], [1, 1])],
            "block 0 is not convex: at its corner 1, (1, 0)",
        ),
        (vec![block([[0.0, 0.0], [1.0, f64::NAN], [1.0, 1.0], [0.0, 1.0]], [1, 1])], "block 0 is not convex"),
        (vec![good(), square([1.0, 0.0], 0)], "block 1 is divided into 0 × 0 cells"),
        (
            vec![good(), square([1.0, 0.0], 3)],
            "blocks 0 and 1 share the side from (1, 0) to (1, 1) but divide it into 2 and 3 cells",
        ),
        (
            vec![good(), square([1.0, 0.5], 2)],
            "the corner (1, 0.5) of block 1 lies within the side of block 0 from (1, 0) to (1, 1)",
        ),
        (vec![square([0.0, 0.0], 1 << 20)], "cells together"),
        (vec![QuadBlock { grading: [1.0, 0.0], ..good() }], "block 0 has the grading [1.0, 0.0]"),
        (vec![QuadBlock { grading: [f64::NAN, 1.0], ..good() }], "block 0 has the grading [NaN, 1.0]"),
    ];
    for (blocks, message) in refused {
        let error = triangulate(&blocks, Pattern::Structured).unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
}
