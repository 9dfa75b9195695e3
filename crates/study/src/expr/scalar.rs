//! Numbers that carry derivatives, and the functions whose derivatives need care at the edge of their domain.

use super::Expression;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// A number with no, first, or first and second derivatives in the plane.
pub trait Real:
    Copy
    + Send
    + Sync
    + From<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// The value.
    fn re(&self) -> f64;

    /// `f(self)`, given `f`, `f'` and `f''` at the value of `self`. A derivative that is infinite there stays out of
    /// the directions in which `self` does not move: `0 · ∞` counts as 0.
    #[must_use]
    fn chain(self, f0: f64, f1: f64, f2: f64) -> Self;

    /// `f(x, y)`, given `f`, its derivatives `f_x, f_y` and `f_xx, f_xy, f_yy` at the values of `x` and `y`, all finite.
    #[must_use]
    fn chain_plane(x: Self, y: Self, f0: f64, f1: [f64; 2], f2: [f64; 3]) -> Self;

    /// `f(self)` for an expression in one variable.
    #[must_use]
    fn through(self, f: &Expression) -> Self;

    /// `1/self`.
    #[inline]
    #[must_use]
    fn recip(self) -> Self {
        let f = 1.0 / self.re();
        self.chain(f, -f * f, 2.0 * f * f * f)
    }

    /// Sine and cosine.
    #[inline]
    #[must_use]
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.re().sin_cos();
        (self.chain(s, c, -s), self.chain(c, -s, -c))
    }

    /// `e^self`.
    #[inline]
    #[must_use]
    fn exp(self) -> Self {
        let f = self.re().exp();
        self.chain(f, f, f)
    }

    /// The natural logarithm.
    #[inline]
    #[must_use]
    fn ln(self) -> Self {
        let (t, inverse) = (self.re(), 1.0 / self.re());
        self.chain(t.ln(), inverse, -inverse * inverse)
    }

    /// The arc tangent.
    #[inline]
    #[must_use]
    fn atan(self) -> Self {
        let t = self.re();
        // f' = 1/(1 + t²), f'' = −2t f'²
        let slope = 1.0 / (1.0 + t * t);
        self.chain(t.atan(), slope, -2.0 * t * slope * slope)
    }
}

impl Real for f64 {
    #[inline]
    fn re(&self) -> f64 {
        *self
    }

    #[inline]
    fn chain(self, f0: f64, _: f64, _: f64) -> Self {
        f0
    }

    #[inline]
    fn chain_plane(_: Self, _: Self, f0: f64, _: [f64; 2], _: [f64; 3]) -> Self {
        f0
    }

    #[inline]
    fn through(self, f: &Expression) -> Self {
        f.eval(&[self])
    }
}

/// `√x`; at 0 the derivatives are infinite.
#[inline]
pub fn sqrt<D: Real>(x: D) -> D {
    let root = x.re().sqrt();
    let slope = 0.5 / root;
    let bend = if x.re() == 0.0 { f64::NEG_INFINITY } else { -0.5 * slope / x.re() };
    x.chain(root, slope, bend)
}

/// `x^n` for a constant `n`, with its true value and derivatives at `x = 0`, infinite where they are. A negative base
/// needs a whole `n`, else the result is NaN.
#[inline]
pub fn power<D: Real>(x: D, n: f64) -> D {
    let t = x.re();
    if n == 2.0 {
        x.chain(t * t, 2.0 * t, 2.0)
    } else if n == 3.0 {
        x.chain(t * t * t, 3.0 * (t * t), 6.0 * t)
    } else if n.fract() == 0.0 && n.abs() <= 1024.0 {
        let n = n as i32;
        let (c1, c2) = (f64::from(n), f64::from(n) * f64::from(n - 1));
        x.chain(t.powi(n), coefficient(c1, || t.powi(n - 1)), coefficient(c2, || t.powi(n - 2)))
    } else if t > 0.0 {
        // f' = n f/x, f'' = (n−1) f'/x: one call of the library's power in place of three.
        let f0 = t.powf(n);
        let f1 = n * f0 / t;
        x.chain(f0, f1, (n - 1.0) * f1 / t)
    } else {
        let (c1, c2) = (n, n * (n - 1.0));
        x.chain(t.powf(n), coefficient(c1, || t.powf(n - 1.0)), coefficient(c2, || t.powf(n - 2.0)))
    }
}

