//! Displacements on curved bodies against a second evaluation in plain numbers: angles by `atan2`, derivatives of the traces
//! by hand, and the derivatives across the graph by solving for the traction in place of the lemma's matrix.

use super::*;
use signorini_contact::{Body, Vec2};

/// `λ`, `μ`, `L` of a body.
fn moduli(body: Body) -> (f64, f64, f64) {
    let l = PAIRS[2][body.index()];
    (l.lambda, l.mu, l.lambda + 2.0 * l.mu)
}

/// `ρ^α (1+cos φ)/2`, and `ρ^α sin φ` times `(1+cos φ)/2` and `(1−cos φ)/2`.
fn wedge(x: f64, y: f64, alpha: f64) -> [f64; 3] {
    let (growth, phi) = (x.hypot(y).powf(alpha), y.atan2(x));
    let half = (1.0 + phi.cos()) / 2.0;
    [growth * half, growth * phi.sin() * half, growth * phi.sin() * (1.0 - half)]
}

/// `(u_r, u_θ)` before the cutoff, without the singular part: `g = (θ−0.9)_+³` and `p` times `load`.
fn on_arc(body: Body, r: f64, theta: f64, load: f64) -> [f64; 2] {
    let (lambda, _, modulus) = moduli(body);
    let (share, a, slope_a) = match body {
        Body::First => (-0.6 * load, (2.0 * theta + 1.0).sin() / 5.0, 2.0 * (2.0 * theta + 1.0).cos() / 5.0),
        Body::Second => (0.4 * load, -theta * theta / 10.0, -theta / 5.0),
    };
    let w = (2.0 * theta).cos() / 20.0 + share * positive(theta - 0.9, 3.0);
    let slope_w = -(2.0 * theta).sin() / 10.0 + 3.0 * share * positive(theta - 0.9, 2.0);
    let p = -4.0 * load * positive(0.9 - theta, 2.0);
    [w + (r - 1.0) * (p - lambda * (w + slope_a)) / modulus, a + (r - 1.0) * (a - slope_w)]
}

fn arc_displacement(name: &str, alpha: f64, body: Body, at: Point) -> Vec2 {
    let (r, theta) = (at.norm(), at.y.atan2(at.x));
    let [mut radial, mut angular] = on_arc(body, r, theta, if name == "arcP" { 1.0 } else { 0.0 });
    if name == "arcR" {
        let (lambda, _, modulus) = moduli(body);
        let (sigma, opening) = if body == Body::First { (-1.0, -0.24) } else { (1.0, 0.16) };
        let [open, slide, press] = wedge(theta - 0.9, (r - 1.0).abs(), alpha);
        radial += opening * open * (1.0 - (r - 1.0) * lambda / modulus) - sigma * 2.0 / modulus * press;
        angular -= sigma * alpha * opening * slide;
    }
    let q = |x: f64, y: f64| if body == Body::First { x + y - 0.5 } else { (2.0 - x) * (2.0 - y) };
    let (e_r, e_theta) = (Vec2::new(theta.cos(), theta.sin()), Vec2::new(-theta.sin(), theta.cos()));
    let share = q(at.x, at.y) / q(theta.cos(), theta.sin());
    (radial * e_r + angular * e_theta) * share * (2.0 - share)
}

/// The derivatives `(c, b)` across a graph of slope `slope` with `τ (1, −F)ᵀ = (p, 0)ᵀ`: the traction is an affine function
/// of them, built from Hooke's law column by column.
fn across(body: Body, slope: f64, slope_w: f64, slope_a: f64, p: f64) -> [f64; 2] {
    let (lambda, mu, modulus) = moduli(body);
    let traction = |c: f64, b: f64, slope_w: f64, slope_a: f64| {
        // ∂_x u = (c, b), ∂_y u = (w_y − F c, a_y − F b)
        let (e11, e22, e12) = (c, slope_a - slope * b, 0.5 * (slope_w - slope * c + b));
        let (t11, t22, t12) = (modulus * e11 + lambda * e22, lambda * e11 + modulus * e22, 2.0 * mu * e12);
        [t11 - slope * t12, t12 - slope * t22]
    };
    let ([k11, k21], [k12, k22]) = (traction(1.0, 0.0, 0.0, 0.0), traction(0.0, 1.0, 0.0, 0.0));
    let [r1, r2] = traction(0.0, 0.0, slope_w, slope_a);
    let (f1, f2) = (p - r1, -r2);
    let det = k11 * k22 - k12 * k21;
    [(f1 * k22 - k12 * f2) / det, (k11 * f2 - k21 * f1) / det]
}

