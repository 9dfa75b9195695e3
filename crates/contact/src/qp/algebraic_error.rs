//! How far a computed `x, λ` is from the minimiser, in the energy norm, from raw data alone.
//!
//! Let `x*, λ*` be the solution, `x⁻ = min(x, g)` (on the bounded components), `λ⁺ = max(λ, 0)`, `r = f − Kx⁻ − λ⁺` and
//! `e = x⁻ − x*`. Since `K x* = f − λ*`,
//!
//! ```text
//! eᵀKe = −eᵀr + (λ* − λ⁺)ᵀ(x⁻ − x*)_c
//! λ*ᵀ(x⁻ − x*) = λ*ᵀ(x⁻ − g) ≤ 0,      −λ⁺ᵀ(x⁻ − x*) ≤ λ⁺ᵀ(g − x⁻)
//! ⇒  ‖e‖²_K ≤ ‖r‖²_{K⁻¹} + 2 Σ λ⁺ (g − x⁻),      ‖x − x*‖_K ≤ ‖e‖_K + ‖x − x⁻‖_K
//! ```
//!
//! which holds for every feasible `x⁻` and every `λ⁺ ≥ 0`. Tension has gone into `r`, penetration into `x − x⁻`. Where
//! the products `λ⁺ (g − x⁻)` dominate, a second pair is tried that has none: `x⁻ = g` where the multiplier outweighs the
//! slack times its stiffness, `λ⁺ = 0` elsewhere. The smaller of the two counts.
//!
//! The products and `x − x⁻` are computed exactly: this part is a bound. `‖r‖²_{K⁻¹}` is an *estimate*, from below, by a
//! few steps of conjugate gradients with block-Jacobi preconditioning, whose energy grows towards it. The step limit
//! makes it sharp for rough residuals (rounding, a stopped iteration), less so for smooth ones on fine meshes.

use super::{Bound, BoundQp, residual};
use crate::sparse::BlockMatrix;

/// Steps of conjugate gradients.
const STEPS: usize = 40;
/// Relative growth of the energy in one step below which it is taken as settled.
const SETTLED: f64 = 1e-3;
/// Curvature below this share of the preconditioner's is a motion without stiffness.
const NO_STIFFNESS: f64 = 1e-12;

/// An estimate of `‖x − x*‖_K`. Two-sided kernel motions cost nothing in this norm.
pub fn algebraic_error(qp: &BoundQp, x: &[f64], multipliers: &[f64]) -> f64 {
    let projected = Pair::projected(qp, x, multipliers);
    let (residual_part, gap_work) = projected.square(qp);
    let first = (residual_part + gap_work).sqrt() + projected.distance(qp, x);
    if gap_work <= residual_part || first.is_nan() {
        return first;
    }
    let complementary = Pair::complementary(qp, x, multipliers);
    let (residual_part, gap_work) = complementary.square(qp);
    first.min((residual_part + gap_work).sqrt() + complementary.distance(qp, x))
}

/// A feasible point and non-negative multipliers.
struct Pair {
    /// `x⁻`.
    point: Vec<f64>,
    /// `λ⁺` on the bounded components, zero elsewhere.
    pressure: Vec<f64>,
}

impl Pair {
    /// `min(x, g)` and `max(λ, 0)`.
    fn projected(qp: &BoundQp, x: &[f64], multipliers: &[f64]) -> Self {
        let mut pair = Self { point: x.to_vec(), pressure: vec![0.0; x.len()] };
        for (bound, &multiplier) in qp.bounds.iter().zip(multipliers) {
            let i = bound.dof as usize;
            if x[i] > bound.upper {
                pair.point[i] = bound.upper;
            }
            pair.pressure[i] = if multiplier < 0.0 { 0.0 } else { multiplier };
        }
        pair
    }

