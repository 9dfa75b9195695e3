//! Random numbers that are the same on every machine.

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood: *Fast Splittable Pseudorandom Number Generators*, 2014): integer
/// operations alone, and conversions to `f64` that are exact.
#[derive(Clone, Debug)]
pub(crate) struct Random(u64);

impl Random {
    /// An independent sequence for each pair of a seed and a stream.
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut of_seed = Self(seed);
        let mut of_pair = Self(of_seed.next() ^ stream);
        Self(of_pair.next())
    }

    /// The next 64 bits.
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in `[−1, 1)`, a multiple of `2^{-52}`.
    pub fn signed(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Uniform in `(0, 1)`.
    pub fn uniform(&mut self) -> f64 {
        (self.next() >> 11) as f64 * 2.0_f64.powi(-53) + 2.0_f64.powi(-54)
    }

    /// Uniform in the unit disc, by rejection: no trigonometry, which differs between machines.
    pub fn in_disc(&mut self) -> [f64; 2] {
        loop {
            let [x, y] = [self.signed(), self.signed()];
            if x * x + y * y <= 1.0 {
                return [x, y];
            }
        }
    }

    /// True or false with equal chances.
    pub fn coin(&mut self) -> bool {
        self.next() >> 63 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    /// First outputs of the published generator for the seed 1234567.
    #[test]
    fn splitmix_matches_its_published_values() {
        let mut random = Random(1_234_567);
        let known = [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        assert_eq!([(); 3].map(|()| random.next()), known);
    }

    #[test]
    fn numbers_fill_their_range_evenly() {
        let mut random = Random::new(7, 16);
        let n = 20_000;
        let (mut sum, mut squares, mut inner, mut heads) = (0.0, 0.0, 0, 0);
        for _ in 0..n {
            let x = random.signed();
            assert!((-1.0..1.0).contains(&x));
            (sum, squares) = (sum + x, squares + x * x);
            let [a, b] = random.in_disc();
            assert!(a * a + b * b <= 1.0);
            inner += usize::from(a * a + b * b < 0.5);
            heads += usize::from(random.coin());
        }
        // Mean 0, variance 1/3; half of the disc's area; half heads. Five standard deviations of room.
        assert!((sum / n as f64).abs() < 5.0 * (1.0 / 3.0 / n as f64).sqrt());
        assert!((squares / n as f64 - 1.0 / 3.0).abs() < 0.011);
        assert!((inner as f64 / n as f64 - 0.5).abs() < 0.018);
        assert!((heads as f64 / n as f64 - 0.5).abs() < 0.018);
    }

    #[test]
    fn streams_differ() {
        let first = |seed, stream| Random::new(seed, stream).next();
        assert_eq!(first(1, 8), first(1, 8));
        assert_ne!(first(1, 8), first(1, 16));
        assert_ne!(first(1, 8), first(2, 8));
        assert_ne!(first(8, 1), first(1, 8));
    }
}
