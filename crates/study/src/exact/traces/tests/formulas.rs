//! The arc and the two graphs against the closed forms written out in plain numbers, slopes by hand.

use super::*;
use crate::exact::Exact;
use signorini_contact::{Body, Vec2};

fn pos(x: f64) -> f64 {
    x.max(0.0)
}

/// The displacement near the unit circle, from `θ` and `r`.
fn by_hand_on_the_arc(body: Body, at: Point) -> Vec2 {
    let (r, theta) = (at.norm(), at.y.atan2(at.x));
    let (gap, slope) = (pos(theta - 0.9).powi(3), 3.0 * pos(theta - 0.9).powi(2));
    let p = -4.0 * pos(0.9 - theta).powi(2);
    let (share, a, a_slope, lambda, modulus) = match body {
        Body::First => (-0.6, (2.0 * theta + 1.0).sin() / 5.0, 0.4 * (2.0 * theta + 1.0).cos(), 1.5, 3.5),
        Body::Second => (0.4, -theta * theta / 10.0, -theta / 5.0, 3.0, 7.0),
    };
    let w = (2.0 * theta).cos() / 20.0 + share * gap;
    let w_slope = -(2.0 * theta).sin() / 10.0 + share * slope;
    let u_r = w + (r - 1.0) * (p - lambda * (w + a_slope)) / modulus;
    let u_theta = a + (r - 1.0) * (a - w_slope);
    let q = |p: Point| match body {
        Body::First => p.x + p.y - 0.5,
        Body::Second => (2.0 - p.x) * (2.0 - p.y),
    };
    let share = q(at) / q(at / r);
    let (sin, cos) = theta.sin_cos();
    share * (2.0 - share) * Vec2::new(u_r * cos - u_theta * sin, u_r * sin + u_theta * cos)
}

/// The displacement beside the graphs.
fn by_hand_on_the_graphs(body: Body, at: Point) -> Vec2 {
    let (x, y) = (at.x, at.y);
    let [(_, c1), (_, c2)] = ends();
    let gap = pos(-c1 - y).powi(3) + pos(y - c2).powi(3);
    let gap_slope = 3.0 * (pos(y - c2).powi(2) - pos(-c1 - y).powi(2));
    let (width, width_slope) = (0.4 * y * y + 0.05 * y.powi(3) - gap, 0.8 * y + 0.15 * y * y - gap_slope);
    let p = -12.0 * pos((y + c1) * (c2 - y)).powi(2);
    let (side, f, slope, a, a_slope, lame, far) = match body {
        Body::First => {
            let (f, slope) = (y * y / 4.0 + y.powi(3) / 20.0, y / 2.0 + 3.0 * y * y / 20.0);
            (-0.5, f, slope, (2.0 * y).sin() / 10.0, (2.0 * y).cos() / 5.0, SOFT, 2.0)
        }
        Body::Second => (0.5, -3.0 * y * y / 20.0, -3.0 * y / 10.0, -y * y / 20.0, -y / 10.0, STIFF, -2.0),
    };
    let w = (2.0 * y).cos() / 20.0 + side * width;
    let w_slope = -(2.0 * y).sin() / 10.0 + side * width_slope;
    let (lambda, mu) = (lame.lambda, lame.mu);
    let modulus = lambda + 2.0 * mu;
    // The two conditions on c and b as a linear system: row by row of τ (1, −F)ᵀ with ∂_x u = (c, b),
    // ∂_y u = (w_η − F c, a_η − F b), solved by Cramer's rule.
    let [a11, a12] = [modulus + mu * slope * slope, -(lambda + mu) * slope];
    let [a21, a22] = [-(lambda + mu) * slope, mu + modulus * slope * slope];
    let r1 = p - lambda * a_slope + mu * slope * w_slope;
    let r2 = -mu * w_slope + modulus * slope * a_slope;
    let determinant = a11 * a22 - a12 * a21;
    let (c, b) = ((r1 * a22 - a12 * r2) / determinant, (a11 * r2 - a21 * r1) / determinant);
    let share = (far - x) / (far - f);
    share * (2.0 - share) * Vec2::new(w + (x - f) * c, a + (x - f) * b)
}

/// Value against value, first and second derivatives against central differences of the plain formula.
fn compare(exact: &dyn Exact, plain: impl Fn(Body, Point) -> Vec2, body: Body, at: Point) {
    let jet = exact.jet2(body, at);
    assert!((jet.value - plain(body, at)).norm() < 1e-13, "{body:?} {at:?}");
    let step = 1e-3;
    let [ex, ey] = [step * Vec2::x(), step * Vec2::y()];
    let u = |e: Vec2| plain(body, at + e);
    // Fourth order, so that a step that leaves rounding small has a small error of its own.
    let slope = |e: Vec2| (8.0 * (u(e) - u(-e)) - (u(2.0 * e) - u(-2.0 * e))) / (12.0 * step);
    let bend =
        |e: Vec2| (16.0 * (u(e) + u(-e)) - u(2.0 * e) - u(-2.0 * e) - 30.0 * u(Vec2::zeros())) / (12.0 * step * step);
    let mixed = (u(ex + ey) - u(ex - ey) - u(ey - ex) + u(-ex - ey)) / (4.0 * step * step);
    for i in 0..2 {
        let pairs = [
            (slope(ex)[i], jet.gradient[i][0], 1e-9),
            (slope(ey)[i], jet.gradient[i][1], 1e-9),
            (bend(ex)[i], jet.hessian[i][0][0], 1e-6),
            (bend(ey)[i], jet.hessian[i][1][1], 1e-6),
            (mixed[i], jet.hessian[i][0][1], 1e-4),
        ];
        for (k, (difference, exact, tolerance)) in pairs.into_iter().enumerate() {
            let error = (difference - exact).abs();
            assert!(error < tolerance * (1.0 + exact.abs()), "{body:?} {at:?}, entry {k}: {difference} ≠ {exact}");
        }
    }
}

#[test]
fn the_arc_has_its_closed_form() {
    let exact = traces(&ARC, &[], [SOFT, STIFF]);
    for i in 0..12 {
        // No point within two steps of the switch at 0.9.
        let theta = 0.05 + 0.127 * f64::from(i);
        for (body, r) in [(Body::First, 0.8), (Body::First, 0.97), (Body::Second, 1.04), (Body::Second, 1.6)] {
            compare(&exact, by_hand_on_the_arc, body, r * Vec2::new(theta.cos(), theta.sin()));
        }
    }
}

#[test]
fn the_graphs_have_their_closed_form() {
    let exact = traces(&GRAPH, &ends(), [SOFT, STIFF]);
    for i in 0..13 {
        let y = -0.95 + 0.157 * f64::from(i);
        for (body, x) in [(Body::First, 0.4), (Body::First, 1.7), (Body::Second, -0.3), (Body::Second, -1.4)] {
            compare(&exact, by_hand_on_the_graphs, body, Point::new(x, y));
        }
    }
}
