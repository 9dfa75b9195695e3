//! `A` and `f` on the nodal fields of one mesh and on the solution `u`, which need not be one of them.

use signorini_contact::material::Material;
use signorini_contact::mesh::Mesh;
use signorini_contact::{Vec2, assembly};

/// The two forms, by the same quadrature wherever `u` takes part.
pub struct Forms<'a> {
    /// The mesh of the nodal fields.
    pub mesh: &'a Mesh,
    /// Elastic constants of the bodies.
    pub materials: &'a [Material; 2],
    /// `f(φ_i)`.
    pub loads: Vec<Vec2>,
    /// `A(u, φ_i)`.
    pub stresses: Vec<Vec2>,
    /// `f(u)`.
    pub work: f64,
    /// `A(u, u)`.
    pub energy: f64,
}

impl<'a> Forms<'a> {
    /// Where `u` is a nodal field of the mesh itself, with nodal loads `loads`.
    pub fn of_nodal(mesh: &'a Mesh, materials: &'a [Material; 2], loads: Vec<Vec2>, u: &[Vec2]) -> Self {
        let stresses = assembly::internal_forces(mesh, materials, u);
        Self { work: dot(&loads, u), energy: dot(&stresses, u), mesh, materials, loads, stresses }
    }

    /// `f(v)`.
    pub fn load(&self, v: &[Vec2]) -> f64 {
        dot(&self.loads, v)
    }

    /// `A(u, v)`.
    pub fn stress(&self, v: &[Vec2]) -> f64 {
        dot(&self.stresses, v)
    }

    /// `A(v, w)`.
    pub fn product(&self, v: &[Vec2], w: &[Vec2]) -> f64 {
        dot(&assembly::internal_forces(self.mesh, self.materials, v), w)
    }
}

/// `Σ a_i·b_i`.
pub fn dot(a: &[Vec2], b: &[Vec2]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}
