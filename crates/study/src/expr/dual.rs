//! Numbers that carry their derivatives: first ones in the plane, first and second ones in the plane, or both along a line.
//!
//! A number is `a` with `∂_x a, ∂_y a` and, of [`Dual2`], `∂_xx a, ∂_xy a, ∂_yy a`; [`Along`] has `a', a''`. All arithmetic is the product and the chain
//! rule; the Hessian is stored once, so it is symmetric to the last bit.

use super::Expression;
use super::scalar::Real;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// A value with its gradient in the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    /// `a`.
    pub re: f64,
    /// `∂_x a, ∂_y a`.
    pub gradient: [f64; 2],
}

/// A value with its gradient and its Hessian in the plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual2 {
    /// `a`.
    pub re: f64,
    /// `∂_x a, ∂_y a`.
    pub gradient: [f64; 2],
    /// `∂_xx a, ∂_xy a, ∂_yy a`.
    pub hessian: [f64; 3],
}

/// A value with its first and second derivative by one variable.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Along {
    /// `a`.
    pub re: f64,
    /// `a', a''`.
    pub derivatives: [f64; 2],
}

impl Along {
    /// The variable itself where it is `re`.
    #[inline]
    pub fn variable(re: f64) -> Self {
        Self { re, derivatives: [1.0, 0.0] }
    }
}

impl Dual {
    /// The coordinate `axis` (0 or 1) where it is `re`.
    #[inline]
    pub fn variable(re: f64, axis: usize) -> Self {
        let mut gradient = [0.0; 2];
        gradient[axis] = 1.0;
        Self { re, gradient }
    }
}

impl Dual2 {
    /// The coordinate `axis` (0 or 1) where it is `re`.
    #[inline]
    pub fn variable(re: f64, axis: usize) -> Self {
        let Dual { re, gradient } = Dual::variable(re, axis);
        Self { re, gradient, hessian: [0.0; 3] }
    }
}

impl Real for Dual {
    #[inline]
    fn re(&self) -> f64 {
        self.re
    }

    #[inline]
    fn chain(self, f0: f64, f1: f64, _: f64) -> Self {
        // ∂_i f = f' ∂_i x
        Self { re: f0, gradient: self.gradient.map(|v| times(v, f1)) }
    }

    #[inline]
    fn chain_plane(x: Self, y: Self, f0: f64, f1: [f64; 2], _: [f64; 3]) -> Self {
        Self { re: f0, gradient: combine(f1[0], x.gradient, f1[1], y.gradient) }
    }

    #[inline]
    fn through(self, f: &Expression) -> Self {
        follow(self, f)
    }
}

impl Real for Dual2 {
    #[inline]
    fn re(&self) -> f64 {
        self.re
    }

    #[inline]
    fn chain(self, f0: f64, f1: f64, f2: f64) -> Self {
        // ∂_i ∂_j f = f'' ∂_i x ∂_j x + f' ∂_i ∂_j x
        let [v, w] = self.gradient;
        let (squares, h) = ([v * v, v * w, w * w], self.hessian);
        if f1.is_finite() && f2.is_finite() {
            return Self { re: f0, gradient: [f1 * v, f1 * w], hessian: combine(f2, squares, f1, h) };
        }
        let entry = |k: usize| times(squares[k], f2) + times(h[k], f1);
        Self { re: f0, gradient: [times(v, f1), times(w, f1)], hessian: [entry(0), entry(1), entry(2)] }
    }

    #[inline]
    fn chain_plane(x: Self, y: Self, f0: f64, f1: [f64; 2], f2: [f64; 3]) -> Self {
        let (a, b) = (x.gradient, y.gradient);
        // ∂_i ∂_j f = f_xx a_i a_j + f_xy (a_i b_j + b_i a_j) + f_yy b_i b_j + f_x ∂_i ∂_j x + f_y ∂_i ∂_j y
        let bend = |i: usize, j: usize| f2[0] * a[i] * a[j] + f2[1] * (a[i] * b[j] + b[i] * a[j]) + f2[2] * b[i] * b[j];
        let straight = combine(f1[0], x.hessian, f1[1], y.hessian);
        let bent = [bend(0, 0), bend(0, 1), bend(1, 1)];
        Self { re: f0, gradient: combine(f1[0], a, f1[1], b), hessian: combine(1.0, straight, 1.0, bent) }
    }

    #[inline]
    fn through(self, f: &Expression) -> Self {
        follow(self, f)
    }
}

impl Real for Along {
    #[inline]
    fn re(&self) -> f64 {
        self.re
    }

    #[inline]
    fn chain(self, f0: f64, f1: f64, f2: f64) -> Self {
        let [v, h] = self.derivatives;
        // (f(x))'' = f'' x'² + f' x''
        Self { re: f0, derivatives: [times(v, f1), times(v * v, f2) + times(h, f1)] }
    }

    #[inline]
    fn chain_plane(x: Self, y: Self, f0: f64, f1: [f64; 2], f2: [f64; 3]) -> Self {
        let ([a, h], [b, k]) = (x.derivatives, y.derivatives);
        let bend = f2[0] * a * a + 2.0 * f2[1] * a * b + f2[2] * b * b;
        Self { re: f0, derivatives: [f1[0] * a + f1[1] * b, f1[0] * h + f1[1] * k + bend] }
    }

    #[inline]
    fn through(self, f: &Expression) -> Self {
        f.eval(&[self])
    }
}

/// `f(x)` by the derivatives of `f` along its one variable: dearer numbers never enter `f`.
fn follow<D: Real>(x: D, f: &Expression) -> D {
    let Along { re, derivatives: [slope, bend] } = f.eval(&[Along::variable(x.re())]);
    x.chain(re, slope, bend)
}

