//! The alternative with a logarithm, in words.

use crate::format;
use signorini_study::record::Rate;

/// What the fits with a logarithm say; empty where the study does not call the regularity borderline.
pub fn words(rate: &Rate) -> String {
    let Some(first) = rate.log_alternatives.first() else { return String::new() };
    let one = |q: f64, exponent: f64, residual: f64| {
        format!("q = {q} gives p = {} (residual {})", format::rate(exponent), format::significant(residual, 2))
    };
    let all: Vec<String> = rate.log_alternatives.iter().map(|a| one(a.q, a.exponent, a.residual)).collect();
    format!(
        "\nThe regularity is borderline. Fitted as C h^p |log h|^q, {}; without a logarithm the residual is {}. Residuals are root mean \
         squares of log e; nothing is judged by them.\n",
        all.join(", "),
        format::significant(first.plain_residual, 2),
    )
}
