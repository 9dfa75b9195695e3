//! Norms of the difference of two fields that live on different meshes of the same bodies.
//!
//! ```text
//!   +-------+      The sum runs over the triangles of the fine mesh. Straight triangles of both meshes have convex
//!   |\  /\  |      polygons in common, on which the difference is linear: those are integrated exactly. A fine triangle
//!   | \/  \ |      that has to do with a curved one of either mesh is integrated by points, each of which takes the
//!   +-/----\+      coarse function of the element that it lies in.
//! ```
//!
//! The coarse function itself is taken, not its interpolant at the fine nodes: that one smooths what the fine mesh cannot
//! hold, the kinks along the coarse sides, and so underestimates the difference.

use super::clip::Polygon;
use super::{Several, Squares, square_of_linear};
use crate::element::{displacement_gradient, gradients, hats};
use crate::geometry::{Point, Vec2};
use crate::material::Material;
use crate::mesh::{Locator, Mesh};
use crate::quadrature::Cubature;
use crate::sum::ordered_sum;
use rayon::prelude::*;
use std::ops::AddAssign;

/// Polygons that leave less than this share of a triangle uncovered cover it.
const UNCOVERED: f64 = 1e-9;

/// The norms of `v − w` for each of several pairs of a field `v` on the fine mesh and a field `w` on the mesh of `coarse`, once
/// for every depth. A depth refines the rule on triangles that are integrated by points: 7 of them, or 64 with a curved side,
/// on each of `4^depth` pieces.
pub fn of_located<const N: usize, const M: usize>(
    fine: &Mesh,
    materials: &[Material; 2],
    coarse: &Locator,
    pairs: [(&[Vec2], &[Vec2]); N],
    depths: [u32; M],
) -> [[Squares; N]; M] {
    let cubatures = depths.map(|depth| Cubature { depth, ..Default::default() });
    let overlay = Overlay { fine, materials, coarse, pairs };
    let sums: EachDepth<N, M> = ordered_sum(fine.triangles.len(), |t| match overlay.by_polygons(t) {
        Some(exact) => EachDepth([exact; M]),
        None => EachDepth(cubatures.each_ref().map(|cubature| overlay.by_points(t, cubature))),
    });
    sums.0.map(|several| several.0)
}

/// Sums for several fields, once for every depth.
struct EachDepth<const N: usize, const M: usize>([Several<N>; M]);

impl<const N: usize, const M: usize> Default for EachDepth<N, M> {
    fn default() -> Self {
        Self([Several::default(); M])
    }
}

impl<const N: usize, const M: usize> AddAssign for EachDepth<N, M> {
    fn add_assign(&mut self, other: Self) {
        self.0.iter_mut().zip(other.0).for_each(|(sum, part)| *sum += part);
    }
}

/// Two meshes of the same bodies and what is compared on them.
struct Overlay<'a, const N: usize> {
    fine: &'a Mesh,
    materials: &'a [Material; 2],
    coarse: &'a Locator<'a>,
    pairs: [(&'a [Vec2], &'a [Vec2]); N],
}

