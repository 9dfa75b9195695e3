//! Quantiles of Student's t distribution.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// The `t` with `P(T ≤ t) = p` for `df ≥ 1` degrees of freedom and `½ ≤ p < 1`.
///
/// Bisection in `θ = atan(t/√df)` on the finite series of Abramowitz and Stegun, *Handbook of Mathematical
/// Functions*, 26.7.3 and 26.7.4.
///
/// # Panics
/// If `df = 0` or `p` lies outside `[½, 1)`.
pub fn quantile(p: f64, df: usize) -> f64 {
    assert!(df > 0 && (0.5..1.0).contains(&p), "no t quantile for p = {p}, df = {df}");
    let wanted = 2.0 * p - 1.0;
    let (mut low, mut high) = (0.0, FRAC_PI_2);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            // t = √df tan θ
            return (df as f64).sqrt() * low.tan();
        }
        if central(middle, df) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// `P(|T| ≤ √df tan θ)`.
fn central(theta: f64, df: usize) -> f64 {
    let (sin, cos) = theta.sin_cos();
    if df.is_multiple_of(2) {
        // sin θ {1 + 1/2 cos² θ + (1·3)/(2·4) cos⁴ θ + … + cos^{df−2} θ}
        sin * series(1.0, cos * cos, 1, df / 2)
    } else {
        // 2/π {θ + sin θ [cos θ + 2/3 cos³ θ + … + cos^{df−2} θ]}
        FRAC_2_PI * (theta + sin * series(cos, cos * cos, 2, df / 2))
    }
}

/// `terms` terms of `first · (1 + k/(k+1) q + k(k+2)/((k+1)(k+3)) q² + …)`.
fn series(first: f64, q: f64, k: usize, terms: usize) -> f64 {
    let mut term = first;
    let mut sum = 0.0;
    for i in 0..terms {
        sum += term;
        let top = (k + 2 * i) as f64;
        term *= q * top / (top + 1.0);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published tables, `t_{0.975}`.
    #[test]
    fn agrees_with_published_tables() {
        let table = [
            (1, 12.706204736),
            (2, 4.302652730),
            (3, 3.182446305),
            (4, 2.776445105),
            (10, 2.228138852),
            (30, 2.042272456),
        ];
        for (df, t) in table {
            assert!((quantile(0.975, df) - t).abs() < 1e-9, "df {df}: {}", quantile(0.975, df));
        }
    }

    /// The density integrated by Simpson's rule up to the quantile gives the probability back.
    #[test]
    fn density_integrates_to_the_probability() {
        // Γ(4)/(√(7π) Γ(7/2)) with Γ(7/2) = 15√π/8
        let scale = 6.0 * 8.0 / (15.0 * std::f64::consts::PI * 7.0_f64.sqrt());
        let density = |t: f64| scale * (1.0 + t * t / 7.0).powi(-4);
        for p in [0.6, 0.9, 0.975, 0.999] {
            let t = quantile(p, 7);
            let n = 2000;
            let step = t / n as f64;
            let weight = |i: usize| {
                if i == 0 || i == n { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 }
            };
            let half: f64 = (0..=n).map(|i| weight(i) * density(i as f64 * step)).sum::<f64>() * step / 3.0;
            assert!((0.5 + half - p).abs() < 1e-10, "p {p}: {}", 0.5 + half);
        }
    }
}
