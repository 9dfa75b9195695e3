//! Smooth curves with exact points, derivatives and foot points.

use super::{Point, Vec2, cross};
use std::fmt;
use std::sync::Arc;

/// A smooth curve `γ(s)`, `0 ≤ s ≤ 1`, whose derivative vanishes nowhere. A body on its left has the outward normal
/// [`Curve::normal`].
pub trait Curve: fmt::Debug + Send + Sync {
    /// `γ(s)`.
    fn point(&self, s: f64) -> Point;

    /// `γ'(s)` and `γ''(s)`.
    fn derivatives(&self, s: f64) -> [Vec2; 2];

    /// `γ(s)` and `γ'(s)`, where one evaluation serves both.
    fn point_and_velocity(&self, s: f64) -> (Point, Vec2) {
        (self.point(s), self.derivatives(s)[0])
    }

    /// Kind and numbers in words, the same for equal curves: what hashes and messages show.
    fn describe(&self) -> String;

    /// `γ'(s)/|γ'(s)|`.
    fn tangent(&self, s: f64) -> Vec2 {
        self.derivatives(s)[0].normalize()
    }

    /// The unit normal to the right of the direction of growing `s`.
    fn normal(&self, s: f64) -> Vec2 {
        let t = self.tangent(s);
        Vec2::new(t.y, -t.x)
    }

    /// The curvature, positive where the curve turns left.
    fn curvature(&self, s: f64) -> f64 {
        let [d1, d2] = self.derivatives(s);
        // κ = γ' × γ'' / |γ'|³
        cross(d1, d2) / d1.norm().powi(3)
    }

    /// The parameter of the point of the curve that is nearest to `x`: the best of 129 samples, then Newton's method for
    /// `(γ − x)·γ' = 0`. Between 0 and 1.
    fn foot(&self, x: Point) -> f64 {
        let far = |s: f64| (self.point(s) - x).norm_squared();
        let samples = (0..=SAMPLES).map(|k| f64::from(k) / f64::from(SAMPLES));
        let nearer = |(best, least): (f64, f64), s: f64| {
            let distance = far(s);
            if distance < least { (s, distance) } else { (best, least) }
        };
        let (start, _) = samples.fold((0.0, f64::INFINITY), nearer);
        newton(self, x, start)
    }
}

/// A curve that several owners share.
pub type SharedCurve = Arc<dyn Curve>;

/// Intervals of the first search of [`Curve::foot`].
const SAMPLES: u32 = 128;

/// Newton's method within one sample of `start`; steps that leave it are cut back to its ends.
fn newton(curve: &(impl Curve + ?Sized), x: Point, start: f64) -> f64 {
    let reach = 1.0 / f64::from(SAMPLES);
    let (low, high) = ((start - reach).max(0.0), (start + reach).min(1.0));
    let mut s = start;
    for _ in 0..30 {
        let ([d1, d2], to) = (curve.derivatives(s), curve.point(s) - x);
        let (slope, bend) = (to.dot(&d1), d1.norm_squared() + to.dot(&d2));
        // A bend that is not positive is no minimum: fall back on Gauss–Newton, which descends.
        let next = (s - slope / if bend > 0.0 { bend } else { d1.norm_squared() }).clamp(low, high);
        let step = (next - s).abs();
        s = next;
        if step < 1e-16 {
            break;
        }
    }
    s
}

impl PartialEq for dyn Curve {
    fn eq(&self, other: &Self) -> bool {
        self.describe() == other.describe()
    }
}

/// The length of the part `from ≤ s ≤ to` of a curve, by composite Gauss quadrature; negative if `to < from`.
pub fn arc_length(curve: &dyn Curve, [from, to]: [f64; 2]) -> f64 {
    const PARTS: u32 = 16;
    let speed = |s: f64| curve.derivatives(s)[0].norm();
    let width = (to - from) / f64::from(PARTS);
    let part = |k: u32| {
        let left = from + f64::from(k) * width;
        crate::quadrature::GAUSS_8.iter().map(|&(x, w)| w * width * speed(left + x * width)).sum::<f64>()
    };
    (0..PARTS).map(part).sum()
}
