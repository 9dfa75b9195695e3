//! Admissible fields: random ones of the discrete set, and what becomes of them where that set is no part of `K`.

use super::dot;
use crate::family::random;
use signorini_contact::material::Material;
use signorini_contact::mesh::Mesh;
use signorini_contact::problem::Discrete;
use signorini_contact::{Vec2, assembly};

/// Points of a contact side at which overlap is looked for.
const SAMPLES: usize = 32;

/// How often bodies are pushed apart before it is given up.
const PUSHES: usize = 20;

/// Seeded random fields of a discrete set `K_h`.
pub struct Random<'a> {
    /// The discrete problem.
    pub discrete: &'a Discrete,
    /// Its mesh.
    pub mesh: &'a Mesh,
    /// Elastic constants.
    pub materials: &'a [Material; 2],
    /// The components `x` that random fields lie around.
    pub centre: &'a [f64],
}

impl Random<'_> {
    /// Components of a field at the distance `distance` from the centre in the energy norm, before its bounded components are
    /// brought below their bounds. One seed and stream is one field.
    pub fn components(&self, seed: u64, stream: u64, distance: f64) -> Vec<f64> {
        let mut random = random::Random::new(seed, stream);
        let basis = &self.discrete.basis;
        let noise: Vec<f64> = basis.fixed.iter().map(|fixed| random.signed() * f64::from(u8::from(!fixed))).collect();
        let still = vec![0.0; noise.len()];
        let rest = basis.displacement(&still);
        let field: Vec<Vec2> = basis.displacement(&noise).iter().zip(&rest).map(|(u, r)| u - r).collect();
        let norm = dot(&assembly::internal_forces(self.mesh, self.materials, &field), &field).sqrt();
        let scale = distance / norm.max(f64::MIN_POSITIVE);
        let mut x: Vec<f64> = self.centre.iter().zip(&noise).map(|(x, n)| x + scale * n).collect();
        // x_c ≤ g_c, component by component: the constraints are bounds in this basis
        for bound in &self.discrete.qp.bounds {
            let c = bound.dof as usize;
            x[c] = x[c].min(bound.upper);
        }
        x
    }

    /// The field itself.
    pub fn field(&self, seed: u64, stream: u64, distance: f64) -> Vec<Vec2> {
        self.discrete.basis.displacement(&self.components(seed, stream, distance))
    }
}

/// The field of the components `x` with the bodies pushed apart until they overlap nowhere, between the nodes neither; `None`
/// where supports prevent it. In `K` on curved zones too, where nodal constraints are not enough.
pub fn opened(discrete: &Discrete, mesh: &Mesh, mut x: Vec<f64>) -> Option<Vec<Vec2>> {
    for _ in 0..PUSHES {
        let field = discrete.basis.displacement(&x);
        let overlap = overlap(mesh, &field);
        if overlap <= 0.0 {
            return Some(field);
        }
        // a little farther than the samples ask for
        discrete.qp.bounds.iter().for_each(|b| x[b.dof as usize] -= 1.25 * overlap);
    }
    None
}

/// The largest `n·(v' − v'') − ε` between the nodes, at least 0.
pub fn overlap(mesh: &Mesh, field: &[Vec2]) -> f64 {
    let of_side = |side: usize| {
        let view = mesh.contact_view(side);
        let at = |k: usize| {
            let t = k as f64 / SAMPLES as f64;
            let point = view.at(t);
            view.jump(t, &point, field) - point.gap
        };
        (0..=SAMPLES).map(at).fold(0.0, f64::max)
    };
    (0..mesh.contact.len()).map(of_side).fold(0.0, f64::max)
}
