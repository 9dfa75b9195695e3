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

mod element;
#[cfg(test)]
mod tests;

use crate::study::{ExactScene, PartCondition, Scene};
use element::{Element, ElementIntegrand};
use rayon::prelude::*;
use signorini_contact::geometry::{Segment, right_normal};
use signorini_contact::material::Material;
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use signorini_contact::problem::Data;
use signorini_contact::quadrature::Cubature;
use signorini_contact::sum::ordered_sum;
use signorini_contact::{Vec2, zone::Zone};

/// A piece of an element is not split more often than this.
const DEEPEST: u32 = 6;

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
    /// `∫_{Γ_K} T_n φ ds` for the two ends of every contact side.
    pub contact_stress: Vec<[f64; 2]>,
    /// `∫ τ(u)n·u ds` and, for the two ends, `∫ τ(u)n φ ds` over every side of `Γ_u`, with its nodes.
    reactions: Vec<([u32; 2], [Vec2; 2], f64)>,
}

/// The same integrals by two quadratures, the second one refinement finer on every element.
pub struct Pair {
    /// The coarser one: what the quadrature error is measured against.
    pub base: Integrals,
    /// The finer one: what is used.
    pub fine: Integrals,
}

impl Pair {
    /// Integrates on every element, splitting pieces where one more refinement still changes the result by more than its
    /// share. `u_I` are the nodal values of `u`. With `fixed` nothing is graded, cut or split: one rule for all elements.
    pub fn new(scene: &Scene, exact: &ExactScene, mesh: &Mesh, zone: &Zone, interpolant: &[Vec2], fixed: bool) -> Self {
        let cubature = scene.cubature(0, fixed);
        let element = |t: usize| ElementIntegrand::new(scene, exact, mesh, interpolant, t);
        let rough = |t: usize| element(t).once(&cubature).interpolation.energy;
        let total = ordered_sum(mesh.triangles.len(), rough);
        let share = total * f64::min(SMALLEST_SHARE, 1.0 / mesh.triangles.len() as f64);
        let deepest = if fixed { 0 } else { DEEPEST };
        let pair = |t: usize| element(t).adaptively(&cubature, share, deepest);
        let pairs: Vec<[Element; 2]> = (0..mesh.triangles.len()).into_par_iter().with_min_len(16).map(pair).collect();
        let collect = |k: usize| {
            let elements = pairs.iter().map(|pair| pair[k]).collect();
            Integrals::new(scene, exact, mesh, zone, elements, &scene.cubature(k as u32, fixed))
        };
        Self { base: collect(0), fine: collect(1) }
    }
}

impl Integrals {
    /// Sums up the elements and adds the boundary.
    fn new(
        scene: &Scene,
        exact: &ExactScene,
        mesh: &Mesh,
        zone: &Zone,
        elements: Vec<Element>,
        cubature: &Cubature,
    ) -> Self {
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
            contact_stress: contact_stress(exact, mesh, zone, cubature),
            reactions: Vec::new(),
        };
        integrals.add_boundary(scene, exact, mesh, cubature);
        integrals
    }

    /// Tractions: their loads and their work on `u`. Reactions of `Γ_u`.
    fn add_boundary(&mut self, scene: &Scene, exact: &ExactScene, mesh: &Mesh, cubature: &Cubature) {
        for side in &mesh.sides {
            let part = &scene.parts[side.part as usize];
            let corners = side.nodes.map(|i| mesh.points[i as usize]);
            let normal = right_normal(corners[0], corners[1]);
            let mut ends = [Vec2::zeros(); 2];
            let mut work = 0.0;
            let fixed = matches!(part.condition, PartCondition::Fixed(_));
            if !fixed && !matches!(part.condition, PartCondition::Traction(_)) {
                continue;
            }
            on_side(corners, cubature, &mut |x, w, phi| {
                let stress = if fixed {
                    exact.traction(part.body, x, normal)
                } else {
                    scene.traction(side.part as usize, x, normal)
                };
                (0..2).for_each(|k| ends[k] += w * phi[k] * stress);
                work += w * stress.dot(&exact.solution.value(part.body, x));
            });
            if fixed {
                self.reactions.push((side.nodes, ends, work));
            } else {
                side.nodes.iter().zip(ends).for_each(|(&i, l)| self.load[i as usize] += l);
                self.energy -= work;
            }
        }
    }

    /// Squares of the error `u − u_h` for `u_h = u_I − d`.
    pub fn error(&self, mesh: &Mesh, materials: &[Material; 2], d: &[Vec2]) -> Squares {
        ordered_sum(self.elements.len(), |t| {
            let nodal = mesh.triangles[t].map(|i| d[i as usize]);
            self.elements[t].error(mesh, &materials[mesh.body(t).index()], t, nodal)
        })
    }

    /// `∫_{Γ_K} T_n [v]_n ds` for nodal values of the jump `[v]_n` at the two ends of every contact side.
    pub fn contact_work(&self, jump: &[[f64; 2]]) -> f64 {
        self.contact_stress.iter().zip(jump).map(|(s, j)| s[0] * j[0] + s[1] * j[1]).sum()
    }

    /// `∫_{Γ_u} τ(u)n·(v − u) ds`.
    pub fn reaction_work(&self, v: &[Vec2]) -> f64 {
        let on = |(nodes, ends, work): &([u32; 2], [Vec2; 2], f64)| {
            nodes.iter().zip(ends).map(|(&i, r)| r.dot(&v[i as usize])).sum::<f64>() - work
        };
        self.reactions.iter().map(on).sum()
    }
}

fn contact_stress(exact: &ExactScene, mesh: &Mesh, zone: &Zone, cubature: &Cubature) -> Vec<[f64; 2]> {
    let of_side = |(side, &normal): (usize, &Vec2)| {
        let corners = mesh.contact[side].first.map(|i| mesh.points[i as usize]);
        let mut ends = [0.0; 2];
        on_side(corners, cubature, &mut |x, w, phi| {
            let stress = w * exact.contact_stress(x, normal);
            (0..2).for_each(|k| ends[k] += phi[k] * stress);
        });
        ends
    };
    zone.side_normals.iter().enumerate().map(of_side).collect()
}

/// Quadrature over a side with the two linear hat functions at each point.
fn on_side(ends: [Vec2; 2], cubature: &Cubature, visit: &mut impl FnMut(Vec2, f64, [f64; 2])) {
    let side = Segment { a: ends[0], b: ends[1] };
    cubature.side(ends[0], ends[1], &mut |x, w| {
        let s = side.parameter(x);
        visit(x, w, [1.0 - s, s]);
    });
}
