//! Norms of displacements and of their errors, both bodies together: `|v|² = ∫ ε_ij(v) ε_ij(v) dx` (the strain seminorm
//! of every estimate), `A(v,v)`, the `H¹` seminorm and `L²`.

mod across;
mod clip;
#[cfg(test)]
mod tests;

pub use across::{interpolate, of_located};

use crate::element::{displacement_gradient, gradients, hats};
use crate::geometry::{Point, Vec2, twice_area};
use crate::material::{Material, contract, strain};
use crate::mesh::{Body, Mesh};
use crate::quadrature::Cubature;
use crate::sum::ordered_sum;
use std::ops::AddAssign;

/// Squares of the norms of a displacement field.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Squares {
    /// `∫ ε_ij ε_ij` on `Ω'` and `Ω''`.
    pub strain: [f64; 2],
    /// `A(v,v)`.
    pub energy: f64,
    /// `∫ |∇v|²`.
    pub gradient: f64,
    /// `∫ |v|²`.
    pub l2: f64,
}

impl AddAssign for Squares {
    fn add_assign(&mut self, other: Self) {
        (0..2).for_each(|i| self.strain[i] += other.strain[i]);
        self.energy += other.energy;
        self.gradient += other.gradient;
        self.l2 += other.l2;
    }
}

impl Squares {
    /// The strain seminorm.
    pub fn strain_seminorm(&self) -> f64 {
        (self.strain[0] + self.strain[1]).sqrt()
    }

    /// The energy norm `√A(v,v)`.
    pub fn energy_norm(&self) -> f64 {
        self.energy.sqrt()
    }

    /// The full `H¹` norm.
    pub fn h1_norm(&self) -> f64 {
        (self.gradient + self.l2).sqrt()
    }

    /// The `L²` norm.
    pub fn l2_norm(&self) -> f64 {
        self.l2.sqrt()
    }

    /// Adds `weight` times the squares of a value and a gradient at one point.
    pub fn add(&mut self, body: Body, material: &Material, weight: f64, value: Vec2, gradient: [[f64; 2]; 2]) {
        let e = strain(gradient);
        self.strain[body.index()] += weight * contract(e, e);
        self.energy += weight * contract(material.stress(e), e);
        self.gradient += weight * gradient.iter().flatten().map(|g| g * g).sum::<f64>();
        self.l2 += weight * value.norm_squared();
    }
}

/// The norms of a field of the finite element space: exactly on straight triangles (`L²` by the element mass matrix), by 64
/// points on those with a curved side.
pub fn of_linear(mesh: &Mesh, materials: &[Material; 2], v: &[Vec2]) -> Squares {
    of_nodal(mesh, materials, |i| v[i])
}

/// The same of the difference `u − v` of two fields, which is nowhere stored.
pub fn of_linear_difference(mesh: &Mesh, materials: &[Material; 2], u: &[Vec2], v: &[Vec2]) -> Squares {
    of_nodal(mesh, materials, |i| u[i] - v[i])
}

fn of_nodal(mesh: &Mesh, materials: &[Material; 2], nodal: impl Fn(usize) -> Vec2 + Sync) -> Squares {
    ordered_sum(mesh.triangles.len(), |t| {
        let body = mesh.body(t);
        let values = mesh.triangles[t].map(|i| nodal(i as usize));
        let mut squares = Squares::default();
        if let Some(curved) = mesh.curved_triangle(t) {
            let material = &materials[body.index()];
            curved.points(&mut |p, w| squares.add(body, material, w, p.value(&values), p.gradient(&values)));
            return squares;
        }
        let (g, area) = gradients(mesh.corners(t));
        squares.add(body, &materials[body.index()], area, Vec2::zeros(), displacement_gradient(&g, values));
        squares.l2 = square_of_linear(mesh.corners(t), &values);
        squares
    })
}

/// `∫ |v|² = |T|/12 (|v_0+v_1+v_2|² + Σ|v_k|²)` of the linear field with these values at the corners of a triangle.
pub fn square_of_linear([a, b, c]: [Point; 3], values: &[Vec2; 3]) -> f64 {
    let total: Vec2 = values.iter().sum();
    0.5 * twice_area(a, b, c).abs() / 12.0
        * (total.norm_squared() + values.iter().map(|v| v.norm_squared()).sum::<f64>())
}

/// A displacement and its gradient `g[i][j] = ∂_j u_i` at a point of a body.
pub type ExactFn<'a> = dyn Fn(Body, Point) -> (Vec2, [[f64; 2]; 2]) + Sync + 'a;

/// The norms of `u − v` for each of several piecewise linear fields `v` and a given `u`, evaluating `u` once per
/// quadrature point.
pub fn of_differences<const N: usize>(
    mesh: &Mesh,
    materials: &[Material; 2],
    u: &ExactFn,
    fields: [&[Vec2]; N],
    cubature: &Cubature,
) -> [Squares; N] {
    let sums: Several<N> = ordered_sum(mesh.triangles.len(), |t| {
        let (body, corners) = (mesh.body(t), mesh.corners(t));
        let nodal = fields.map(|v| mesh.triangles[t].map(|i| v[i as usize]));
        let mut sums = Several::default();
        let mut add = |x: Point, hats: &[f64; 3], gradients: &[Vec2; 3], w: f64| {
            let (value, gradient) = u(body, x);
            for k in 0..N {
                let v: Vec2 = (0..3).map(|c| hats[c] * nodal[k][c]).sum();
                let linear = displacement_gradient(gradients, nodal[k]);
                let difference = std::array::from_fn(|i| std::array::from_fn(|j| gradient[i][j] - linear[i][j]));
                sums.0[k].add(body, &materials[body.index()], w, value - v, difference);
            }
        };
        match mesh.curved_triangle(t) {
            Some(curved) => cubature.curved(&curved, &mut |p, w| add(p.x, &p.hats, &p.gradients, w)),
            None => {
                let (g, _) = gradients(corners);
                cubature.triangle(corners, &mut |x, w| add(x, &hats(corners, x), &g, w));
            }
        }
        sums
    });
    sums.0
}

/// Sums for several fields at once.
#[derive(Clone, Copy)]
struct Several<const N: usize>([Squares; N]);

impl<const N: usize> Default for Several<N> {
    fn default() -> Self {
        Self([Squares::default(); N])
    }
}

impl<const N: usize> AddAssign for Several<N> {
    fn add_assign(&mut self, other: Self) {
        (0..N).for_each(|k| self.0[k] += other.0[k]);
    }
}
