//! Which boundaries can be filled.

use super::draft::Draft;
use super::score::COT_20;
use super::{at, refuse};
use signorini_contact::geometry::cross;
use signorini_contact::{Error, Point};

/// Refuses what is not a simple polygon, counterclockwise, with corners of at least 20°.
pub(super) fn check(boundary: &[Point]) -> Result<(), Error> {
    let n = boundary.len();
    if n < 3 {
        return refuse(format!("a boundary needs at least 3 nodes, and this one has {n}; add the missing corners"));
    }
    if let Some(k) = boundary.iter().position(|p| !(p.x.is_finite() && p.y.is_finite())) {
        return refuse(format!("boundary node {k} lies at {}; coordinates must be finite", at(boundary[k])));
    }
    check_repeated(boundary)?;
    let area = twice_area_of(boundary);
    if area <= 0.0 {
        return refuse(format!(
            "the boundary that starts at {} encloses the area {}; it must run counterclockwise: reverse its nodes",
            at(boundary[0]),
            0.5 * area
        ));
    }
    Draft::new(boundary.to_vec(), n)?;
    (0..n).try_for_each(|k| check_corner(boundary, k))
}

/// Twice the area of a polygon, positive if it runs counterclockwise.
pub(super) fn twice_area_of(polygon: &[Point]) -> f64 {
    let (n, o) = (polygon.len(), polygon[0]);
    (0..n).map(|k| cross(polygon[k] - o, polygon[(k + 1) % n] - o)).sum()
}

fn check_repeated(boundary: &[Point]) -> Result<(), Error> {
    let mut order: Vec<usize> = (0..boundary.len()).collect();
    // Adding 0 makes −0 and 0 the same.
    let key = |k: usize| (boundary[k].x + 0.0, boundary[k].y + 0.0);
    order.sort_by(|&a, &b| key(a).0.total_cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
    match order.windows(2).find(|w| boundary[w[0]] == boundary[w[1]]) {
        None => Ok(()),
        Some(w) => refuse(format!(
            "boundary nodes {} and {} are both at {}; list each node once, and do not repeat the first at the end",
            w[0].min(w[1]),
            w[0].max(w[1]),
            at(boundary[w[0]])
        )),
    }
}

fn check_corner(boundary: &[Point], k: usize) -> Result<(), Error> {
    let n = boundary.len();
    let x = boundary[k];
    let (back, on) = (boundary[(k + n - 1) % n] - x, boundary[(k + 1) % n] - x);
    // The interior angle runs from the next side counterclockwise to the previous one.
    let (c, s) = (on.dot(&back), cross(on, back));
    if s <= 0.0 || c <= COT_20 * s * (1.0 + 1e-12) {
        return Ok(());
    }
    refuse(format!(
        "the boundary has an angle of {:.1}° at {}, and every angle of the mesh must be at least 20°; blunt the corner",
        f64::atan2(s, c).to_degrees(),
        at(x)
    ))
}
