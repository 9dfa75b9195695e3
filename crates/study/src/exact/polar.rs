//! Half a neighbourhood of a switch point: `X = x − s`, `Y = |y| ≥ 0`, with the functions of `r, θ` that singular
//! solutions are made of, free of `atan2` and of cancellation.

use crate::expr::{Real, power, sqrt};

/// A point `(X, Y)`, `Y ≥ 0`, off the origin, with its distance.
pub(super) struct Polar<D> {
    x: D,
    y: D,
    squared: D,
    /// `r`.
    r: D,
}

impl<D: Real> Polar<D> {
    /// `None` at the origin itself.
    pub(super) fn new(x: D, y: D) -> Option<Self> {
        let squared = x * x + y * y;
        (squared.re() > 0.0).then(|| Self { x, y, squared, r: sqrt(squared) })
    }

    /// Real and imaginary part of `ζ^{1/2}`, `ζ = X + iY`.
    pub(super) fn complex_root(&self) -> (D, D) {
        let [p, q] = root(self.x.re(), self.y.re(), self.r.re());
        // f' = ½ ζ^{−1/2} = ½ conj(f)/r,  f'' = −f'/(2ζ) = −½ f' conj(ζ)/r²
        let half = 0.5 / self.r.re();
        let (a, b) = (p * half, -q * half);
        let (x, y) = (half * self.x.re(), half * self.y.re());
        let (c, d) = (-(a * x + b * y) / self.r.re(), -(b * x - a * y) / self.r.re());
        // ∂_x f = f', ∂_y f = i f', ∂_yy f = −f''
        let real = D::chain_plane(self.x, self.y, p, [a, -b], [c, -d, -c]);
        let imaginary = D::chain_plane(self.x, self.y, q, [b, a], [d, c, -d]);
        (real, imaginary)
    }

    /// `(sin θ, (1+cos θ)/2, (1−cos θ)/2)`.
    pub(super) fn angle(&self) -> (D, D, D) {
        let sine = self.y / self.r;
        // The smaller of the two halves, (1−|cos θ|)/2 = Y²/(2r(r+|X|)), is computed without cancellation.
        if self.x.re() >= 0.0 {
            let small = sine * self.y / (self.r + self.x) * 0.5;
            (sine, -small + 1.0, small)
        } else {
            let small = sine * self.y / (self.r - self.x) * 0.5;
            (sine, small, -small + 1.0)
        }
    }

    /// `r^α`.
    pub(super) fn radius_power(&self, alpha: f64) -> D {
        power(self.squared, 0.5 * alpha)
    }
}

/// `ζ^{1/2} = p + iq`: `p² − q² = X`, `2pq = Y`; the larger of the two first, so that nothing cancels.
fn root(x: f64, y: f64, r: f64) -> [f64; 2] {
    if x >= 0.0 {
        let p = (0.5 * (r + x)).sqrt();
        [p, 0.5 * y / p]
    } else {
        let q = (0.5 * (r - x)).sqrt();
        [0.5 * y / q, q]
    }
}

/// Zero at the origin, with first derivatives `slope` and infinite second ones: a singular solution at its own tip.
pub(super) fn tip<D: Real>(x: D, y: D, slope: f64) -> D {
    x.chain(0.0, slope, f64::INFINITY) + y.chain(0.0, slope, f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Dual, Dual2};

    const PI: f64 = std::f64::consts::PI;

    #[test]
    fn root_and_angle_agree_with_polar_coordinates_at_every_angle() {
        for i in 0..=64 {
            let theta = PI * f64::from(i) / 64.0;
            let (x, y) = (0.3 * theta.cos(), 0.3 * theta.sin());
            let polar = Polar::new(x, y).unwrap();
            let (p, q) = polar.complex_root();
            let root = 0.3f64.sqrt();
            assert!((p - root * (theta / 2.0).cos()).abs() < 1e-15);
            assert!((q - root * (theta / 2.0).sin()).abs() < 1e-15);
            let (sine, plus, minus) = polar.angle();
            assert!((sine - theta.sin()).abs() < 1e-15);
            assert!((plus - (theta / 2.0).cos().powi(2)).abs() < 1e-15);
            assert!((minus - (theta / 2.0).sin().powi(2)).abs() < 1e-15);
        }
    }

    #[test]
    fn a_negative_zero_stays_on_the_upper_side() {
        let (p, q) = Polar::new(-0.25, -0.0).unwrap().complex_root();
        assert_eq!((p.abs(), q), (0.0, 0.5));
    }

    #[test]
    fn nothing_cancels_near_the_negative_axis() {
        // (1+cos θ)/2 ≈ (π−θ)²/4 far below the rounding of cos θ.
        let (_, plus, _) = Polar::new(-1.0, 1e-10).unwrap().angle();
        assert!((plus / 2.5e-21 - 1.0).abs() < 1e-12, "{plus:e}");
    }

    /// `ζ^{1/2}` is analytic: its parts satisfy the Cauchy–Riemann equations and are harmonic.
    #[test]
    fn the_root_is_analytic() {
        for (a, b) in [(0.2, 0.0), (-0.2, 0.0), (0.1, 0.3), (-0.1, 0.3), (0.0, 0.5)] {
            let x = Dual2::variable(a, 0);
            let y = Dual2::variable(b, 1);
            let (p, q) = Polar::new(x, y).unwrap().complex_root();
            let (dp, dq) = (p.gradient, q.gradient);
            assert!((dp[0] - dq[1]).abs() < 1e-13 && (dp[1] + dq[0]).abs() < 1e-13);
            for part in [p, q] {
                let [xx, xy, yy] = part.hessian;
                assert!((xx + yy).abs() < 1e-12 * (xx.abs() + xy.abs()));
            }
        }
    }

    #[test]
    fn a_tip_is_zero_with_honest_derivatives() {
        let x = Dual::variable(0.0, 0);
        let y = Dual::variable(0.0, 1);
        let t = tip(x, y, f64::INFINITY);
        assert_eq!(t.re, 0.0);
        assert!(t.gradient.iter().all(|d| d.is_infinite()));
    }
}
