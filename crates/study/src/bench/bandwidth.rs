//! The bandwidth of the memory: the floor below everything that reads a matrix once.
//!
//! ```text
//! a_i = b_i + s c_i        24 bytes for each i (two numbers read, one written)
//! ```

use rayon::prelude::*;
use std::hint::black_box;
use std::time::Instant;

/// Numbers in each of the three arrays: 64 MiB, beyond any cache.
const LENGTH: usize = 8 << 20;
/// Passes, of which the fastest counts: others only show what disturbed them.
const PASSES: usize = 8;
/// Numbers that a thread takes at once.
const CHUNK: usize = 1 << 14;
/// Bytes moved for each number.
const BYTES: f64 = 24.0;

/// Bytes per second of the triad on one thread, and on all threads of the pool.
pub fn bandwidth() -> [f64; 2] {
    let (b, c) = (vec![1.0; LENGTH], vec![2.0; LENGTH]);
    let mut a = vec![0.0; LENGTH];
    let one = fastest(|| triad(&mut a, &b, &c));
    let all = fastest(|| {
        let sources = b.par_chunks(CHUNK).zip(c.par_chunks(CHUNK));
        a.par_chunks_mut(CHUNK).zip(sources).for_each(|(a, (b, c))| triad(a, b, c));
    });
    [one, all].map(|seconds| BYTES * LENGTH as f64 / seconds)
}

fn triad(a: &mut [f64], b: &[f64], c: &[f64]) {
    let s = black_box(3.0);
    a.iter_mut().zip(b).zip(c).for_each(|((a, b), c)| *a = b + s * c);
    black_box(a);
}

fn fastest(mut pass: impl FnMut()) -> f64 {
    let mut time = || {
        let start = Instant::now();
        pass();
        start.elapsed().as_secs_f64()
    };
    (0..PASSES).map(|_| time()).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_triad_adds_and_multiplies() {
        let mut a = [0.0; 3];
        triad(&mut a, &[1.0, 2.0, 3.0], &[1.0, 0.0, -1.0]);
        assert_eq!(a, [4.0, 2.0, 0.0]);
    }
}
