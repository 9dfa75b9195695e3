//! One triangle with a curved side: what it contributes, and its error for a discrete solution.
//!
//! Gradients of the hat functions may vary over it, so the mixed terms need `∫ ∂_j w_i ∂_l φ_k` in place of the mean of `∇w`.

use super::element::Element;
use signorini_contact::element::{CurvedTriangle, ElementPoint};
use signorini_contact::material::Material;
use signorini_contact::norm::Squares;
use signorini_contact::{Body, Vec2};
use std::ops::AddAssign;

/// The sums of an element, and its moments.
#[derive(Clone, Copy, Default)]
pub struct CurvedPart {
    /// What every element has; its `mean` is not used.
    pub element: Element,
    /// `moments[k][i][j][l] = ∫ ∂_j w_i ∂_l φ_k`.
    moments: [[[[f64; 2]; 2]; 2]; 3],
}

/// The strain components `11, 22, 2·12` as sums of entries of a gradient.
const ENTRIES: [&[(usize, usize)]; 3] = [&[(0, 0)], &[(1, 1)], &[(0, 1), (1, 0)]];

impl CurvedPart {
    /// Adds the moments of `∇w` at one point.
    pub fn add_moments(&mut self, point: &ElementPoint, weight: f64, grad_w: &[[f64; 2]; 2]) {
        for (moments, gradient) in self.moments.iter_mut().zip(&point.gradients) {
            for (i, row) in moments.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    (0..2).for_each(|l| entry[l] += weight * grad_w[i][j] * gradient[l]);
                }
            }
        }
    }

    /// `2(w, d) + ‖d‖²` for nodal values `d`.
    pub fn remainder(&self, triangle: &CurvedTriangle, body: Body, material: &Material, d: [Vec2; 3]) -> Squares {
        let mut squares = Squares::default();
        triangle.points(&mut |p, w| squares.add(body, material, w, p.value(&d), p.gradient(&d)));
        // ∫ ∂_j w_i ∂_l d_m
        let mixed = |(i, j): (usize, usize), (m, l): (usize, usize)| -> f64 {
            (0..3).map(|k| d[k][m] * self.moments[k][i][j][l]).sum()
        };
        let strain = |p: usize, q: usize| -> f64 {
            ENTRIES[p].iter().map(|&w| ENTRIES[q].iter().map(|&v| mixed(w, v)).sum::<f64>()).sum()
        };
        // ε:ε = ε_11² + ε_22² + ½ (2ε_12)²
        squares.strain[body.index()] += 2.0 * (strain(0, 0) + strain(1, 1) + 0.5 * strain(2, 2));
        let c = material.matrix();
        squares.energy += 2.0 * (0..9).map(|k| c[k / 3][k % 3] * strain(k / 3, k % 3)).sum::<f64>();
        squares.gradient += 2.0 * (0..4).map(|k| mixed((k / 2, k % 2), (k / 2, k % 2))).sum::<f64>();
        squares.l2 += 2.0 * d.iter().zip(&self.element.moments).map(|(d, m)| d.dot(m)).sum::<f64>();
        squares
    }

    /// `A(w, φ_k e_p)` for the three nodes.
    pub fn forces(&self, material: &Material) -> [Vec2; 3] {
        let c = material.matrix();
        self.moments.map(|m| {
            // ∫ τ_a ∂_q φ_k, with a = 11, 22, 12
            let stress = |a: usize, q: usize| -> f64 {
                let strain = |b: usize| ENTRIES[b].iter().map(|&(i, j)| m[i][j][q]).sum::<f64>();
                (0..3).map(|b| c[a][b] * strain(b)).sum()
            };
            Vec2::new(stress(0, 0) + stress(2, 1), stress(2, 0) + stress(1, 1))
        })
    }
}

impl AddAssign for CurvedPart {
    fn add_assign(&mut self, other: Self) {
        self.element += other.element;
        let flat = |m: &mut [[[[f64; 2]; 2]; 2]; 3], n: &[[[[f64; 2]; 2]; 2]; 3]| {
            m.iter_mut()
                .flatten()
                .flatten()
                .flatten()
                .zip(n.iter().flatten().flatten().flatten())
                .for_each(|(a, b)| *a += b);
        };
        flat(&mut self.moments, &other.moments);
    }
}
