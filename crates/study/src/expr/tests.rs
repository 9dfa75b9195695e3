//! Values, derivatives and errors of whole expressions.

use super::{Dual, Dual2, ExprError, Expression, Real};
use std::collections::BTreeMap;

const VARIABLES: [&str; 2] = ["x", "y"];

fn parse(text: &str) -> Result<Expression, ExprError> {
    let parameters = BTreeMap::from([("s".to_string(), 0.4), ("alpha".to_string(), 1.5)]);
    Expression::parse(text, &VARIABLES, &parameters)
}

fn value(text: &str, x: f64, y: f64) -> f64 {
    parse(text).unwrap_or_else(|e| panic!("{e}")).eval(&[x, y])
}

#[test]
fn precedence_follows_the_usual_rules() {
    let x = 3.0;
    let y: f64 = -2.0;
    for (text, expected) in [
        ("-x^2", -9.0),
        ("(-x)^2", 9.0),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("2^-x^2", (2.0f64).powi(-9)),
        ("8/4/2", 1.0),
        ("8/4*2", 4.0),
        ("1-2-3", -4.0),
        ("1 - -x", 4.0),
        ("2*-x", -6.0),
        ("--x", 3.0),
        ("+x", 3.0),
        ("2+3*4", 14.0),
        ("(2+3)*4", 20.0),
        ("1e-3*x", 3e-3),
        ("2.5E+1", 25.0),
        (".5 + 1.", 1.5),
        ("6/-2^2", -1.5),
        ("x*y^2", 12.0),
        ("s*alpha", 0.4 * 1.5),
        ("e^0 + cos(pi)", 0.0),
        ("if(x > 2 and y < 0, 1, 2)", 1.0),
        ("if(not x > 2 or y >= 0, 1, 2)", 2.0),
        ("if(not (x > 2 and y > 0), 1, 2)", 1.0),
        ("if(x != 3, 1, if(y == -2, 5, 6))", 5.0),
        ("if(x <= 3 or 1/0 > 0 and x < 0, 1, 2)", 1.0),
        ("min(x, y, 0)", -2.0),
        ("max(x, y)", 3.0),
        ("pow(x, 2) + pos(y) + pos(x)", 12.0),
        ("sign(y) + step(x) + step(0) + sign(0)", 0.0),
        ("abs(y) * sqrt(4)", 4.0),
        ("log(e^2)", 2.0),
        ("atan2(1, -1)/pi", 0.75),
        ("x^y", 1.0 / 9.0),
    ] {
        let got = value(text, x, y);
        assert!((got - expected).abs() < 1e-15, "{text}: {got} ≠ {expected}");
    }
}

#[test]
fn only_the_branch_taken_is_evaluated() {
    let d = parse("if(x > s, (x-s)^1.5, 0)").unwrap();
    let at = |x: f64| d.eval(&[Dual2::variable(x, 0), Dual2::variable(0.0, 1)]);
    assert_eq!(at(0.1).re, 0.0);
    assert_eq!(at(0.1).gradient, [0.0; 2], "no NaN from the other branch");
    assert!((at(0.65).re - 0.125).abs() < 1e-15);
}

/// Central differences of the value and of the gradient, at points away from kinks.
#[test]
fn derivatives_agree_with_differences() {
    for text in [
        "x^3*y - 2*x/y",
        "sqrt(x*y) + abs(-x) + pos(y - 0.1)^3",
        "sin(x)*cos(y) + tan(x*y)",
        "asin(x*y) + acos(x/2) + atan(3*x - y)",
        "atan2(y, -x) + atan2(-y, x*x)",
        "exp(-x^2)*log(1 + y)",
        "sinh(x) - cosh(y)*tanh(x + y)",
        "x^y + pow(y, x)",
        "x^1.5 + y^-0.5 + (x*y)^alpha",
        "if(x < y, x^2, y^2) + min(x, y^3) + max(x*y, 0)",
        "step(x)*x^2 + sign(y)*y^3",
    ] {
        let e = parse(text).unwrap();
        for (x, y) in [(0.3, 0.8), (0.71, 0.45)] {
            check_gradient(&e, x, y);
            check_hessian(&e, x, y);
        }
    }
}

fn gradient(e: &Expression, x: f64, y: f64) -> [f64; 2] {
    let d = e.eval(&[Dual::variable(x, 0), Dual::variable(y, 1)]);
    d.gradient
}

fn check_gradient(e: &Expression, x: f64, y: f64) {
    let h = 1e-5;
    let difference = [
        (e.eval(&[x + h, y]) - e.eval(&[x - h, y])) / (2.0 * h),
        (e.eval(&[x, y + h]) - e.eval(&[x, y - h])) / (2.0 * h),
    ];
    let exact = gradient(e, x, y);
    for i in 0..2 {
        let error = (difference[i] - exact[i]).abs();
        assert!(error < 1e-8 * (1.0 + exact[i].abs()), "{}: {error:e}", e.text());
    }
}

