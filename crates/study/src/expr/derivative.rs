//! The derivative of a tree by a variable, again as a tree.

use super::build::{apply, choice, constant, is, negative, over, power, sum, times};
use super::functions::Unary;
use super::tree::{Condition, Node, Relation};

/// `∂a/∂x_i`.
pub(super) fn derivative(a: &Node, i: usize) -> Node {
    match a {
        Node::Constant(_) => constant(0.0),
        Node::Variable(j) => constant(f64::from(u8::from(*j == i))),
        Node::Negative(a) => negative(derivative(a, i)),
        Node::Sum(first, rest) => {
            let head = (false, derivative(first, i));
            sum(std::iter::once(head).chain(rest.iter().map(|(subtracted, b)| (*subtracted, derivative(b, i)))))
        }
        Node::Product(first, rest) => {
            let factors: Vec<(bool, &Node)> =
                std::iter::once((false, &**first)).chain(rest.iter().map(|(divided, b)| (*divided, b))).collect();
            of_product(&factors, i)
        }
        Node::Power(base, exponent) => of_power(base, exponent, i),
        Node::Apply(f, a) => slope(*f, a, derivative(a, i)),
        Node::Atan2(a, b) => of_angle(a, b, i),
        Node::Minimum(all) => of_extreme(all, i, Relation::Less, Node::Minimum),
        Node::Maximum(all) => of_extreme(all, i, Relation::Greater, Node::Maximum),
        Node::If(condition, a, b) => choice((**condition).clone(), derivative(a, i), derivative(b, i)),
    }
}

/// `(a b)' = a' b + a b'` with the factors split in halves, so that the tree of a long product stays of the size of the
/// product times its logarithm; `(1/a)' = −a'/a/a`.
fn of_product(factors: &[(bool, &Node)], i: usize) -> Node {
    match factors {
        [(false, a)] => derivative(a, i),
        [(true, a)] => negative(over(over(derivative(a, i), (*a).clone()), (*a).clone())),
        _ => {
            let (left, right) = factors.split_at(factors.len() / 2);
            let first = times(of_product(left, i), product(right));
            let second = times(product(left), of_product(right, i));
            sum([(false, first), (false, second)])
        }
    }
}

fn product(factors: &[(bool, &Node)]) -> Node {
    factors.iter().fold(constant(1.0), |all, (divided, a)| {
        let a = (*a).clone();
        if *divided { over(all, a) } else { times(all, a) }
    })
}

/// `(a^b)' = b a^{b−1} a' + a^b log(a) b'`; the second term is 0 at `a = 0`, where `a^n log a → 0`.
fn of_power(a: &Node, b: &Node, i: usize) -> Node {
    let (slope_a, slope_b) = (derivative(a, i), derivative(b, i));
    if let Some(n) = b.constant() {
        return times(times(constant(n), power(a.clone(), n - 1.0)), slope_a);
    }
    let lowered = Node::Power(Box::new(a.clone()), Box::new(sum([(false, b.clone()), (true, constant(1.0))])));
    let by_base = times(times(b.clone(), lowered), slope_a);
    if is(a, 0.0) || is(&slope_b, 0.0) {
        return by_base;
    }
    let whole = Node::Power(Box::new(a.clone()), Box::new(b.clone()));
    let by_exponent = times(times(whole, apply(Unary::Log, a.clone())), slope_b);
    let vanishes = Condition::Compare(Relation::Equal, a.clone(), constant(0.0));
    let by_exponent = if a.constant().is_some() { by_exponent } else { choice(vanishes, constant(0.0), by_exponent) };
    sum([(false, by_base), (false, by_exponent)])
}

/// `f'(a) a'`.
fn slope(f: Unary, a: &Node, inner: Node) -> Node {
    let one = || constant(1.0);
    let a = || a.clone();
    let one_and_square = |subtracted: bool, b: Node| sum([(false, one()), (subtracted, power(b, 2.0))]);
    match f {
        Unary::Sign | Unary::Step => constant(0.0),
        Unary::Abs => times(apply(Unary::Sign, a()), inner),
        // f' = 1/(2 √a)
        Unary::Sqrt => over(times(constant(0.5), inner), apply(Unary::Sqrt, a())),
        Unary::Sin => times(apply(Unary::Cos, a()), inner),
        Unary::Cos => negative(times(apply(Unary::Sin, a()), inner)),
        // f' = 1 + tan² a
        Unary::Tan => times(one_and_square(false, apply(Unary::Tan, a())), inner),
        // f' = (1 − a²)^{−1/2}
        Unary::Asin => over(inner, apply(Unary::Sqrt, one_and_square(true, a()))),
        Unary::Acos => negative(over(inner, apply(Unary::Sqrt, one_and_square(true, a())))),
        // f' = 1/(1 + a²)
        Unary::Atan => over(inner, one_and_square(false, a())),
        Unary::Exp => times(apply(Unary::Exp, a()), inner),
        Unary::Log => over(inner, a()),
        Unary::Sinh => times(apply(Unary::Cosh, a()), inner),
        Unary::Cosh => times(apply(Unary::Sinh, a()), inner),
        // f' = 1 − tanh² a
        Unary::Tanh => times(one_and_square(true, apply(Unary::Tanh, a())), inner),
        Unary::Positive => choice(Condition::Compare(Relation::LessEqual, a(), constant(0.0)), constant(0.0), inner),
    }
}

/// `atan2(a, b)' = (b a' − a b')/(a² + b²)`.
fn of_angle(a: &Node, b: &Node, i: usize) -> Node {
    let turn = sum([(false, times(b.clone(), derivative(a, i))), (true, times(a.clone(), derivative(b, i)))]);
    over(turn, sum([(false, power(a.clone(), 2.0)), (false, power(b.clone(), 2.0))]))
}

/// The derivative of the best of the operands; of equals the first. Halves, so that a long list stays a shallow tree.
fn of_extreme(all: &[Node], i: usize, better: Relation, best: fn(Vec<Node>) -> Node) -> Node {
    if let [a] = all {
        return derivative(a, i);
    }
    let (left, right) = all.split_at(all.len() / 2);
    let best_of = |half: &[Node]| if let [a] = half { a.clone() } else { best(half.to_vec()) };
    let later = Condition::Compare(better, best_of(right), best_of(left));
    choice(later, of_extreme(right, i, better, best), of_extreme(left, i, better, best))
}

#[cfg(test)]
mod tests;
