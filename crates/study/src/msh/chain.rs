//! Sides in a row, and where a row of straight sides has its corners.

use super::body::BodyMesh;
use super::error::{MshError, refuse};
use signorini_contact::Point;
use signorini_contact::geometry::{Path, Segment, SharedCurve};
use std::collections::{BTreeMap, BTreeSet};

/// The rows of nodes that oriented sides form: open ones in the order of their first sides, then closed ones, whose first node
/// stands at the end again.
pub fn rows(sides: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let next: BTreeMap<u32, u32> = sides.iter().map(|[a, b]| (*a, *b)).collect();
    let ends: BTreeSet<u32> = sides.iter().map(|s| s[1]).collect();
    let mut left: BTreeSet<u32> = next.keys().copied().collect();
    let heads = sides.iter().map(|s| s[0]).filter(|a| !ends.contains(a));
    let mut rows: Vec<Vec<u32>> = heads.map(|head| follow(head, &next, &mut left)).collect();
    while let Some(&head) = left.first() {
        rows.push(follow(head, &next, &mut left));
    }
    rows
}

fn follow(head: u32, next: &BTreeMap<u32, u32>, left: &mut BTreeSet<u32>) -> Vec<u32> {
    let mut row = vec![head];
    let mut at = head;
    while left.remove(&at) {
        at = next[&at];
        row.push(at);
    }
    row
}

/// The path of a row of straight sides, from corner to corner: a node is one where the sides before and after leave the
/// segment. Nodes between are put onto it.
pub fn straight(body: &mut BodyMesh, row: &[u32]) -> Path {
    let row = from_a_corner(body, row);
    let mut corners = corners(body, &row);
    corners.sort_unstable();
    for w in corners.windows(2) {
        let segment = Segment { a: body.point(row[w[0]]), b: body.point(row[w[1]]) };
        for &n in &row[w[0] + 1..w[1]] {
            let foot = segment.parameter(body.point(n));
            put(body, n, (1.0 - foot) * segment.a + foot * segment.b);
        }
    }
    Path::polyline(corners.iter().map(|k| body.point(row[*k])).collect::<Vec<Point>>())
}

/// A closed row may begin inside a straight part; its leftmost node, the lowest of these, is a corner.
fn from_a_corner(body: &BodyMesh, row: &[u32]) -> Vec<u32> {
    let open = row.len() - 1;
    if row[0] != row[open] {
        return row.to_vec();
    }
    let place = |k: &usize| body.point(row[*k]);
    let first = (0..open).min_by(|a, b| place(a).x.total_cmp(&place(b).x).then(place(a).y.total_cmp(&place(b).y)));
    let start = first.unwrap_or(0);
    (0..=open).map(|k| row[(start + k) % open]).collect()
}

/// The corners of a row: its ends, and between two corners the node farthest from their segment, as long as it is off by more than
/// its tolerance.
fn corners(body: &BodyMesh, row: &[u32]) -> Vec<usize> {
    let mut corners = vec![0, row.len() - 1];
    let mut open = vec![(0, row.len() - 1)];
    while let Some((from, to)) = open.pop() {
        let (a, b) = (body.point(row[from]), body.point(row[to]));
        let off = |k: usize| {
            let x = body.point(row[k]);
            // the ends of a closed row are one point
            if a == b { (x - a).norm() } else { Segment { a, b }.distance(x) }
        };
        let farthest = (from + 1..to).map(|k| (k, off(k))).fold((from, 0.0), |m, n| if n.1 > m.1 { n } else { m });
        if farthest.1 > body.tolerance(row[farthest.0]) {
            corners.push(farthest.0);
            open.extend([(from, farthest.0), (farthest.0, to)]);
        }
    }
    corners
}

/// The path of a row whose nodes lie on a curve; they are put onto it.
///
/// # Errors
/// A node farther from the curve than its tolerance, a row that turns back or closes on it.
pub fn along(body: &mut BodyMesh, row: &[u32], name: &str, curve: &SharedCurve) -> Result<Path, MshError> {
    let mut feet = Vec::with_capacity(row.len());
    for &n in row {
        let t = curve.foot(body.point(n));
        let (foot, bound) = (curve.point(t), body.tolerance(n));
        let distance = (foot - body.point(n)).norm();
        if distance > bound {
            let message = format!(
                "{} is {distance:.3e} away from the curve `{name}`, where at most {bound:.1e} is allowed, 1e-4 of the shortest side there",
                body.at(n)
            );
            return refuse(message, "correct the curve in the study, or the group that is said to follow it");
        }
        put(body, n, foot);
        feet.push(t);
    }
    let rises = feet[feet.len() - 1] > feet[0];
    if let Some(k) = (1..feet.len()).find(|&k| (feet[k] > feet[k - 1]) != rises || feet[k] == feet[k - 1]) {
        let message = format!("the sides turn back on the curve `{name}` at {}", body.at(row[k]));
        return refuse(message, "let the group run once along the curve and not close; cut a closed one in two groups");
    }
    let ends = [row[0], row[row.len() - 1]].map(|n| body.point(n));
    Ok(Path { corners: ends.into(), curves: vec![Some(curve.clone())] })
}

/// Moves a node, unless it is there to rounding.
fn put(body: &mut BodyMesh, n: u32, x: Point) {
    let at = &mut body.mesh.points[n as usize];
    if (x - *at).norm() > ROUNDING * x.norm().max(body.size[n as usize]) {
        *at = x;
    }
}

/// Share of a coordinate that the file's own digits may be off: nodes that far from their place stay.
const ROUNDING: f64 = 1e-14;
