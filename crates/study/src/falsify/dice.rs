//! Random choices that make short numbers.

use crate::family::random::Random;
use signorini_contact::mesh::fnv1a;

/// The choices of one draw.
pub(super) struct Dice(Random);

impl Dice {
    /// The sequence of one draw: a function of its target's name, the seed and its number alone.
    pub fn new(target: &str, seed: u64, index: usize) -> Self {
        Self(Random::new(seed ^ fnv1a(target.as_bytes()), index as u64))
    }

    /// Uniform between two bounds, to three digits.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        rounded(low + (high - low) * self.0.uniform(), 3)
    }

    /// `10^x` with `x` uniform between two bounds, to three digits.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        rounded(10.0_f64.powf(low + (high - low) * self.0.uniform()), 3)
    }

    /// One of `0 … n − 1`.
    pub fn below(&mut self, n: usize) -> usize {
        ((self.0.uniform() * n as f64) as usize).min(n - 1)
    }

    /// One of the values.
    pub fn pick<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len())]
    }

    /// True or false.
    pub fn coin(&mut self) -> bool {
        self.0.coin()
    }

    /// A seed for meshes.
    pub fn seed(&mut self) -> u64 {
        1 + self.below(9999) as u64
    }
}

/// `x` to so many significant digits, as the nearest decimal number.
pub(super) fn rounded(x: f64, digits: usize) -> f64 {
    // printing and reading rounds to the nearest decimal and then to the nearest double: no power of ten is divided by
    format!("{:.*e}", digits - 1, x).parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_in_their_range() {
        assert_eq!([rounded(0.123456, 3), rounded(-98765.0, 2), rounded(0.0, 3)], [0.123, -99000.0, 0.0]);
        let mut dice = Dice::new("x", 1, 0);
        for _ in 0..500 {
            let (x, y, n) = (dice.between(-0.5, 2.0), dice.decades(-3.0, 2.0), dice.below(3));
            assert!((-0.5..=2.0).contains(&x) && (1e-3..=100.0).contains(&y) && n < 3);
            assert_eq!([rounded(x, 3), rounded(y, 3)], [x, y]);
        }
    }

    #[test]
    fn each_draw_has_its_own_sequence() {
        let first = |target: &str, seed, index| Dice::new(target, seed, index).between(0.0, 1e6);
        assert_eq!(first("a", 1, 2), first("a", 1, 2));
        assert!(first("a", 1, 2) != first("a", 1, 3) && first("a", 1, 2) != first("b", 1, 2));
    }
}
