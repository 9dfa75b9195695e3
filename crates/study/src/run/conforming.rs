//! Where `K_{2h} ⊂ K_h ⊂ K`, so that energies fall to `L(u)` from above: nested meshes of straight bodies, and nothing
//! interpolated on `Γ_u`.

use crate::error::RunError;
use crate::extrapolation;
use crate::family;
use crate::record::{Extrapolation, Level};
use crate::study::{Case, PartCondition, Scene};
use signorini_contact::mesh::Mesh;
use signorini_contact::problem::Data;

/// A given displacement below this share of 1 is none.
const ZERO: f64 = 1e-14;

/// Shares of a side at which given displacements are looked at.
const SAMPLES: [f64; 5] = [0.0, 0.13, 0.5, 0.77, 1.0];

/// Whether the discrete sets of the levels are nested and lie in `K`.
pub(super) fn is(case: &Case, cells: &[usize]) -> Result<bool, RunError> {
    let Some(scene) = case.scene().filter(|scene| scene.domain().nests(&case.family)) else { return Ok(false) };
    let coarsest = family::build_level(&case.family, &scene.domain(), cells, 0)?;
    Ok(is_held_fast(scene, coarsest.hierarchy.finest()))
}

/// Whether nothing moves on `Γ_u`.
fn is_held_fast(scene: &Scene, mesh: &Mesh) -> bool {
    let fixed = |part: usize| matches!(scene.parts[part].condition, PartCondition::Fixed(_));
    mesh.sides.iter().filter(|s| fixed(s.part as usize)).all(|side| {
        let piece = mesh.boundary_view(side).piece;
        SAMPLES.iter().all(|t| scene.displacement(side.part as usize, piece.point(*t)).amax() < ZERO)
    })
}

/// The limit of the energies, beside the energy of the reference, if there is one. Only of levels that are nested one above
/// the other.
pub(super) fn extrapolate(levels: &[Level]) -> Option<Extrapolation> {
    if !levels.iter().skip(1).all(|l| l.nested) {
        return None;
    }
    let finest = levels.last()?;
    let reference = finest.errors.energy_gap.map(|gap| finest.energy - gap);
    extrapolation::extrapolate(levels, reference)
}
