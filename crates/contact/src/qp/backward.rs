//! Residuals row by row, each against the terms it is made of.

use super::BoundQp;

/// `max_i |r_i| / (|K||x| + |f|)_i`: for a residual `r`, the smallest relative change of the entries of `K` and `f` that explains
/// it (W. Oettli, W. Prager, 1964). Rows with nothing in them count as 0; a NaN in the residual shows.
pub(crate) fn backward_error(qp: &BoundQp, x: &[f64], rest: &[f64]) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..qp.matrix.rows() {
        let mut size = [qp.load[2 * i].abs(), qp.load[2 * i + 1].abs()];
        for (j, b) in qp.matrix.row(i) {
            let (u, v) = (x[2 * j].abs(), x[2 * j + 1].abs());
            size[0] += b[0].abs() * u + b[1].abs() * v;
            size[1] += b[2].abs() * u + b[3].abs() * v;
        }
        for k in 0..2 {
            let ratio = if rest[2 * i + k] == 0.0 { 0.0 } else { rest[2 * i + k].abs() / size[k] };
            worst = if ratio > worst || ratio.is_nan() { ratio } else { worst };
        }
        if worst.is_nan() {
            return worst;
        }
    }
    worst
}
