//! Condensation on the bounded components.
//!
//! With `c` the bounded components, `i` the others and `Σ = diag(K_cc)`, the matrix `M = K + Σ` (shifted on `c` only) is
//! positive definite even where the body is held by contact alone. One factorisation of `M` with `c` last gives
//!
//! ```text
//! S = K_cc − K_ci K_ii⁻¹ K_ic = L_cc L_ccᵀ − Σ          (from the trailing block of the factor)
//! b = f_c − K_ci K_ii⁻¹ f_i   = (S + Σ) (M⁻¹ f)_c       (one solve)
//! K x = f − λ                 ⇔  M x = f − λ + Σ x_c    (one solve)
//! ```

use super::cholesky::{Cholesky, NotPositiveDefinite};
use crate::qp::BoundQp;
use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::{Accum, Mat, Par};

/// Stiffness that cancels to this share of the diagonal of `K` is none.
const NO_STIFFNESS: f64 = 1e-12;

/// The factor of `M = K + Σ`.
#[derive(Debug)]
pub struct Condensation {
    factor: Cholesky,
    bounded: Vec<usize>,
    /// `Σ`.
    shift: Vec<f64>,
}

impl Condensation {
    /// Factors, with the unknowns `held` at zero (none of them bounded).
    ///
    /// # Errors
    /// [`NotPositiveDefinite`] if some motion that moves no bounded component costs no energy.
    pub fn new(qp: &BoundQp, held: &[usize]) -> Result<Self, NotPositiveDefinite> {
        let mut removed = vec![false; qp.matrix.dimension()];
        held.iter().for_each(|&i| removed[i] = true);
        let trailing: Vec<u32> = qp.bounds.iter().map(|b| b.dof).collect();
        let shift = shift(qp);
        Ok(Self {
            factor: Cholesky::new(&qp.matrix, &removed, &trailing, &shift)?,
            bounded: trailing.iter().map(|&i| i as usize).collect(),
            shift,
        })
    }

    /// `S = L_cc L_ccᵀ − Σ`, both triangles.
    pub fn schur_complement(&self) -> Mat<f64> {
        let factor = self.factor.trailing_block();
        let m = factor.nrows();
        let mut schur = Mat::zeros(m, m);
        matmul(
            schur.as_mut(),
            BlockStructure::TriangularLower,
            Accum::Replace,
            factor.as_ref(),
            BlockStructure::TriangularLower,
            factor.transpose(),
            BlockStructure::TriangularUpper,
            1.0,
            Par::Seq,
        );
        self.remove_shift(&mut schur);
        schur
    }

    /// `S ← S − Σ`, the upper triangle filled; a component whose stiffness cancels to rounding has none at all.
    fn remove_shift(&self, schur: &mut Mat<f64>) {
        let m = schur.nrows();
        for i in 0..m {
            schur[(i, i)] -= self.shift[i];
        }
        let loose: Vec<bool> = (0..m).map(|i| schur[(i, i)] <= NO_STIFFNESS * self.shift[i]).collect();
        for j in 0..m {
            for i in j..m {
                if loose[i] || loose[j] {
                    schur[(i, j)] = 0.0;
                }
                schur[(j, i)] = schur[(i, j)];
            }
        }
    }

    /// `b = (S + Σ) (M⁻¹ f)_c`.
    pub fn reduced_load(&self, schur: &Mat<f64>, load: &[f64]) -> Vec<f64> {
        if self.bounded.is_empty() {
            return Vec::new();
        }
        let mut z = load.to_vec();
        self.factor.solve(&mut z);
        let z: Vec<f64> = self.bounded.iter().map(|&i| z[i]).collect();
        let mut b: Vec<f64> = self.shift.iter().zip(&z).map(|(s, z)| s * z).collect();
        for (j, zj) in z.iter().enumerate() {
            for (i, b) in b.iter_mut().enumerate() {
                *b += schur[(i, j)] * zj;
            }
        }
        b
    }

    /// `x = M⁻¹ (f − λ + Σ x_c)`, from the bounded components and the multipliers of all bounds.
    pub fn back_substitute(&self, load: &[f64], bounded: &[f64], multipliers: &[f64]) -> Vec<f64> {
        let mut x = load.to_vec();
        for (k, &i) in self.bounded.iter().enumerate() {
            x[i] += self.shift[k] * bounded[k] - multipliers[k];
        }
        self.factor.solve(&mut x);
        x
    }
}

/// `Σ`: the diagonal of `K`, or its largest entry for a component with no stiffness.
fn shift(qp: &BoundQp) -> Vec<f64> {
    let diagonal = |dof: usize| qp.matrix.diagonal_block(dof / 2)[3 * (dof % 2)];
    let largest = (0..qp.matrix.dimension()).map(diagonal).fold(0.0, f64::max);
    let positive = |bound: &crate::qp::Bound| match diagonal(bound.dof as usize) {
        k if k > 0.0 => k,
        _ if largest > 0.0 => largest,
        _ => 1.0,
    };
    qp.bounds.iter().map(positive).collect()
}