fn check_hessian(e: &Expression, x: f64, y: f64) {
    let h = 1e-5;
    let d = e.eval(&[Dual2::variable(x, 0), Dual2::variable(y, 1)]);
    let [xx, xy, yy] = d.hessian;
    let hessian = [[xx, xy], [xy, yy]];
    for (k, (dx, dy)) in [(h, 0.0), (0.0, h)].into_iter().enumerate() {
        let (after, before) = (gradient(e, x + dx, y + dy), gradient(e, x - dx, y - dy));
        for j in 0..2 {
            let error = ((after[j] - before[j]) / (2.0 * h) - hessian[j][k]).abs();
            let scale = 1.0 + hessian[j][k].abs();
            assert!(error < 1e-7 * scale, "{}: {error:e}", e.text());
        }
    }
}

#[test]
fn powers_at_zero_are_finite_where_the_limit_is() {
    for (text, slope) in [
        ("x^3", 0.0),
        ("x^1.5", 0.0),
        ("x", 1.0),
        ("x^1", 1.0),
        ("pos(x)^2.5", 0.0),
        ("y*x^2", 0.0),
        ("x^(1 + y)", 0.0),
    ] {
        let got = gradient(&parse(text).unwrap(), 0.0, 0.7);
        assert_eq!(got, [slope, 0.0], "{text}");
    }
    assert_eq!(gradient(&parse("sqrt(x)").unwrap(), 0.0, 0.7), [f64::INFINITY, 0.0]);
}

#[test]
fn errors_say_what_and_where() {
    for (text, column, part) in [
        ("", 1, "empty"),
        ("x +", 4, "found the end"),
        ("(x + 1", 1, "never closed"),
        ("sin(x", 4, "never closed"),
        ("x + 1)", 6, "closes no parenthesis"),
        ("2 x", 3, "`*` is missing"),
        ("2(x)", 2, "`*` is missing"),
        ("x y", 3, "follows a complete expression"),
        ("1 + alhpa", 5, "did you mean `alpha`"),
        ("q + 1", 1, "known here: x, y, alpha, s, pi, e"),
        ("cosinus(x)", 1, "unknown function"),
        ("sqr(x)", 1, "did you mean `sqrt`"),
        ("sin + 1", 1, "is a function"),
        ("x(2)", 1, "is not a function"),
        ("sin(x, y)", 1, "takes 1 argument, found 2"),
        ("atan2(x)", 1, "takes 2 arguments, found 1"),
        ("max(x)", 1, "at least 2 arguments, found 1"),
        ("sin()", 1, "takes 1 argument, found 0"),
        ("if(x, 1, 2)", 4, "a number stands where a condition"),
        ("x < y", 1, "a condition stands where a number"),
        ("1 + (x < y)", 5, "a condition stands where a number"),
        ("if(0 < x < 1, 1, 2)", 10, "do not chain"),
        ("if(x < 1 and y, 1, 2)", 14, "a number stands where a condition"),
        ("x * * y", 5, "found `*`"),
        ("and", 1, "where a number is expected"),
        ("max(x,, y)", 7, "found `,`"),
        ("x = 1", 3, "=="),
    ] {
        let error = parse(text).expect_err(text);
        assert_eq!(error.column, column, "{text}: {error}");
        assert!(error.message.contains(part), "{text}: {error}");
    }
}

#[test]
fn the_caret_stands_under_the_column() {
    let shown = parse("1 + alhpa").unwrap_err().to_string();
    let lines: Vec<&str> = shown.lines().collect();
    assert_eq!(lines[1..], ["  1 + alhpa", "      ^"]);
}

#[test]
fn depth_is_bounded_and_length_is_not() {
    let deep = |n: usize| format!("{}x{}", "(".repeat(n), ")".repeat(n));
    assert!(parse(&deep(60)).is_ok());
    for text in
        [deep(100_000), "-".repeat(100_000), "2^".repeat(100_000), "sin(".repeat(100_000), "not ".repeat(100_000)]
    {
        let error = parse(&text).unwrap_err();
        assert!(error.message.contains("nested deeper"), "{}", error.message);
    }
    let long = vec!["x"; 50_000].join("+");
    assert_eq!(value(&long, 2.0, 0.0), 100_000.0);
}

/// Random strings of the language's own pieces and of any characters: an answer or an error, never a panic, and what is
/// accepted can be differentiated and evaluated.
#[test]
fn no_text_panics() {
    let pieces = [
        "x", "y", "s", "1", "2.5", "1e-3", "+", "-", "*", "/", "^", "(", ")", ",", "<", "==", "if(", "min(", "sin(",
        "atan2(", "and", "or", "not", " ", "é", "\n", "!", "0", "pow(", "pos(",
    ];
    let mut random = Lcg(1979);
    let mut accepted = 0;
    for _ in 0..20_000 {
        let length = random.below(14) + 1;
        let text: String = (0..length).map(|_| pieces[random.below(pieces.len())]).collect();
        if let Ok(e) = parse(&text) {
            accepted += 1;
            evaluate_everywhere(&e);
        }
    }
    assert!(accepted > 300, "only {accepted} were expressions");
}

fn evaluate_everywhere(e: &Expression) {
    let kinds = e.eval(&[0.0, -1.5]);
    let first = e.eval(&[Dual::variable(0.0, 0); 2]).re;
    let second = e.eval(&[Dual2::from(0.5).chain(0.5, 1.0, 0.0); 2]);
    let slope = e.derivative(0).derivative(1).eval(&[0.25, -1.5]);
    let _ = (kinds, first, second, slope);
}

/// A linear congruential generator: the same strings on every machine.
struct Lcg(u64);

impl Lcg {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n as u64) as usize
    }
}