    /// The projected pair with the smaller factor of each product `λ (g − x)` set to zero.
    fn complementary(qp: &BoundQp, x: &[f64], multipliers: &[f64]) -> Self {
        let mut pair = Self::projected(qp, x, multipliers);
        for bound in &qp.bounds {
            let i = bound.dof as usize;
            let stiffness = qp.matrix.diagonal_block(i / 2)[3 * (i % 2)];
            if pair.pressure[i] > stiffness * (bound.upper - pair.point[i]) {
                pair.point[i] = bound.upper;
            } else {
                pair.pressure[i] = 0.0;
            }
        }
        pair
    }

    /// `‖r‖²_{K⁻¹}` and `2 Σ λ⁺ (g − x⁻)`.
    fn square(&self, qp: &BoundQp) -> (f64, f64) {
        let mut rest = residual(qp, &self.point);
        rest.iter_mut().zip(&self.pressure).for_each(|(r, p)| *r -= p);
        let slack = |bound: &Bound| bound.upper - self.point[bound.dof as usize];
        let products = qp.bounds.iter().map(|b| self.pressure[b.dof as usize] * slack(b));
        (inverse_energy(&qp.matrix, &rest), 2.0 * products.sum::<f64>())
    }

    /// `‖x − x⁻‖_K`.
    fn distance(&self, qp: &BoundQp, x: &[f64]) -> f64 {
        let change: Vec<f64> = x.iter().zip(&self.point).map(|(a, b)| a - b).collect();
        energy_norm(&qp.matrix, &change)
    }
}

/// `√(vᵀKv)`.
fn energy_norm(matrix: &BlockMatrix, v: &[f64]) -> f64 {
    let mut kv = vec![0.0; v.len()];
    matrix.apply(v, &mut kv);
    let square = dot(v, &kv);
    // Rounding may make a square that vanishes negative; NaN stays NaN.
    if square < 0.0 { 0.0 } else { square.sqrt() }
}

/// `rᵀK⁻¹r` from below: the energy gained by preconditioned conjugate gradients for `K d = r`.
fn inverse_energy(matrix: &BlockMatrix, residual: &[f64]) -> f64 {
    let mut r = residual.to_vec();
    let mut p = precondition(matrix, &r);
    let mut kp = vec![0.0; r.len()];
    let mut rz = dot(&r, &p);
    let mut energy: f64 = 0.0;
    for _ in 0..STEPS {
        matrix.apply(&p, &mut kp);
        let curvature = dot(&p, &kp);
        if rz == 0.0 || curvature <= NO_STIFFNESS * rz {
            // a motion that K does not resist: count it with the preconditioner's stiffness
            return energy + rz;
        }
        let length = rz / curvature;
        energy += length * rz;
        r.iter_mut().zip(&kp).for_each(|(r, k)| *r -= length * k);
        let z = precondition(matrix, &r);
        let next = dot(&r, &z);
        let growth = length * rz;
        if growth <= SETTLED * energy || energy.is_nan() {
            break;
        }
        p.iter_mut().zip(&z).for_each(|(p, z)| *p = z + next / rz * *p);
        rz = next;
    }
    energy
}

/// `D⁻¹r` with the 2×2 diagonal blocks.
fn precondition(matrix: &BlockMatrix, r: &[f64]) -> Vec<f64> {
    let mut z = vec![0.0; r.len()];
    for i in 0..matrix.rows() {
        let solution = solve_block(matrix.diagonal_block(i), [r[2 * i], r[2 * i + 1]]);
        z[2 * i..2 * i + 2].copy_from_slice(&solution);
    }
    z
}

/// Solves with one diagonal block; a singular one is replaced by its diagonal, a component without stiffness gives 0.
fn solve_block(block: [f64; 4], r: [f64; 2]) -> [f64; 2] {
    let [a, b, _, d] = block;
    let determinant = a * d - b * b;
    if determinant > NO_STIFFNESS * a * d {
        return [(d * r[0] - b * r[1]) / determinant, (a * r[1] - b * r[0]) / determinant];
    }
    let divide = |r: f64, k: f64| if k > 0.0 { r / k } else { 0.0 };
    [divide(r[0], a), divide(r[1], d)]
}

/// `Σ a_i b_i`, in order.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
