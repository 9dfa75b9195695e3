//! The bound-constrained quadratic problem and its KKT certificate.
//!
//! ```text
//! min ½ xᵀKx − fᵀx   subject to   x_c ≤ g_c  for the bounded components c
//! ```
//!
//! Optimal are `x, λ` with `Kx + Σ λ_c e_c = f`, `λ_c ≥ 0`, `x_c ≤ g_c`, `λ_c (g_c − x_c) = 0`.
//! Nothing here knows of meshes, pairs or displacements.

use crate::sparse::BlockMatrix;

/// An upper bound `x_dof ≤ upper`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Scalar component, `< K.dimension()`.
    pub dof: u32,
    /// The bound `g`.
    pub upper: f64,
}

/// The problem. `K` is symmetric and positive semidefinite; a fixed component keeps an identity row and column and a
/// zero load. Each dof carries at most one bound.
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
