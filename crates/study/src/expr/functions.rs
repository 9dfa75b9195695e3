//! The functions of the language.

use super::scalar::{self, Real};

/// A function of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unary {
    Abs,
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Exp,
    Log,
    Sinh,
    Cosh,
    Tanh,
    Sign,
    Step,
    Positive,
}

/// What a name in front of a parenthesis calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Callable {
    Unary(Unary),
    Atan2,
    Power,
    Minimum,
    Maximum,
    Choice,
}

/// Every function with its name, in the order of the documentation.
pub(super) const FUNCTIONS: [(&str, Callable); 21] = [
    ("if", Callable::Choice),
    ("min", Callable::Minimum),
    ("max", Callable::Maximum),
    ("abs", Callable::Unary(Unary::Abs)),
    ("sqrt", Callable::Unary(Unary::Sqrt)),
    ("pow", Callable::Power),
    ("exp", Callable::Unary(Unary::Exp)),
    ("log", Callable::Unary(Unary::Log)),
    ("sin", Callable::Unary(Unary::Sin)),
    ("cos", Callable::Unary(Unary::Cos)),
    ("tan", Callable::Unary(Unary::Tan)),
    ("asin", Callable::Unary(Unary::Asin)),
    ("acos", Callable::Unary(Unary::Acos)),
    ("atan", Callable::Unary(Unary::Atan)),
    ("atan2", Callable::Atan2),
    ("sinh", Callable::Unary(Unary::Sinh)),
    ("cosh", Callable::Unary(Unary::Cosh)),
    ("tanh", Callable::Unary(Unary::Tanh)),
    ("sign", Callable::Unary(Unary::Sign)),
    ("step", Callable::Unary(Unary::Step)),
    ("pos", Callable::Unary(Unary::Positive)),
];

/// Named constants.
pub(super) const CONSTANTS: [(&str, f64); 2] = [("pi", std::f64::consts::PI), ("e", std::f64::consts::E)];

impl Callable {
    /// Smallest and largest number of arguments.
    pub(super) fn arity(self) -> (usize, usize) {
        match self {
            Self::Unary(_) => (1, 1),
            Self::Atan2 | Self::Power => (2, 2),
            Self::Minimum | Self::Maximum => (2, usize::MAX),
            Self::Choice => (3, 3),
        }
    }
}

impl Unary {
    /// `f(x)`. At a kink the derivative is that of the value: 0 for `abs`, `sign`, `step` and `pos` at 0.
    pub(super) fn eval<D: Real>(self, x: D) -> D {
        let t = x.re();
        match self {
            Self::Abs => x.chain(t.abs(), sign(t), 0.0),
            Self::Sqrt => scalar::sqrt(x),
            Self::Sin => x.sin_cos().0,
            Self::Cos => x.sin_cos().1,
            Self::Tan => {
                let f = t.tan();
                x.chain(f, 1.0 + f * f, 2.0 * f * (1.0 + f * f))
            }
            Self::Asin => arc_sine(x),
            Self::Acos => -(arc_sine(x) - t.asin()) + t.acos(),
            Self::Atan => x.atan(),
            Self::Exp => x.exp(),
            Self::Log => x.chain(t.ln(), 1.0 / t, -1.0 / (t * t)),
            Self::Sinh => x.chain(t.sinh(), t.cosh(), t.sinh()),
            Self::Cosh => x.chain(t.cosh(), t.sinh(), t.cosh()),
            Self::Tanh => {
                let f = t.tanh();
                x.chain(f, 1.0 - f * f, -2.0 * f * (1.0 - f * f))
            }
            Self::Sign => x.chain(sign(t), 0.0, 0.0),
            Self::Step => x.chain(f64::from(u8::from(t > 0.0)), 0.0, 0.0),
            Self::Positive => positive(x),
        }
    }
}

fn arc_sine<D: Real>(x: D) -> D {
    let t = x.re();
    // f' = (1−x²)^{−1/2}, f'' = x (1−x²)^{−3/2}
    let slope = 1.0 / (1.0 - t * t).sqrt();
    x.chain(t.asin(), slope, t * slope.powi(3))
}

fn positive<D: Real>(x: D) -> D {
    if x.re() > 0.0 || x.re().is_nan() { x } else { D::from(0.0) }
}

fn sign(t: f64) -> f64 {
    if t == 0.0 { 0.0 } else { t.signum() }
}
