//! Seconds per quadrature point of exact solutions: displacement, gradient and second derivatives, from which loads follow.
//!
//! `cargo bench -p signorini-study`: the throughput is in points per second, so 2 MItem/s are ½ µs per point.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use signorini_contact::material::Lame;
use signorini_contact::{Body, Point};
use signorini_study::exact::{Exact, Expressions, built_in};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The name of a built-in solution, its parameters, and the lower left corner of a unit square in `Ω'`.
type Solution = (&'static str, &'static [(&'static str, f64)], [f64; 2]);

const SOLUTIONS: [Solution; 8] = [
    ("P", &[("k", 3.0), ("m", 2.0)], [0.0, 0.0]),
    ("W", &[], [0.0, 0.0]),
    ("R", &[("alpha", 1.5)], [0.0, 0.0]),
    ("many-switches", &[("cells", 8.0)], [0.0, 0.0]),
    ("tiles", &[("beta", 0.75), ("power", 1.0)], [0.0, 0.0]),
    ("arcR", &[("alpha", 1.5)], [0.3, 0.3]),
    ("graphR", &[("alpha", 1.5), ("gap", 0.0)], [0.5, 0.0]),
    ("bilateral", &[], [0.0, 0.4]),
];

/// Points of `Ω'` in the unit square from `corner` on, on no grid of any mesh.
fn points(corner: [f64; 2]) -> Vec<Point> {
    let share = |k: u32, step: f64| (0.5 + f64::from(k) * step).fract();
    (0..1000).map(|k| Point::new(corner[0] + share(k, 0.754_877), corner[1] + share(k, 0.569_840))).collect()
}

fn solution(name: &str, parameters: &[(&str, f64)]) -> Arc<dyn Exact> {
    let parameters: BTreeMap<String, f64> = parameters.iter().map(|(k, v)| ((*k).to_owned(), *v)).collect();
    built_in(name, &parameters, [Lame { lambda: 1.0, mu: 1.0 }, Lame { lambda: 2.0, mu: 1.5 }])
        .expect("a known solution")
}

#[divan::bench(args = 0..SOLUTIONS.len())]
fn built_in_with_second_derivatives(bencher: Bencher, k: usize) {
    let (name, parameters, corner) = SOLUTIONS[k];
    let (exact, points) = (solution(name, parameters), points(corner));
    bencher
        .counter(ItemsCount::new(points.len()))
        .bench(|| points.iter().map(|x| black_box(exact.jet2(Body::First, *x)).hessian[0][0][0]).sum::<f64>());
}

#[divan::bench]
fn expressions_with_second_derivatives(bencher: Bencher) {
    let texts = ["sin(2*x)/10*(1 - y^2)", "(cos(2*x)/20 + 0.6*pos(x - 0.4)^3)*(1 - y^2)"];
    let exact = Expressions::parse([texts, texts], &BTreeMap::new()).expect("two expressions");
    let points = points([0.0, 0.0]);
    bencher
        .counter(ItemsCount::new(points.len()))
        .bench(|| points.iter().map(|x| black_box(exact.jet2(Body::First, *x)).hessian[0][0][0]).sum::<f64>());
}

fn main() {
    divan::main();
}
