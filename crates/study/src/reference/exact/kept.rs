//! What is kept of a straight element until the solve is over, as small as the errors allow.

use super::element::Element;
use signorini_contact::Vec2;
use signorini_contact::element::{displacement_gradient, gradients};
use signorini_contact::material::{Material, Sym2, contract, strain};
use signorini_contact::mesh::Mesh;
use signorini_contact::norm::Squares;
use std::ops::AddAssign;

/// The integrals of `w = u − u_I` that products with a linear field need: 72 bytes.
#[derive(Clone, Copy, Default)]
pub struct Kept {
    /// `∫∇w` by the finer rule.
    mean: [[f64; 2]; 2],
    /// `∫ w φ_k` by the finer rule; they enter the `L²` norm alone, to seven digits.
    moments: [[f32; 2]; 3],
    /// By how much `∫ε(w)` of the coarser rule is larger; it enters the budget alone.
    change: [f32; 3],
}

/// `2(w, d) + ‖d‖²` for a field `d`: what the interpolation error lacks to be the error.
#[derive(Clone, Copy, Default)]
pub struct Remainder {
    /// By the finer quadrature.
    pub fine: Squares,
    /// That of the energy by the coarser one.
    pub base_energy: f64,
}

impl AddAssign for Remainder {
    fn add_assign(&mut self, other: Self) {
        self.fine += other.fine;
        self.base_energy += other.base_energy;
    }
}

impl Kept {
    /// Of an element by a coarser and a finer rule.
    pub fn new([base, fine]: &[Element; 2]) -> Self {
        let (e, e_base) = (strain(fine.mean), strain(base.mean));
        Self {
            mean: fine.mean,
            moments: fine.moments.map(|m| [m.x as f32, m.y as f32]),
            change: std::array::from_fn(|k| (e_base[k] - e[k]) as f32),
        }
    }

    /// `∫ε(w)` by the coarser and the finer rule.
    fn strains(&self) -> [Sym2; 2] {
        let fine = strain(self.mean);
        [std::array::from_fn(|k| fine[k] + f64::from(self.change[k])), fine]
    }

    /// `A(w, φ_k e_p) = ∫τ_pq(w) ∂_q φ_k` for the three nodes, by either rule.
    pub fn forces(&self, mesh: &Mesh, material: &Material, t: usize) -> [[Vec2; 3]; 2] {
        let (g, _) = gradients(mesh.corners(t));
        self.strains().map(|e| {
            let [s11, s22, s12] = material.stress(e);
            g.map(|g| Vec2::new(s11 * g.x + s12 * g.y, s12 * g.x + s22 * g.y))
        })
    }

    /// On triangle `t` for the nodal values of `d` there.
    pub fn remainder(&self, mesh: &Mesh, material: &Material, t: usize, d: [Vec2; 3]) -> Remainder {
        let body = mesh.body(t);
        let (g, area) = gradients(mesh.corners(t));
        let grad = displacement_gradient(&g, d);
        let (e, [base, mean]) = (strain(grad), self.strains());
        let mut squares = Squares::default();
        squares.add(body, material, area, Vec2::zeros(), grad);
        let (own, stress) = (squares.energy, material.stress(e));
        squares.strain[body.index()] += 2.0 * contract(e, mean);
        squares.energy += 2.0 * contract(stress, mean);
        squares.gradient += 2.0 * (0..4).map(|k| grad[k / 2][k % 2] * self.mean[k / 2][k % 2]).sum::<f64>();
        // ∫|w + d|² = ∫|w|² + 2 Σ d_k·∫wφ_k + |T|/12 (|Σd_k|² + Σ|d_k|²)
        let total: Vec2 = d.iter().sum();
        squares.l2 += area / 12.0 * (total.norm_squared() + d.iter().map(|d| d.norm_squared()).sum::<f64>());
        let moment = |m: &[f32; 2]| Vec2::new(f64::from(m[0]), f64::from(m[1]));
        squares.l2 += 2.0 * d.iter().zip(&self.moments).map(|(d, m)| d.dot(&moment(m))).sum::<f64>();
        Remainder { fine: squares, base_energy: own + 2.0 * contract(stress, base) }
    }
}
