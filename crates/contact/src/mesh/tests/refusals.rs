//! Every way to give `Mesh::build` nonsense, and what it says.

use super::{Scene, part, points, squares};
use crate::mesh::Body;
use crate::mesh::blocks::{Pattern, triangulate};

/// Spoils the scene of two 2×2 squares and demands a message with these fragments.
fn refuse(fragments: &[&str], spoil: impl FnOnce(&mut Scene)) {
    let mut scene = squares(2, Pattern::Structured);
    spoil(&mut scene);
    let error = scene.build().unwrap_err().to_string();
    for fragment in fragments {
        assert!(error.contains(fragment), "“{fragment}” is not in: {error}");
    }
}

#[test]
fn the_unspoilt_scene_is_accepted() {
    assert!(squares(2, Pattern::Structured).build().is_ok());
}

#[test]
fn bad_triangles() {
    refuse(&["triangle 3 of Ω''", "clockwise", "Jacobian -2.5", "exchange"], |s| {
        s.bodies[1].triangles[3].swap(0, 1);
    });
    refuse(&["triangle 0 of Ω'", "degenerate", "(0, 0)"], |s| {
        s.bodies[0].points[4] = points([[1.0, 0.0]])[0];
    });
    refuse(&["triangle 1 of Ω'", "corner 9", "9 nodes"], |s| s.bodies[0].triangles[1][2] = 9);
    refuse(&["node 5 of Ω'", "NaN", "finite"], |s| s.bodies[0].points[5].y = f64::NAN);
    refuse(&["Ω'' has no triangle"], |s| s.bodies[1].triangles.clear());
    refuse(&["node 9 of Ω' at (7, 7)", "no triangle"], |s| {
        s.bodies[0].points.push(points([[7.0, 7.0]])[0]);
    });
}

#[test]
fn overlapping_triangles() {
    refuse(&["side from (0, 0) to (0.5, 0.5)", "nodes 0, 4", "more than two triangles 0, 1, 8"], |s| {
        s.bodies[0].points.push(points([[0.5, -0.3]])[0]);
        s.bodies[0].triangles.push([4, 0, 9]);
    });
    refuse(&["of Ω'", "same side of both triangles 0, 8"], |s| s.bodies[0].triangles.push([0, 1, 5]));
}

#[test]
fn boundary_without_or_with_two_names() {
    refuse(&["boundary side of Ω'", "from (0, 0.5) to (0, 0)", "covered by no part", "add it"], |s| {
        drop(s.parts.remove(1))
    });
    refuse(&["from (0.5, 1) to (0, 1)", "part \"top\" and by part \"half\""], |s| {
        s.parts.push(part(Body::First, "half", [[0.0, 1.0], [0.5, 1.0]]))
    });
    refuse(&["from (0, 0) to (0.5, 0)", "part \"base\" and by the contact polyline"], |s| {
        s.parts.push(part(Body::First, "base", [[0.0, 0.0], [1.0, 0.0]]))
    });
}

#[test]
fn parts_that_do_not_fit() {
    refuse(&["part \"cut\" from (0, 0.5) matches no side of Ω'"], |s| {
        s.parts.push(part(Body::First, "cut", [[0.0, 0.5], [1.0, 0.5]]));
    });
    refuse(&["(0.7, 1) of part \"top\"", "not a node on the boundary of Ω'", "nearest is node 7", "2.000e-1"], |s| {
        s.parts[0].along.corners[1].x = 0.7;
    });
    refuse(&["part \"top\" has the length 1.5", "have 1;"], |s| {
        s.parts[0].along.corners.push(points([[0.5, 1.0]])[0]);
    });
    refuse(&["Ω' has two parts named \"top\""], |s| s.parts[1].name = "top".into());
    refuse(&["part \"top\" of Ω' has 1 points"], |s| s.parts[0].along.corners.truncate(1));
    refuse(&["part \"rest\" of Ω''", "segment of length 0"], |s| {
        s.parts[3].along.corners[1] = s.parts[3].along.corners[0]
    });
    refuse(&["part \"rest\" of Ω''", "segment of length NaN"], |s| s.parts[3].along.corners[1].x = f64::NAN);
}

#[test]
fn contact_zones_that_do_not_fit() {
    refuse(&["contact polyline has 0 points", "must not be empty"], |s| s.contact.clear());
    refuse(&["(0.3, 0) of the contact polyline", "not a node", "Ω'"], |s| {
        s.contact.insert(1, points([[0.3, 0.0]])[0]);
    });
    refuse(&["Ω' lies on the wrong side", "(1, 0)", "reverse the polyline"], |s| s.contact.reverse());
    refuse(&["Ω'' lies on the wrong side", "both bodies lie on its left"], |s| {
        s.bodies[1] = s.bodies[0].clone();
        s.parts[3].along.corners.iter_mut().for_each(|p| p.y = -p.y);
    });
}

#[test]
fn contact_nodes_without_partner() {
    refuse(
        &["contact node 1 of Ω' at (0.5, 0) has no partner in Ω''", "(0.6666666666666666, 0)", "1.667e-1 away"],
        |s| {
            let fine = [super::square([0.0, -1.0], 3)];
            s.bodies[1] = triangulate(&fine, Pattern::Structured).unwrap();
        },
    );
    refuse(&["contact node", "of Ω'' at (0.25, 0) has no partner in Ω'"], |s| {
        let fine = [super::square([0.0, -1.0], 4)];
        s.bodies[1] = triangulate(&fine, Pattern::Structured).unwrap();
    });
}
