//! Numbers that depend on the seed and the number of the case alone.

use std::env;
use std::ops::Range;

/// SplitMix64.
pub struct Random(u64);

impl Random {
    /// The sequence of one case.
    pub fn new(case: u64) -> Self {
        let mut of_seed = Self(setting("SIGNORINI_FUZZ_SEED").unwrap_or(1));
        Self(of_seed.next() ^ case.wrapping_mul(0xd134_2543_de82_ef95))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// From 0 to `n − 1`.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }

    /// One of several.
    pub fn pick<'a, T>(&mut self, of: &'a [T]) -> &'a T {
        &of[self.below(of.len())]
    }

    /// True once in `n` times.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// Uniform between two numbers, to three decimals of their distance.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.below(1001) as f64 / 1000.0
    }
}

/// The numbers of the cases to try.
pub fn cases(default: u64) -> Range<u64> {
    let first = setting("SIGNORINI_FUZZ_FIRST").unwrap_or(0);
    first..first + setting("SIGNORINI_FUZZ_CASES").unwrap_or(default)
}

fn setting(name: &str) -> Option<u64> {
    let text = env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name} = {text} is no number")))
}
