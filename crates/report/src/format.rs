//! Numbers as a reader wants them: errors to five digits, rates to three decimals, bounds as fractions.

/// Stands where there is no value.
pub const MISSING: &str = "–";

/// `x` to `digits` significant digits; scientific below `1e-3` and from `1e5` on.
pub fn significant(x: f64, digits: usize) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if !x.is_finite() {
        return format!("{x}");
    }
    let scientific = format!("{:.*e}", digits.saturating_sub(1), x);
    // The exponent after rounding: 0.99999 to two digits is 1.0.
    let exponent: i32 = scientific.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    if !(-3..5).contains(&exponent) {
        return scientific;
    }
    let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
    format!("{x:.decimals$}")
}

/// A rate to three decimals; no `-0.000`.
pub fn rate(x: f64) -> String {
    let text = format!("{x:.3}");
    if text == "-0.000" { "0.000".into() } else { text }
}

/// `0.998 [0.994, 1.002]`: a slope and its 95 % interval.
pub fn interval(slope: f64, low: f64, high: f64) -> String {
    format!("{} [{}, {}]", rate(slope), rate(low), rate(high))
}

/// `0.998 ± 0.004`: a slope and half its 95 % interval, which is symmetric.
pub fn half_interval(slope: f64, low: f64, high: f64) -> String {
    format!("{} ± {}", rate(slope), rate(0.5 * (high - low)))
}

/// A bound: whole numbers and simple fractions as such (`1`, `3/4`), the rest to three decimals without tail zeros.
pub fn bound(x: f64) -> String {
    match fraction(x) {
        Some((p, 1)) => format!("{p}"),
        Some((p, q)) => format!("{p}/{q}"),
        None => trimmed(x),
    }
}

/// The order of a bound, `O(h)`, `O(h²)`, `O(h^{3/4})`; what stands in `^{…}` is to be raised.
pub fn order(exponent: f64) -> String {
    format!("O({})", power_of_h(exponent))
}

/// `h`, `h²`, `h^{3/2}`, `h^{0.72}`; `1` for the exponent 0.
fn power_of_h(exponent: f64) -> String {
    match bound(exponent).as_str() {
        "0" => "1".into(),
        "1" => "h".into(),
        text if text.chars().all(|c| c.is_ascii_digit()) => format!("h{}", superscript(text)),
        text => format!("h^{{{text}}}"),
    }
}

/// Digits and sign raised, for whole exponents.
pub fn superscript(text: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    text.chars()
        .map(|c| match c {
            '0'..='9' => DIGITS[c as usize - '0' as usize],
            '-' => '⁻',
            other => other,
        })
        .collect()
}

/// `level 3`, `levels 0–6`.
pub fn level_words(numbers: &[usize]) -> String {
    let word = if numbers.len() == 1 { "level" } else { "levels" };
    format!("{word} {}", levels(numbers))
}

/// Levels as ranges: `2–5`, `0, 2–4`.
pub fn levels(numbers: &[usize]) -> String {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for &n in numbers {
        match runs.last_mut() {
            Some(run) if run.1 + 1 == n => run.1 = n,
            _ => runs.push((n, n)),
        }
    }
    let words: Vec<String> =
        runs.iter().map(|&(a, b)| if a == b { format!("{a}") } else { format!("{a}–{b}") }).collect();
    words.join(", ")
}

fn fraction(x: f64) -> Option<(i64, i64)> {
    (1..=4_i64).map(|q| ((x * q as f64).round() as i64, q)).find(|&(p, q)| (x - p as f64 / q as f64).abs() < 1e-9)
}

fn trimmed(x: f64) -> String {
    let text = format!("{x:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_significant_ones() {
        for (x, text) in [
            (0.012345678, "0.012346"),
            (1.0, "1.0000"),
            (12345.6, "12346"),
            (99999.9, "1.0000e5"),
            (1.5e-9, "1.5000e-9"),
            (0.00099999999, "0.0010000"),
            (-0.25, "-0.25000"),
            (0.0, "0"),
            (-0.0, "0"),
        ] {
            assert_eq!(significant(x, 5), text, "{x}");
        }
    }

    #[test]
    fn bounds_read_as_fractions() {
        for (x, text, order_text) in [
            (1.0, "1", "O(h)"),
            (0.75, "3/4", "O(h^{3/4})"),
            (1.5, "3/2", "O(h^{3/2})"),
            (2.0, "2", "O(h²)"),
            (0.72, "0.72", "O(h^{0.72})"),
            (0.0, "0", "O(1)"),
        ] {
            assert_eq!(bound(x), text);
            assert_eq!(order(x), order_text);
        }
    }

    #[test]
    fn level_ranges() {
        assert_eq!(levels(&[2, 3, 4, 5]), "2–5");
        assert_eq!(levels(&[0, 2, 3]), "0, 2–3");
        assert_eq!(levels(&[]), "");
    }
}
