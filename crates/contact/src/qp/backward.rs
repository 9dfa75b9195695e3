//! Residuals row by row, each against the terms it is made of.

use super::BoundQp;

/// `(|K||x| + |f|)_i` for the two rows of a node.
fn sizes(qp: &BoundQp, x: &[f64], node: usize) -> [f64; 2] {
    let mut size = [qp.load[2 * node].abs(), qp.load[2 * node + 1].abs()];
    for (j, b) in qp.matrix.row(node) {
        let (u, v) = (x[2 * j].abs(), x[2 * j + 1].abs());
        size[0] += b[0].abs() * u + b[1].abs() * v;
        size[1] += b[2].abs() * u + b[3].abs() * v;
    }
    size
}

/// `(|K||x| + |f|)_i`: what rounding in row `i` of the residual is relative to.
pub(crate) fn row_size(qp: &BoundQp, x: &[f64], row: usize) -> f64 {
    sizes(qp, x, row / 2)[row % 2]
}

/// `max_i |r_i| / (|K||x| + |f|)_i`: for a residual `r`, the smallest relative change of the entries of `K` and `f` that explains
/// it (W. Oettli, W. Prager, 1964). Rows with nothing in them count as 0; a NaN in the residual shows.
pub(crate) fn backward_error(qp: &BoundQp, x: &[f64], rest: &[f64]) -> f64 {
    let mut worst = 0.0_f64;
    for node in 0..qp.matrix.rows() {
        for (k, size) in sizes(qp, x, node).into_iter().enumerate() {
            let r = rest[2 * node + k].abs();
            let ratio = if r == 0.0 { 0.0 } else { r / size };
            if ratio.is_nan() {
                return ratio;
            }
            worst = worst.max(ratio);
        }
    }
    worst
}
