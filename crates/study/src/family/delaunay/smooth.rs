//! Moves inner nodes so that sides get their wished length and triangles become equilateral.
//!
//! One node at a time descends the energy of the sides and triangles around it, with the connectivity held. A node never moves
//! so far that a triangle turns over.

use super::draft::Draft;
use super::wish::Wish;
use nalgebra::Matrix2;
use signorini_contact::geometry::twice_area;
use signorini_contact::{Point, Vec2};

/// Sweeps over all nodes before the connectivity is made anew.
const SWEEPS: usize = 3;

/// Weight of the triangles' shapes beside the sides' lengths.
const SHAPE: f64 = 0.3;

/// Share of the wished length below which a move is not worth its price.
const STILL: f64 = 1e-3;

/// [`SWEEPS`] sweeps with the exponent `k` of [`Ring::energy`].
pub(super) fn smooth(draft: &mut Draft, wish: &Wish, k: i32) {
    let sizes: Vec<f64> = draft.points.iter().map(|&p| wish.size(p)).collect();
    let around = Around::new(draft);
    let mut ring = Ring { exponent: k, others: Vec::new() };
    for _ in 0..SWEEPS {
        for i in draft.fixed..draft.points.len() {
            ring.fill(draft, &around, &sizes, i);
            let x = draft.points[i];
            draft.points[i] = ring.descend(x, sizes[i]);
        }
    }
}

/// The next corners, counterclockwise, in the triangles of each inner node.
struct Around {
    start: Vec<usize>,
    next: Vec<[u32; 2]>,
}

impl Around {
    fn new(draft: &Draft) -> Self {
        let mut start = vec![0; draft.points.len() + 1];
        for &i in draft.triangles.iter().flatten() {
            start[i as usize + 1] += 1;
        }
        for i in 1..start.len() {
            start[i] += start[i - 1];
        }
        let mut place = start.clone();
        let mut next = vec![[0; 2]; 3 * draft.triangles.len()];
        for &[a, b, c] in &draft.triangles {
            for [i, j, k] in [[a, b, c], [b, c, a], [c, a, b]] {
                next[place[i as usize]] = [j, k];
                place[i as usize] += 1;
            }
        }
        Self { start, next }
    }
}

/// A triangle `x, a, b` around a node `x`, and `s²` of the side from `x` to `a`.
#[derive(Clone, Copy)]
struct Corner {
    a: Point,
    b: Point,
    square: f64,
}

/// The triangles around one inner node.
struct Ring {
    exponent: i32,
    others: Vec<Corner>,
}

impl Ring {
    fn fill(&mut self, draft: &Draft, around: &Around, sizes: &[f64], i: usize) {
        self.others.clear();
        for &[j, k] in &around.next[around.start[i]..around.start[i + 1]] {
            let size = 0.5 * (sizes[i] + sizes[j as usize]);
            let [a, b] = [j, k].map(|n| draft.points[n as usize]);
            self.others.push(Corner { a, b, square: size * size });
        }
    }

    /// `E(x) = Σ (q^k + q^{−k} + w η^{2k})`, `q = |x − a|²/s²`, `η = (sum of squared sides)/(4√3 area) ≥ 1`; infinite where a
    /// triangle is turned over.
    fn energy(&self, x: Point) -> f64 {
        let mut sum = 0.0;
        for c in &self.others {
            let area = twice_area(x, c.a, c.b);
            if area.is_nan() || area <= 0.0 {
                return f64::INFINITY;
            }
            let q = ((x - c.a).norm_squared() / c.square).powi(self.exponent);
            sum += q + 1.0 / q + SHAPE * shape(x, c, area).powi(2 * self.exponent);
        }
        sum
    }

    /// Gradient and a positive definite approximation of the Hessian.
    fn slope(&self, x: Point) -> (Vec2, Matrix2<f64>) {
        let (mut gradient, mut hessian) = (Vec2::zeros(), Matrix2::zeros());
        let (n, k) = (self.exponent, f64::from(self.exponent));
        for c in &self.others {
            let q = (x - c.a).norm_squared() / c.square;
            let dq = (x - c.a) * (2.0 / c.square);
            let (up, down) = (q.powi(n - 1), q.powi(-n - 1));
            // d/dq and d²/dq² of q^k + q^{−k}
            let (first, second) = (k * (up - down), k * ((k - 1.0) * up / q + (k + 1.0) * down / q));
            gradient += first * dq;
            hessian += second * dq * dq.transpose() + Matrix2::identity() * (first.max(0.0) * 2.0 / c.square);

            // ∇η = (∇N − η ∇D)/D with N the sum of squares and D = 4√3 area
            let area = twice_area(x, c.a, c.b);
            let (eta, d) = (shape(x, c, area), ROOT * area);
            let deta = (2.0 * (2.0 * x - c.a - c.b) - eta * ROOT * Vec2::new(c.a.y - c.b.y, c.b.x - c.a.x)) / d;
            let first = SHAPE * 2.0 * k * eta.powi(2 * n - 1);
            gradient += first * deta;
            hessian += first * ((2.0 * k - 1.0) / eta * deta * deta.transpose() + Matrix2::identity() * (4.0 / d));
        }
        (gradient, hessian)
    }

    /// A Newton step, halved until the energy falls.
    fn descend(&self, x: Point, size: f64) -> Point {
        let start = self.energy(x);
        if start.is_infinite() {
            return self.middle();
        }
        let (gradient, hessian) = self.slope(x);
        let Some(inverse) = hessian.try_inverse() else { return x };
        let mut step = -(inverse * gradient);
        step *= (0.4 * size / step.norm()).min(1.0);
        while step.norm() > STILL * size {
            if self.energy(x + step) < start {
                return x + step;
            }
            step *= 0.5;
        }
        x
    }

    /// The mean of the neighbours, where a node that touches a side it must not goes.
    fn middle(&self) -> Point {
        self.others.iter().map(|c| c.a).sum::<Point>() / self.others.len() as f64
    }
}

/// `2√3`, so that `η = (sum of squared sides)/(2√3 · twice the area)`.
const ROOT: f64 = 3.464_101_615_137_754_6;

fn shape(x: Point, c: &Corner, area: f64) -> f64 {
    ((x - c.a).norm_squared() + (x - c.b).norm_squared() + (c.a - c.b).norm_squared()) / (ROOT * area)
}
