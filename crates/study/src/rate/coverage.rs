//! How often the 95 % interval holds the true slope, measured on made-up errors whose slope is known.
//!
//! ```text
//! e(h) = t(h) exp(σ ξ),   ξ standard normal, independent on each level,   h = 2^{−3}, 2^{−4}, …
//! t(h) = h   or   h/(1 + 4h)   (rates rise to 1)   or   h (1 + 4h)   (rates fall to 1)
//! ```
//!
//! Two intervals are measured: that of the straight line through all levels, which Student's theorem promises to cover in 95 of
//! 100 draws where `t(h) = h`, and that of [`fit`], whose window is chosen from the same errors. The choice prefers
//! windows with small scatter, and so it covers less. Every draw has its own sequence of random numbers: the table does not
//! depend on the number of threads.

use super::{CONFIDENCE, Point, fit, line::Line, logs, student};
use crate::family::random::Random;
use rayon::prelude::*;

/// The slope of every made-up error, asymptotically.
pub const TRUE_SLOPE: f64 = 1.0;

/// The coverage that is stated beside every fitted rate: of settled windows on [`STATED_LEVELS`] levels with
/// [`STATED_NOISE`], where nothing but noise disturbs the power of `h`.
pub const STATED_COVERAGE: f64 = 0.92;

/// Levels of the stated coverage: as many as most studies have.
pub const STATED_LEVELS: usize = 5;

/// Relative noise of the stated coverage.
pub const STATED_NOISE: f64 = 0.01;

/// Errors without noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Truth {
    /// `h`.
    Power,
    /// `h/(1 + 4h)`: pairwise rates rise towards 1.
    Rising,
    /// `h (1 + 4h)`: pairwise rates fall towards 1.
    Falling,
}

impl Truth {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Power, Self::Rising, Self::Falling];

    /// The formula.
    pub fn formula(self) -> &'static str {
        match self {
            Self::Power => "h",
            Self::Rising => "h/(1 + 4h)",
            Self::Falling => "h (1 + 4h)",
        }
    }

    /// The error at the mesh size `h`.
    pub fn error(self, h: f64) -> f64 {
        match self {
            Self::Power => h,
            Self::Rising => h / (1.0 + 4.0 * h),
            Self::Falling => h * (1.0 + 4.0 * h),
        }
    }
}

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Errors without noise.
    pub truth: Truth,
    /// Number of levels, at least [`MIN_LEVELS`](super::MIN_LEVELS).
    pub levels: usize,
    /// `σ`, the relative size of the noise.
    pub noise: f64,
}

/// The settings of the table, in its order.
pub fn settings() -> Vec<Setting> {
    let of = |truth, levels| [0.001, 0.01, 0.05].map(|noise| Setting { truth, levels, noise });
    Truth::ALL.into_iter().flat_map(|truth| [4, 5, 6, 8].into_iter().flat_map(move |n| of(truth, n))).collect()
}

/// How often one kind of interval held the true slope.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// Intervals.
    pub drawn: usize,
    /// Those that held it.
    pub covered: usize,
    /// Mean of half their lengths.
    pub half_width: f64,
    /// Mean of slope − 1.
    pub bias: f64,
}

impl Share {
    /// `covered/drawn`; none where nothing was drawn.
    pub fn value(&self) -> Option<f64> {
        (self.drawn > 0).then(|| self.covered as f64 / self.drawn as f64)
    }

    /// Standard error of [`Share::value`], `√(s(1 − s)/drawn)`.
    pub fn stderr(&self) -> Option<f64> {
        self.value().map(|s| (s * (1.0 - s) / self.drawn as f64).sqrt())
    }

    fn of(intervals: impl Iterator<Item = Interval>) -> Self {
        let mut share = Self::default();
        for interval in intervals {
            share.drawn += 1;
            share.covered += usize::from(interval.low <= TRUE_SLOPE && TRUE_SLOPE <= interval.high);
            share.half_width += 0.5 * (interval.high - interval.low);
            share.bias += interval.slope - TRUE_SLOPE;
        }
        if share.drawn > 0 {
            share.half_width /= share.drawn as f64;
            share.bias /= share.drawn as f64;
        }
        share
    }
}

/// The measured coverage of one setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coverage {
    /// What was drawn.
    pub setting: Setting,
    /// The line through all levels.
    pub all_levels: Share,
    /// The line over the chosen window, in every draw.
    pub window: Share,
    /// The same in the draws whose pairwise rates count as settled.
    pub settled: Share,
}

