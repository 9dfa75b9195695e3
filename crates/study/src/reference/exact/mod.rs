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
#[cfg(test)]
mod tests;

use crate::splitting::Forms;
use crate::study::{ExactScene, PartCondition, Scene};
use contact::ContactLoad;
use curved::CurvedPart;
use element::{Element, ElementIntegrand};
use rayon::prelude::*;
use signorini_contact::material::Material;
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use signorini_contact::problem::Data;
use signorini_contact::quadrature::Cubature;
use signorini_contact::sum::ordered_sum;
use signorini_contact::{Error, Vec2, assembly};
use std::collections::BTreeMap;

/// A piece of an element is not split more often than this.
const DEEPEST: u32 = 6;

/// Size of the first pieces relative to their distance from a singular point.
const ADAPTIVE_GRADING: f64 = 0.9;

/// Every piece may err by this share of the accuracy, or by its element's even share if that is less.
const SMALLEST_SHARE: f64 = 1e-4;

/// Integrals of the exact solution over a mesh with one quadrature.
pub struct Integrals {
    elements: Vec<Element>,
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
    /// Elements with a curved side, by number.
    curved: BTreeMap<u32, CurvedPart>,
}

/// The same integrals by two quadratures, the second of higher degree or one refinement finer on every element.
pub struct Pair {
    /// The coarser one: what the quadrature error is measured against.
    pub base: Integrals,
    /// The finer one: what is used.
    pub fine: Integrals,
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
        let rough = |t: usize| {
            if mesh.curved.of(t).is_some() { 0.0 } else { element(t).rough_energy(&cubature) }
        };
        let total = ordered_sum(mesh.triangles.len(), rough);
        let share = total * f64::min(SMALLEST_SHARE, 1.0 / mesh.triangles.len() as f64);
        let deepest = if fixed { 0 } else { DEEPEST };
        let curved: Vec<(u32, [CurvedPart; 2])> = (mesh.curved.sides.par_iter())
            .map(|s| (s.triangle, element(s.triangle as usize).adaptively_curved(&cubature, share, deepest)))
            .collect();
        let pair = |t: usize| {
            if mesh.curved.of(t).is_some() {
                Default::default()
            } else {
                element(t).adaptively(&cubature, share, deepest)
            }
        };
        let mut pairs: Vec<[Element; 2]> =
            (0..mesh.triangles.len()).into_par_iter().with_min_len(16).map(pair).collect();
        curved.iter().for_each(|(t, parts)| pairs[*t as usize] = parts.map(|p| p.element));
        let collect = |k: usize| {
            let elements = pairs.iter().map(|pair| pair[k]).collect();
            let curved = curved.iter().map(|(t, parts)| (*t, parts[k])).collect();
            Integrals::new(scene, exact, mesh, elements, curved, &scene.cubature(k as u32, fixed))
        };
        Ok(Self { base: collect(0)?, fine: collect(1)? })
    }
}

impl Integrals {
    /// Sums up the elements and adds the boundary.
    fn new(
        scene: &Scene,
        exact: &ExactScene,
        mesh: &Mesh,
        elements: Vec<Element>,
        curved: BTreeMap<u32, CurvedPart>,
        cubature: &Cubature,
    ) -> Result<Self, Error> {
        let solution = ordered_sum(elements.len(), |t| elements[t].solution);
        let interpolation = ordered_sum(elements.len(), |t| elements[t].interpolation);
        let body_work = ordered_sum(elements.len(), |t| elements[t].work);
        let mut load = vec![Vec2::zeros(); mesh.points.len()];
        for (corners, element) in mesh.triangles.iter().zip(&elements) {
            corners.iter().zip(&element.load).for_each(|(&i, l)| load[i as usize] += l);
        }
        let mut integrals = Self {
            elements,
            interpolation,
            solution,
            energy: 0.5 * solution.energy - body_work,
            load,
            contact: (0..mesh.contact.len()).map(|side| ContactLoad::new(exact, mesh, side, cubature)).collect(),
            reactions: Vec::new(),
            curved,
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

    /// Squares of the error `u − u_h` for `u_h = u_I − d`.
    pub fn error(&self, mesh: &Mesh, materials: &[Material; 2], d: &[Vec2]) -> Squares {
        ordered_sum(self.elements.len(), |t| {
            let nodal = mesh.triangles[t].map(|i| d[i as usize]);
            let material = &materials[mesh.body(t).index()];
            match mesh.curved_triangle(t).zip(self.curved.get(&(t as u32))) {
                Some((triangle, part)) => part.error(&triangle, mesh.body(t), material, nodal),
                None => self.elements[t].error(mesh, material, t, nodal),
            }
        })
    }

    /// `A` and `f` on nodal fields and on `u`, by this quadrature: `A(u, φ_i) = A(w, φ_i) + A(u_I, φ_i)` with `w = u − u_I`.
    pub fn forms<'a>(&self, mesh: &'a Mesh, materials: &'a [Material; 2], interpolant: &[Vec2]) -> Forms<'a> {
        let mut stresses = assembly::internal_forces(mesh, materials, interpolant);
        for (t, corners) in mesh.triangles.iter().enumerate() {
            let material = &materials[mesh.body(t).index()];
            let forces = match self.curved.get(&(t as u32)) {
                Some(part) => part.forces(material),
                None => self.elements[t].forces(mesh, material, t),
            };
            corners.iter().zip(forces).for_each(|(&i, f)| stresses[i as usize] += f);
        }
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