fn graph_displacement(name: &str, list: &[(&str, f64)], alpha: f64, body: Body, at: Point) -> Vec2 {
    let (x, y, shape) = (at.x, at.y, shape(list));
    let [f, g] = Body::BOTH.map(|b| shape.boundary(b, y));
    let (half, sigma) = if body == Body::First { (-0.5, 1.0) } else { (0.5, -1.0) };
    let [boundary, slope, _] = shape.boundary(body, y);
    let mut approach = [f[0] - g[0], f[1] - g[1]];
    let mut p = 0.0;
    let (low, high) = (-1.0 / 5.0f64.sqrt(), 1.0 / 3.0f64.sqrt());
    if name == "graphP" {
        approach[0] -= positive(low - y, 3.0) + positive(y - high, 3.0);
        approach[1] += 3.0 * positive(low - y, 2.0) - 3.0 * positive(y - high, 2.0);
        p = gap_and_force(name, list, y).1;
    }
    let (a, slope_a) = match body {
        Body::First => ((2.0 * y).sin() / 10.0, (2.0 * y).cos() / 5.0),
        Body::Second => (-y * y / 20.0, -y / 10.0),
    };
    let slope_w = -(2.0 * y).sin() / 10.0 + half * approach[1];
    let [c, b] = across(body, slope, slope_w, slope_a, p);
    let mut u = Vec2::new((2.0 * y).cos() / 20.0 + half * approach[0] + (x - boundary) * c, a + (x - boundary) * b);
    if name == "graphR" {
        let [open, slide, press] = wedge(y - high, (x - boundary).abs(), alpha);
        // The derivatives across the graph for w_y = 1, p = 0 and for w_y = 0, p = −2, each with its own field.
        let (sheared, pressed) = (across(body, slope, 1.0, 0.0, 0.0), across(body, slope, 0.0, 0.0, -2.0));
        let rate = -half * 0.4 * alpha;
        u += Vec2::new(-half * 0.4 * open, 0.0);
        u += sigma * (rate * slide * Vec2::from(sheared) + press * Vec2::from(pressed));
    }
    let q = (2.0 * sigma - x) / (2.0 * sigma - boundary);
    u * q * (2.0 - q)
}

#[test]
fn displacements_agree_with_a_second_evaluation() {
    for (name, list) in ON_CURVES {
        let exact = made(name, list, PAIRS[2]);
        let alpha = list.iter().find(|(name, _)| *name == "alpha").map_or(f64::NAN, |p| p.1);
        for i in 0..400 {
            let (s, d) = ((f64::from(i % 20) + 0.3) / 20.0, (f64::from(i / 20) + 0.1) / 20.0);
            for body in Body::BOTH {
                let sigma = if body == Body::First { 1.0 } else { -1.0 };
                let (at, expected) = if name.starts_with("arc") {
                    let theta = s * std::f64::consts::FRAC_PI_2;
                    let at = (1.0 - 0.4 * sigma * d) * Point::new(theta.cos(), theta.sin());
                    (at, arc_displacement(name, alpha, body, at))
                } else {
                    let y = 2.0 * s - 1.0;
                    let at = Point::new(shape(list).boundary(body, y)[0] + sigma * d, y);
                    (at, graph_displacement(name, list, alpha, body, at))
                };
                let error = (exact.value(body, at) - expected).norm();
                assert!(error < 1e-13, "{name} {list:?} {body:?} at {at:?}: {error:e}");
            }
        }
    }
}
