//! Whether the discrete set is part of the continuous one, `K_h ⊂ K`, and so of that of every nested finer mesh.

use crate::study::{PartCondition, Scene};
use signorini_contact::mesh::Mesh;
use signorini_contact::problem::Data;

/// Prescribed displacements that miss their interpolant by more than this share of their size are not interpolated exactly.
const ROUNDING: f64 = 1e-12;

/// Whether `K_h ⊂ K` by construction: a common polygonal zone with the normals of its segments (Lemma 2.1), straight bodies, and
/// prescribed displacements that are linear on every side.
pub(super) fn is_inside(scene: &Scene, mesh: &Mesh) -> bool {
    mesh.direction.is_none() && !scene.domain().is_curved() && data_are_interpolated(scene, mesh)
}

fn data_are_interpolated(scene: &Scene, mesh: &Mesh) -> bool {
    let fixed = |part: u16| matches!(scene.parts[usize::from(part)].condition, PartCondition::Fixed(_));
    mesh.sides.iter().filter(|s| fixed(s.part)).all(|side| {
        let [a, b] = side.nodes.map(|i| mesh.points[i as usize]);
        let at = |x| scene.displacement(side.part as usize, x);
        let (u, v) = (at(a), at(b));
        let size = u.amax().max(v.amax());
        [0.25, 0.5, 0.75].into_iter().all(|t| {
            let difference = at((1.0 - t) * a + t * b) - ((1.0 - t) * u + t * v);
            difference.amax() <= ROUNDING * size.max(at(0.5 * (a + b)).amax())
        })
    })
}
