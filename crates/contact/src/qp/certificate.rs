//! The KKT certificate: how far `x, λ` are from optimal, recomputed from the raw data. No solver grades itself.

use super::{BoundQp, backward_error, largest, residual};

/// A multiplier or a slack below this share of the largest counts as zero.
const WEAK: f64 = 1e-8;

/// The sizes that make the residuals free of units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertificateScales {
    /// `max|u|`, the largest nodal displacement.
    pub displacement: f64,
    /// `A(u_h,u_h)`.
    pub energy: f64,
}

/// The KKT residuals. All vanish at a solution; NaN in the data shows as NaN here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certificate {
    /// `‖f − Kx − λ‖_∞ / (‖K‖_∞‖x‖_∞ + ‖f‖_∞)`.
    pub stationarity: f64,
    /// The same row by row, `max_i |f−Kx−λ|_i / (|K||x| + |f|)_i`: soft bodies beside hard ones, and small loads beside large
    /// ones, count as much as the others. Without the rows of weakly active bounds, whose force is rounding: those the line above judges.
    pub componentwise: f64,
    /// `max(x_c − g)_+ / max|u|`.
    pub penetration: f64,
    /// `max(−λ)_+ / max|λ|`.
    pub tension: f64,
    /// `Σ|λ(g − x_c)| / A(u_h,u_h)`.
    pub complementarity: f64,
    /// Bounds with both `λ < 1e-8 max λ` and `g − x_c < 1e-8 max|u|`.
    pub weakly_active: usize,
    /// `max|λ|`.
    pub max_multiplier: f64,
    /// Bounds with `λ > 1e-8 max λ`.
    pub active: usize,
}

/// The certificate of `x` (length of the load) and `multipliers` (one per bound).
pub fn certify(qp: &BoundQp, x: &[f64], multipliers: &[f64], scales: &CertificateScales) -> Certificate {
    let slack: Vec<f64> = qp.bounds.iter().map(|b| b.upper - x[b.dof as usize]).collect();
    let max_multiplier = largest(multipliers);
    let small_slack = WEAK * scales.displacement;
    let presses = |multiplier: f64| multiplier > WEAK * max_multiplier;
    let pairs = || multipliers.iter().copied().zip(slack.iter().copied());
    let is_weak = |multiplier: f64, slack: f64| !presses(multiplier) && slack < small_slack;
    let mut rest = imbalance(qp, x, multipliers);
    let stationarity = stationarity(qp, x, &rest);
    for (bound, (multiplier, slack)) in qp.bounds.iter().zip(pairs()) {
        if is_weak(multiplier, slack) {
            rest[bound.dof as usize] = 0.0;
        }
    }
    let products = pairs().map(|(multiplier, slack)| (multiplier * slack).abs());
    Certificate {
        stationarity,
        componentwise: backward_error(qp, x, &rest),
        penetration: ratio(largest_deficit(&slack), scales.displacement),
        tension: ratio(largest_deficit(multipliers), max_multiplier),
        complementarity: ratio(products.sum(), scales.energy),
        weakly_active: pairs().filter(|&(multiplier, slack)| is_weak(multiplier, slack)).count(),
        max_multiplier,
        active: pairs().filter(|&(multiplier, _)| presses(multiplier)).count(),
    }
}

/// `f − Kx − λ`.
fn imbalance(qp: &BoundQp, x: &[f64], multipliers: &[f64]) -> Vec<f64> {
    let mut rest = residual(qp, x);
    for (bound, multiplier) in qp.bounds.iter().zip(multipliers) {
        rest[bound.dof as usize] -= multiplier;
    }
    rest
}

/// `‖r‖_∞ / (‖K‖_∞‖x‖_∞ + ‖f‖_∞)` with `r = f − Kx − λ`.
fn stationarity(qp: &BoundQp, x: &[f64], rest: &[f64]) -> f64 {
    let scale = qp.matrix.norm_inf() * largest(x) + largest(&qp.load);
    ratio(largest(rest), scale)
}

/// `max(−v)_+`; NaN if any entry is.
fn largest_deficit(v: &[f64]) -> f64 {
    let deficit: Vec<f64> = v.iter().map(|&v| if v > 0.0 { 0.0 } else { v }).collect();
    largest(&deficit)
}

/// 0 where both vanish.
fn ratio(numerator: f64, denominator: f64) -> f64 {
    if numerator == 0.0 { 0.0 } else { numerator / denominator }
}
