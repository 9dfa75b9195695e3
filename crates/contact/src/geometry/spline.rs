//! A curve through given points: the natural cubic spline over the chord lengths.

use super::{Curve, Point, Vec2};
use crate::Error;

/// The natural cubic spline through points, twice continuously differentiable; its knots are the sums of the chord
/// lengths, scaled to `[0, 1]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    points: Vec<Point>,
    knots: Vec<f64>,
    /// `γ''` at the knots.
    bends: Vec<Vec2>,
}

impl Spline {
    /// The spline through `points`, of which there must be at least two, no two in a row the same.
    ///
    /// # Errors
    /// [`Error::Mesh`] with the first point that is not finite or repeats the one before.
    pub fn through(points: Vec<Point>) -> Result<Self, Error> {
        if points.len() < 2 {
            return Err(Error::Mesh(format!("a spline through {} points; give at least two", points.len())));
        }
        let mut knots = vec![0.0];
        for (i, w) in points.windows(2).enumerate() {
            let length = (w[1] - w[0]).norm();
            if !(length > 0.0 && length.is_finite()) {
                return Err(Error::Mesh(format!(
                    "points {i} and {} of a spline are {length} apart; they must differ and be finite",
                    i + 1
                )));
            }
            knots.push(knots[i] + length);
        }
        let total = knots[knots.len() - 1];
        knots.iter_mut().for_each(|k| *k /= total);
        let bends = natural_bends(&points, &knots);
        Ok(Self { points, knots, bends })
    }

    /// The interval of `s`, its width and the place of `s` in it, from 0 to 1.
    fn locate(&self, s: f64) -> (usize, f64, f64) {
        let i = self.knots.partition_point(|k| *k <= s).clamp(1, self.knots.len() - 1) - 1;
        let width = self.knots[i + 1] - self.knots[i];
        (i, width, (s - self.knots[i]) / width)
    }
}

/// `γ''` at the knots: `h_{i−1} m_{i−1} + 2(h_{i−1} + h_i) m_i + h_i m_{i+1} = 6 (d_i − d_{i−1})`, zero at both ends, by
/// elimination.
fn natural_bends(points: &[Point], knots: &[f64]) -> Vec<Vec2> {
    let n = points.len();
    let width = |i: usize| knots[i + 1] - knots[i];
    let slope = |i: usize| (points[i + 1] - points[i]) / width(i);
    let mut bends = vec![Vec2::zeros(); n];
    let mut upper = vec![0.0; n];
    for i in 1..n - 1 {
        let pivot = 2.0 * (width(i - 1) + width(i)) - width(i - 1) * upper[i - 1];
        upper[i] = width(i) / pivot;
        bends[i] = (6.0 * (slope(i) - slope(i - 1)) - width(i - 1) * bends[i - 1]) / pivot;
    }
    for i in (1..n - 1).rev() {
        bends[i] = bends[i] - upper[i] * bends[i + 1];
    }
    bends
}

impl Curve for Spline {
    fn point(&self, s: f64) -> Point {
        let (i, h, t) = self.locate(s);
        let cubic = |t: f64| h * h / 6.0 * (t * t * t - t);
        (1.0 - t) * self.points[i]
            + t * self.points[i + 1]
            + cubic(1.0 - t) * self.bends[i]
            + cubic(t) * self.bends[i + 1]
    }

    fn derivatives(&self, s: f64) -> [Vec2; 2] {
        let (i, h, t) = self.locate(s);
        let slope = |t: f64| h / 6.0 * (3.0 * t * t - 1.0);
        let first =
            (self.points[i + 1] - self.points[i]) / h - slope(1.0 - t) * self.bends[i] + slope(t) * self.bends[i + 1];
        [first, (1.0 - t) * self.bends[i] + t * self.bends[i + 1]]
    }

    fn describe(&self) -> String {
        let points: String = self.points.iter().map(|p| format!(" ({:?}, {:?})", p.x, p.y)).collect();
        format!("spline through{points}")
    }
}
