//! Everything but the solve: what a case would do, level by level.

use super::corners::corners_of;
use super::{Profile, refused, verify_exact};
use crate::error::RunError;
use crate::family;
use crate::record::{Corner, Level};
use crate::study::{Case, Scene, Subject};
use signorini_contact::assembly;
use signorini_contact::problem::Problem;
use signorini_contact::zone::Zone;

/// A level before it is solved.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckedLevel {
    /// The study's `n`.
    pub cells: usize,
    /// Largest side.
    pub h: f64,
    /// Smallest angle in degrees.
    pub min_angle: f64,
    /// Longest over shortest side.
    pub side_ratio: f64,
    /// Whether `V_{k−1} ⊂ V_k`.
    pub nested: bool,
    /// Free displacement components.
    pub dofs: usize,
    /// Pairs on `Γ_K`.
    pub contact_pairs: usize,
    /// Constraints kept.
    pub constraints: usize,
    /// Warnings of mesh and rigid motions.
    pub warnings: Vec<String>,
}

/// Verifies the exact solution, meshes every level, and tests supports, loads and rigid motions.
///
/// # Errors
/// As [`run_case`](super::run_case).
pub fn check_case(case: &Case, profile: Profile) -> Result<Vec<CheckedLevel>, RunError> {
    let cells = if profile == Profile::Quick { &case.quick } else { &case.full };
    let scene = match &case.subject {
        Subject::Contact(scene) => scene,
        // A lemma solves nothing, so measuring it is all there is to check.
        Subject::Lemma(lemma) => return (0..cells.len()).map(|k| lemma.measure(cells, k).map(checked)).collect(),
    };
    verify_exact(case, scene)?;
    let checked = (0..cells.len()).map(|index| check_level(case, scene, cells, index)).collect();
    let mut parted = refused::part(checked, cells)?;
    parted.solved[0].warnings.extend(parted.refused);
    Ok(parted.solved)
}

/// The corners of a case with their exponents; nothing is solved, so no state governs.
///
/// # Errors
/// As [`check_case`].
pub fn check_corners(case: &Case, profile: Profile) -> Result<Vec<Corner>, RunError> {
    corners_of(case, if profile == Profile::Quick { &case.quick } else { &case.full }, None)
}

fn checked(level: Level) -> CheckedLevel {
    CheckedLevel {
        cells: level.cells,
        h: level.h,
        min_angle: level.min_angle,
        side_ratio: level.side_ratio,
        nested: level.nested,
        dofs: level.dofs,
        contact_pairs: level.contact_pairs,
        constraints: level.constraints,
        warnings: level.warnings,
    }
}

pub(super) fn check_level(case: &Case, scene: &Scene, cells: &[usize], index: usize) -> Result<CheckedLevel, RunError> {
    let meshed = family::build_level(&case.family, &scene.domain(), cells, index)?;
    let supports = scene.supports();
    let cubature = scene.cubature(0, case.fixed_quadrature);
    let mesh = meshed.hierarchy.finest();
    let problem = Problem { mesh, materials: scene.materials, supports: &supports, data: scene, cubature: &cubature };
    let load = assembly::loads(mesh, &supports, scene, &cubature)?;
    let discrete = scene.discretise(&problem, load, Zone::new(mesh))?;
    Ok(CheckedLevel {
        cells: cells[index],
        h: meshed.quality.h,
        min_angle: meshed.quality.min_angle,
        side_ratio: meshed.quality.side_ratio,
        nested: meshed.nested,
        dofs: discrete.dofs(),
        contact_pairs: discrete.zone.pairs.len(),
        constraints: discrete.qp.bounds.len(),
        warnings: discrete.warnings,
    })
}
