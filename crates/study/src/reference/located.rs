//! A discrete reference on a mesh that shares no triangle with the level's, as on curved bodies: the level's function is
//! found by point location, in its own element and in the true geometry.

use super::overkill::Overkill;
use signorini_contact::Vec2;
use signorini_contact::material::Material;
use signorini_contact::mesh::{Locator, Mesh};
use signorini_contact::norm::{Squares, interpolate, of_located};

/// Refinements of the rule on triangles of the reference mesh that have to do with a curved side of either mesh; the others are
/// integrated exactly.
const DEPTH: u32 = 0;

/// A level's solution and the reference, compared.
pub struct Located {
    /// Squares of `u_ref − u_h`.
    pub error: Squares,
    /// Squares of `u_ref − u_I`, with the level's interpolant `u_I` of `u_ref`.
    pub interpolation: Squares,
    /// Squares of `u_h − I u_h`, with the interpolant `I` on the reference mesh: the part of `u_h` that the reference's space
    /// does not hold. Zero on nested meshes.
    pub unresolved: Squares,
    /// Change of `√A(e,e)` under one refinement of the rule.
    pub quadrature: f64,
}

impl Located {
    /// Compares the field `u_h` on `mesh` with the reference.
    pub fn new(reference: &Overkill, mesh: &Mesh, materials: &[Material; 2], u_h: &[Vec2]) -> Self {
        let (fine, u_ref) = (reference.hierarchy.finest(), &reference.solution.displacement);
        let (on_level, on_fine) = (Locator::new(mesh), Locator::new(fine));
        let u_i = interpolate(mesh, &on_fine, u_ref);
        let lifted = interpolate(fine, &on_level, u_h);
        let pairs: [(&[Vec2], &[Vec2]); 3] = [(u_ref, u_h), (u_ref, &u_i), (&lifted, u_h)];
        let [[rough, ..], [error, interpolation, unresolved]] =
            of_located(fine, materials, &on_level, pairs, [DEPTH, DEPTH + 1]);
        let quadrature = (error.energy_norm() - rough.energy_norm()).abs();
        Self { error, interpolation, unresolved, quadrature }
    }
}
