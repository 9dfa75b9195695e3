//! Two-sided kernels: unknowns that hold the body during the solve, and the motion that restores `p(x) = 0` afterwards.
//!
//! The load does no work on a two-sided kernel motion, so holding one unknown per motion, at zero or at any other value
//! ([`Settings::start_slide`](super::Settings::start_slide)), calls up no reaction:
//! the held problem gives one of the solutions, and all others differ from it by kernel motions. This is the bordered
//! system `[K Pᵀ; P 0]` solved exactly, without its indefiniteness.

use crate::qp::BoundQp;
use nalgebra::{DMatrix, DVector};

/// Relative size below which a pivot counts as zero.
const SINGULAR: f64 = 1e-10;

/// One unknown per kernel vector, so that no nonzero kernel motion vanishes on all of them: Gaussian elimination of the
/// vectors with full row pivoting. `None` if the vectors are linearly dependent.
pub fn anchors(kernel: &[Vec<f64>]) -> Option<Vec<usize>> {
    let mut vectors = kernel.to_vec();
    let mut anchors = Vec::with_capacity(kernel.len());
    for k in 0..vectors.len() {
        let (anchor, pivot) = largest_entry(&vectors[k]);
        if pivot.abs() <= SINGULAR * largest_entry(&kernel[k]).1.abs() {
            return None;
        }
        anchors.push(anchor);
        let (done, rest) = vectors.split_at_mut(k + 1);
        for other in rest {
            let factor = other[anchor] / pivot;
            for (o, v) in other.iter_mut().zip(&done[k]) {
                *o -= factor * v;
            }
            other[anchor] = 0.0;
        }
    }
    Some(anchors)
}

/// The point where the held unknowns have the value `at` and all others are zero: `x_0`, with `K (x − x_0) = f − K x_0` to be
/// solved for `x − x_0`.
pub fn start(qp: &BoundQp, held: &[usize], at: f64) -> Vec<f64> {
    let mut x = vec![0.0; qp.matrix.dimension()];
    held.iter().for_each(|&i| x[i] = at);
    x
}

/// Position and value of the entry of largest absolute value, the first of several.
fn largest_entry(vector: &[f64]) -> (usize, f64) {
    let larger = |best: (usize, f64), (i, &v): (usize, &f64)| {
        if v.abs() > best.1.abs() { (i, v) } else { best }
    };
    vector.iter().enumerate().fold((0, 0.0), larger)
}

/// Adds the kernel motion with which every condition `p(x) = 0` holds. `None` if the conditions do not determine it.
pub fn impose_conditions(qp: &BoundQp, x: &mut [f64]) -> Option<()> {
    let n = qp.kernel.len();
    if n == 0 {
        return Some(());
    }
    if qp.conditions.len() != n {
        return None;
    }
    // Σ_k p_j(y_k) a_k = −p_j(x), each row scaled by its own size
    let scale = |j: usize| f64::recip(row_size(qp, j));
    let matrix = DMatrix::from_fn(n, n, |j, k| scale(j) * functional(&qp.conditions[j], &qp.kernel[k]));
    let rhs = DVector::from_fn(n, |j, _| -scale(j) * functional(&qp.conditions[j], x));
    let factor = matrix.full_piv_lu();
    let pivots = factor.u().diagonal().abs();
    if !pivots.iter().all(|&p| p > SINGULAR) {
        return None;
    }
    let amount = factor.solve(&rhs)?;
    for (y, a) in qp.kernel.iter().zip(&amount) {
        for (x, y) in x.iter_mut().zip(y) {
            *x += a * y;
        }
    }
    Some(())
}

/// `p(x) = Σ p_i x_i`.
fn functional(p: &[(u32, f64)], x: &[f64]) -> f64 {
    p.iter().map(|&(i, p)| p * x[i as usize]).sum()
}

/// `max_k Σ_i |p_i y_k,i|`: what `p_j(y_k)` would be without cancellation.
fn row_size(qp: &BoundQp, j: usize) -> f64 {
    let size = |y: &Vec<f64>| -> f64 {
        let terms = qp.conditions[j].iter();
        terms.map(|&(i, p)| (p * y[i as usize]).abs()).sum()
    };
    qp.kernel.iter().map(size).fold(0.0, f64::max)
}
