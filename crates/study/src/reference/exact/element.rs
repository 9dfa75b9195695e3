//! One triangle: what it contributes, by a rule that is refined where it does not resolve the solution.

use super::curved::CurvedPart;
use crate::exact::derived;
use crate::study::{ExactScene, Scene, VectorField};
use signorini_contact::element::{CurvedTriangle, displacement_gradient, gradients, hats};
use signorini_contact::material::{Material, contract, strain};
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use signorini_contact::quadrature::{Cubature, Patch, conical_points, quarter, seven_points, sixteen_points};
use signorini_contact::{Body, Vec2};
use std::ops::AddAssign;

/// What one triangle contributes.
#[derive(Clone, Copy, Default)]
pub struct Element {
    /// `∫∇w`.
    pub mean: [[f64; 2]; 2],
    /// Squares of `w`.
    pub interpolation: Squares,
    /// `∫ w φ_k`.
    pub moments: [Vec2; 3],
    /// `∫ F φ_k`.
    pub load: [Vec2; 3],
    /// `∫ F·u`.
    pub work: f64,
    /// Squares of `u`.
    pub solution: Squares,
}

/// Share of the interpolation error's square that one more refinement of the quadrature may change.
const ACCURACY: f64 = 2.5e-7;

/// Share of the interpolation error, in the energy norm, that the loads may change by under one more refinement.
const LOAD_ACCURACY: f64 = 1e-4;

/// Everything that is integrated over one element.
pub struct ElementIntegrand<'a> {
    exact: &'a ExactScene,
    body: Body,
    material: &'a Material,
    given_force: Option<&'a VectorField>,
    corners: [Vec2; 3],
    curved: Option<CurvedTriangle<'a>>,
    nodal: [Vec2; 3],
    linear: [[f64; 2]; 2],
}

impl<'a> ElementIntegrand<'a> {
    pub fn new(scene: &'a Scene, exact: &'a ExactScene, mesh: &'a Mesh, interpolant: &[Vec2], t: usize) -> Self {
        let (body, corners) = (mesh.body(t), mesh.corners(t));
        let nodal = mesh.triangles[t].map(|i| interpolant[i as usize]);
        let linear = displacement_gradient(&gradients(corners).0, nodal);
        let given_force = scene.body_force[body.index()].as_ref();
        let (material, curved) = (&scene.materials[body.index()], mesh.curved_triangle(t));
        Self { exact, body, material, given_force, corners, curved, nodal, linear }
    }

    /// `A(w,w)` on the element by one rule, without splitting: what shares of the accuracy are measured in.
    pub fn rough_energy(&self, cubature: &Cubature) -> f64 {
        let mut energy = 0.0;
        cubature.pieces(self.corners, &mut |piece| {
            seven_points(piece, &mut |x, weight| {
                let gradient = self.exact.solution.jet(self.body, x).gradient;
                let e = strain(std::array::from_fn(|i| std::array::from_fn(|j| gradient[i][j] - self.linear[i][j])));
                energy += weight * contract(self.material.stress(e), e);
            });
        });
        energy
    }

    /// By a rule on pieces and a finer one. Where the two differ too much, a rule of still higher degree takes over, and
    /// pieces are split until it settles. `share` of the interpolation error is allowed to each piece, and a quarter of it
    /// to each of its quarters.
    pub fn adaptively(&self, cubature: &Cubature, share: f64, deepest: u32) -> [Element; 2] {
        let mut pair = [Element::default(); 2];
        cubature.pieces(self.corners, &mut |piece| {
            let coarse = self.over(piece, Rule::Ordinary);
            let fine = self.over(piece, Rule::Fine);
            if deepest > 0 && self.is_rough(&coarse, &fine, share) {
                self.split(piece, &self.over(piece, Rule::Rich), share, deepest, &mut pair);
            } else {
                pair[0] += coarse;
                pair[1] += fine;
            }
        });
        pair
    }

