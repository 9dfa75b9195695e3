//! Observed rates: least squares of `log e` on `log h` over the asymptotic window.
//!
//! ```text
//!   log e
//!     │                      · 0        pairwise rates   0–1: 0.71   not asymptotic yet
//!     │                 · 1                              1–2: 0.93   │ each differs from the
//!     │            · 2                                   2–3: 0.96   │ next by less than 0.05:
//!     │       · 3                                        3–4: 0.97   │ the window is 1, 2, 3, 4
//!     │  · 4
//!     └──────────────────────── log h
//! ```
//!
//! The window is chosen from the measured errors alone; the claim has no say in it. On noise-free data the residuals
//! are systematic, so the interval is descriptive, and [`Rate::curvature`] stands beside it.

pub mod coverage;
mod guard;
mod line;
mod logarithm;
mod of_ledger;
mod of_levels;
pub mod student;
mod window;

pub use guard::{NoFit, check};
pub use logarithm::{POWERS, log_alternatives};
pub use of_ledger::{PREFIX as LEDGER, fit_term};
pub use of_levels::{ROUNDING, all, fit_levels, is_rounding, points, rounding_floor};

use crate::record::Rate;
pub(crate) use line::Line;

/// Fewest levels that make a rate.
pub const MIN_LEVELS: usize = 4;

/// Successive pairwise rates in the window differ by less than this.
pub const DRIFT: f64 = 0.05;

/// Confidence of the interval.
const CONFIDENCE: f64 = 0.95;

/// A measured error on one level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Number of the level, 0 the coarsest.
    pub level: usize,
    /// Measured mesh size: the largest side.
    pub h: f64,
    /// Free displacement components.
    pub dofs: usize,
    /// A norm of the error, not its square.
    pub error: f64,
}

/// Fits `e ≈ C h^slope` to `points`, coarsest first.
///
/// Where even the last four levels drift by [`DRIFT`] or more, they are fitted all the same and the rate is marked
/// as not asymptotic.
///
/// # Errors
/// [`NoFit`] where the points cannot carry a rate.
pub fn fit(points: &[Point]) -> Result<Rate, NoFit> {
    fit_above(points, 0.0)
}

/// [`fit`], refusing errors at or below `floor`, the size of rounding in the units of the error.
///
/// # Errors
/// [`NoFit`] where the points cannot carry a rate.
pub fn fit_above(points: &[Point], floor: f64) -> Result<Rate, NoFit> {
    check(points, floor, MIN_LEVELS)?;
    let pairwise = pairwise_rates(points);
    let window = window::choose(&pairwise);
    let chosen = &points[window.start..];
    let inner = &pairwise[window.start..];
    let line = Line::through(&logs(chosen, |p| p.h));
    let reach = student::quantile(0.5 + 0.5 * CONFIDENCE, chosen.len() - 2) * line.stderr;
    Ok(Rate {
        slope: line.slope,
        stderr: line.stderr,
        low: line.slope - reach,
        high: line.slope + reach,
        levels: chosen.iter().map(|p| p.level).collect(),
        intercept: line.intercept,
        r2: line.r2,
        pairwise: points[1..].iter().map(|p| p.level).zip(pairwise.iter().copied()).collect(),
        // mean second difference: (r_last − r_first) / (number of changes)
        curvature: (inner[inner.len() - 1] - inner[0]) / (inner.len() - 1) as f64,
        dofs_slope: Line::through(&logs(chosen, |p| (p.dofs as f64).powf(-0.5))).slope,
        asymptotic: window.asymptotic,
        log_alternatives: Vec::new(),
    })
}

/// `log(e_{i−1}/e_i) / log(h_{i−1}/h_i)` for each successive pair.
fn pairwise_rates(points: &[Point]) -> Vec<f64> {
    points.windows(2).map(|p| (p[0].error / p[1].error).ln() / (p[0].h / p[1].h).ln()).collect()
}

/// Pairs `(log size, log error)`.
fn logs(points: &[Point], size: impl Fn(&Point) -> f64) -> Vec<(f64, f64)> {
    points.iter().map(|p| (size(p).ln(), p.error.ln())).collect()
}

#[cfg(test)]
mod tests;
