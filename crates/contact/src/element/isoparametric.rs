//! Zlámal's element: linear functions on the reference triangle, carried over by a map that is exact on the arc (2.8).
//!
//! ```text
//! F(r, t) = A + r (S − A) + t (B − A) + (1 − r − t) q(t),    q(t) = (γ(t) − A − t (B − A)) / (1 − t)
//! ```
//!
//! On the arc (`r = 0`) this is `γ(t)` and the hat functions are `1 − t` and `t`: traces are linear in the curve's
//! parameter. M. Zlámal, *Curved elements in the finite element method I*, SIAM J. Numer. Anal. 10 (1973).

use super::curved::{CurvedTriangle, ElementPoint};
use crate::geometry::{Point, Vec2, cross};

/// The view of a curved triangle as this element.
pub(super) struct Isoparametric<'a> {
    /// The triangle.
    pub triangle: &'a CurvedTriangle<'a>,
    /// See [`super::CurvedElement::Isoparametric`].
    pub skew: f64,
}

/// Closer to `t = 1` than this, `q` and its derivative are replaced by their limits.
const END: f64 = 1e-12;

/// Most steps of Newton's method; a handful is enough where the map does not fold.
const STEPS: u32 = 20;

/// A step this small moves nothing but the last digits.
const ROUNDING: f64 = 1e-15;

/// A point of the reference triangle and its image.
struct Image {
    /// The hat functions of `S, A, B`.
    coordinates: [f64; 3],
    x: Point,
    by_r: Vec2,
    by_t: Vec2,
    det: f64,
}

impl Image {
    fn grad_t(&self) -> Vec2 {
        Vec2::new(self.by_r.y, -self.by_r.x) / self.det
    }

    fn grad_r(&self) -> Vec2 {
        Vec2::new(-self.by_t.y, self.by_t.x) / self.det
    }
}

impl Isoparametric<'_> {
    /// `r = 1 − ρ`, `t = ρ τ`.
    pub fn at(&self, rho: f64, tau: f64) -> ElementPoint {
        self.point(rho, &self.image(1.0 - rho, rho * tau, rho * (1.0 - tau)))
    }

    /// The point whose image is `x`, by Newton's method for `F(r, t) = x` from the given coordinates `(r, t)`.
    pub fn at_place(&self, x: Point, [mut r, mut t]: [f64; 2]) -> ElementPoint {
        let mut image = self.image(r, t, 1.0 - r - t);
        for _ in 0..STEPS {
            let miss = x - image.x;
            let (dr, dt) = (image.grad_r().dot(&miss), image.grad_t().dot(&miss));
            (r, t) = (r + dr, t + dt);
            image = self.image(r, t, 1.0 - r - t);
            if dr.abs().max(dt.abs()) < ROUNDING {
                break;
            }
        }
        self.point(1.0 - r, &image)
    }

    /// `F(r, t)` and its derivatives; `rest = 1 − r − t`.
    fn image(&self, r: f64, t: f64, rest: f64) -> Image {
        let [s, a, b] = self.triangle.from_apex();
        let (q, slope) = self.bump(t);
        let x = a + r * (s - a) + t * (b - a) + rest * q;
        let by_r = (s - a) - q;
        let by_t = (b - a) - q + rest * slope;
        // ∂x/∂(t, r), positive since S, A, B run counterclockwise
        Image { coordinates: [r, rest, t], x, by_r, by_t, det: cross(by_t, by_r) }
    }

    fn point(&self, rho: f64, image: &Image) -> ElementPoint {
        let (grad_t, grad_r) = (image.grad_t(), image.grad_r());
        ElementPoint {
            x: image.x,
            jacobian: rho * image.det,
            hats: self.in_order(image.coordinates),
            gradients: self.in_order([grad_r, -grad_r - grad_t, grad_t]),
        }
    }

    /// The hat functions at `γ(s)`: the reference coordinate is the `t` with `t + k t(1−t) = s`.
    pub fn trace(&self, s: f64) -> [f64; 3] {
        let (k, linear) = (self.skew, 1.0 + self.skew);
        // k t² − (1 + k) t + s = 0, the root that tends to s for k → 0
        let t = 2.0 * s / (linear + (linear * linear - 4.0 * k * s).sqrt());
        self.in_order([0.0, 1.0 - t, t])
    }

    /// `q(t)` and `q'(t)`.
    fn bump(&self, t: f64) -> (Vec2, Vec2) {
        let [_, a, b] = self.triangle.from_apex();
        let k = self.skew;
        let (gamma, velocity) = self.triangle.arc(t + k * t * (1.0 - t));
        let bump = gamma - ((1.0 - t) * a + t * b);
        let slope = velocity * (1.0 + k * (1.0 - 2.0 * t)) - (b - a);
        let left = 1.0 - t;
        if left < END {
            return (-slope, Vec2::zeros());
        }
        (bump / left, slope / left + bump / (left * left))
    }

    /// From `S, A, B` to the order of the corners.
    fn in_order<T: Copy>(&self, [s, a, b]: [T; 3]) -> [T; 3] {
        let from_apex = [s, a, b];
        [0, 1, 2].map(|corner| from_apex[(corner + 3 - self.triangle.apex) % 3])
    }
}
