//! The bound-constrained quadratic problem and its KKT certificate.
//!
//! ```text
//! min ½ xᵀKx − fᵀx   subject to   x_c ≤ g_c  for the bounded components c
//! ```
//!
//! Optimal are `x, λ` with `Kx + Σ λ_c e_c = f`, `λ_c ≥ 0`, `x_c ≤ g_c`, `λ_c (g_c − x_c) = 0`.
//! Nothing here knows of meshes, pairs or displacements.

mod algebraic_error;
mod backward;
mod border;
mod certificate;

pub use algebraic_error::algebraic_error;
pub(crate) use backward::{backward_error, row_norm, row_size};
pub use border::remove_imbalance;
pub use certificate::{Certificate, CertificateScales, certify};

use crate::sparse::BlockMatrix;
use rayon::prelude::*;

/// An upper bound `x_dof ≤ upper`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Scalar component, `< K.dimension()`.
    pub dof: u32,
    /// The bound `g`.
    pub upper: f64,
}

/// The problem. `K` is symmetric and positive semidefinite; a fixed component keeps a diagonal
/// entry of the size of the others, nothing beside it, and a zero load. Each dof carries at most one bound.
#[derive(Clone, Debug, Default)]
pub struct BoundQp {
    /// The matrix `K`.
    pub matrix: BlockMatrix,
    /// The load `f`, of length `K.dimension()`.
    pub load: Vec<f64>,
    /// The bounds, by ascending dof.
    pub bounds: Vec<Bound>,
    /// A basis of the two-sided kernel: `K y = 0`, `y_c = 0` on every bounded component, and `f·y = 0`
    /// (to rounding). The solution is determined up to these motions.
    pub kernel: Vec<Vec<f64>>,
    /// One condition `p(x) = Σ p_i x_i = 0` per kernel vector, which makes the solution unique.
    pub conditions: Vec<Vec<(u32, f64)>>,
}

/// The energy `½ xᵀKx − fᵀx`.
pub fn energy(qp: &BoundQp, x: &[f64]) -> f64 {
    energy_of(&qp.matrix, &qp.load, x)
}

/// The same of a matrix and a load.
pub(crate) fn energy_of(matrix: &BlockMatrix, load: &[f64], x: &[f64]) -> f64 {
    let mut kx = vec![0.0; x.len()];
    matrix.apply(x, &mut kx);
    // Σ x_i (½ (Kx)_i − f_i)
    let terms = x.iter().zip(&kx).zip(load);
    terms.map(|((x, kx), f)| x * (0.5 * kx - f)).sum()
}

/// The residual `f − Kx`: on a bounded component its multiplier, elsewhere what stationarity lacks.
pub fn residual(qp: &BoundQp, x: &[f64]) -> Vec<f64> {
    let mut r = vec![0.0; x.len()];
    qp.matrix.apply(x, &mut r);
    r.par_iter_mut().with_min_len(1 << 14).zip(&qp.load).for_each(|(r, f)| *r = f - *r);
    r
}

/// `‖v‖_∞`; NaN if any entry is.
pub(crate) fn largest(v: &[f64]) -> f64 {
    let larger = |max: f64, &x: &f64| {
        let x = x.abs();
        if x > max || x.is_nan() { x } else { max }
    };
    v.iter().fold(0.0, larger)
}
