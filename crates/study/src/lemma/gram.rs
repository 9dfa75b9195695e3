//! Small symmetric eigenvalue problems: the largest ratio of two quadratic forms.

use nalgebra::SMatrix;

/// `max_x xᵀAx / xᵀBx` for symmetric `A` and positive definite `B`; nothing if `B` is not.
///
/// With `B = L Lᵀ` it is the largest eigenvalue of `L⁻¹ A L⁻ᵀ`.
pub fn largest_ratio<const N: usize>(a: &SMatrix<f64, N, N>, b: &SMatrix<f64, N, N>) -> Option<f64> {
    let l = b.cholesky()?.l();
    let half = l.solve_lower_triangular(a)?;
    let whole = l.solve_lower_triangular(&half.transpose())?;
    // Eigenvalues of any size N: the dynamic matrix has the decomposition.
    let symmetric = nalgebra::DMatrix::from_fn(N, N, |i, j| 0.5 * (whole[(i, j)] + whole[(j, i)]));
    Some(symmetric.symmetric_eigenvalues().max())
}
