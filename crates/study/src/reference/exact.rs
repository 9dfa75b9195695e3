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

use crate::exact::derived;
use crate::study::{ExactScene, PartCondition, Scene};
use rayon::prelude::*;
use signorini_contact::element::{displacement_gradient, gradients, hats};
use signorini_contact::geometry::right_normal;
use signorini_contact::material::{Material, contract, strain};
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use signorini_contact::quadrature::Cubature;
use signorini_contact::sum::ordered_sum;
use signorini_contact::{Vec2, zone::Zone};

/// What one triangle contributes.
#[derive(Clone, Copy, Default)]
struct Element {
    /// `∫∇w`.
    mean: [[f64; 2]; 2],
    /// Squares of `w`.
    interpolation: Squares,
    /// `∫ w φ_k`.
    moments: [Vec2; 3],
    /// `∫ F φ_k`.
    load: [Vec2; 3],
    /// `∫ F·u`.
    work: f64,
    /// Squares of `u`.
    solution: Squares,
}

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

impl Integrals {
    /// One pass over the mesh. `u_I` are the nodal values of `u`.
    pub fn new(
        scene: &Scene,
        exact: &ExactScene,
        mesh: &Mesh,
        zone: &Zone,
        interpolant: &[Vec2],
        cubature: &Cubature,
    ) -> Self {
        let element = |t: usize| Element::new(scene, exact, mesh, interpolant, cubature, t);
        let elements: Vec<Element> = (0..mesh.triangles.len()).into_par_iter().with_min_len(32).map(element).collect();
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
                    signorini_contact::problem::Data::traction(scene, side.part as usize, x, normal)
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

impl Element {
    fn new(
        scene: &Scene,
        exact: &ExactScene,
        mesh: &Mesh,
        interpolant: &[Vec2],
        cubature: &Cubature,
        t: usize,
    ) -> Self {
        let (body, corners) = (mesh.body(t), mesh.corners(t));
        let (material, own) = (&scene.materials[body.index()], &exact.materials[body.index()]);
        let given = scene.body_force[body.index()].as_ref();
        let (g, _) = gradients(corners);
        let nodal = mesh.triangles[t].map(|i| interpolant[i as usize]);
        let linear = displacement_gradient(&g, nodal);
        let mut sums = Self::default();
        cubature.triangle(corners, &mut |x, weight| {
            let jet = exact.solution.jet2(body, x);
            let force = given.map_or_else(|| derived::body_force_of(&jet, own), |f| f(x, Vec2::zeros()));
            let hat = hats(corners, x);
            let u_i: Vec2 = (0..3).map(|k| hat[k] * nodal[k]).sum();
            let w = jet.value - u_i;
            let grad_w: [[f64; 2]; 2] =
                std::array::from_fn(|i| std::array::from_fn(|j| jet.gradient[i][j] - linear[i][j]));
            for i in 0..2 {
                (0..2).for_each(|j| sums.mean[i][j] += weight * grad_w[i][j]);
            }
            for k in 0..3 {
                sums.moments[k] += weight * hat[k] * w;
                sums.load[k] += weight * hat[k] * force;
            }
            sums.work += weight * force.dot(&jet.value);
            sums.interpolation.add(body, material, weight, w, grad_w);
            sums.solution.add(body, material, weight, jet.value, jet.gradient);
        });
        sums
    }

    fn error(&self, mesh: &Mesh, material: &Material, t: usize, d: [Vec2; 3]) -> Squares {
        let body = mesh.body(t);
        let (g, area) = gradients(mesh.corners(t));
        let grad = displacement_gradient(&g, d);
        let (e, mean) = (strain(grad), strain(self.mean));
        let mut squares = self.interpolation;
        squares.add(body, material, area, Vec2::zeros(), grad);
        squares.strain[body.index()] += 2.0 * contract(e, mean);
        squares.energy += 2.0 * contract(material.stress(e), mean);
        squares.gradient += 2.0 * (0..4).map(|k| grad[k / 2][k % 2] * self.mean[k / 2][k % 2]).sum::<f64>();
        // ∫|w + d|² = ∫|w|² + 2 Σ d_k·∫wφ_k + |T|/12 (|Σd_k|² + Σ|d_k|²)
        let total: Vec2 = d.iter().sum();
        squares.l2 += area / 12.0 * (total.norm_squared() + d.iter().map(|d| d.norm_squared()).sum::<f64>());
        squares.l2 += 2.0 * d.iter().zip(&self.moments).map(|(d, m)| d.dot(m)).sum::<f64>();
        squares
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
    let side = signorini_contact::geometry::Segment { a: ends[0], b: ends[1] };
    cubature.side(ends[0], ends[1], &mut |x, w| {
        let s = side.parameter(x);
        visit(x, w, [1.0 - s, s]);
    });
}
