//! What is left of a load that balances only to a tolerance.
//!
//! With two-sided kernel motions `y_j` and conditions `p_k(x) = 0` the bordered system reads `Kx + Σ μ_k p_k = f`. Tested with
//! the motions, `Σ_k p_k(y_j) μ_k = f·y_j`. A load that passed for balanced may leave `f·y_j` of the size of that tolerance; with
//! `f − Σ μ_k p_k` in place of `f` the system has a solution to rounding, and since `p_k(x) = 0` its energy is the same.

use super::BoundQp;
use nalgebra::{DMatrix, DVector};

/// Takes `Σ μ_k p_k` off the load; nothing where there is no kernel, or where the conditions do not determine it.
pub fn remove_imbalance(qp: &mut BoundQp) {
    let n = qp.kernel.len();
    if n == 0 || qp.conditions.len() != n {
        return;
    }
    let apply = |p: &[(u32, f64)], y: &[f64]| -> f64 { p.iter().map(|&(i, p)| p * y[i as usize]).sum() };
    let work = |y: &[f64]| -> f64 { y.iter().zip(&qp.load).map(|(y, f)| y * f).sum() };
    let matrix = DMatrix::from_fn(n, n, |j, k| apply(&qp.conditions[k], &qp.kernel[j]));
    let rhs = DVector::from_fn(n, |j, _| work(&qp.kernel[j]));
    let Some(forces) = matrix.full_piv_lu().solve(&rhs) else { return };
    for (condition, force) in qp.conditions.iter().zip(&forces) {
        for &(i, p) in condition {
            qp.load[i as usize] -= force * p;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::qp::residual;
    use crate::solver::{Settings, solve};
    use crate::sparse::BlockMatrix;

    /// Four masses in a row, free to move along it, and a load that is out of balance by 1e-9.
    fn row() -> BoundQp {
        let blocks = vec![[1.0, -1.0, -1.0, 2.0], [0.0, 0.0, -1.0, 0.0], [0.0, -1.0, 0.0, 0.0], [2.0, -1.0, -1.0, 1.0]];
        let matrix = BlockMatrix::new(vec![0, 2, 4], vec![0, 1, 0, 1], blocks);
        let kernel = vec![vec![1.0; 4]];
        let conditions = vec![(0..4).map(|i| (i, 1.0)).collect()];
        BoundQp { matrix, load: vec![1.0, 0.0, 0.0, -1.0 + 1e-9], kernel, conditions, ..Default::default() }
    }

    #[test]
    fn what_is_left_over_goes_into_the_condition() {
        let mut qp = row();
        let size = |qp: &BoundQp| {
            let solution = solve(qp, &Settings::default());
            residual(qp, &solution.x).iter().fold(0.0, |m: f64, r| m.max(r.abs()))
        };
        assert!(size(&qp) > 1e-10, "one mass would carry the rest alone");
        remove_imbalance(&mut qp);
        assert!(size(&qp) < 1e-15);
        assert!(qp.load.iter().sum::<f64>().abs() < 1e-15);
        assert!((qp.load[1] + 0.25e-9).abs() < 1e-15, "a quarter each");
    }
}
