//! A linear axis: its range, its ticks, and the power of ten that its labels leave out.

use super::axis::Tick;
use crate::format::superscript;

/// `low < high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LinearRange {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

/// A negative value below this share of the largest positive one is rounding.
const ROUNDING: f64 = 1e-9;

impl LinearRange {
    /// From zero, or a little below the smallest value if that is negative beyond rounding, to a little above the largest; one
    /// without a value still has an extent.
    pub fn around_zero(values: impl Iterator<Item = f64>) -> Self {
        let finite = values.filter(|v| v.is_finite());
        let (smallest, largest) = finite.fold((0.0, 0.0), |(a, b), v| (f64::min(a, v), f64::max(b, v)));
        let low = if smallest < -ROUNDING * largest { smallest } else { 0.0 };
        match (low < 0.0, largest > 0.0) {
            (false, true) => Self { low: 0.0, high: 1.06 * largest },
            (false, false) => Self { low: 0.0, high: 1.0 },
            (true, _) => Self { low: low - 0.06 * (largest - low), high: largest + 0.06 * (largest - low) },
        }
    }

    /// Position of `value` between the ends, 0 to 1.
    pub fn share(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    /// The power of ten that labels leave out: 0 for moderate numbers.
    pub fn exponent(&self) -> i32 {
        let exponent = self.low.abs().max(self.high.abs()).log10().floor() as i32;
        if (-2..4).contains(&exponent) { 0 } else { exponent }
    }

    /// ` (10⁻³)` behind the name of the axis, or nothing.
    pub fn unit(&self) -> String {
        match self.exponent() {
            0 => String::new(),
            e => format!(" (10{})", superscript(&e.to_string())),
        }
    }

    /// Multiples of 1, 2 or 5 × 10^k, the finest step that leaves `room` pixels to each on an axis of `length` pixels.
    pub fn ticks(&self, length: f64, room: f64) -> Vec<Tick> {
        let least = (self.high - self.low) * room / length;
        let mut power = 10_f64.powi(least.log10().floor() as i32);
        let mut step = power;
        for factor in [1.0, 2.0, 5.0, 10.0] {
            step = factor * power;
            if step >= least {
                break;
            }
        }
        power = 10_f64.powi(self.exponent());
        // what a step needs behind the point
        let decimals = (-(step / power).log10().floor()).max(0.0) as usize;
        let (first, last) = ((self.low / step).ceil() as i64, (self.high / step).floor() as i64);
        let tick = |k: i64| {
            let value = k as f64 * step;
            Tick { value, label: format!("{:.decimals$}", value / power) }
        };
        (first..=last).map(tick).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64, length: f64, room: f64) -> Vec<String> {
        LinearRange { low, high }.ticks(length, room).into_iter().map(|t| t.label).collect()
    }

    #[test]
    fn ticks_are_round_and_keep_their_distance() {
        assert_eq!(labels(0.0, 1.0, 500.0, 100.0), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(0.0, 0.27, 500.0, 120.0), ["0.0", "0.1", "0.2"]);
        assert_eq!(labels(-3.0, 12.0, 300.0, 60.0), ["0", "5", "10"]);
        for k in 0..200 {
            let (low, span) = (f64::from(k) * 0.173 - 9.0, 10_f64.powf(f64::from(k) / 20.0 - 5.0));
            let range = LinearRange { low, high: low + span };
            let ticks = range.ticks(400.0, 50.0);
            assert!(ticks.len() >= 2 && ticks.len() <= 9, "{range:?}: {ticks:?}");
            for pair in ticks.windows(2) {
                let apart = 400.0 * (range.share(pair[1].value) - range.share(pair[0].value));
                assert!(apart >= 49.999 && pair[0].label != pair[1].label, "{pair:?}");
            }
        }
    }

    #[test]
    fn small_and_large_numbers_leave_their_power_to_the_name() {
        let range = LinearRange { low: 0.0, high: 0.0034 };
        assert_eq!((range.exponent(), range.unit().as_str()), (-3, " (10⁻³)"));
        assert_eq!(labels(0.0, 0.0034, 500.0, 120.0), ["0", "1", "2", "3"]);
        assert_eq!(LinearRange { low: 0.0, high: 40.0 }.unit(), "");
    }

    #[test]
    fn negative_values_have_their_place_and_rounding_has_none() {
        let range = |values: &[f64]| LinearRange::around_zero(values.iter().copied());
        assert_eq!(range(&[f64::NAN]), LinearRange { low: 0.0, high: 1.0 });
        assert_eq!(range(&[2.0, -1e-12]), LinearRange { low: 0.0, high: 2.12 });
        assert_eq!(range(&[2.0, -3.0]), LinearRange { low: -3.3, high: 2.3 });
        assert_eq!(range(&[-1.0]), LinearRange { low: -1.06, high: 0.06 });
    }
}
