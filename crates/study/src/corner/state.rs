//! Whether the discrete solution is in contact along a ray from a corner.

use super::Ray;
use crate::record::{CornerState, RayState, ZoneProfile};
use signorini_contact::Point;

/// How many nodes along a ray have to agree, beyond the corner itself.
pub const NEAR: usize = 4;

/// A node presses if its pressure exceeds this share of the largest.
const ACTIVE: f64 = 1e-8;

/// The state that the solved zone takes at a corner; `None` where the nodes along a ray disagree.
pub(super) fn governing(zone: &ZoneProfile, at: Point, rays: &[Ray], states: &[CornerState]) -> Option<usize> {
    let seen: Option<Vec<RayState>> = rays.iter().map(|ray| along(zone, at, *ray)).collect();
    let seen = seen?;
    states.iter().position(|s| s.rays == seen)
}

/// What the nearest nodes of the zone along the ray do, the corner itself left out.
fn along(zone: &ZoneProfile, at: Point, ray: Ray) -> Option<RayState> {
    let distance = |i: usize| (Point::new(zone.points[i][0], zone.points[i][1]) - at).norm();
    let count = zone.points.len();
    let nearest = (0..count).map(distance).fold(f64::INFINITY, f64::min);
    let span = zone.coordinate.last()? - zone.coordinate.first()?;
    // a corner with two constraints stands twice; one that the supports decide not at all
    let is_here = |i: &usize| distance(*i) <= nearest + 1e-9 * span;
    let off_zone = nearest > 1e-9 * span;
    let nodes: Vec<usize> = if ray.forward {
        let start = (0..count).rfind(is_here)? + usize::from(!off_zone);
        (start..count).take(NEAR).collect()
    } else {
        let end = (0..count).find(is_here)? + usize::from(off_zone);
        (0..end).rev().take(NEAR).collect()
    };
    let largest = zone.pressure.iter().fold(0.0, |m: f64, p| m.max(*p));
    let pressing = nodes.iter().filter(|i| zone.pressure[**i] > ACTIVE * largest).count();
    if nodes.is_empty() {
        None
    } else if pressing == nodes.len() {
        Some(RayState::Closed)
    } else {
        (pressing == 0).then_some(RayState::Open)
    }
}
