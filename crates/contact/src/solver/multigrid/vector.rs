//! Vector kernels: parallel, and the same to the last bit for any number of threads.

use rayon::prelude::*;

/// Entries handled by one task; sums are made of these pieces, in order.
const CHUNK: usize = 1 << 14;

/// `Σ a_i b_i`.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let piece = |(a, b): (&[f64], &[f64])| -> f64 { lanes(a, b) };
    if a.len() <= CHUNK {
        return piece((a, b));
    }
    let parts: Vec<f64> = a.par_chunks(CHUNK).zip(b.par_chunks(CHUNK)).map(piece).collect();
    parts.iter().sum()
}

/// Four running sums, so that additions need not wait for one another.
fn lanes(a: &[f64], b: &[f64]) -> f64 {
    let (a4, a_rest) = a.as_chunks::<4>();
    let (b4, b_rest) = b.as_chunks::<4>();
    let mut sum = [0.0; 4];
    for (a, b) in a4.iter().zip(b4) {
        (0..4).for_each(|k| sum[k] += a[k] * b[k]);
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    (sum[0] + sum[1]) + (sum[2] + sum[3]) + rest
}

/// `a = b − a`, entry by entry.
pub fn subtract_from(a: &mut [f64], b: &[f64]) {
    let piece = |(a, b): (&mut [f64], &[f64])| a.iter_mut().zip(b).for_each(|(a, b)| *a = b - *a);
    a.par_chunks_mut(CHUNK).zip(b.par_chunks(CHUNK)).for_each(piece);
}

/// `a += factor · b`.
pub fn add(a: &mut [f64], factor: f64, b: &[f64]) {
    let piece = |(a, b): (&mut [f64], &[f64])| a.iter_mut().zip(b).for_each(|(a, b)| *a += factor * b);
    a.par_chunks_mut(CHUNK).zip(b.par_chunks(CHUNK)).for_each(piece);
}

/// `p = α z + β p`, then `x += σ p`: a step and what it changes, in one pass.
pub fn step(p: &mut [f64], [alpha, beta]: [f64; 2], z: &[f64], x: &mut [f64], sign: f64) {
    let piece = |((p, z), x): ((&mut [f64], &[f64]), &mut [f64])| {
        for ((p, z), x) in p.iter_mut().zip(z).zip(x) {
            // β = 0 must forget the last step even where it is not finite
            *p = if beta == 0.0 { alpha * z } else { alpha * z + beta * *p };
            *x += sign * *p;
        }
    };
    p.par_chunks_mut(CHUNK).zip(z.par_chunks(CHUNK)).zip(x.par_chunks_mut(CHUNK)).for_each(piece);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_do_what_their_formulas_say() {
        let n = 3 * CHUNK + 5;
        let a: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let b: Vec<f64> = (0..n).map(|i| (i as f64).cos()).collect();
        let plain: f64 = a.iter().zip(&b).map(|(a, b)| a * b).sum();
        assert!((dot(&a, &b) - plain).abs() < 1e-10);
        let mut c = a.clone();
        subtract_from(&mut c, &b);
        add(&mut c, 2.0, &a);
        assert!(c.iter().zip(&a).zip(&b).all(|((c, a), b)| (c - (a + b)).abs() < 1e-15));
        let (mut p, mut x) = (b.clone(), a.clone());
        step(&mut p, [2.0, 3.0], &a, &mut x, -1.0);
        assert!((0..n).all(|i| p[i] == 2.0 * a[i] + 3.0 * b[i] && x[i] == a[i] - p[i]));
        step(&mut p, [1.0, 0.0], &b, &mut x, 0.0);
        assert_eq!(p, b);
    }

    #[test]
    fn a_dot_product_does_not_depend_on_the_number_of_threads() {
        let a: Vec<f64> = (0..5 * CHUNK + 3).map(|i| 1.0 / (i as f64 + 0.1)).collect();
        let with =
            |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap().install(|| dot(&a, &a).to_bits());
        assert_eq!(with(1), with(3));
    }
}
