//! The exact solution on one mesh: everything that quadrature has to know of it, gathered before the solve.
//!
//! With `w = u − u_I` and `d = u_I − u_h`, linear on each triangle,
//!
//! ```text
//! ∫|ε(u − u_h)|² = ∫|ε(w)|² + 2 ε(d):∫ε(w) + |T| |ε(d)|²
//! ```
//!
//! so one pass over the quadrature points serves the loads, the work of the loads on `u` and, after the solve, every
//! error norm. Both parts are of the size of the error: nothing cancels.

mod contact;
mod curved;
mod element;
mod gather;
mod kept;
mod resolve;
#[cfg(test)]
mod tests;

use crate::splitting::Forms;
use crate::study::{ExactScene, PartCondition, Scene};
use contact::ContactLoad;
use curved::CurvedPart;
use element::ElementIntegrand;
use gather::{Gathered, Sums, of_curved};
use kept::{Kept, Remainder};
use rayon::prelude::*;
use signorini_contact::material::Material;
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use signorini_contact::problem::Data;
use signorini_contact::quadrature::Cubature;
use signorini_contact::sum::ordered_sum;
use signorini_contact::{Error, Vec2, assembly};

/// A piece of an element is not split more often than this.
const DEEPEST: u32 = 6;

/// On meshes of more triangles than this low degrees are tried first: on coarser ones they never suffice.
const FINE: usize = 100_000;

/// Meshes of more triangles than this need not look closely to know how large the interpolation error is, roughly.
const MANY: usize = 10_000;

/// Size of the first pieces relative to their distance from a singular point.
const ADAPTIVE_GRADING: f64 = 0.9;

/// Every piece may err by this share of the accuracy, or by its element's even share if that is less.
const SMALLEST_SHARE: f64 = 1e-4;

/// Integrals of the exact solution over a mesh with one quadrature.
pub struct Integrals {
    /// Squares of the interpolation error `u − u_I`.
    pub interpolation: Squares,
    /// Squares of `u` itself.
    pub solution: Squares,
    /// `L(u) = ½A(u,u) − f(u)`.
    pub energy: f64,
    /// Nodal loads `f(φ_i)`.
    pub load: Vec<Vec2>,
    /// The contact stress on every contact side, as a functional.
    contact: Vec<ContactLoad>,
    /// `∫ τ(u)n·u ds` and `∫ τ(u)n φ ds` over every side of `Γ_u`, with the nodes of its triangle.
    reactions: Vec<([u32; 3], [Vec2; 3], f64)>,
}

/// The same integrals by two quadratures, the second of higher degree or one refinement finer on every element.
pub struct Pair {
    /// The coarser one: what the quadrature error is measured against.
    pub base: Integrals,
    /// The finer one: what is used.
    pub fine: Integrals,
    /// What straight elements leave for the errors.
    kept: Vec<Kept>,
    /// Elements with a curved side, by number in ascending order.
    curved: Vec<(u32, [CurvedPart; 2])>,
}

/// The error `u − u_h` by both quadratures.
pub struct ErrorSquares {
    /// Its squares by the finer one.
    pub fine: Squares,
    /// `A(e,e)` by the coarser one.
    pub base_energy: f64,
}

impl Pair {
    /// Integrates on every element, splitting pieces where one more refinement still changes the result by more than its
    /// share. `u_I` are the nodal values of `u`. With `fixed` nothing is graded, cut or split: one rule for all elements.
    ///
    /// # Errors
    /// [`Error::Load`] for a traction that is no number, with its part.
    pub fn new(
        scene: &Scene,
        exact: &ExactScene,
        mesh: &Mesh,
        interpolant: &[Vec2],
        fixed: bool,
    ) -> Result<Self, Error> {
        // pieces are refined until they settle, so they may start larger than where one rule has to do
        let cubature = Cubature { grading: ADAPTIVE_GRADING, ..scene.cubature(0, fixed) };
        let element = |t: usize| ElementIntegrand::new(scene, exact, mesh, interpolant, t);
        // of many elements each has one point of its three, in turn
        let sample = |t: usize| (mesh.triangles.len() > MANY).then_some(t % 3);
        let rough = |t: usize| {
            if mesh.curved.of(t).is_some() { 0.0 } else { element(t).rough_energy(&cubature, sample(t)) }
        };
        let total = ordered_sum(mesh.triangles.len(), rough);
        let share = total * f64::min(SMALLEST_SHARE, 1.0 / mesh.triangles.len() as f64);
        let deepest = if fixed { 0 } else { DEEPEST };
        let curved: Vec<(u32, [CurvedPart; 2])> = (mesh.curved.sides.par_iter())
            .map(|s| (s.triangle, element(s.triangle as usize).adaptively_curved(&cubature, share, deepest)))
            .collect();
        let straight = |t: usize| match fixed {
            true => element(t).plainly(&cubature),
            false => element(t).adaptively(&cubature, share, deepest, mesh.triangles.len() > FINE),
        };
        let Gathered { sums, load: [base_load, fine_load], kept } = Gathered::new(mesh, &curved, straight);
        let of = |k: usize, load| Integrals::new(scene, exact, mesh, sums[k], load, &scene.cubature(k as u32, fixed));
        Ok(Self { base: of(0, base_load)?, fine: of(1, fine_load)?, kept, curved })
    }