/// `c f`, but 0 for `c = 0` whatever `f` would be.
#[inline]
fn coefficient(c: f64, f: impl Fn() -> f64) -> f64 {
    if c == 0.0 { 0.0 } else { c * f() }
}

/// `(x)_+^n`; zero with all its derivatives for `x ≤ 0`.
#[inline]
pub fn positive_power<D: Real>(x: D, n: f64) -> D {
    if x.re() > 0.0 { power(x, n) } else { D::from(0.0) }
}

/// The angle of `(x, y)` in `[−π, π]`. The sign of a zero `y` does not count: on the negative axis the angle is `π`.
#[inline]
pub fn atan2<D: Real>(y: D, x: D) -> D {
    let (b, a) = (y.re() + 0.0, x.re());
    let angle = b.atan2(a);
    if a == 0.0 && b == 0.0 {
        return (y + x).chain(angle, f64::NAN, f64::NAN);
    }
    // Divide by the larger of the two and shift the value to the right branch.
    let turned = if a.abs() >= b.abs() { (y / x).atan() } else { -(x / y).atan() };
    turned + (angle - turned.re())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Dual, Dual2};

    fn variable(x: f64) -> Dual2 {
        Dual2::variable(x, 0)
    }

    fn parts(d: Dual2) -> (f64, f64, f64) {
        assert_eq!((d.gradient[1], d.hessian[1], d.hessian[2]), (0.0, 0.0, 0.0));
        (d.re, d.gradient[0], d.hessian[0])
    }

    #[test]
    fn powers_at_zero_have_their_limits() {
        let inf = f64::INFINITY;
        for (n, expected) in [
            (0.0, (1.0, 0.0, 0.0)),
            (1.0, (0.0, 1.0, 0.0)),
            (2.0, (0.0, 0.0, 2.0)),
            (3.0, (0.0, 0.0, 0.0)),
            (0.5, (0.0, inf, -inf)),
            (1.5, (0.0, 0.0, inf)),
            (2.5, (0.0, 0.0, 0.0)),
            (-1.0, (inf, -inf, inf)),
        ] {
            assert_eq!(parts(power(variable(0.0), n)), expected, "x^{n}");
        }
        assert_eq!(parts(sqrt(variable(0.0))), (0.0, inf, -inf));
    }

    #[test]
    fn powers_agree_with_the_known_derivatives() {
        for n in [-2.0, -0.5, 0.3, 1.0, 1.5, 2.0, 3.0, 7.25] {
            let (f0, f1, f2) = parts(power(variable(1.7), n));
            let t = 1.7f64;
            assert!((f0 - t.powf(n)).abs() < 1e-14 * f0.abs());
            assert!((f1 - n * t.powf(n - 1.0)).abs() <= 1e-14 * f1.abs());
            assert!((f2 - n * (n - 1.0) * t.powf(n - 2.0)).abs() <= 1e-13 * f2.abs());
        }
        assert_eq!(parts(power(variable(-2.0), 3.0)), (-8.0, 12.0, -12.0), "whole exponents take a negative base");
        assert!(power(-2.0, 0.5).is_nan());
    }

    /// Against products of the number type itself, for curved `x`, `y`.
    #[test]
    fn a_function_of_two_numbers_has_the_chain_rule() {
        let (s, t) = (Dual2::variable(0.7, 0), Dual2::variable(-1.3, 1));
        let (x, y) = (s * t, t * t + s);
        let (a, b) = (x.re, y.re);
        let expected = x * x * y;
        let got = Dual2::chain_plane(x, y, a * a * b, [2.0 * a * b, a * a], [2.0 * b, 2.0 * a, 0.0]);
        assert!((got.re - expected.re).abs() < 1e-15);
        assert!((0..2).all(|i| (got.gradient[i] - expected.gradient[i]).abs() < 1e-14));
        assert!((0..3).all(|i| (got.hessian[i] - expected.hessian[i]).abs() < 1e-13));
    }

    #[test]
    fn the_angle_keeps_to_one_branch_and_has_its_derivatives_on_the_axes() {
        assert_eq!(atan2(-0.0, -1.0), std::f64::consts::PI);
        for (a, b) in [(1.0, 0.0), (0.0, 2.0), (-3.0, 0.0), (0.0, -0.5), (0.3, 0.4)] {
            let d = atan2(Dual::variable(b, 1), Dual::variable(a, 0)).gradient;
            let r2 = a * a + b * b;
            assert!((d[0] + b / r2).abs() < 1e-15 && (d[1] - a / r2).abs() < 1e-15);
        }
    }
}
