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
use crate::study::{ExactScene, PartCondition, Scene, VectorField};
use rayon::prelude::*;
use signorini_contact::element::{displacement_gradient, gradients, hats};
use signorini_contact::geometry::right_normal;
use signorini_contact::material::{Material, contract, strain};
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use signorini_contact::quadrature::{Cubature, conical_points, quarter, seven_points};
use signorini_contact::sum::ordered_sum;
use signorini_contact::{Body, Vec2, zone::Zone};
use std::ops::AddAssign;

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

/// Share of the interpolation error's square that one more refinement of the quadrature may change.
const ACCURACY: f64 = 2.5e-7;

/// Share of the interpolation error, in the energy norm, that the loads may change by under one more refinement.
const LOAD_ACCURACY: f64 = 1e-4;

/// Every piece may err by this share of the accuracy, or by its element's even share if that is less.
const SMALLEST_SHARE: f64 = 1e-4;

/// A piece of an element is not split more often than this.
const DEEPEST: u32 = 6;

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

/// Everything that is integrated over one element.
struct ElementIntegrand<'a> {
    exact: &'a ExactScene,
    body: Body,
    material: &'a Material,
    given_force: Option<&'a VectorField>,
    corners: [Vec2; 3],
    nodal: [Vec2; 3],
    linear: [[f64; 2]; 2],
}

impl<'a> ElementIntegrand<'a> {
    fn new(scene: &'a Scene, exact: &'a ExactScene, mesh: &Mesh, interpolant: &[Vec2], t: usize) -> Self {
        let (body, corners) = (mesh.body(t), mesh.corners(t));
        let nodal = mesh.triangles[t].map(|i| interpolant[i as usize]);
        let linear = displacement_gradient(&gradients(corners).0, nodal);
        let given_force = scene.body_force[body.index()].as_ref();
        Self { exact, body, material: &scene.materials[body.index()], given_force, corners, nodal, linear }
    }

    /// The rule on every piece, without splitting.
    fn once(&self, cubature: &Cubature) -> Element {
        let mut sums = Element::default();
        cubature.pieces(self.corners, &mut |piece| sums += self.over(piece, Rule::Ordinary));
        sums
    }

    /// By a rule on pieces and on their quarters. Where the two differ too much, a rule of higher degree takes over, and
    /// pieces are split until it settles. `share` of the interpolation error is allowed to each piece, and a quarter of it
    /// to each of its quarters.
    fn adaptively(&self, cubature: &Cubature, share: f64, deepest: u32) -> [Element; 2] {
        let mut pair = [Element::default(); 2];
        cubature.pieces(self.corners, &mut |piece| {
            let coarse = self.over(piece, Rule::Ordinary);
            let fine = self.over_quarters(piece, Rule::Ordinary);
            if deepest > 0 && self.is_rough(&coarse, &sum(&fine), share) {
                self.split(piece, &self.over(piece, Rule::Rich), share, deepest, &mut pair);
            } else {
                pair[0] += coarse;
                pair[1] += sum(&fine);
            }
        });
        pair
    }

    fn split(&self, piece: [Vec2; 3], coarse: &Element, share: f64, deepest: u32, pair: &mut [Element; 2]) {
        let parts = self.over_quarters(piece, Rule::Rich);
        let fine = sum(&parts);
        if deepest > 0 && self.is_rough(coarse, &fine, share) {
            for (quarter, part) in quarter(piece).into_iter().zip(&parts) {
                self.split(quarter, part, 0.25 * share, deepest - 1, pair);
            }
        } else {
            pair[0] += *coarse;
            pair[1] += fine;
        }
    }

    /// Whether one refinement still changed the interpolation error or the loads by more than their shares.
    fn is_rough(&self, coarse: &Element, fine: &Element, share: f64) -> bool {
        let whole = fine.interpolation.energy + share;
        let change = (coarse.interpolation.energy - fine.interpolation.energy).abs();
        let load: f64 = coarse.load.iter().zip(&fine.load).map(|(b, f)| (b - f).norm_squared()).sum();
        change > ACCURACY * whole || load / self.material.matrix()[0][0] > LOAD_ACCURACY * LOAD_ACCURACY * whole
    }

    fn over_quarters(&self, piece: [Vec2; 3], rule: Rule) -> [Element; 4] {
        quarter(piece).map(|q| self.over(q, rule))
    }

    fn over(&self, piece: [Vec2; 3], rule: Rule) -> Element {
        let mut sums = Element::default();
        match rule {
            Rule::Ordinary => seven_points(piece, &mut |x, w| self.add_point(x, w, &mut sums)),
            Rule::Rich => conical_points(piece, &mut |x, w| self.add_point(x, w, &mut sums)),
        }
        sums
    }

    fn add_point(&self, x: Vec2, weight: f64, sums: &mut Element) {
        let jet = self.exact.solution.jet2(self.body, x);
        let derive = || derived::body_force_of(&jet, &self.exact.materials[self.body.index()]);
        let force = self.given_force.map_or_else(derive, |f| f(x, Vec2::zeros()));
        let hat = hats(self.corners, x);
        let u_i: Vec2 = (0..3).map(|k| hat[k] * self.nodal[k]).sum();
        let w = jet.value - u_i;
        let grad_w = std::array::from_fn(|i| std::array::from_fn(|j| jet.gradient[i][j] - self.linear[i][j]));
        add_scaled(&mut sums.mean, weight, &grad_w);
        for k in 0..3 {
            sums.moments[k] += weight * hat[k] * w;
            sums.load[k] += weight * hat[k] * force;
        }
        sums.work += weight * force.dot(&jet.value);
        sums.interpolation.add(self.body, self.material, weight, w, grad_w);
        sums.solution.add(self.body, self.material, weight, jet.value, jet.gradient);
    }
}

/// Degree 5 where the integrand is smooth on the piece's scale, degree 10 where it is not.
#[derive(Clone, Copy)]
enum Rule {
    Ordinary,
    Rich,
}

fn sum(parts: &[Element; 4]) -> Element {
    let mut sum = Element::default();
    parts.iter().for_each(|p| sum += *p);
    sum
}

fn add_scaled(sum: &mut [[f64; 2]; 2], factor: f64, by: &[[f64; 2]; 2]) {
    sum.iter_mut().flatten().zip(by.iter().flatten()).for_each(|(s, b)| *s += factor * b);
}

impl AddAssign for Element {
    fn add_assign(&mut self, other: Self) {
        add_scaled(&mut self.mean, 1.0, &other.mean);
        (0..3).for_each(|k| self.moments[k] += other.moments[k]);
        (0..3).for_each(|k| self.load[k] += other.load[k]);
        self.work += other.work;
        self.interpolation += other.interpolation;
        self.solution += other.solution;
    }
}

impl Element {
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