impl<const N: usize> Overlay<'_, N> {
    /// Exactly, if triangle `t` is straight and straight triangles of the coarse mesh cover it.
    fn by_polygons(&self, t: usize) -> Option<Several<N>> {
        if self.fine.curved.of(t).is_some() {
            return None;
        }
        let corners = self.fine.corners(t);
        let (body, coarse) = (self.fine.body(t), self.coarse.mesh());
        let (gradients, area) = gradients(corners);
        let (mut sums, mut covered) = (Several::default(), 0.0);
        self.coarse.each_near(body, corners, &mut |home| {
            if coarse.curved.of(home).is_some() || (1.0 - UNCOVERED) * area <= covered {
                return;
            }
            let others = coarse.corners(home);
            if are_apart(&corners, &others) {
                return;
            }
            let common = Polygon::common(corners, others);
            let share = common.area();
            if share > 0.0 {
                covered += share;
                self.add_polygon(t, &gradients, home, &common, &mut sums);
            }
        });
        ((1.0 - UNCOVERED) * area <= covered).then_some(sums)
    }

    /// The difference on what triangle `t` has in common with the coarse triangle `home`.
    fn add_polygon(&self, t: usize, own: &[Vec2; 3], home: usize, common: &Polygon, sums: &mut Several<N>) {
        let (body, coarse) = (self.fine.body(t), self.coarse.mesh());
        let (corners, coarse_corners) = (self.fine.corners(t), coarse.corners(home));
        let (theirs, _) = gradients(coarse_corners);
        for (sum, (v, w)) in sums.0.iter_mut().zip(self.pairs) {
            let values = self.fine.triangles[t].map(|i| v[i as usize]);
            let coarse_values = coarse.triangles[home].map(|i| w[i as usize]);
            let gradient = minus(displacement_gradient(own, values), displacement_gradient(&theirs, coarse_values));
            sum.add(body, &self.materials[body.index()], common.area(), Vec2::zeros(), gradient);
            // linear with the gradient G: (v − w)(x) = (v − w)(a) + G (x − a)
            let a = common.corners()[0];
            let at_a = linear(corners, &values, a) - linear(coarse_corners, &coarse_values, a);
            let [g1, g2] = gradient.map(|[gx, gy]| Vec2::new(gx, gy));
            let difference = |x: Vec2| at_a + Vec2::new(g1.dot(&(x - a)), g2.dot(&(x - a)));
            sum.l2 += common.triangles().map(|part| square_of_linear(part, &part.map(difference))).sum::<f64>();
        }
    }

    fn by_points(&self, t: usize, cubature: &Cubature) -> Several<N> {
        let (body, coarse) = (self.fine.body(t), self.coarse.mesh());
        let nodes = self.fine.triangles[t];
        let mut sums = Several::default();
        let mut add = |x: Vec2, phi: &[f64; 3], gradients: &[Vec2; 3], weight: f64| {
            let found = self.coarse.locate(body, x);
            for (sum, (v, w)) in sums.0.iter_mut().zip(self.pairs) {
                let values = nodes.map(|i| v[i as usize]);
                let value = (0..3).map(|k| phi[k] * values[k]).sum::<Vec2>() - found.value(coarse, w);
                let gradient = minus(displacement_gradient(gradients, values), found.gradient(coarse, w));
                sum.add(body, &self.materials[body.index()], weight, value, gradient);
            }
        };
        match self.fine.curved_triangle(t) {
            Some(curved) => cubature.curved(&curved, &mut |p, w| add(p.x, &p.hats, &p.gradients, w)),
            None => {
                let corners = self.fine.corners(t);
                let (gradients, _) = gradients(corners);
                cubature.triangle(corners, &mut |x, w| add(x, &hats(corners, x), &gradients, w));
            }
        }
        sums
    }
}

/// Whether the boxes around two triangles have no point in common.
fn are_apart(a: &[Point; 3], b: &[Point; 3]) -> bool {
    let range = |t: &[Point; 3], k: usize| {
        (f64::min(t[0][k], f64::min(t[1][k], t[2][k])), f64::max(t[0][k], f64::max(t[1][k], t[2][k])))
    };
    (0..2).any(|k| {
        let ((low_a, high_a), (low_b, high_b)) = (range(a, k), range(b, k));
        high_a < low_b || high_b < low_a
    })
}

fn minus(a: [[f64; 2]; 2], b: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][j] - b[i][j]))
}

/// The linear function with these values at the corners, at `x`.
fn linear(corners: [Point; 3], values: &[Vec2; 3], x: Point) -> Vec2 {
    hats(corners, x).iter().zip(values).map(|(h, v)| *h * v).sum()
}

/// The value of a field at points of another mesh: nodal values of its interpolant there.
pub fn interpolate(at: &Mesh, from: &Locator, nodal: &[Vec2]) -> Vec<Vec2> {
    let value = |(x, body): (&Vec2, &_)| from.locate(*body, *x).value(from.mesh(), nodal);
    at.points.par_iter().zip(&at.node_bodies).map(value).collect()
}
