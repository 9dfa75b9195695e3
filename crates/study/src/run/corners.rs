//! The corners of a case, and the rate that they let expect.

use crate::corner;
use crate::error::RunError;
use crate::family;
use crate::record::{Bounds, Corner, ZoneProfile, corner_rate};
use crate::study::Case;

/// The corners of a scene without exact solution, from the coarsest of its meshes; `zone` is the solved zone, if there is one.
/// None of a lemma, and none where an exact solution decides the regularity.
///
/// # Errors
/// What meshing refuses.
pub(super) fn corners_of(case: &Case, cells: &[usize], zone: Option<&ZoneProfile>) -> Result<Vec<Corner>, RunError> {
    let Some(scene) = case.scene().filter(|scene| scene.exact.is_none()) else { return Ok(Vec::new()) };
    let coarsest = family::build_level(&case.family, &scene.domain(), cells, 0)?;
    Ok(corner::corners(scene, coarsest.hierarchy.finest(), zone)?)
}

/// The case's bounds, the expected rate from the corners where the study asks for it.
pub(super) fn bounds(case: &Case, corners: &[Corner]) -> Bounds {
    let mut bounds = case.bounds.clone();
    if case.expected_from_corners {
        bounds.expected = Some(corner_rate(corners));
    }
    bounds
}
