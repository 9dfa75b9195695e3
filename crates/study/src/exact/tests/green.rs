//! Green's formula on patches beside the curved zones: with the stated contact force `T`, for smooth fields `φ` that vanish
//! on the rest of the patch's boundary,
//!
//! ```text
//! ∫_ω' τ:ε(φ) − F·φ dx = ∫ T n·φ dμ,      ∫_ω'' τ:ε(φ) − F·φ dx = −∫ T n·φ dμ
//! ```
//!
//! with `n = e_r`, `dμ = dθ` on the arc and `n = −e_x`, `dμ = dy` on the graphs. It ties the signs of both bodies, and the
//! factor `1/cos α` of the force per unit of `y`, to the weak form.

use super::*;
use crate::exact::Field;
use crate::exact::derived::{body_force_of, stress};
use crate::expr::{Real, atan2, sqrt};
use signorini_contact::quadrature::GAUSS_8;
use signorini_contact::{Body, Vec2};

/// A patch beside the zone, `from ≤ s ≤ to` along it and `0 ≤ d ≤ depth` into the body, with a field that vanishes on its
/// three inner sides.
struct Patch {
    /// The graphs; none on the arc.
    shape: Option<GapShape>,
    along: [f64; 2],
    depth: f64,
}

impl Patch {
    /// `x`, and the Jacobian of `(s, d) → x`.
    fn point(&self, body: Body, s: f64, d: f64) -> (Point, f64) {
        match (self.shape, body) {
            (None, Body::First) => ((1.0 - d) * Point::new(s.cos(), s.sin()), 1.0 - d),
            (None, Body::Second) => ((1.0 + d) * Point::new(s.cos(), s.sin()), 1.0 + d),
            (Some(shape), Body::First) => (Point::new(shape.boundary(body, s)[0] + d, s), 1.0),
            (Some(shape), Body::Second) => (Point::new(shape.boundary(body, s)[0] - d, s), 1.0),
        }
    }

    fn normal(&self, s: f64) -> Vec2 {
        if self.shape.is_some() { -Vec2::x() } else { Vec2::new(s.cos(), s.sin()) }
    }
}

impl Field for Patch {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let (s, height) = match self.shape {
            None => (atan2(y, x), -sqrt(x * x + y * y) + 1.0),
            Some(shape) => (y, x - graph(shape.coefficients(body), y)),
        };
        let d = if body == Body::First { height } else { -height };
        let across = -d / self.depth + 1.0;
        let bump = (s - self.along[0]) * (-s + self.along[1]) * across;
        let bump = bump * bump;
        [bump * (x + 1.0), bump * (-y + 2.0)]
    }
}

/// `x = f(y)`.
fn graph<D: Real>([c0, c1, c2, c3]: [f64; 4], y: D) -> D {
    y * c1 + y * y * c2 + y * y * y * c3 + c0
}

/// Ends of the panels of a composite rule between `from` and `to`: equal ones, or halved again and again towards `from`.
fn panels(from: f64, to: f64, graded: bool) -> Vec<[f64; 2]> {
    const LEVELS: i32 = 18;
    let mut shares: Vec<f64> =
        if graded { (0..LEVELS).rev().map(|k| 0.5f64.powi(k)).collect() } else { vec![0.25, 0.5, 0.75, 1.0] };
    shares.insert(0, 0.0);
    shares.windows(2).map(|w| [from + w[0] * (to - from), from + w[1] * (to - from)]).collect()
}

/// Points and weights of Gauss's rule on every panel.
fn rule(panels: &[[f64; 2]]) -> Vec<(f64, f64)> {
    let on = |&[a, b]: &[f64; 2]| GAUSS_8.map(|(x, w)| (a + x * (b - a), w * (b - a).abs()));
    panels.iter().flat_map(on).collect()
}

/// `∫_ω τ:ε(φ) − F·φ dx`, and `∫_ω |τ:ε(φ)| dx` to compare with.
fn work(exact: &dyn Exact, patch: &Patch, body: Body, along: &[(f64, f64)], across: &[(f64, f64)]) -> (f64, f64) {
    let material = materials(PAIRS[2])[body.index()];
    let (mut sum, mut size) = (0.0, 0.0);
    for &(s, ws) in along {
        for &(d, wd) in across {
            let (at, jacobian) = patch.point(body, s, d);
            let (tau, phi) = (stress(exact, &material, body, at), patch.jet(body, at));
            let g = phi.gradient;
            let inner = tau[0] * g[0][0] + tau[1] * g[1][1] + tau[2] * (g[0][1] + g[1][0]);
            let force = body_force_of(&exact.jet2(body, at), &material);
            sum += ws * wd * jacobian * (inner - force.dot(&phi.value));
            size += ws * wd * jacobian * inner.abs();
        }
    }
    (sum, size)
}

#[test]
fn contact_forces_satisfy_greens_formula_in_both_bodies() {
    for (name, list) in ON_CURVES.into_iter().filter(|(_, list)| !list.contains(&("alpha", 0.4))) {
        let exact = made(name, list, PAIRS[2]);
        let (on_arc, graded) = (name.starts_with("arc"), name.ends_with('R'));
        let patch = Patch {
            shape: (!on_arc).then(|| shape(list)),
            along: if on_arc { [0.5, 1.4] } else { [-0.8, 0.9] },
            depth: 0.4,
        };
        let (low, high) = (-1.0 / 5.0f64.sqrt(), 1.0 / 3.0f64.sqrt());
        let ([a, b], s) = (patch.along, if on_arc { 0.9 } else { high });
        let mut ends = [panels(s, a, graded), panels(s, b, graded)].concat();
        if name == "graphP" {
            ends = [panels(a, low, false), panels(low, high, false), panels(high, b, false)].concat();
        }
        let (along, across) = (rule(&ends), rule(&panels(0.0, patch.depth, graded)));
        for (body, sign) in [(Body::First, 1.0), (Body::Second, -1.0)] {
            let (inside, size) = work(&*exact, &patch, body, &along, &across);
            let of_forces = |weight: &dyn Fn(f64) -> f64| -> f64 {
                let term = |&(s, w): &(f64, f64)| {
                    let phi = patch.value(body, patch.point(body, s, 0.0).0);
                    w * weight(s) * gap_and_force(name, list, s).1 * patch.normal(s).dot(&phi)
                };
                sign * along.iter().map(term).sum::<f64>()
            };
            let forces = of_forces(&|_| 1.0);
            let tolerance = if graded { 1e-5 } else { 1e-10 } * size;
            let what = format!("{name} {list:?} {body:?}: {inside:e} {forces:e} {size:e}");
            assert!((inside - forces).abs() < tolerance, "{what}");
            // The formula sees the sign, and on the graphs the difference of dy and ds.
            assert!(forces.abs() > 1e-2 * size, "{what}");
            if let Some(shape) = patch.shape {
                let per_length = of_forces(&|s| shape.boundary(body, s)[1].hypot(1.0));
                assert!((inside - per_length).abs() > 1e-4 * size, "{what}: {per_length:e}");
            }
        }
    }
}
