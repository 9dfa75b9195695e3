//! The linear triangle: gradients of its hat functions and its stiffness. Triangles with a curved side are in [`curved`].

pub mod curved;
mod inverse;
mod isoparametric;
mod physical;

pub use curved::{CurvedElement, CurvedTriangle, ElementPoint};

use crate::geometry::{Point, Vec2, twice_area};
use crate::material::{Material, Sym2, strain};

/// Gradients of the hat functions `φ_0, φ_1, φ_2` and the area, from the corners in counterclockwise order.
#[inline]
pub fn gradients(corners: [Point; 3]) -> ([Vec2; 3], f64) {
    let [a, b, c] = corners;
    let det = twice_area(a, b, c);
    // ∇φ_i = (opposite side turned by a right angle) / 2|T|.
    let turned = |p: Point, q: Point| Vec2::new(p.y - q.y, q.x - p.x) / det;
    ([turned(b, c), turned(c, a), turned(a, b)], 0.5 * det)
}

/// The values of the hat functions (barycentric coordinates) at `x`.
pub fn hats(corners: [Point; 3], x: Point) -> [f64; 3] {
    let [a, b, c] = corners;
    let det = twice_area(a, b, c);
    [twice_area(x, b, c) / det, twice_area(a, x, c) / det, twice_area(a, b, x) / det]
}

/// The gradient `g[i][j] = ∂_j u_i` of the linear displacement with nodal values `u`.
#[inline]
pub fn displacement_gradient(gradients: &[Vec2; 3], u: [Vec2; 3]) -> [[f64; 2]; 2] {
    let [g, h, k] = gradients;
    let entry = |i: usize, j: usize| u[0][i] * g[j] + u[1][i] * h[j] + u[2][i] * k[j];
    [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
}

/// The strain of the linear displacement with nodal values `u`.
#[inline]
pub fn linear_strain(gradients: &[Vec2; 3], u: [Vec2; 3]) -> Sym2 {
    strain(displacement_gradient(gradients, u))
}

/// The 2×2 block `k_ij = |T| B_iᵀ C B_j` of the element stiffness, by rows; `B_i` takes the displacement of
/// node `i` to the strain `(ε_11, ε_22, 2ε_12)`.
pub fn stiffness_block(material: &Material, area: f64, gi: Vec2, gj: Vec2) -> [f64; 4] {
    times_gradient(&stress_of(material, gi), area, gj)
}

/// The blocks `k_ij` for `i = corner` and every corner `j` of a triangle with these gradients.
#[inline]
pub fn stiffness_row(material: &Material, area: f64, gradients: &[Vec2; 3], corner: usize) -> [[f64; 4]; 3] {
    let left = stress_of(material, gradients[corner]);
    [0, 1, 2].map(|j| times_gradient(&left, area, gradients[j]))
}

/// `B_iᵀ C` before its terms are added: column `p` of `B_i` has the two entries `∂_p φ_i`, in the row of `ε_pp`, and `∂_{1−p} φ_i`,
/// in that of the shear; each times its row of `C`.
type Stress = [[[f64; 3]; 2]; 2];

#[inline]
fn stress_of(material: &Material, g: Vec2) -> Stress {
    let c = material.matrix();
    let times = |d: f64, row: &[f64; 3]| [d * row[0], d * row[1], d * row[2]];
    [[times(g.x, &c[0]), times(g.y, &c[2])], [times(g.y, &c[1]), times(g.x, &c[2])]]
}

/// `|T| (B_iᵀ C) B_j`.
#[inline]
fn times_gradient(left: &Stress, area: f64, g: Vec2) -> [f64; 4] {
    let entry = |[normal, shear]: &[[f64; 3]; 2], q: usize, d: f64, e: f64| {
        area * (normal[q] * d + normal[2] * e + shear[q] * d + shear[2] * e)
    };
    let [first, second] = left;
    [entry(first, 0, g.x, g.y), entry(first, 1, g.y, g.x), entry(second, 0, g.x, g.y), entry(second, 1, g.y, g.x)]
}

#[cfg(test)]
mod tests;

#[cfg(test)]
mod linear {
    use super::*;
    use crate::material::{Plane, contract};

    fn triangle() -> [Point; 3] {
        [Point::new(0.3, -0.2), Point::new(1.7, 0.4), Point::new(0.1, 1.9)]
    }

    #[test]
    fn hats_are_nodal_sum_to_one_and_have_these_gradients() {
        let t = triangle();
        for (i, p) in t.into_iter().enumerate() {
            let h = hats(t, p);
            assert!((0..3).all(|k| (h[k] - f64::from(u8::from(k == i))).abs() < 1e-15));
        }
        let (g, area) = gradients(t);
        assert!((area - 0.5 * twice_area(t[0], t[1], t[2])).abs() < 1e-15);
        let (x, step) = (Point::new(0.6, 0.5), 1e-6);
        assert!((hats(t, x).iter().sum::<f64>() - 1.0).abs() < 1e-15);
        for j in 0..2 {
            let mut y = x;
            y[j] += step;
            for k in 0..3 {
                let difference = (hats(t, y)[k] - hats(t, x)[k]) / step;
                assert!((difference - g[k][j]).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn the_stiffness_is_the_energy_of_the_strain_and_rigid_motions_have_none() {
        let t = triangle();
        let m = Material::isotropic(1.0, 0.3, Plane::Strain).unwrap();
        let (g, area) = gradients(t);
        let energy = |u: [Vec2; 3]| -> f64 {
            let mut sum = 0.0;
            for i in 0..3 {
                for j in 0..3 {
                    let k = stiffness_block(&m, area, g[i], g[j]);
                    sum += u[i].x * (k[0] * u[j].x + k[1] * u[j].y) + u[i].y * (k[2] * u[j].x + k[3] * u[j].y);
                }
            }
            sum
        };
        let u = [Vec2::new(0.1, 0.7), Vec2::new(-0.4, 0.2), Vec2::new(0.5, -0.6)];
        let e = linear_strain(&g, u);
        assert!((energy(u) - area * contract(m.stress(e), e)).abs() < 1e-14);
        let rotation = t.map(|x| Vec2::new(0.3 - x.y, x.x - 0.8));
        assert!(energy(rotation).abs() < 1e-14);
    }
}
