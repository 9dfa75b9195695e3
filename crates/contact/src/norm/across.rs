//! Norms of the difference of two fields that live on different meshes of the same bodies.
//!
//! ```text
//!   +-------+      The sum runs over the triangles of the fine mesh. One that lies in a single straight triangle of the
//!   |\  /\  |      coarse mesh sees a linear difference, which is integrated exactly. One that is cut by coarse sides, or
//!   | \/  \ |      has to do with a curved triangle of either mesh, is integrated by points, each of which takes the
//!   +-/----\+      coarse function of the element that it lies in.
//! ```
//!
//! The coarse function itself is taken, not its interpolant at the fine nodes: that one smooths what the fine mesh cannot
//! hold, the kinks along the coarse sides, and so underestimates the difference.

use super::{Several, Squares, of_triangle};
use crate::element::{displacement_gradient, gradients, hats};
use crate::geometry::Vec2;
use crate::material::Material;
use crate::mesh::{Locator, Mesh};
use crate::quadrature::Cubature;
use crate::sum::ordered_sum;
use rayon::prelude::*;

/// A corner may stick out of a triangle by this much, as a value of a hat function, and still lie in it.
const ROUNDING: f64 = 1e-12;

/// The norms of `v − w` for each of several pairs of a field `v` on the fine mesh and a field `w` on the mesh of `coarse`.
/// `depth` refines the rule on the triangles that are integrated by points: 7 points, or 64 with a curved side, on each of
/// `4^depth` pieces.
pub fn of_located<const N: usize>(
    fine: &Mesh,
    materials: &[Material; 2],
    coarse: &Locator,
    pairs: [(&[Vec2], &[Vec2]); N],
    depth: u32,
) -> [Squares; N] {
    let overlay = Overlay { fine, materials, coarse, pairs, cubature: Cubature { depth, ..Default::default() } };
    ordered_sum(fine.triangles.len(), |t| overlay.triangle(t)).0
}

/// Two meshes of the same bodies and what is compared on them.
struct Overlay<'a, const N: usize> {
    fine: &'a Mesh,
    materials: &'a [Material; 2],
    coarse: &'a Locator<'a>,
    pairs: [(&'a [Vec2], &'a [Vec2]); N],
    cubature: Cubature,
}

impl<const N: usize> Overlay<'_, N> {
    fn triangle(&self, t: usize) -> Several<N> {
        self.within_one(t).unwrap_or_else(|| self.by_points(t))
    }

    /// Exactly, if triangle `t` is straight and lies in one straight triangle.
    fn within_one(&self, t: usize) -> Option<Several<N>> {
        if self.fine.curved.of(t).is_some() {
            return None;
        }
        let corners = self.fine.corners(t);
        let (body, coarse) = (self.fine.body(t), self.coarse.mesh());
        let home = self.coarse.locate(body, corners.iter().sum::<Vec2>() / 3.0).triangle;
        if coarse.curved.of(home).is_some() {
            return None;
        }
        let within = corners.map(|x| hats(coarse.corners(home), x));
        if within.iter().flatten().any(|h| *h < -ROUNDING) {
            return None;
        }
        let mut sums = Several::default();
        for (sum, (v, w)) in sums.0.iter_mut().zip(self.pairs) {
            let values = coarse.triangles[home].map(|i| w[i as usize]);
            let coarse_value = |k: usize| -> Vec2 { (0..3).map(|c| within[k][c] * values[c]).sum() };
            let difference = [0, 1, 2].map(|k| v[self.fine.triangles[t][k] as usize] - coarse_value(k));
            *sum = of_triangle(corners, body, &self.materials[body.index()], &difference);
        }
        Some(sums)
    }

    fn by_points(&self, t: usize) -> Several<N> {
        let (body, coarse) = (self.fine.body(t), self.coarse.mesh());
        let nodes = self.fine.triangles[t];
        let mut sums = Several::default();
        let mut add = |x: Vec2, phi: &[f64; 3], gradients: &[Vec2; 3], weight: f64| {
            let found = self.coarse.locate(body, x);
            for (sum, (v, w)) in sums.0.iter_mut().zip(self.pairs) {
                let values = nodes.map(|i| v[i as usize]);
                let value = (0..3).map(|k| phi[k] * values[k]).sum::<Vec2>() - found.value(coarse, w);
                let (fine, own) = (displacement_gradient(gradients, values), found.gradient(coarse, w));
                let gradient = std::array::from_fn(|i| std::array::from_fn(|j| fine[i][j] - own[i][j]));
                sum.add(body, &self.materials[body.index()], weight, value, gradient);
            }
        };
        match self.fine.curved_triangle(t) {
            Some(curved) => self.cubature.curved(&curved, &mut |p, w| add(p.x, &p.hats, &p.gradients, w)),
            None => {
                let corners = self.fine.corners(t);
                let (gradients, _) = gradients(corners);
                self.cubature.triangle(corners, &mut |x, w| add(x, &hats(corners, x), &gradients, w));
            }
        }
        sums
    }
}

/// The value of a field at points of another mesh: nodal values of its interpolant there.
pub fn interpolate(at: &Mesh, from: &Locator, nodal: &[Vec2]) -> Vec<Vec2> {
    let value = |(x, body): (&Vec2, &_)| from.locate(*body, *x).value(from.mesh(), nodal);
    at.points.par_iter().zip(&at.node_bodies).map(value).collect()
}
