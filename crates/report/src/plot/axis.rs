//! Ticks of a logarithmic axis: 1, 2, 5 × 10^k where they fit, labels that never touch.

use crate::format::superscript;

/// A range of decimal logarithms, `low < high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LogRange {
    /// `log10` of the lower end.
    pub low: f64,
    /// `log10` of the upper end.
    pub high: f64,
}

/// Least extent of an axis in decades, so that equal values still have ticks about them.
const LEAST: f64 = 0.8;

impl LogRange {
    /// The range of positive finite values, widened by `pad` of itself on each side; `None` without a value.
    pub fn around(values: impl Iterator<Item = f64>, pad: f64) -> Option<Self> {
        let logs = values.filter(|v| *v > 0.0 && v.is_finite()).map(f64::log10);
        let (low, high) = logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        if low > high {
            return None;
        }
        let missing = (LEAST / (1.0 + 2.0 * pad) - (high - low)).max(0.0) / 2.0;
        let margin = missing + pad * (high - low + 2.0 * missing);
        Some(Self { low: low - margin, high: high + margin })
    }

    /// Decades between the ends.
    pub fn decades(&self) -> f64 {
        self.high - self.low
    }

    /// Position of `value` between the ends, 0 to 1.
    pub fn share(&self, value: f64) -> f64 {
        (value.log10() - self.low) / self.decades()
    }
}

/// A labelled value on an axis.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    /// The value.
    pub value: f64,
    /// Its label.
    pub label: String,
}

/// Fewest ticks that let a reader read values off an axis.
const ENOUGH: usize = 3;
/// More ticks than these are noise.
const PLENTY: usize = 12;

/// Ticks for an axis of `length` pixels. `extent` is the room a label takes along the axis; between two labels at
/// least `gap` pixels stay free.
///
/// 1, 2, 5 × 10^k if they fit and are enough, else whole decades in a wide range, finer steps in a narrow one.
pub(crate) fn ticks(range: LogRange, length: f64, gap: f64, extent: impl Fn(&str) -> f64) -> Vec<Tick> {
    let fits = |ticks: &[Tick]| {
        ticks.len() <= PLENTY
            && ticks.windows(2).all(|pair| {
                let room = (range.share(pair[1].value) - range.share(pair[0].value)) * length;
                room >= gap + 0.5 * (extent(&pair[0].label) + extent(&pair[1].label))
            })
    };
    let regular = regular(range).into_iter().map(labelled);
    let enough = |ticks: &Vec<Tick>| ticks.len() >= ENOUGH && fits(ticks);
    regular.into_iter().find(enough).unwrap_or_else(|| filled(range, fits))
}

/// 1, 2, 5 × 10^k, then every decade, every second, …
fn regular(range: LogRange) -> Vec<Vec<(f64, i32)>> {
    let decades = [1, 2, 3, 5, 10, 20, 50, 100].map(|every| within(range, &[1.0], every));
    let mut sets = vec![within(range, &[1.0, 2.0, 5.0], 1)];
    sets.extend(decades);
    sets
}

/// Numbers of one decimal, each where it still fits, for ranges that hold few of 1, 2, 5 × 10^k: the roundest first,
/// and no rounder group is left half used once there are enough.
fn filled(range: LogRange, fits: impl Fn(&[Tick]) -> bool) -> Vec<Tick> {
    let tenths: Vec<f64> = (10..100).map(|m| f64::from(m) / 10.0).collect();
    let rounder: [&[f64]; 6] =
        [&[1.0], &[5.0], &[2.0], &[3.0, 7.0], &[1.5, 4.0, 6.0, 8.0], &[1.2, 1.7, 2.5, 3.5, 4.5, 5.5, 6.5, 9.0]];
    let mut chosen: Vec<(f64, i32)> = Vec::new();
    for mantissas in rounder.into_iter().chain([tenths.as_slice()]) {
        if chosen.len() >= ENOUGH {
            break;
        }
        for number in within(range, mantissas, 1) {
            let mut more = chosen.clone();
            more.push(number);
            more.sort_by(|a, b| a.1.cmp(&b.1).then(a.0.total_cmp(&b.0)));
            more.dedup();
            if fits(&labelled(more.clone())) {
                chosen = more;
            }
        }
    }
    labelled(chosen)
}

