//! The zone out of a file: partners, corners, curves.

use super::super::MshError;
use super::super::body::BodyMesh;
use super::super::chain::{along, rows, straight};
use super::super::zone::{Faces, zone};
use super::*;
use signorini_contact::Point;
use signorini_contact::geometry::{CircularArc, Path, SharedCurve};
use std::sync::Arc;

fn faces(first: &str, second: &str) -> Faces {
    Faces { groups: [first.into(), second.into()], curve: None }
}

fn bodies(msh: &Msh, names: [&str; 2]) -> [BodyMesh; 2] {
    names.map(|n| BodyMesh::new(msh, n).unwrap())
}

fn dovetail_zone(msh: &Msh) -> Result<(Path, [BodyMesh; 2]), MshError> {
    let mut bodies = bodies(msh, ["tongue", "groove"]);
    zone(msh, &mut bodies, &[faces("tongue-face", "groove-face")]).map(|path| (path, bodies))
}

/// The node of a body at a place.
fn node(msh: &Msh, body: &str, x: Point) -> u64 {
    let body = BodyMesh::new(msh, body).unwrap();
    let found = body.mesh.points.iter().position(|p| (p - x).norm() < 1e-9).unwrap();
    body.tags[found]
}

#[test]
fn the_zone_runs_from_corner_to_corner_with_the_first_body_on_its_left() {
    let (path, _) = dovetail_zone(&dovetail()).unwrap();
    let corners: Vec<[f64; 2]> = path.corners.iter().map(|p| [p.x, p.y]).collect();
    assert_eq!(corners, [[-0.5, 0.0], [-1.0, -1.0], [1.0, -1.0], [0.5, 0.0]]);
    assert!(!path.is_curved());
}

/// Half a ten-thousandth of a side is rounding, and the partner takes the place; ten times that is none.
#[test]
fn partners_are_verified() {
    let place = Point::new(-0.2, -1.0);
    let off = |by: f64| {
        let mut msh = dovetail();
        let tag = node(&msh, "groove", place);
        msh.nodes.get_mut(&tag).unwrap().y -= by;
        (dovetail_zone(&msh), tag)
    };
    let (zone, tag) = off(2e-5);
    let (_, bodies) = zone.unwrap();
    let moved = bodies[1].tags.iter().position(|t| *t == tag).unwrap();
    assert!((bodies[1].mesh.points[moved] - place).norm() < 1e-9);
    let (refused, tag) = off(2e-4);
    let message = refused.unwrap_err().message;
    assert!(message.contains("has no partner on the zone of \"groove\": the nearest is node"), "{message}");
    assert!(
        message.contains(&format!("the nearest is node {tag} at (-0.19999")) && message.contains("2.000e-4 away"),
        "{message}"
    );
}

#[test]
fn faces_with_other_counts_are_refused() {
    // the flank alone against flank, bottom and flank
    let msh = dovetail();
    let mut bodies = bodies(&msh, ["tongue", "groove"]);
    let error = zone(&msh, &mut bodies, &[faces("tongue-top", "groove-face")]).unwrap_err();
    assert!(
        error.message.contains("has no partner on the zone of \"groove\"") && error.next.contains("Transfinite"),
        "{error}"
    );
}

#[test]
fn zones_in_pieces_are_refused() {
    let msh = dovetail();
    let mut bodies = bodies(&msh, ["tongue", "groove"]);
    let error = zone(&msh, &mut bodies, &[faces("tongue-sides", "groove-face")]).unwrap_err();
    assert!(error.message.starts_with("the zone of \"tongue\" has 2 separate pieces, from node"), "{error}");
}

/// Nodes that both bodies use are partners of themselves.
#[test]
fn bodies_may_share_the_nodes_of_the_zone() {
    let mut msh = Msh::read(squares(2).as_bytes()).unwrap();
    let (first, second) = ([1, 2, 3], [10, 11, 12]);
    assert!(first.iter().zip(&second).all(|(a, b)| (msh.nodes[a].x, 0.0) == (msh.nodes[b].x, msh.nodes[a].y)));
    let upper_row: Vec<u64> = msh.nodes.iter().filter(|(t, p)| **t < 10 && p.y == 0.0).map(|(t, _)| *t).collect();
    let lower_row: Vec<u64> = msh.nodes.iter().filter(|(t, p)| **t >= 10 && p.y == 0.0).map(|(t, _)| *t).collect();
    let shared = |n: &mut u64| {
        if let Some(k) = lower_row.iter().position(|t| t == n) {
            *n = upper_row[k];
        }
    };
    msh.triangles.iter_mut().flat_map(|t| &mut t.nodes).for_each(shared);
    msh.lines.iter_mut().flat_map(|l| &mut l.nodes).for_each(shared);
    let mut bodies = bodies(&msh, ["upper", "lower"]);
    let path = zone(&msh, &mut bodies, &[faces("upper:contact", "upper:contact")]).unwrap();
    assert_eq!(path.corners.len(), 2);
}

fn circle(radius: f64) -> SharedCurve {
    let turn = std::f64::consts::FRAC_PI_2;
    Arc::new(CircularArc { centre: Point::zeros(), radius, from: -turn, to: turn })
}

#[test]
fn a_row_follows_the_curve_that_the_study_names() {
    let mut msh = Msh::read(PIN).unwrap();
    // a node that is off by less than the tolerance is put onto the curve
    let tag = node(&msh, "pin", Point::new(1.0, 0.0));
    msh.nodes.get_mut(&tag).unwrap().x = 1.000_01;
    let mut pin = BodyMesh::new(&msh, "pin").unwrap();
    let row = rows(&pin.sides(&msh, "pin-face").unwrap()).remove(0);
    assert_eq!(row.len(), 13);
    let path = along(&mut pin, &row, "hole", &circle(1.0)).unwrap();
    assert!(row.iter().all(|n| (pin.point(*n).norm() - 1.0).abs() < 1e-14));
    assert!(path.is_curved() && path.corners.len() == 2 && (path.corners[0].y + 1.0).abs() < 1e-14);
    let error = along(&mut pin, &row, "hole", &circle(1.01)).unwrap_err();
    assert!(
        error.message.starts_with("node ") && error.message.contains("is 1.000e-2 away from the curve `hole`"),
        "{error}"
    );
    // without a curve the chords are a polygon: thirteen nodes, each a corner
    assert_eq!(straight(&mut pin, &row).corners.len(), 13);
}

/// A row that closes begins at a corner, wherever the file begins it.
#[test]
fn a_closed_row_of_straight_sides_has_its_four_corners() {
    let msh = Msh::read(squares(3).as_bytes()).unwrap();
    let mut body = BodyMesh::new(&msh, "upper").unwrap();
    let sides: Vec<[u32; 2]> = body.boundary.values().copied().collect();
    for turn in 0..sides.len() {
        let turned = [&sides[turn..], &sides[..turn]].concat();
        let found = rows(&turned);
        assert_eq!((found.len(), found[0].len()), (1, 13));
        let corners: Vec<[f64; 2]> = straight(&mut body, &found[0]).corners.iter().map(|p| [p.x, p.y]).collect();
        assert_eq!(corners, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]]);
    }
}