    /// Squares of the error `u − u_h` for `u_h = u_I − d`.
    pub fn error(&self, mesh: &Mesh, materials: &[Material; 2], d: &[Vec2]) -> ErrorSquares {
        let remainder = ordered_sum(self.kept.len(), |t| {
            let nodal = mesh.triangles[t].map(|i| d[i as usize]);
            let (body, material) = (mesh.body(t), &materials[mesh.body(t).index()]);
            match mesh.curved_triangle(t).zip(of_curved(&self.curved, t)) {
                Some((triangle, [base, fine])) => Remainder {
                    fine: fine.remainder(&triangle, body, material, nodal),
                    base_energy: base.remainder(&triangle, body, material, nodal).energy,
                },
                None => self.kept[t].remainder(mesh, material, t, nodal),
            }
        });
        let mut fine = self.fine.interpolation;
        fine += remainder.fine;
        ErrorSquares { fine, base_energy: self.base.interpolation.energy + remainder.base_energy }
    }

    /// `A` and `f` on nodal fields and on `u`, by both quadratures: `A(u, φ_i) = A(w, φ_i) + A(u_I, φ_i)` with `w = u − u_I`.
    pub fn forms<'a>(&self, mesh: &'a Mesh, materials: &'a [Material; 2], interpolant: &[Vec2]) -> [Forms<'a>; 2] {
        let of_interpolant = assembly::internal_forces(mesh, materials, interpolant);
        let mut stresses = [of_interpolant.clone(), of_interpolant];
        for (t, corners) in mesh.triangles.iter().enumerate() {
            let material = &materials[mesh.body(t).index()];
            let forces = match of_curved(&self.curved, t) {
                Some(parts) => parts.each_ref().map(|p| p.forces(material)),
                None => self.kept[t].forces(mesh, material, t),
            };
            for (stresses, forces) in stresses.iter_mut().zip(forces) {
                corners.iter().zip(forces).for_each(|(&i, f)| stresses[i as usize] += f);
            }
        }
        let [base, fine] = stresses;
        [self.base.forms(mesh, materials, base), self.fine.forms(mesh, materials, fine)]
    }
}

impl Integrals {
    /// Sums up the elements and adds the boundary.
    fn new(
        scene: &Scene,
        exact: &ExactScene,
        mesh: &Mesh,
        sums: Sums,
        load: Vec<Vec2>,
        cubature: &Cubature,
    ) -> Result<Self, Error> {
        let Sums { interpolation, solution, work } = sums;
        let mut integrals = Self {
            interpolation,
            solution,
            energy: 0.5 * solution.energy - work,
            load,
            contact: (0..mesh.contact.len()).map(|side| ContactLoad::new(exact, mesh, side, cubature)).collect(),
            reactions: Vec::new(),
        };
        integrals.add_boundary(scene, exact, mesh, cubature)?;
        Ok(integrals)
    }

    /// Tractions: their loads and their work on `u`. Reactions of `Γ_u`.
    fn add_boundary(
        &mut self,
        scene: &Scene,
        exact: &ExactScene,
        mesh: &Mesh,
        cubature: &Cubature,
    ) -> Result<(), Error> {
        for side in &mesh.sides {
            let part = &scene.parts[side.part as usize];
            let mut ends = [Vec2::zeros(); 3];
            let mut work = 0.0;
            let fixed = matches!(part.condition, PartCondition::Fixed(_));
            if !fixed && !matches!(part.condition, PartCondition::Traction(_)) {
                continue;
            }
            let view = mesh.boundary_view(side);
            view.points(cubature, &mut |x, normal, phi, w| {
                let stress = if fixed {
                    exact.traction(part.body, x, normal)
                } else {
                    scene.traction(side.part as usize, x, normal)
                };
                (0..3).for_each(|k| ends[k] += w * phi[k] * stress);
                work += w * stress.dot(&exact.solution.value(part.body, x));
            });
            let middle = 0.5 * (view.piece.point(0.0) + view.piece.point(1.0));
            assembly::check_load(&ends, || {
                format!("traction on part '{}' near ({:.6}, {:.6})", part.name, middle.x, middle.y)
            })?;
            if fixed {
                self.reactions.push((view.nodes, ends, work));
            } else {
                view.nodes.iter().zip(ends).for_each(|(&i, l)| self.load[i as usize] += l);
                self.energy -= work;
            }
        }
        Ok(())
    }

    fn forms<'a>(&self, mesh: &'a Mesh, materials: &'a [Material; 2], stresses: Vec<Vec2>) -> Forms<'a> {
        let energy = self.solution.energy;
        // L(u) = ½A(u,u) − f(u)
        let work = 0.5 * energy - self.energy;
        Forms { mesh, materials, loads: self.load.clone(), stresses, work, energy }
    }

    /// `∫_{Γ_K} T_n [v]_n ds`, or across a gap `∫ T_ξ (v''_ξ − v'_ξ − ε) dη`, for a nodal field.
    pub fn contact_work(&self, v: &[Vec2]) -> f64 {
        self.contact.iter().map(|side| side.work(v)).sum()
    }

    /// `A(u, φ_i) = f(φ_i) + ∫_{Γ_K} T_n [φ_i]_n ds`, or across a gap `∫ T_ξ (φ''_iξ − φ'_iξ) dη`, for the nodes that `Γ_u` leaves
    /// free: the load whose solution is the projection of `u`.
    pub fn projection_load(&self) -> Vec<Vec2> {
        let mut load = self.load.clone();
        self.contact.iter().for_each(|side| side.add_to(&mut load));
        load
    }

    /// `∫_{Γ_u} τ(u)n·(v − u) ds`.
    pub fn reaction_work(&self, v: &[Vec2]) -> f64 {
        let on = |(nodes, ends, work): &([u32; 3], [Vec2; 3], f64)| {
            nodes.iter().zip(ends).map(|(&i, r)| r.dot(&v[i as usize])).sum::<f64>() - work
        };
        self.reactions.iter().map(on).sum()
    }
}
