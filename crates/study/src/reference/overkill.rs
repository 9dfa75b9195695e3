//! A discrete reference on a finer nested mesh: the difference is piecewise linear there and integrated exactly.

use signorini_contact::basis::BoundOrigin;
use signorini_contact::material::Material;
use signorini_contact::mesh::Hierarchy;
use signorini_contact::norm::{self, Squares};
use signorini_contact::problem::{Discrete, Solution};
use signorini_contact::{Vec2, assembly};

/// The reference solution with the meshes below it.
pub struct Overkill {
    /// Every study level and, finest, the reference mesh.
    pub hierarchy: Hierarchy,
    /// The discrete problem on the reference mesh.
    pub discrete: Discrete,
    /// Its solution.
    pub solution: Solution,
}

impl Overkill {
    /// The nodal values of a coarse field on the reference mesh; `level` counts in the hierarchy.
    pub fn prolong(&self, level: usize, coarse: &[Vec2]) -> Vec<Vec2> {
        self.hierarchy.prolong(level, self.hierarchy.levels().len() - 1, coarse)
    }

    /// The reference's nodal values at the nodes of a coarser level: its interpolant there.
    pub fn interpolant(&self, level: usize) -> &[Vec2] {
        &self.solution.displacement[..self.hierarchy.levels()[level].points.len()]
    }

    /// `A(u_ref, φ_i)` for the nodes of a coarser level: the load whose solution is the projection of `u_ref`.
    pub fn projection_load(&self, materials: &[Material; 2], level: usize) -> Vec<Vec2> {
        let forces = assembly::internal_forces(self.hierarchy.finest(), materials, &self.solution.displacement);
        self.hierarchy.restrict(self.hierarchy.levels().len() - 1, level, &forces)
    }

    /// Squares of `u_ref − v` for a field on the reference mesh.
    pub fn error(&self, materials: &[Material; 2], v: &[Vec2]) -> Squares {
        norm::of_linear_difference(self.hierarchy.finest(), materials, &self.solution.displacement, v)
    }

    /// `A(u_ref, w) − f(w) = −Σ λ_c w_c` for `w = v − u_ref`: the reference's own residual, which stands for the exact
    /// contact stress.
    pub fn contact_work(&self, v: &[Vec2]) -> f64 {
        let held = self.discrete.basis.held.iter().map(|h| &h.origin);
        let force = |o: &BoundOrigin| self.solution.contact_forces[o.pair][o.constraint];
        let work = |o: &BoundOrigin| force(o) * (self.jump(o, v) - self.jump(o, &self.solution.displacement));
        -self.discrete.origins.iter().chain(held).map(work).sum::<f64>()
    }

    /// `Σ λ_c (v_c − g_c)_+`: the reference's contact forces on what a field penetrates between its own nodes. With it
    /// `½A(e,e) ≤ a + b + c` where `K_h ⊄ K_ref`, as (3.45) has it across a gap; zero where the constraint sets are nested.
    pub fn penetration_work(&self, v: &[Vec2]) -> f64 {
        let gap = |o: &BoundOrigin| self.discrete.zone.pairs[o.pair].constraints[o.constraint].gap;
        let forces = self.solution.raw.multipliers.iter();
        forces.zip(&self.discrete.origins).map(|(force, o)| force * (self.jump(o, v) - gap(o)).max(0.0)).sum()
    }

    /// `n·(v' − v'')` at a constraint of the reference.
    fn jump(&self, origin: &BoundOrigin, field: &[Vec2]) -> f64 {
        let pair = &self.discrete.zone.pairs[origin.pair];
        let normal = pair.constraints[origin.constraint].normal;
        normal.dot(&(field[pair.first as usize] - field[pair.second as usize]))
    }
}
