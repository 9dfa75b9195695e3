//! Residuals row by row, each against the terms it is made of.

use super::{BoundQp, largest};
use rayon::prelude::*;

/// A row whose terms lie below this share of `‖K_i‖₁‖x‖_∞` consists of rounding: a body at rest beside one that moves. The share is
/// 1000 n u for n = 100, as the authors of the rule have it for n unknowns.
const NOISE: f64 = 1e5 * f64::EPSILON;

/// Of one row `i`.
#[derive(Clone, Copy, Debug, Default)]
struct RowSize {
    /// `(|K||x| + |f|)_i`.
    terms: f64,
    /// `‖K_i‖₁`.
    norm: f64,
}

/// The two rows of a node.
fn sizes(qp: &BoundQp, x: &[f64], node: usize) -> [RowSize; 2] {
    let mut size = [2 * node, 2 * node + 1].map(|i| RowSize { terms: qp.load[i].abs(), norm: 0.0 });
    for (j, b) in qp.matrix.row(node) {
        let (u, v) = (x[2 * j].abs(), x[2 * j + 1].abs());
        for (k, size) in size.iter_mut().enumerate() {
            let (a, b) = (b[2 * k].abs(), b[2 * k + 1].abs());
            size.terms += a * u + b * v;
            size.norm += a + b;
        }
    }
    size
}

/// `(|K||x| + |f|)_i`: what rounding in row `i` of the residual is relative to.
pub(crate) fn row_size(qp: &BoundQp, x: &[f64], row: usize) -> f64 {
    sizes(qp, x, row / 2)[row % 2].terms
}

/// `‖K_i‖₁`: times the rounding of `x`, the rounding of row `i` of the residual.
pub(crate) fn row_norm(qp: &BoundQp, x: &[f64], row: usize) -> f64 {
    sizes(qp, x, row / 2)[row % 2].norm
}

/// `max_i |r_i| / (|K||x| + |f|)_i`: for a residual `r`, the smallest relative change of the entries of `K` and `f` that explains
/// it (W. Oettli, W. Prager, 1964). Where the terms of a row are themselves rounding, `‖K_i‖₁‖x‖_∞` stands for them (M. Arioli,
/// J. Demmel, I. Duff, 1989). Rows with nothing in them count as 0; a NaN in the residual shows.
pub(crate) fn backward_error(qp: &BoundQp, x: &[f64], rest: &[f64]) -> f64 {
    let reach = largest(x);
    let of_node = |node: usize| {
        let [a, b] = sizes(qp, x, node);
        larger(relative(rest[2 * node], &a, reach), relative(rest[2 * node + 1], &b, reach))
    };
    (0..qp.matrix.rows()).into_par_iter().with_min_len(4096).map(of_node).reduce(|| 0.0, larger)
}

fn relative(r: f64, size: &RowSize, reach: f64) -> f64 {
    let whole = size.norm * reach;
    let scale = if size.terms > NOISE * whole { size.terms } else { size.terms + whole };
    if r == 0.0 { 0.0 } else { r.abs() / scale }
}

/// The larger of two; NaN if one is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b <= a { a } else { b }
}
