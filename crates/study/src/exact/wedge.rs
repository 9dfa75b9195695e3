//! The three fields that a switch point of chosen regularity is made of.
//!
//! In polar coordinates `r, θ` of the half plane `Y ≥ 0`, `θ` measured from the open side, for `0 < α < 2`:
//!
//! | field | on `Y = 0` | its `∂_Y` there |
//! | --- | --- | --- |
//! | `open = r^α (1+cos θ)/2` | `X_+^α` | 0 |
//! | `slide = r^α sin θ (1+cos θ)/2` | 0 | `X_+^{α−1}` |
//! | `press = r^α sin θ (1−cos θ)/2` | 0 | `(−X)_+^{α−1}` |
//!
//! So `open` prescribes a gap, `slide` frees the open side of the shear stress that comes with it, and `press` makes
//! the pressure. All three are smooth off the origin and lie in `H^{1+α−δ}`.

use super::polar::{Polar, tip};
use crate::expr::Real;

/// Values at one point `(X, Y)`.
pub(super) struct Wedge<D> {
    /// `r^α (1+cos θ)/2`.
    pub open: D,
    /// `r^α sin θ (1+cos θ)/2`.
    pub slide: D,
    /// `r^α sin θ (1−cos θ)/2`.
    pub press: D,
}

impl<D: Real> Wedge<D> {
    /// At `(X, Y)`. At the origin all three vanish; first derivatives exist there only for `α > 1`.
    pub(super) fn new(x: D, y: D, alpha: f64) -> Self {
        let Some(polar) = Polar::new(x, y) else {
            let zero = tip(x, y, if alpha > 1.0 { 0.0 } else { f64::INFINITY });
            return Self { open: zero, slide: zero, press: zero };
        };
        let growth = polar.radius_power(alpha);
        let (sine, plus, minus) = polar.angle();
        Self { open: growth * plus, slide: growth * sine * plus, press: growth * sine * minus }
    }
}

/// What the record says of an exponent for which the body force, `~ r^{α−2}`, is not square integrable.
pub(super) fn notes(alpha: f64) -> Vec<String> {
    if alpha > 1.0 {
        return Vec::new();
    }
    vec![format!("α = {alpha}: the body force is not square integrable near the switch point")]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Dual;

    /// The table above, on both sides of the origin, and the formulas in plain polar coordinates inside.
    #[test]
    fn traces_and_normal_derivatives_are_the_stated_ones() {
        for alpha in [0.4, 1.0, 1.5] {
            for x in [0.3, -0.3] {
                let [a, b] = [Dual::variable(x, 0), Dual::variable(0.0, 1)];
                let w = Wedge::new(a, b, alpha);
                let (open, closed) = if x > 0.0 { (1.0, 0.0) } else { (0.0, 1.0) };
                let (value, slope) = (0.3f64.powf(alpha), 0.3f64.powf(alpha - 1.0));
                let expected = [(open * value, 0.0), (0.0, open * slope), (0.0, closed * slope)];
                for (got, (trace, normal)) in [w.open, w.slide, w.press].into_iter().zip(expected) {
                    assert!((got.re - trace).abs() < 1e-15 && (got.gradient[1] - normal).abs() < 1e-14);
                }
            }
            for theta in [0.4f64, 1.7, 3.1] {
                let w = Wedge::new(0.2 * theta.cos(), 0.2 * theta.sin(), alpha);
                let growth = 0.2f64.powf(alpha);
                let half = (theta / 2.0).cos().powi(2);
                assert!((w.open - growth * half).abs() < 1e-15);
                assert!((w.slide - growth * theta.sin() * half).abs() < 1e-15);
                assert!((w.press - growth * theta.sin() * (1.0 - half)).abs() < 1e-15);
            }
        }
    }
}
