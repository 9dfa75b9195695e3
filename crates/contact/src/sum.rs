//! Sums over elements, in parallel and yet the same to the last bit for any number of threads.

use rayon::prelude::*;
use std::ops::AddAssign;

/// Elements summed by one task; the order of summation depends on this number and on nothing else.
const CHUNK: usize = 512;

/// `Σ_i f(i)` for `i < count`: chunks in parallel, then the chunks' sums in order.
pub fn ordered_sum<T: Default + AddAssign + Send>(count: usize, f: impl Fn(usize) -> T + Sync) -> T {
    let chunk_sum = |chunk: usize| {
        let mut sum = T::default();
        (chunk * CHUNK..((chunk + 1) * CHUNK).min(count)).for_each(|i| sum += f(i));
        sum
    };
    let parts: Vec<T> = (0..count.div_ceil(CHUNK)).into_par_iter().map(chunk_sum).collect();
    let mut total = T::default();
    parts.into_iter().for_each(|p| total += p);
    total
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_does_not_depend_on_the_number_of_threads() {
        let f = |i: usize| 1.0 / (i as f64 + 0.1);
        let with = |threads| {
            rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| ordered_sum(100_003, f))
        };
        let sum: f64 = with(1);
        assert_eq!(sum.to_bits(), with(2).to_bits());
        assert_eq!(sum.to_bits(), with(3).to_bits());
        assert!((sum - (0..100_003).map(f).sum::<f64>()).abs() < 1e-9);
        assert_eq!(ordered_sum(0, f), 0.0);
    }
}
