//! One triangle: what it contributes by one rule.

use super::curved::CurvedPart;
use crate::exact::{Jet2, derived};
use crate::study::{ExactScene, Scene, VectorField};
use signorini_contact::element::{CurvedTriangle, displacement_gradient, gradients};
use signorini_contact::geometry::twice_area;
use signorini_contact::material::{Material, contract, strain};
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::{Squares, square_of_linear};
use signorini_contact::quadrature::{
    Cubature, Patch, conical_points, seven_points, six_points, sixteen_points, three_points,
};
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

/// Everything that is integrated over one element.
pub struct ElementIntegrand<'a> {
    exact: &'a ExactScene,
    body: Body,
    material: &'a Material,
    given_force: Option<&'a VectorField>,
    /// The corners, counterclockwise.
    pub corners: [Vec2; 3],
    /// The triangle, if it has a curved side.
    pub curved: Option<CurvedTriangle<'a>>,
    centroid: Vec2,
    hat_gradients: [Vec2; 3],
    nodal: [Vec2; 3],
    linear: [[f64; 2]; 2],
}

impl<'a> ElementIntegrand<'a> {
    /// On triangle `t`, for the nodal values of `u_I`.
    pub fn new(scene: &'a Scene, exact: &'a ExactScene, mesh: &'a Mesh, interpolant: &[Vec2], t: usize) -> Self {
        let (body, corners) = (mesh.body(t), mesh.corners(t));
        let nodal = mesh.triangles[t].map(|i| interpolant[i as usize]);
        let (hat_gradients, _) = gradients(corners);
        let linear = displacement_gradient(&hat_gradients, nodal);
        let centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
        let given_force = scene.body_force[body.index()].as_ref();
        let (material, curved) = (&scene.materials[body.index()], mesh.curved_triangle(t));
        Self { exact, body, material, given_force, corners, curved, centroid, hat_gradients, nodal, linear }
    }

    /// The material of the discrete problem.
    pub fn material(&self) -> &Material {
        self.material
    }

    /// `A(w,w)` on the element by a rule of degree 2 without splitting: what shares of the accuracy are measured in. With a `sample`,
    /// by that one of its three points alone.
    pub fn rough_energy(&self, cubature: &Cubature, sample: Option<usize>) -> f64 {
        let mut energy = 0.0;
        let mut add = |x: Vec2, weight: f64| {
            let gradient = self.exact.solution.jet(self.body, x).gradient;
            let e = strain(std::array::from_fn(|i| std::array::from_fn(|j| gradient[i][j] - self.linear[i][j])));
            energy += weight * contract(self.material.stress(e), e);
        };
        cubature.pieces(self.corners, &mut |piece| {
            let mut number = 0;
            three_points(piece, &mut |x, weight| {
                match sample {
                    None => add(x, weight),
                    Some(k) if k == number => add(x, 3.0 * weight),
                    Some(_) => {}
                }
                number += 1;
            });
        });
        energy
    }

    /// What a piece of the triangle contributes by a rule.
    pub fn over(&self, piece: [Vec2; 3], rule: Rule) -> Element {
        let mut sums = Element::default();
        let mut add = |x: Vec2, weight: f64| {
            self.add(x, weight, &self.hats(x), &self.linear, &mut sums);
        };
        match rule {
            Rule::Six => six_points(piece, &mut add),
            Rule::Seven => seven_points(piece, &mut add),
            Rule::Sixteen => sixteen_points(piece, &mut add),
            Rule::Conical => conical_points(piece, &mut add),
        }
        sums.solution = self.solution(&piece, &sums);
        sums
    }

    /// Squares of `u = u_I + w` on a piece of a straight triangle, from the integrals of `w`: `‖u‖² = ‖w‖² + 2(w, u_I) + ‖u_I‖²`.
    fn solution(&self, piece: &[Vec2; 3], sums: &Element) -> Squares {
        let (e, mean) = (strain(self.linear), strain(sums.mean));
        let mut squares = sums.interpolation;
        squares.add(self.body, self.material, area(piece), Vec2::zeros(), self.linear);
        squares.strain[self.body.index()] += 2.0 * contract(e, mean);
        squares.energy += 2.0 * contract(self.material.stress(e), mean);
        squares.gradient += 2.0 * (0..4).map(|k| self.linear[k / 2][k % 2] * sums.mean[k / 2][k % 2]).sum::<f64>();
        squares.l2 += square_of_linear(*piece, &piece.map(|x| self.interpolant(&self.hats(x))));
        squares.l2 += 2.0 * self.nodal.iter().zip(&sums.moments).map(|(u, m)| u.dot(m)).sum::<f64>();
        squares
    }

    /// `φ_k(x) = ⅓ + ∇φ_k·(x − centroid)`.
    fn hats(&self, x: Vec2) -> [f64; 3] {
        let offset = x - self.centroid;
        self.hat_gradients.map(|g| 1.0 / 3.0 + g.dot(&offset))
    }

    /// `u_I` from the values of the hat functions.
    fn interpolant(&self, hats: &[f64; 3]) -> Vec2 {
        (0..3).map(|k| hats[k] * self.nodal[k]).sum()
    }

    /// What a patch of a triangle with a curved side contributes by the product of a rule on `(0, 1)` with itself.
    pub fn over_patch(&self, triangle: &CurvedTriangle, patch: Patch, rule: &[(f64, f64)]) -> CurvedPart {
        let mut part = CurvedPart::default();
        triangle.points_by(rule, patch.rho, patch.tau, &mut |p, weight| {
            let linear = p.gradient(&self.nodal);
            let (jet, grad_w) = self.add(p.x, weight, &p.hats, &linear, &mut part.element);
            part.element.solution.add(self.body, self.material, weight, jet.value, jet.gradient);
            part.add_moments(p, weight, &grad_w);
        });
        part
    }

    /// Adds a point with the values of the hat functions and the gradient of `u_I` there, all but the squares of `u`; gives back
    /// `u` and `∇w`.
    fn add(
        &self,
        x: Vec2,
        weight: f64,
        hat: &[f64; 3],
        linear: &[[f64; 2]; 2],
        sums: &mut Element,
    ) -> (Jet2, [[f64; 2]; 2]) {
        let jet = self.exact.solution.jet2(self.body, x);
        let derive = || derived::body_force_of(&jet, &self.exact.materials[self.body.index()]);
        let force = self.given_force.map_or_else(derive, |f| f(x, Vec2::zeros()));
        let w = jet.value - self.interpolant(hat);
        let grad_w = std::array::from_fn(|i| std::array::from_fn(|j| jet.gradient[i][j] - linear[i][j]));
        add_scaled(&mut sums.mean, weight, &grad_w);
        for k in 0..3 {
            sums.moments[k] += weight * hat[k] * w;
            sums.load[k] += weight * hat[k] * force;
        }
        sums.work += weight * force.dot(&jet.value);
        sums.interpolation.add(self.body, self.material, weight, w, grad_w);
        (jet, grad_w)
    }
}

/// A rule on a triangle.
#[derive(Clone, Copy)]
pub enum Rule {
    /// Of degree 4.
    Six,
    /// Of degree 5.
    Seven,
    /// Of degree 8.
    Sixteen,
    /// Of degree 10, 36 points.
    Conical,
}

fn area(t: &[Vec2; 3]) -> f64 {
    0.5 * twice_area(t[0], t[1], t[2]).abs()
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