    fn split(&self, piece: [Vec2; 3], coarse: &Element, share: f64, deepest: u32, pair: &mut [Element; 2]) {
        let parts = quarter(piece).map(|q| self.over(q, Rule::Rich));
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

    /// The same for a triangle with a curved side, patch by patch; its one rule is rich already.
    pub fn adaptively_curved(&self, cubature: &Cubature, share: f64, deepest: u32) -> [CurvedPart; 2] {
        let mut pair = [CurvedPart::default(); 2];
        if let Some(triangle) = &self.curved {
            cubature.patches(triangle, &mut |patch| {
                self.split_curved(triangle, patch, &self.over_patch(triangle, patch), share, deepest, &mut pair);
            });
        }
        pair
    }

    fn split_curved(
        &self,
        triangle: &CurvedTriangle,
        patch: Patch,
        coarse: &CurvedPart,
        share: f64,
        deepest: u32,
        pair: &mut [CurvedPart; 2],
    ) {
        let parts = patch.quarter().map(|q| self.over_patch(triangle, q));
        let mut fine = CurvedPart::default();
        parts.iter().for_each(|p| fine += *p);
        if deepest > 0 && self.is_rough(&coarse.element, &fine.element, share) {
            for (quarter, part) in patch.quarter().into_iter().zip(&parts) {
                self.split_curved(triangle, quarter, part, 0.25 * share, deepest - 1, pair);
            }
        } else {
            pair[0] += *coarse;
            pair[1] += fine;
        }
    }

    fn over_patch(&self, triangle: &CurvedTriangle, patch: Patch) -> CurvedPart {
        let mut part = CurvedPart::default();
        triangle.points_within(patch.rho, patch.tau, &mut |p, weight| {
            let linear = p.gradient(&self.nodal);
            let grad_w = self.add(p.x, weight, &p.hats, &linear, &mut part.element);
            part.add_moments(p, weight, &grad_w);
        });
        part
    }

    /// Whether one refinement still changed the interpolation error or the loads by more than their shares.
    fn is_rough(&self, coarse: &Element, fine: &Element, share: f64) -> bool {
        let whole = fine.interpolation.energy + share;
        let change = (coarse.interpolation.energy - fine.interpolation.energy).abs();
        let load: f64 = coarse.load.iter().zip(&fine.load).map(|(b, f)| (b - f).norm_squared()).sum();
        change > ACCURACY * whole || load / self.material.matrix()[0][0] > LOAD_ACCURACY * LOAD_ACCURACY * whole
    }

    fn over(&self, piece: [Vec2; 3], rule: Rule) -> Element {
        let mut sums = Element::default();
        match rule {
            Rule::Ordinary => seven_points(piece, &mut |x, w| self.add_point(x, w, &mut sums)),
            Rule::Fine => sixteen_points(piece, &mut |x, w| self.add_point(x, w, &mut sums)),
            Rule::Rich => conical_points(piece, &mut |x, w| self.add_point(x, w, &mut sums)),
        }
        sums
    }

    fn add_point(&self, x: Vec2, weight: f64, sums: &mut Element) {
        self.add(x, weight, &hats(self.corners, x), &self.linear, sums);
    }

    /// Adds a point with the values of the hat functions and the gradient of `u_I` there; gives back `∇w`.
    fn add(&self, x: Vec2, weight: f64, hat: &[f64; 3], linear: &[[f64; 2]; 2], sums: &mut Element) -> [[f64; 2]; 2] {
        let jet = self.exact.solution.jet2(self.body, x);
        let derive = || derived::body_force_of(&jet, &self.exact.materials[self.body.index()]);
        let force = self.given_force.map_or_else(derive, |f| f(x, Vec2::zeros()));
        let u_i: Vec2 = (0..3).map(|k| hat[k] * self.nodal[k]).sum();
        let w = jet.value - u_i;
        let grad_w = std::array::from_fn(|i| std::array::from_fn(|j| jet.gradient[i][j] - linear[i][j]));
        add_scaled(&mut sums.mean, weight, &grad_w);
        for k in 0..3 {
            sums.moments[k] += weight * hat[k] * w;
            sums.load[k] += weight * hat[k] * force;
        }
        sums.work += weight * force.dot(&jet.value);
        sums.interpolation.add(self.body, self.material, weight, w, grad_w);
        sums.solution.add(self.body, self.material, weight, jet.value, jet.gradient);
        grad_w
    }
}

/// Degrees 5 and 8 where the integrand is smooth on the piece's scale, degree 10 where it is not.
#[derive(Clone, Copy)]
enum Rule {
    Ordinary,
    Fine,
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
    /// `A(w, φ_k e_p) = ∫τ_pq(w) ∂_q φ_k` for the three nodes.
    pub fn forces(&self, mesh: &Mesh, material: &Material, t: usize) -> [Vec2; 3] {
        let (g, _) = gradients(mesh.corners(t));
        let [s11, s22, s12] = material.stress(strain(self.mean));
        g.map(|g| Vec2::new(s11 * g.x + s12 * g.y, s12 * g.x + s22 * g.y))
    }

    pub fn error(&self, mesh: &Mesh, material: &Material, t: usize, d: [Vec2; 3]) -> Squares {
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
