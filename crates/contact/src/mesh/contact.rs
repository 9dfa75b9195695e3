//! The contact zone of two triangulations: sides sorted along the polyline, nodes matched pairwise.
//!
//! ```text
//!            Ω'            The polyline A_1 → A_2 → … keeps Ω' on its left and Ω'' on its
//!   A_1 ----•----•---- A_2 right, so the outward normal of Ω' points to the right of its
//!            Ω''           direction.
//! ```

use super::outline::Owner;
use super::triangulation::{FreeSide, Triangulation, at, mesh_error};
use super::{Body, ContactSide};
use crate::Error;
use crate::geometry::{ContactLine, Piece, Point, Vec2, tangent_of};

/// A side of one body on the contact zone, in the direction of the polyline.
struct Oriented {
    segment: u16,
    /// Parameter of the middle on the piece, in 0..1.
    place: f64,
    nodes: [u32; 2],
    triangle: u32,
}

/// The sides of the contact zone in the order of the polyline; nodes are numbered in their own body.
pub(super) fn match_sides(
    bodies: &[Triangulation; 2],
    free: [&[FreeSide]; 2],
    owners: [&[Owner]; 2],
    line: &ContactLine,
    tolerance: f64,
) -> Result<Vec<ContactSide>, Error> {
    let pieces = line.pieces();
    let sorted = Body::BOTH.map(|body| {
        let b = body.index();
        sort_along(&bodies[b], free[b], owners[b], pieces.iter().map(|both| &both[b]).collect())
    });
    check_orientation(bodies, &sorted)?;
    check_matching(bodies, &sorted, line.direction(), tolerance)?;
    let [first, second] = sorted.map(|(sides, _)| sides);
    let side = |(f, s): (&Oriented, &Oriented)| ContactSide {
        first: f.nodes,
        second: s.nodes,
        triangles: [f.triangle, s.triangle],
        segment: f.segment,
    };
    Ok(first.iter().zip(&second).map(side).collect())
}

/// The contact sides of a body along the polyline, and for each whether the body lies on its left.
fn sort_along(
    mesh: &Triangulation,
    free: &[FreeSide],
    owners: &[Owner],
    pieces: Vec<&Piece>,
) -> (Vec<Oriented>, Vec<bool>) {
    let mut sides = Vec::new();
    for (side, owner) in free.iter().zip(owners) {
        if let Owner::Contact(segment) = *owner {
            let piece = pieces[usize::from(segment)];
            let [a, b] = side.nodes.map(|i| piece.foot(mesh.points[i as usize]));
            let [n, m] = side.nodes;
            let nodes = if a < b { [n, m] } else { [m, n] };
            sides.push((Oriented { segment, place: 0.5 * (a + b), nodes, triangle: side.triangle }, a < b));
        }
    }
    sides.sort_by(|(a, _), (b, _)| (a.segment.cmp(&b.segment)).then(a.place.total_cmp(&b.place)));
    sides.into_iter().unzip()
}

fn check_orientation(bodies: &[Triangulation; 2], sorted: &[(Vec<Oriented>, Vec<bool>); 2]) -> Result<(), Error> {
    let wrong = |b: usize, left: bool| sorted[b].1.iter().position(|&l| l != left);
    let (first, second) = (wrong(0, true), wrong(1, false));
    let (body, place, hint) = match (first, second) {
        (None, None) => return Ok(()),
        (Some(i), Some(_)) => (Body::First, i, "reverse the polyline, or exchange the bodies"),
        (Some(i), None) => (Body::First, i, "both bodies lie on its right: they must not overlap"),
        (None, Some(i)) => (Body::Second, i, "both bodies lie on its left: they must not overlap"),
    };
    let b = body.index();
    let [a, c] = sorted[b].0[place].nodes.map(|i| bodies[b].points[i as usize]);
    Err(mesh_error(format!(
        "{body} lies on the wrong side of the contact polyline, e.g. between {} and {}; Ω' must lie on its left and \
         Ω'' on its right: {hint}",
        at(a),
        at(c)
    )))
}

fn check_matching(
    bodies: &[Triangulation; 2],
    sorted: &[(Vec<Oriented>, Vec<bool>); 2],
    direction: Option<Vec2>,
    tolerance: f64,
) -> Result<(), Error> {
    // Across a gap, partners share η and nothing else: only that component counts.
    let seen = |x: Point| direction.map_or(x, |xi| x.dot(&tangent_of(xi)) * tangent_of(xi));
    let nodes = |b: usize| sorted[b].0.iter().flat_map(|s| s.nodes);
    let place = |b: usize, i: u32| bodies[b].points[i as usize];
    let pairs = || nodes(0).zip(nodes(1));
    let far = |(i, j): &(u32, u32)| seen(place(0, *i) - place(1, *j)).norm() > tolerance;
    if sorted[0].0.len() == sorted[1].0.len() && !pairs().any(|pair| far(&pair)) {
        return Ok(());
    }
    for (body, other) in [(Body::First, Body::Second), (Body::Second, Body::First)] {
        let (b, o) = (body.index(), other.index());
        for i in nodes(b) {
            let (j, distance) = nearest_seen(place(b, i), nodes(o), &bodies[o].points, seen);
            if distance > tolerance {
                return Err(mesh_error(format!(
                    "contact node {i} of {body} at {} has no partner in {other}: the nearest contact node there is \
                     {j} at {}, {distance:.3e} away (at most {tolerance:.1e}); both bodies need the same nodes on the \
                     contact zone, so give them the same divisions there",
                    at(place(b, i)),
                    at(place(o, j))
                )));
            }
        }
    }
    Err(mesh_error(format!(
        "the bodies have {} and {} sides on the contact zone with nodes at the same places; some lie twice on the \
         polyline: remove the repeated ones",
        sorted[0].0.len(),
        sorted[1].0.len()
    )))
}

/// The node nearest to `x` in the components that count, and its distance.
fn nearest_seen(
    x: Point,
    nodes: impl Iterator<Item = u32>,
    points: &[Point],
    seen: impl Fn(Point) -> Point,
) -> (u32, f64) {
    nodes
        .map(|i| (i, seen(points[i as usize] - x).norm()))
        .fold((0, f64::INFINITY), |best, next| if next.1 < best.1 { next } else { best })
}
