//! Lemma 3.3: the inverse inequality `|p|_1 ≤ c (b−a)^{−1/2} ‖p‖_{1/2}` for linear `p` on `[a, b]`.
//!
//! `|p|²_{1/2} = ∫∫ (p(x)−p(y))²/(x−y)² dx dy` (Slobodeckij) and `‖p‖²_{1/2} = ‖p‖²_0 + |p|²_{1/2}`. For linear `p` the quotient
//! is constant, so that `|p|_1 = (b−a)^{−1/2} |p|_{1/2}`; the double integral is nevertheless computed by a quadrature that
//! takes any `p` and uses nothing but its values.

use super::gram::largest_ratio;
use crate::family::random::Random;
use nalgebra::Matrix2;
use signorini_contact::Point;
use signorini_contact::quadrature::{GAUSS_8, conical_points};

/// The norms on the two sides of the inequality.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Norms {
    /// `|p|_1` and `|p|_{1/2}`: then the constant is 1 for every `p`.
    Seminorms,
    /// `|p|_1` and `‖p‖_{1/2}`: the worst `p`.
    FullRight,
    /// `‖p‖_1` and `‖p‖_{1/2}`: the worst `p`.
    Full,
}

/// A family of intervals: one, divided into irregular pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intervals {
    /// The interval that is divided.
    pub whole: [f64; 2],
    /// The norms.
    pub norms: Norms,
    /// Of the division, and of the random `p`.
    pub seed: u64,
}

/// Random `p` on each interval.
const SAMPLES: usize = 4;

/// Largest move of a point of division, as a share of the mean length.
const MOVE: f64 = 0.25;

impl Intervals {
    /// The points of the division into `n` pieces.
    pub fn points(&self, n: usize) -> Vec<f64> {
        let [a, b] = self.whole;
        let mut random = Random::new(self.seed, n as u64);
        let mut at = |i: usize| {
            let moved = if i == 0 || i == n { 0.0 } else { MOVE * random.signed() };
            a + (b - a) * (i as f64 + moved) / n as f64
        };
        (0..=n).map(&mut at).collect()
    }

    /// The constant on the intervals of a division: of seminorms the value farthest from 1, else the largest.
    pub fn constant(&self, points: &[f64]) -> f64 {
        let mut random = Random::new(self.seed, !(points.len() as u64));
        let mut worst: f64 = if self.norms == Norms::Seminorms { 1.0 } else { 0.0 };
        for w in points.windows(2) {
            let interval = [w[0], w[1]];
            match self.norms {
                Norms::Seminorms => {
                    for _ in 0..SAMPLES {
                        let c = equality(interval, [random.signed(), random.signed()]);
                        worst = if (c - 1.0).abs() > (worst - 1.0).abs() { c } else { worst };
                    }
                }
                norms => worst = worst.max(full(interval, norms)),
            }
        }
        worst
    }
}

/// `(b−a)^{1/2} |p|_1 / |p|_{1/2}` for the linear `p` with the given values at the ends.
fn equality(interval: [f64; 2], ends: [f64; 2]) -> f64 {
    let length = interval[1] - interval[0];
    let slope = (ends[1] - ends[0]) / length;
    // |p|²_1 = (b−a) p'²
    let first = length * slope * slope;
    (length * first / slobodeckij(interval, |x| linear(interval, ends, x))).sqrt()
}

/// The largest `(b−a)^{1/2} |p|_1 / ‖p‖_{1/2}`, or with `‖p‖_1`, over linear `p`: the 2×2 eigenvalue problem in the values at
/// the ends.
fn full(interval: [f64; 2], norms: Norms) -> f64 {
    let length = interval[1] - interval[0];
    let mass = gram(|ends| square(interval, |x| linear(interval, ends, x)));
    let half = mass + gram(|ends| slobodeckij(interval, |x| linear(interval, ends, x)));
    let stiffness = Matrix2::new(1.0, -1.0, -1.0, 1.0) / length;
    let left = if norms == Norms::Full { stiffness + mass } else { stiffness };
    largest_ratio(&(length * left), &half).map_or(f64::NAN, f64::sqrt)
}

/// The matrix of a quadratic form in the values at the two ends: `4 B(p, q) = B(p+q, p+q) − B(p−q, p−q)`.
fn gram(square: impl Fn([f64; 2]) -> f64) -> Matrix2<f64> {
    let unit = |k: usize| [[1.0, 0.0], [0.0, 1.0]][k];
    Matrix2::from_fn(|i, j| {
        let (p, q) = (unit(i), unit(j));
        0.25 * (square([p[0] + q[0], p[1] + q[1]]) - square([p[0] - q[0], p[1] - q[1]]))
    })
}

/// The linear function on an interval with the given values at its ends.
fn linear([a, b]: [f64; 2], [pa, pb]: [f64; 2], x: f64) -> f64 {
    (pa * (b - x) + pb * (x - a)) / (b - a)
}

/// `‖p‖²_0` on an interval.
fn square([a, b]: [f64; 2], p: impl Fn(f64) -> f64) -> f64 {
    GAUSS_8.iter().map(|&(x, w)| w * (b - a) * p(a + x * (b - a)).powi(2)).sum()
}

/// `|p|²_{1/2}` on an interval: twice the integral over the triangle `y < x`, by a rule whose points avoid the diagonal.
pub(super) fn slobodeckij([a, b]: [f64; 2], p: impl Fn(f64) -> f64) -> f64 {
    let triangle = [Point::new(a, a), Point::new(b, a), Point::new(b, b)];
    let mut sum = 0.0;
    conical_points(triangle, &mut |at, weight| {
        let quotient = (p(at.x) - p(at.y)) / (at.x - at.y);
        sum += weight * quotient * quotient;
    });
    2.0 * sum
}