/// `a f`, but 0 for `a = 0` whatever `f` is.
#[inline]
fn times(a: f64, f: f64) -> f64 {
    if a == 0.0 && !f.is_finite() { 0.0 } else { a * f }
}

/// `s a + t b`, entry by entry.
#[inline]
fn combine<const N: usize>(s: f64, a: [f64; N], t: f64, b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|k| s * a[k] + t * b[k])
}

/// `a_i b_j + b_i a_j` for `ij = xx, xy, yy`.
#[inline]
fn mixed(a: [f64; 2], b: [f64; 2]) -> [f64; 3] {
    [2.0 * a[0] * b[0], a[0] * b[1] + a[1] * b[0], 2.0 * a[1] * b[1]]
}

impl Mul for Dual {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        Self { re: self.re * b.re, gradient: combine(b.re, self.gradient, self.re, b.gradient) }
    }
}

impl Mul for Dual2 {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        // ∂_i ∂_j (ab) = b ∂_i ∂_j a + a ∂_i ∂_j b + ∂_i a ∂_j b + ∂_j a ∂_i b
        let outer = combine(b.re, self.hessian, self.re, b.hessian);
        let hessian = combine(1.0, outer, 1.0, mixed(self.gradient, b.gradient));
        Self { re: self.re * b.re, gradient: combine(b.re, self.gradient, self.re, b.gradient), hessian }
    }
}

impl Mul for Along {
    type Output = Self;
    #[inline]
    fn mul(self, b: Self) -> Self {
        let ([a1, a2], [b1, b2]) = (self.derivatives, b.derivatives);
        // (ab)'' = a'' b + 2 a' b' + a b''
        let derivatives = [b.re * a1 + self.re * b1, b.re * a2 + self.re * b2 + 2.0 * a1 * b1];
        Self { re: self.re * b.re, derivatives }
    }
}

impl Div for Along {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        let ([a1, a2], [b1, b2]) = (self.derivatives, b.derivatives);
        // q = a/b: q' = (a' − q b')/b, q'' = (a'' − q b'' − 2 q' b')/b
        let (q, inverse) = (self.re / b.re, 1.0 / b.re);
        let slope = (a1 - q * b1) * inverse;
        Self { re: q, derivatives: [slope, (a2 - q * b2 - 2.0 * slope * b1) * inverse] }
    }
}

impl Div for Dual {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        // q = a/b: ∂_i q = (∂_i a − q ∂_i b)/b
        let (q, inverse) = (self.re / b.re, 1.0 / b.re);
        Self { re: q, gradient: combine(inverse, self.gradient, -q * inverse, b.gradient) }
    }
}

impl Div for Dual2 {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        // q = a/b: ∂_i ∂_j q = (∂_i ∂_j a − q ∂_i ∂_j b − ∂_i q ∂_j b − ∂_j q ∂_i b)/b
        let (q, inverse) = (self.re / b.re, 1.0 / b.re);
        let gradient = combine(inverse, self.gradient, -q * inverse, b.gradient);
        let outer = combine(inverse, self.hessian, -q * inverse, b.hessian);
        Self { re: q, gradient, hessian: combine(1.0, outer, -inverse, mixed(gradient, b.gradient)) }
    }
}

/// Sums, scaling and assignment, the same for all kinds of numbers; `$part` are the parts beside the value.
macro_rules! linear {
    ($number:ident, $($part:ident),+) => {
        impl From<f64> for $number {
            #[inline]
            fn from(re: f64) -> Self {
                Self { re, ..Default::default() }
            }
        }

        impl Add for $number {
            type Output = Self;
            #[inline]
            fn add(self, b: Self) -> Self {
                Self { re: self.re + b.re, $($part: combine(1.0, self.$part, 1.0, b.$part)),+ }
            }
        }

        impl Sub for $number {
            type Output = Self;
            #[inline]
            fn sub(self, b: Self) -> Self {
                Self { re: self.re - b.re, $($part: combine(1.0, self.$part, -1.0, b.$part)),+ }
            }
        }

        impl Neg for $number {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                Self { re: -self.re, $($part: self.$part.map(|v| -v)),+ }
            }
        }

        impl Add<f64> for $number {
            type Output = Self;
            #[inline]
            fn add(self, b: f64) -> Self {
                Self { re: self.re + b, ..self }
            }
        }

        impl Sub<f64> for $number {
            type Output = Self;
            #[inline]
            fn sub(self, b: f64) -> Self {
                Self { re: self.re - b, ..self }
            }
        }

        impl Mul<f64> for $number {
            type Output = Self;
            #[inline]
            fn mul(self, b: f64) -> Self {
                Self { re: self.re * b, $($part: self.$part.map(|v| v * b)),+ }
            }
        }

        impl Div<f64> for $number {
            type Output = Self;
            #[inline]
            fn div(self, b: f64) -> Self {
                Self { re: self.re / b, $($part: self.$part.map(|v| v / b)),+ }
            }
        }

        impl AddAssign for $number {
            #[inline]
            fn add_assign(&mut self, b: Self) {
                *self = *self + b;
            }
        }

        impl SubAssign for $number {
            #[inline]
            fn sub_assign(&mut self, b: Self) {
                *self = *self - b;
            }
        }

        impl MulAssign for $number {
            #[inline]
            fn mul_assign(&mut self, b: Self) {
                *self = *self * b;
            }
        }
    };
}

linear!(Dual, gradient);
linear!(Dual2, gradient, hessian);
linear!(Along, derivatives);
