//! Derivatives and loads against differences; the built-in P against its own formula as expressions.

use super::*;
use crate::exact::derived::{body_force, stress, traction};
use crate::exact::{Expressions, Jet2};
use signorini_contact::{Body, Vec2};

/// Points off the contact line, away from every break line of the solutions below by more than a step.
fn probes() -> impl Iterator<Item = (Body, Point)> {
    let places = [(0.11, 0.03), (0.37, 0.21), (0.45, 0.06), (0.73, 0.08), (0.95, 0.6)];
    places.into_iter().flat_map(|(x, y)| [(Body::First, Point::new(x, y)), (Body::Second, Point::new(x, -y))])
}

/// The same on the bodies of the arc and of the graphs.
fn curved_probes(name: &str) -> Vec<(Body, Point)> {
    let place = |body, x: f64, y: f64| (body, Point::new(x, y));
    if name.starts_with("arc") {
        let inside = [(0.6, 0.31), (0.41, 0.62), (0.1, 0.88), (0.57, 0.77)].map(|(x, y)| place(Body::First, x, y));
        let outside = [(1.1, 0.3), (0.7, 0.9), (0.2, 1.6), (1.9, 1.2)].map(|(x, y)| place(Body::Second, x, y));
        return [inside, outside].concat();
    }
    let right = [(0.5, -0.9), (0.35, -0.2), (0.4, 0.55), (1.2, 0.8)].map(|(x, y)| place(Body::First, x, y));
    let left = right.map(|(_, p)| place(Body::Second, -p.x, p.y));
    [right, left].concat()
}

/// Every solution with points of both bodies.
fn everywhere() -> impl Iterator<Item = (&'static str, &'static [(&'static str, f64)], Vec<(Body, Point)>)> {
    let squares = ON_SQUARES.into_iter().map(|(name, list)| (name, list, probes().collect()));
    squares.chain(ON_CURVES.into_iter().map(|(name, list)| (name, list, curved_probes(name))))
}

#[test]
fn body_force_is_minus_the_divergence_of_the_stress() {
    let step = 1e-6;
    for (name, list, points) in everywhere() {
        let exact = made(name, list, PAIRS[2]);
        let materials = materials(PAIRS[2]);
        for (body, at) in points {
            let material = &materials[body.index()];
            let tau = |e: Vec2| stress(&*exact, material, body, at + e);
            let (right, left) = (tau(step * Vec2::x()), tau(-step * Vec2::x()));
            let (up, down) = (tau(step * Vec2::y()), tau(-step * Vec2::y()));
            let slope = |i: usize, j: usize| ((right[i] - left[i]) + (up[j] - down[j])) / (2.0 * step);
            let expected = Vec2::new(-slope(0, 2), -slope(2, 1));
            let force = body_force(&*exact, material, body, at);
            let error = (force - expected).norm() / (1.0 + force.norm());
            assert!(error < 1e-6, "{name} {list:?} {body:?} {at:?}: {error:e}");
        }
    }
}

#[test]
fn value_jet_and_second_jet_agree() {
    for (name, list, points) in everywhere() {
        let exact = made(name, list, PAIRS[0]);
        for (body, at) in points {
            let (value, jet, jet2) = (exact.value(body, at), exact.jet(body, at), exact.jet2(body, at));
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-14 * (1.0 + a.abs());
            for i in 0..2 {
                assert!(near(value[i], jet.value[i]) && near(value[i], jet2.value[i]));
                for j in 0..2 {
                    assert!(near(jet.gradient[i][j], jet2.gradient[i][j]));
                }
                assert_eq!(jet2.hessian[i][0][1], jet2.hessian[i][1][0]);
            }
        }
    }
}

/// The three components of the traction on a slanted line by hand.
#[test]
fn traction_is_the_stress_times_the_normal() {
    let exact = made("W", &[], PAIRS[0]);
    let material = &materials(PAIRS[0])[0];
    let at = Point::new(0.6, 0.2);
    let t = stress(&*exact, material, Body::First, at);
    let n = Vec2::new(0.6, -0.8);
    let force = traction(&*exact, material, Body::First, at, n);
    let expected = Vec2::new(0.6 * t[0] - 0.8 * t[2], 0.6 * t[2] - 0.8 * t[1]);
    assert!((force - expected).norm() < 1e-15);
}

/// P(3, 2) for `(λ, μ) = (1.5, 1)` and `(3, 2)`, written out.
pub(super) const P_AS_TEXT: [[&str; 2]; 2] = [
    [
        "(sin(2*x)/10 - y*(-sin(2*x)/10 + 1.8*pos(x-s)^2))*(1-y^2)",
        "(cos(2*x)/20 + 0.6*pos(x-s)^3 + y*(-6*pos(s-x)^2 - 1.5*cos(2*x)/5)/3.5)*(1-y^2)",
    ],
    [
        "(-x^2/20 - y*(-sin(2*x)/10 - 1.2*pos(x-s)^2))*(1-y^2)",
        "(cos(2*x)/20 - 0.4*pos(x-s)^3 + y*(-6*pos(s-x)^2 + 3*x/10)/7)*(1-y^2)",
    ],
];

pub(super) fn expressions(texts: [[&str; 2]; 2]) -> Expressions {
    let s = parameters(&[("s", 1.0 / 6.0f64.sqrt())]);
    Expressions::parse(texts, &s).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn the_built_in_p_is_its_own_formula() {
    let built = made("P", &[], PAIRS[0]);
    let written = expressions(P_AS_TEXT);
    for i in 0..40 {
        let x = (f64::from(i) + 0.3) / 40.0;
        for (body, y) in [(Body::First, 0.37), (Body::Second, -0.61), (Body::First, 0.0)] {
            let at = Point::new(x, y);
            let difference = distance(&built.jet2(body, at), &written.jet2(body, at));
            assert!(difference < 1e-13, "{body:?} {at:?}: {difference:e}");
        }
    }
}

fn distance(a: &Jet2, b: &Jet2) -> f64 {
    let all = |j: &Jet2| -> Vec<f64> {
        let first = j.value.iter().chain(j.gradient.iter().flatten());
        first.chain(j.hessian.iter().flatten().flatten()).copied().collect()
    };
    let pairs = all(a).into_iter().zip(all(b));
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
