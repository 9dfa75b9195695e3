//! Derivatives as trees against dual numbers, which know nothing of trees.

use super::super::functions::FUNCTIONS;
use super::super::tree::Node;
use super::super::{Dual2, Expression};
use std::collections::BTreeMap;

fn parse(text: &str) -> Expression {
    let parameters = BTreeMap::from([("s".to_string(), 0.4)]);
    Expression::parse(text, &["x", "y"], &parameters).unwrap_or_else(|e| panic!("{e}"))
}

/// Every function, power and operation, smooth at the points of the test or with its kinks between them.
const TEXTS: [&str; 36] = [
    "3*x - 2*y + 7",
    "-x*y - (x - -y)",
    "x^3*y - 2*x/y/(1 + x)",
    "1/x + y/(x*y) - 3/(2*x)",
    "x*y*x*sin(y)*x/(1 + y^2)/x",
    "(x + 2*y)^4 + (x*y)^-2 + x^1 + y^0",
    "x^y + pow(y, x*y)",
    "2^(x*y) + e^x - pow(x, 1.5) + 0^x",
    "sqrt(x*y) + sqrt(2)*x",
    "abs(x - y)*y + abs(-x)",
    "sign(x - y)*x^2 + step(y - s)*y^3",
    "pos(x - s)^3 - 2*pos(s - y)^2",
    "pos(x - s)^1.5*pos(y - s)^2.5",
    "sin(x)*cos(y)",
    "tan(x*y)",
    "asin(x*y/2)",
    "acos(x - y)",
    "atan(3*x - y)",
    "atan2(y - s, x - 0.7)",
    "atan2(x, y^2)",
    "exp(-x^2)*y",
    "log(1 + x*y)",
    "sinh(x)*y",
    "cosh(y)*x",
    "tanh(x + y^2)",
    "min(x, y^3)",
    "max(x*y, s, y^2)",
    "min(x, y, x*y, x^2, s)",
    "max(x, 1 - y) - min(2*x, 3*y)",
    "if(x < y, x^2*y, y^2*x)",
    "if(x > s and not y > s, x^3, if(x <= s or y == 0, sin(y), 1))",
    "if(x > s, (x - s)^1.5, 0)",
    "sqrt(pos(x - s))*y",
    "if(x > s, 0, y)*log(s - x)",
    "sin(cos(exp(x*tanh(y))))",
    "(x^2 + y^2)^0.75*cos(0.75*atan2(y, x))",
];

fn dual(e: &Expression, x: f64, y: f64) -> (f64, [f64; 2], [[f64; 2]; 2]) {
    let d = e.eval(&[Dual2::variable(x, 0), Dual2::variable(y, 1)]);
    let [xx, xy, yy] = d.hessian;
    (d.re, d.gradient, [[xx, xy], [xy, yy]])
}

fn points() -> impl Iterator<Item = (f64, f64)> {
    let place = |i: u32, step: f64| 0.05 + 0.9 * (0.5 + f64::from(i) * step).fract();
    (0..60).map(move |i| (place(i, 0.754_877), place(i, 0.569_840)))
}

/// Equal to rounding; both may be no number.
fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-11 * (1.0 + b.abs()) || (a.is_nan() && b.is_nan())
}

#[test]
fn first_and_second_derivatives_are_those_of_the_dual_numbers() {
    for text in TEXTS {
        let e = parse(text);
        let first = [0, 1].map(|i| e.derivative(i));
        let second = first.each_ref().map(|d| [0, 1].map(|j| d.derivative(j)));
        let mut finite = 0;
        for (x, y) in points() {
            let (whole, gradient, hessian) = dual(&e, x, y);
            if whole.is_nan() {
                // outside the domain numbers have no derivative, where a tree may
                continue;
            }
            finite += usize::from(gradient.iter().chain(hessian.iter().flatten()).all(|d| d.is_finite()));
            for i in 0..2 {
                let (value, slope, _) = dual(&first[i], x, y);
                assert!(near(value, gradient[i]), "∂{i} of {text} at ({x}, {y}): {value} ≠ {}", gradient[i]);
                for j in 0..2 {
                    let expected = hessian[i][j];
                    assert!(near(slope[j], expected), "∂{j} by numbers of ∂{i} of {text} at ({x}, {y})");
                    let twice = second[i][j].eval(&[x, y]);
                    assert!(near(twice, expected), "∂{j}∂{i} of {text} at ({x}, {y}): {twice} ≠ {expected}");
                }
            }
        }
        assert!(finite >= 20, "{text}: only {finite} points tell anything");
    }
}

#[test]
fn no_function_is_left_out() {
    for (name, _) in FUNCTIONS {
        let call = format!("{name}(");
        let found =
            TEXTS.iter().any(|t| t.match_indices(&call).any(|(at, _)| !t[..at].ends_with(char::is_alphanumeric)));
        assert!(found, "{name}");
    }
}

#[test]
fn at_a_kink_the_branch_taken_counts() {
    for (text, at, expected) in [
        ("abs(x)", 0.0, 0.0),
        ("pos(x)", 0.0, 0.0),
        ("sign(x) + step(x)", 0.0, 0.0),
        ("min(x, 2*x)", 0.0, 1.0),
        ("max(3*x, 2*x, x)", 0.0, 3.0),
        ("if(x < s, x, 5*x)", 0.4, 5.0),
        ("if(x <= s, x, 5*x)", 0.4, 1.0),
        ("pos(x)^0.5", -1.0, 0.0),
        ("pos(x - s)^1.5", 0.4, 0.0),
        ("x^1.5", 0.0, 0.0),
        ("x^(1 + y)", 0.0, 0.0),
        ("sqrt(x)", 0.0, f64::INFINITY),
    ] {
        let e = parse(text);
        assert_eq!(e.derivative(0).eval(&[at, 0.7]), expected, "{text}");
        assert_eq!(dual(&e, at, 0.7).1[0], expected, "{text} by dual numbers");
    }
    assert!(parse("sqrt(x^2)").derivative(0).eval(&[0.0, 0.0]).is_nan(), "∞ times 0");
}

#[test]
fn trees_stay_small() {
    for (text, simple) in [
        ("3*x + 2", "3"),
        ("2*x + y - 5", "2"),
        ("y^2/s", "0"),
        ("x^2", "2*x"),
        ("-(x^2)", "-(2*x)"),
        ("-(-x)", "1"),
        ("sin(x)", "cos(x)"),
        ("x/y", "1/y"),
        ("pos(x)^2", "if(x <= 0, 0, 2*pos(x))"),
        ("if(x > 0, 3, 4)", "0"),
        ("min(y, 2)", "0"),
    ] {
        assert_eq!(parse(text).derivative(0).root, parse(simple).root, "{text}");
    }
    assert_eq!(parse("cos(2*x)/20").derivative(1).root, Node::Constant(0.0));
}

/// Long products, sums and lists become neither deep nor of squared size.
#[test]
fn length_is_not_bounded() {
    for (separator, expected) in [("*", 20_000.0), ("+", 20_000.0), (", ", 1.0)] {
        let list = vec!["x"; 20_000].join(separator);
        let text = if separator == ", " { format!("max({list})") } else { list };
        assert_eq!(parse(&text).derivative(0).eval(&[1.0, 0.0]), expected);
    }
}