/// Measures the coverage in `draws` draws.
pub fn measure(setting: Setting, draws: usize, seed: u64) -> Coverage {
    let drawn: Vec<Drawn> =
        (0..draws).into_par_iter().with_min_len(256).map(|k| draw(setting, seed, k as u64)).collect();
    Coverage {
        setting,
        all_levels: Share::of(drawn.iter().map(|d| d.all_levels)),
        window: Share::of(drawn.iter().filter_map(|d| d.window)),
        settled: Share::of(drawn.iter().filter(|d| d.settled).filter_map(|d| d.window)),
    }
}

#[derive(Clone, Copy)]
struct Interval {
    slope: f64,
    low: f64,
    high: f64,
}

struct Drawn {
    all_levels: Interval,
    window: Option<Interval>,
    settled: bool,
}

fn draw(setting: Setting, seed: u64, number: u64) -> Drawn {
    let mut random = Random::new(seed, number);
    let points: Vec<Point> = (0..setting.levels)
        .map(|k| {
            let h = 0.125 * 0.5_f64.powi(k as i32);
            let error = setting.truth.error(h) * (setting.noise * normal(&mut random)).exp();
            Point { level: k, h, dofs: 256 << (2 * k), error }
        })
        .collect();
    let rate = fit(&points).ok();
    Drawn {
        all_levels: through_all(&points),
        settled: rate.as_ref().is_some_and(|r| r.asymptotic),
        window: rate.map(|r| Interval { slope: r.slope, low: r.low, high: r.high }),
    }
}

fn through_all(points: &[Point]) -> Interval {
    let line = Line::through(&logs(points, |p| p.h));
    let reach = student::quantile(0.5 + 0.5 * CONFIDENCE, points.len() - 2) * line.stderr;
    Interval { slope: line.slope, low: line.slope - reach, high: line.slope + reach }
}

/// Standard normal (Box and Muller).
fn normal(random: &mut Random) -> f64 {
    let (u, v) = (random.uniform(), random.uniform());
    (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(truth: Truth, levels: usize, noise: f64) -> Coverage {
        measure(Setting { truth, levels, noise }, 4000, 1)
    }

    /// Student's interval is exact: whatever the number of levels and the size of the noise, 95 of 100, within four standard
    /// errors `√(0.95 · 0.05/4000) = 0.0034`.
    #[test]
    fn the_line_through_all_levels_covers_as_promised() {
        for levels in [4, 5, 8] {
            for noise in [0.001, 0.05] {
                let share = at(Truth::Power, levels, noise).all_levels;
                assert!((share.value().unwrap() - 0.95).abs() < 4.0 * 0.0034, "{levels} levels, {noise}: {share:?}");
                assert!(share.bias.abs() < 0.2 * noise, "{share:?}");
            }
        }
    }

    /// Four levels leave nothing to choose.
    #[test]
    fn with_four_levels_the_window_is_all_of_them() {
        let found = at(Truth::Power, 4, 0.03);
        assert_eq!(found.window, found.all_levels);
        assert!(found.settled.drawn < found.window.drawn && found.settled.drawn > 0);
    }

    /// Series that happen to look settled have too small residuals: their intervals cover less, the more so the larger the noise.
    #[test]
    fn choosing_the_window_costs_coverage() {
        let settled = |noise| at(Truth::Power, 8, noise).settled.value().unwrap();
        assert!((settled(0.001) - 0.95).abs() < 0.014);
        assert!(settled(0.01) < 0.93 && settled(0.05) < 0.75);
    }

    /// The figure that the pages state, within four of its standard errors.
    #[test]
    fn the_stated_figure_is_the_measured_one() {
        let setting = Setting { truth: Truth::Power, levels: STATED_LEVELS, noise: STATED_NOISE };
        let settled = measure(setting, 20_000, 3).settled;
        let allowed = 4.0 * settled.stderr().unwrap() + 0.005;
        assert!((settled.value().unwrap() - STATED_COVERAGE).abs() < allowed, "{settled:?}");
    }

    /// What no interval from residuals can see: a term that has not died out yet biases every level the same way.
    #[test]
    fn a_term_that_has_not_died_out_is_not_covered() {
        for truth in [Truth::Rising, Truth::Falling] {
            let found = at(truth, 4, 0.001);
            assert!(found.window.value().unwrap() < 0.05, "{found:?}");
            // the twin: the same noise without the term
            assert!(at(Truth::Power, 4, 0.001).window.value().unwrap() > 0.93);
        }
        assert!(at(Truth::Rising, 4, 0.001).window.bias < 0.0 && at(Truth::Falling, 4, 0.001).window.bias > 0.0);
    }

    #[test]
    fn a_seed_gives_the_same_table_for_any_number_of_threads() {
        let setting = Setting { truth: Truth::Power, levels: 5, noise: 0.01 };
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| measure(setting, 1000, 7))
        };
        assert_eq!(with(1), with(3));
        assert_ne!(with(1), measure(setting, 1000, 8));
    }
}
