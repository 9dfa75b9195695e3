//! The least-squares line and how well it fits.

/// `y ≈ intercept + slope · x`.
pub(crate) struct Line {
    /// Slope.
    pub slope: f64,
    /// Value at `x = 0`.
    pub intercept: f64,
    /// Standard error of the slope, from the residuals with `n − 2` degrees of freedom.
    pub stderr: f64,
    /// Coefficient of determination.
    pub r2: f64,
    /// Root mean square of the residuals.
    pub residual: f64,
}

impl Line {
    /// The line through at least three points whose `x` are not all equal.
    pub fn through(points: &[(f64, f64)]) -> Self {
        let n = points.len() as f64;
        let mean_x = points.iter().map(|p| p.0).sum::<f64>() / n;
        let mean_y = points.iter().map(|p| p.1).sum::<f64>() / n;
        let moment = |f: fn(f64, f64) -> f64| -> f64 { points.iter().map(|p| f(p.0 - mean_x, p.1 - mean_y)).sum() };
        let (sxx, sxy, syy) = (moment(|x, _| x * x), moment(|x, y| x * y), moment(|_, y| y * y));
        // slope = S_xy / S_xx
        let slope = sxy / sxx;
        let residual = |p: &(f64, f64)| (p.1 - mean_y) - slope * (p.0 - mean_x);
        let sse: f64 = points.iter().map(|p| residual(p).powi(2)).sum();
        Self {
            slope,
            intercept: mean_y - slope * mean_x,
            // stderr² = SSE / ((n − 2) S_xx)
            stderr: (sse / ((n - 2.0) * sxx)).sqrt(),
            // R² = 1 − SSE / S_yy
            r2: 1.0 - sse / syy,
            residual: (sse / n).sqrt(),
        }
    }
}
