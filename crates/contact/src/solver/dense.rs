//! The small dense problem on the bounded components, and linear solves on its faces.
//!
//! ```text
//! min ½ xᵀSx − bᵀx   subject to   x ≤ g,        multipliers λ = b − Sx
//! ```

use faer::linalg::solvers::{Llt, Solve};
use faer::{Mat, MatMut, Side};

/// A pivot of a face matrix below this multiple of its diagonal entry counts as zero.
const PIVOT_TOLERANCE: f64 = 1e-10;
/// Proximal shift of a singular face matrix, relative to its diagonal.
const PROXIMAL: f64 = 1e-8;
/// Rounding of a residual, relative to the sum of the absolute values of its terms.
const ROUNDING: f64 = 1e-13;

/// The problem. `S` is symmetric, positive semidefinite, both triangles stored.
#[derive(Clone, Debug)]
pub struct DenseQp {
    /// The matrix `S`, `m × m`.
    pub matrix: Mat<f64>,
    /// The load `b`, length `m`.
    pub load: Vec<f64>,
    /// The bounds `g`, length `m`.
    pub upper: Vec<f64>,
}

impl DenseQp {
    /// Number of unknowns `m`.
    pub fn len(&self) -> usize {
        self.load.len()
    }

    /// `λ = b − Sx`.
    pub fn residual(&self, x: &[f64]) -> Vec<f64> {
        self.residual_of(&self.load, x)
    }

    /// `b − Sx` for another load `b`.
    pub fn residual_of(&self, load: &[f64], x: &[f64]) -> Vec<f64> {
        let mut residual = load.to_vec();
        for (j, &xj) in x.iter().enumerate() {
            if xj != 0.0 {
                let column = self.column(j);
                residual.iter_mut().zip(column).for_each(|(r, s)| *r -= s * xj);
            }
        }
        residual
    }

    /// Size below which a multiplier, or a slack times its stiffness, is rounding:
    /// `1e-13 max_i (|b_i| + Σ_j |S_ij x_j|)`.
    pub fn tolerance(&self, x: &[f64]) -> f64 {
        let mut size: Vec<f64> = self.load.iter().map(|b| b.abs()).collect();
        for (j, xj) in x.iter().enumerate() {
            let column = self.column(j);
            size.iter_mut().zip(column).for_each(|(a, s)| *a += (s * xj).abs());
        }
        ROUNDING * size.into_iter().fold(0.0, f64::max)
    }

    /// `sᵀSs`.
    pub fn curvature(&self, step: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (j, &sj) in step.iter().enumerate().filter(|(_, s)| **s != 0.0) {
            let column = self.column(j);
            sum += sj * column.iter().zip(step).map(|(a, b)| a * b).sum::<f64>();
        }
        sum
    }

    /// Column `j` of `S`.
    pub fn column(&self, j: usize) -> &[f64] {
        self.matrix.col(j).try_as_col_major().expect("a matrix is stored by columns").as_slice()
    }
}

/// The factored face matrix `S_II`, `I` = the components that are not active.
#[derive(Clone, Debug)]
pub struct Face {
    free: Vec<usize>,
    factor: Option<Llt<f64>>,
    singular: bool,
}

impl Face {
    /// Factors `S_II`, or `S_II + ε diag(S_II)` if it is singular to rounding.
    pub fn new(qp: &DenseQp, active: &[bool]) -> Self {
        let free: Vec<usize> = (0..qp.len()).filter(|&i| !active[i]).collect();
        let plain = factor(qp, &free, 0.0);
        let singular = plain.is_none() && !free.is_empty();
        let factor = plain.or_else(|| factor(qp, &free, PROXIMAL));
        Self { free, factor, singular }
    }

    /// Whether `S_II` is singular, so that [`solve`](Self::solve) is a proximal step only.
    pub fn is_singular(&self) -> bool {
        self.singular
    }

    /// The step `d` with `S_II d_I = r_I` (or its proximal regularisation) and `d = 0` on the active components.
    pub fn solve(&self, residual: &[f64]) -> Vec<f64> {
        let mut step = vec![0.0; residual.len()];
        let Some(factor) = &self.factor else {
            return step;
        };
        let mut rhs: Vec<f64> = self.free.iter().map(|&i| residual[i]).collect();
        let n = rhs.len();
        factor.solve_in_place(MatMut::from_column_major_slice_mut(&mut rhs, n, 1));
        for (&i, d) in self.free.iter().zip(rhs) {
            step[i] = d;
        }
        step
    }
}

/// Cholesky factor of `S_II + shift·diag(S_II)`; `None` if empty or not positive definite beyond rounding.
fn factor(qp: &DenseQp, free: &[usize], shift: f64) -> Option<Llt<f64>> {
    let n = free.len();
    if n == 0 {
        return None;
    }
    // A component without any stiffness has S_ii = 0: its proximal shift is that of the stiffest one.
    let largest = free.iter().map(|&i| qp.matrix[(i, i)]).fold(0.0, f64::max);
    let diagonal = |i: usize| match qp.matrix[(i, i)] {
        s if s > PIVOT_TOLERANCE * largest => s,
        _ if largest > 0.0 => largest,
        _ => 1.0,
    };
    let matrix = Mat::from_fn(n, n, |a, b| {
        let s = qp.matrix[(free[a], free[b])];
        if a == b { s + shift * diagonal(free[a]) } else { s }
    });
    let factor = matrix.llt(Side::Lower).ok()?;
    let regular = |a: usize| factor.L()[(a, a)].powi(2) > PIVOT_TOLERANCE * diagonal(free[a]);
    (0..n).all(regular).then_some(factor)
}
