//! Trees put together from trees, the trivial parts left out: `0·a`, `1·a`, `a + 0`, `−(−a)`, `a^1`, sums and products of
//! numbers.

use super::functions::Unary;
use super::tree::{Condition, Node};

/// The number `c`.
pub(super) fn constant(c: f64) -> Node {
    Node::Constant(c)
}

/// Whether `a` is the number `c`.
pub(super) fn is(a: &Node, c: f64) -> bool {
    a.constant() == Some(c)
}

/// `f(a)`.
pub(super) fn apply(f: Unary, a: Node) -> Node {
    let numeric = a.constant().is_some();
    folded(Node::Apply(f, Box::new(a)), numeric)
}

/// `−a`.
pub(super) fn negative(a: Node) -> Node {
    match a {
        Node::Constant(c) => Node::Constant(-c),
        Node::Negative(inner) => *inner,
        other => Node::Negative(Box::new(other)),
    }
}

/// `Σ ±a_i`, the terms given as `(is it subtracted?, a_i)`.
pub(super) fn sum(terms: impl IntoIterator<Item = (bool, Node)>) -> Node {
    let mut known = 0.0;
    let mut rest: Vec<(bool, Node)> = Vec::new();
    for (subtracted, node) in terms {
        match node {
            Node::Constant(c) => known += if subtracted { -c } else { c },
            Node::Negative(inner) => rest.push((!subtracted, *inner)),
            other => rest.push((subtracted, other)),
        }
    }
    if known != 0.0 || rest.is_empty() {
        rest.push((false, Node::Constant(known)));
    }
    // A term that is added comes first, if there is one.
    let first = rest.iter().position(|(subtracted, _)| !subtracted).unwrap_or(0);
    let (subtracted, head) = rest.remove(first);
    let head = if subtracted { negative(head) } else { head };
    if rest.is_empty() { head } else { Node::Sum(Box::new(head), rest) }
}

/// `a b`; a factor that is a number stands in front.
pub(super) fn times(a: Node, b: Node) -> Node {
    match (a, b) {
        (a, _) | (_, a) if is(&a, 0.0) => a,
        (a, b) | (b, a) if is(&a, 1.0) => b,
        (Node::Constant(a), Node::Constant(b)) => Node::Constant(a * b),
        (Node::Negative(a), b) => negative(times(*a, b)),
        (a, Node::Negative(b)) => negative(times(a, *b)),
        (a, Node::If(c, yes, no)) if is(&yes, 0.0) || is(&no, 0.0) => choice(*c, times(a.clone(), *yes), times(a, *no)),
        (Node::If(c, yes, no), b) if is(&yes, 0.0) || is(&no, 0.0) => choice(*c, times(*yes, b.clone()), times(*no, b)),
        (a, b @ Node::Constant(_)) => chained(b, a),
        (a, b) => chained(a, b),
    }
}

/// `a / b`.
pub(super) fn over(a: Node, b: Node) -> Node {
    if is(&b, 1.0) { a } else { times(a, Node::Product(Box::new(constant(1.0)), vec![(true, b)])) }
}

/// `a^n` for a number `n`.
pub(super) fn power(a: Node, n: f64) -> Node {
    if n == 0.0 {
        return constant(1.0);
    }
    if n == 1.0 {
        return a;
    }
    let numeric = a.constant().is_some();
    folded(Node::Power(Box::new(a), Box::new(constant(n))), numeric)
}

/// `if(c, yes, no)`.
pub(super) fn choice(c: Condition, yes: Node, no: Node) -> Node {
    if yes == no { yes } else { Node::If(Box::new(c), Box::new(yes), Box::new(no)) }
}

/// A node whose operands are numbers becomes a number.
pub(super) fn folded(node: Node, numeric: bool) -> Node {
    if numeric { Node::Constant(node.eval::<f64>(&[])) } else { node }
}

/// The factors of `a`, then those of `b`.
fn chained(a: Node, b: Node) -> Node {
    let (first, mut factors) = factors(a);
    let (second, more) = self::factors(b);
    if !is(&second, 1.0) {
        factors.push((false, second));
    }
    factors.extend(more);
    Node::Product(Box::new(first), factors)
}

fn factors(a: Node) -> (Node, Vec<(bool, Node)>) {
    match a {
        Node::Product(first, rest) => (*first, rest),
        other => (other, Vec::new()),
    }
}