/// `m·10^k` in the range, `k` a multiple of `every`.
fn within(range: LogRange, mantissas: &[f64], every: i32) -> Vec<(f64, i32)> {
    let exponents = range.low.floor() as i32..=range.high.floor() as i32;
    let inside = |m: f64, k: i32| (range.low..=range.high).contains(&(m.log10() + f64::from(k)));
    exponents
        .filter(|k| k.rem_euclid(every) == 0)
        .flat_map(|k| mantissas.iter().map(move |&m| (m, k)))
        .filter(|&(m, k)| inside(m, k))
        .collect()
}

/// Decimals if all are moderate, powers of ten otherwise.
fn labelled(numbers: Vec<(f64, i32)>) -> Vec<Tick> {
    let decimal = numbers.iter().all(|&(_, k)| (-3..4).contains(&k));
    let tick = |&(m, k): &(f64, i32)| Tick {
        value: scaled(m, k),
        label: if decimal { decimal_label(m, k) } else { power_label(m, k) },
    };
    numbers.iter().map(tick).collect()
}

/// `m·10^k`, rounded once.
fn scaled(m: f64, k: i32) -> f64 {
    format!("{m}e{k}").parse().unwrap_or(m)
}

/// `0.002`, `150`
fn decimal_label(m: f64, k: i32) -> String {
    // One decimal of the mantissa survives: m has at most two digits.
    let decimals = usize::try_from(1 - k).unwrap_or(0);
    let text = format!("{:.decimals$}", scaled(m, k));
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

/// `10⁻³`, `2·10⁻³`
fn power_label(m: f64, k: i32) -> String {
    if k == 0 {
        return format!("{m}");
    }
    let power = format!("10{}", superscript(&k.to_string()));
    if m == 1.0 { power } else { format!("{m}·{power}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 13 pixels a character, as the pictures have.
    fn extent(label: &str) -> f64 {
        13.0 * label.chars().count() as f64
    }

    fn ranges() -> impl Iterator<Item = LogRange> {
        let spans = (3..=120).map(|tenth| f64::from(tenth) / 10.0);
        spans
            .flat_map(|span| (0..40).map(move |i| f64::from(i) * 0.37 - 9.0).map(move |low| (low, span)))
            .map(|(low, span)| LogRange { low, high: low + span })
    }

    #[test]
    fn labels_keep_apart_over_all_ranges() {
        for range in ranges() {
            let ticks = ticks(range, 700.0, 12.0, extent);
            for pair in ticks.windows(2) {
                let centres = 700.0 * (range.share(pair[1].value) - range.share(pair[0].value));
                let free = centres - 0.5 * (extent(&pair[0].label) + extent(&pair[1].label));
                assert!(free >= 12.0, "{range:?}: {pair:?} only {free} apart");
            }
        }
    }

    #[test]
    fn every_range_can_be_read() {
        for range in ranges() {
            let ticks = ticks(range, 700.0, 12.0, extent);
            assert!(ticks.len() >= 3, "{range:?}: {ticks:?}");
            assert!(ticks.iter().all(|t| (-1e-12..=1.0 + 1e-12).contains(&range.share(t.value))));
        }
    }

    #[test]
    fn labels_say_the_value() {
        let range = LogRange { low: -2.2, high: -0.4 };
        let labels: Vec<String> = ticks(range, 700.0, 12.0, extent).into_iter().map(|t| t.label).collect();
        assert_eq!(labels, ["0.01", "0.02", "0.05", "0.1", "0.2"]);
        let range = LogRange { low: -16.5, high: -13.5 };
        let labels: Vec<String> = ticks(range, 300.0, 12.0, extent).into_iter().map(|t| t.label).collect();
        assert_eq!(labels, ["10⁻¹⁶", "10⁻¹⁵", "10⁻¹⁴"]);
    }

    #[test]
    fn equal_values_get_a_range() {
        let range = LogRange::around([0.5, 0.5].into_iter(), 0.05).unwrap_or(LogRange { low: 0.0, high: 0.0 });
        assert!((range.decades() - LEAST).abs() < 1e-12, "{range:?}");
        assert!((range.share(0.5) - 0.5).abs() < 1e-12);
        assert_eq!(LogRange::around([0.0, f64::NAN, -1.0].into_iter(), 0.05), None);
    }
}
