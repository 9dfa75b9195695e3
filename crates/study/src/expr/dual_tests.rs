//! Arithmetic of the dual numbers against those of `num-dual`, which share no line with them.

use super::{Along, Dual, Dual2, Expression, Real, power, sqrt};
use num_dual::{Dual2SVec64, DualNum};

/// Values, first and second derivatives of a number of `num-dual`.
fn parts(d: Dual2SVec64<2>) -> [f64; 6] {
    let (g, h) = (d.v1.0.unwrap_or_default(), d.v2.0.unwrap_or_default());
    [d.re, g[0], g[1], h[(0, 0)], h[(0, 1)], h[(1, 1)]]
}

fn check(what: &str, got: Dual2, expected: Dual2SVec64<2>, first: Dual) {
    let [xx, xy, yy] = got.hessian;
    let all = [got.re, got.gradient[0], got.gradient[1], xx, xy, yy];
    for (k, (a, b)) in all.iter().zip(parts(expected)).enumerate() {
        assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "{what}, part {k}: {a} {b}");
    }
    assert!((first.re - got.re).abs() <= 1e-15 * (1.0 + got.re.abs()), "{what}: the value");
    assert!((0..2).all(|k| (first.gradient[k] - got.gradient[k]).abs() <= 1e-14 * (1.0 + got.gradient[k].abs())));
}

/// The same operations on all three kinds of numbers, both operands curved.
macro_rules! same {
    ($what:literal, $x:ident, $y:ident, $ours:expr, $theirs:expr) => {
        for (a, b) in [(0.7, 1.3), (2.1, -0.4), (0.02, 5.0)] {
            let got = {
                let ($x, $y) = curved(Dual2::variable(a, 0), Dual2::variable(b, 1));
                $ours
            };
            let first = {
                let ($x, $y) = curved(Dual::variable(a, 0), Dual::variable(b, 1));
                $ours
            };
            let expected = {
                let (s, t) = (Dual2SVec64::<2>::from_re(a).derivative(0), Dual2SVec64::from_re(b).derivative(1));
                let ($x, $y) = (s * t * t + s, t - s * s * 0.5);
                $theirs
            };
            check($what, got, expected, first);
        }
    };
}

fn curved<D: Real>(s: D, t: D) -> (D, D) {
    (s * t * t + s, t - s * s * 0.5)
}

#[test]
fn arithmetic_is_that_of_an_independent_implementation() {
    same!("sum", x, y, x + y - x * 3.0 + 0.25 - 1.5, x + y - x * 3.0 + 0.25 - 1.5);
    same!("product", x, y, -(x * y) * y / 3.0, -(x * y) * y / 3.0);
    same!("quotient", x, y, x / y, x / y);
    same!("reciprocal", x, _y, x.recip(), x.recip());
    same!("sine and cosine", x, y, x.sin_cos().0 * y.sin_cos().1, x.sin() * y.cos());
    same!("exponential", x, y, (x * 0.1 - y * y * 0.1).exp(), (x * 0.1 - y * y * 0.1).exp());
    same!("logarithm", x, _y, x.ln(), x.ln());
    same!("arc tangent", x, y, (x * y).atan(), (x * y).atan());
    same!("root", x, _y, sqrt(x), x.sqrt());
    same!("powers", x, y, power(x, 1.7) - power(y, 3.0), x.powf(1.7) - y.powi(3));
    same!("assignment", x, y, assigned(x, y), (x + y) * x - y);
}

fn assigned<D: Real>(x: D, y: D) -> D {
    let mut z = x;
    z += y;
    z *= x;
    z -= y;
    z
}

#[test]
fn an_infinite_slope_stays_out_of_directions_that_do_not_move() {
    let root = sqrt(Dual2::variable(0.0, 0));
    assert_eq!((root.gradient, root.hessian), ([f64::INFINITY, 0.0], [f64::NEG_INFINITY, 0.0, 0.0]));
    assert_eq!(sqrt(Dual2::from(0.0)), Dual2::from(0.0));
    assert_eq!(sqrt(Dual::from(0.0)), Dual::from(0.0));
}

/// Along a line the derivatives are those by that coordinate in the plane.
#[test]
fn functions_of_one_variable_are_those_of_the_plane() {
    for text in
        ["t^3/(1 + t^2)", "pos(t - 0.3)^1.5*cos(2*t)", "-exp(t)*t + log(2 + t) - sqrt(t)", "if(t < 0.5, t, t^4)"]
    {
        let f = Expression::parse(text, &["t"], &Default::default()).unwrap();
        for t in [0.1, 0.45, 0.9] {
            let (line, plane) = (f.eval(&[Along::variable(t)]), f.eval(&[Dual2::variable(t, 1)]));
            let pairs = [(line.re, plane.re), (line.derivatives[0], plane.gradient[1])];
            let pairs = pairs.into_iter().chain([(line.derivatives[1], plane.hessian[2])]);
            pairs.for_each(|(a, b)| assert!((a - b).abs() <= 1e-14 * (1.0 + b.abs()), "{text} at {t}: {a} {b}"));
            let (x, y) = curved(Dual2::variable(t, 0), Dual2::variable(0.2, 1));
            let inner = x * 0.5 + y * y * 0.1;
            let (through, direct) = (inner.through(&f), f.eval(&[inner]));
            assert!(
                (0..3)
                    .all(|k| (through.hessian[k] - direct.hessian[k]).abs() < 1e-13 * (1.0 + direct.hessian[k].abs()))
            );
            assert!((0..2).all(|k| (through.gradient[k] - direct.gradient[k]).abs() < 1e-13));
        }
    }
    let whole = Along::variable(0.7);
    let quotient = (whole * whole + 1.0) / (whole * 2.0);
    // (t² + 1)/(2t): slope ½ − 1/(2t²), bend 1/t³
    assert!((quotient.derivatives[0] - (0.5 - 0.5 / 0.49)).abs() < 1e-15);
    assert!((quotient.derivatives[1] - 1.0 / 0.343).abs() < 1e-14);
}
