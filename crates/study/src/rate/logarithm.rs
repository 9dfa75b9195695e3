//! The alternative with a logarithm, `e = C h^p |log h|^q`, for borderline regularity.
//!
//! Estimates at the edge of a Sobolev space often carry `|log h|^{1/2}` or `|log h|`. Over the few octaves of a study
//! `|log h|` is nearly a power of `h` itself, so `p` and `q` cannot be fitted together: `q` is given, `½` or `1`, and `p`
//! follows by least squares of `log e − q log|log h|` on `log h`.

use super::{Point, line::Line, logs, points};
use crate::record::{Level, LogAlternative, Rate};

/// The powers of the logarithm that are tried.
pub const POWERS: [f64; 2] = [0.5, 1.0];

/// The largest mesh size at which `|log h|` stands for what the estimates mean: beyond `1/e` it falls towards zero at `h = 1`.
const COARSEST: f64 = 0.368;

/// The alternatives over the levels of `rate`, in the order of [`POWERS`]; none where a mesh size exceeds `1/e` in the study's unit
/// of length.
pub fn log_alternatives(levels: &[Level], norm: &str, rate: &Rate) -> Vec<LogAlternative> {
    let mut window = points(levels, norm);
    window.retain(|p| rate.levels.contains(&p.level));
    if window.len() < super::MIN_LEVELS || window.iter().any(|p| p.h > COARSEST) {
        return Vec::new();
    }
    POWERS.map(|q| with_power(&window, q)).to_vec()
}

fn with_power(window: &[Point], q: f64) -> LogAlternative {
    let plain = Line::through(&logs(window, |p| p.h));
    // log e − q log|log h| = log C + p log h
    let corrected =
        Line::through(&window.iter().map(|p| (p.h.ln(), p.error.ln() - q * (-p.h.ln()).ln())).collect::<Vec<_>>());
    LogAlternative {
        q,
        exponent: corrected.slope,
        r2: corrected.r2,
        residual: corrected.residual,
        plain_residual: plain.residual,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rate::fit_levels;
    use crate::sample;

    fn alternatives(error: impl Fn(f64) -> f64) -> Vec<LogAlternative> {
        let levels = sample::levels(6, error);
        log_alternatives(&levels, "energy", &fit_levels(&levels, "energy").unwrap())
    }

    #[test]
    fn the_true_logarithm_is_found_exactly() {
        for (k, q) in POWERS.into_iter().enumerate() {
            let found = alternatives(|h| 0.3 * h.powf(0.8) * h.ln().abs().powf(q));
            assert!((found[k].exponent - 0.8).abs() < 1e-12 && found[k].residual < 1e-12, "{found:?}");
            // the other power and the plain one leave residuals
            assert!(found[1 - k].residual > 1e-4 && found[k].plain_residual > 1e-3, "{found:?}");
        }
    }

    #[test]
    fn a_plain_power_is_not_improved_by_a_logarithm() {
        let found = alternatives(|h| 0.3 * h);
        assert!(found.iter().all(|a| a.plain_residual < 1e-12 && a.residual > 1e-3 && a.exponent > 1.1), "{found:?}");
    }

    #[test]
    fn coarse_meshes_have_no_alternative() {
        let mut levels = sample::levels(5, |h| h);
        levels.iter_mut().for_each(|l| l.h *= 4.0);
        let rate = fit_levels(&levels, "energy").unwrap();
        assert!(log_alternatives(&levels, "energy", &rate).is_empty());
    }
}
