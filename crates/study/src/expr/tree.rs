//! The tree of an expression and its value.
//!
//! Sums, products, `min`, `max`, `and`, `or` hold any number of operands, so the depth of the tree is the depth of the
//! parentheses, which the parser bounds: a long sum cannot exhaust the stack.

use super::functions::Unary;
use super::scalar::{self, Real};

/// A number.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Node {
    Constant(f64),
    Variable(usize),
    Negative(Box<Node>),
    /// The first operand, then `(is it subtracted?, operand)`.
    Sum(Box<Node>, Vec<(bool, Node)>),
    /// The first operand, then `(is it divided by?, operand)`.
    Product(Box<Node>, Vec<(bool, Node)>),
    Power(Box<Node>, Box<Node>),
    Apply(Unary, Box<Node>),
    Atan2(Box<Node>, Box<Node>),
    /// `min` of the operands; of equals the first.
    Minimum(Vec<Node>),
    /// `max` of the operands; of equals the first.
    Maximum(Vec<Node>),
    If(Box<Condition>, Box<Node>, Box<Node>),
}

/// True or false.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Condition {
    Compare(Relation, Node, Node),
    All(Vec<Condition>),
    Any(Vec<Condition>),
    Not(Box<Condition>),
}

/// A comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Relation {
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
}

impl Node {
    /// The value at `x`.
    pub(super) fn eval<D: Real>(&self, x: &[D]) -> D {
        match self {
            Self::Constant(c) => D::from(*c),
            Self::Variable(i) => x[*i],
            Self::Negative(a) => -a.eval(x),
            Self::Sum(first, rest) => sum(first.eval(x), rest, x),
            Self::Product(first, rest) => product(first.eval(x), rest, x),
            Self::Power(base, exponent) => raised(base.eval(x), exponent, x),
            Self::Apply(f, a) => f.eval(a.eval(x)),
            Self::Atan2(a, b) => scalar::atan2(a.eval(x), b.eval(x)),
            Self::Minimum(all) => extreme(all, x, |new, best| new < best),
            Self::Maximum(all) => extreme(all, x, |new, best| new > best),
            Self::If(condition, a, b) => {
                let taken = if condition.holds(x) { a } else { b };
                taken.eval(x)
            }
        }
    }

    /// Its value, if no variable occurs in it.
    pub(super) fn constant(&self) -> Option<f64> {
        match self {
            Self::Constant(c) => Some(*c),
            _ => None,
        }
    }
}

impl Condition {
    fn holds<D: Real>(&self, x: &[D]) -> bool {
        match self {
            Self::Compare(relation, a, b) => relation.holds(a.eval(x).re(), b.eval(x).re()),
            Self::All(parts) => parts.iter().all(|c| c.holds(x)),
            Self::Any(parts) => parts.iter().any(|c| c.holds(x)),
            Self::Not(c) => !c.holds(x),
        }
    }
}

impl Relation {
    fn holds(self, a: f64, b: f64) -> bool {
        match self {
            Self::Less => a < b,
            Self::LessEqual => a <= b,
            Self::Greater => a > b,
            Self::GreaterEqual => a >= b,
            Self::Equal => a == b,
            Self::NotEqual => a != b,
        }
    }
}

fn sum<D: Real>(mut value: D, rest: &[(bool, Node)], x: &[D]) -> D {
    for (subtracted, node) in rest {
        if *subtracted {
            value -= node.eval(x);
        } else {
            value += node.eval(x);
        }
    }
    value
}

fn product<D: Real>(mut value: D, rest: &[(bool, Node)], x: &[D]) -> D {
    for (divided, node) in rest {
        value = match (divided, node.constant()) {
            (false, Some(c)) => value * c,
            (true, Some(c)) => value / c,
            (false, None) => value * node.eval(x),
            (true, None) => value / node.eval(x),
        };
    }
    value
}

/// `base ^ exponent`. With a variable exponent `exp(exponent · log base)`, so the base must be positive, or zero under
/// a positive exponent.
fn raised<D: Real>(base: D, exponent: &Node, x: &[D]) -> D {
    if let Some(n) = exponent.constant() {
        return scalar::power(base, n);
    }
    let n = exponent.eval(x);
    if base.re() == 0.0 && n.re() > 0.0 {
        // a^n log a → 0: nothing moves with the exponent.
        scalar::power(base, n.re())
    } else {
        (base.ln() * n).exp()
    }
}

fn extreme<D: Real>(all: &[Node], x: &[D], better: impl Fn(f64, f64) -> bool) -> D {
    let mut best = all[0].eval(x);
    for node in &all[1..] {
        let new = node.eval(x);
        // NaN among the operands is not hidden.
        if better(new.re(), best.re()) || new.re().is_nan() {
            best = new;
        }
    }
    best
}
