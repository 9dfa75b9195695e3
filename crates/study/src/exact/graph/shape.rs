//! The boundaries of the bodies of the graph lemma, for several kinds of gap.

use signorini_contact::geometry::{Graph, SharedCurve};
use signorini_contact::{Body, ContactLine, Vec2};
use std::sync::Arc;

use crate::expr::Real;

/// The graphs `x = f'(y)`, `x = f''(y)`, `−1 ≤ y ≤ 1`, by the curvature of their gap `ε = f' − f'' ≥ 0`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GapShape {
    /// `f' = y²/4 + y³/20`, `f'' = −3y²/20`: the bodies touch at `y = 0`, and `ε` is convex. Between two nodes its
    /// interpolant lies above it, so discrete bodies may penetrate.
    Convex,
    /// `f' = 3/20 − y²/10 − y³/20`, `f'' = −3/20 + y²/10`: `ε` is concave, nowhere zero.
    Concave,
    /// `f' = 1/10 + y²/8 + y³/10`, `f'' = −1/10 + y²/8 − y³/20`: `ε = 1/5 + 3y³/20` is concave for `y < 0` and convex for
    /// `y > 0`.
    BothSigns,
}

impl GapShape {
    /// Every shape, in the order of the parameter `gap`.
    pub const ALL: [Self; 3] = [Self::Convex, Self::Concave, Self::BothSigns];

    /// By the parameter `gap` of the built-in solutions: 0 convex, 1 concave, 2 of both signs.
    ///
    /// # Errors
    /// If it is another number.
    pub fn from_parameter(gap: f64) -> Result<Self, String> {
        crate::exact::parameters::whole("gap", gap, 0.0, 2.0)?;
        Ok(Self::ALL[gap as usize])
    }

    /// Coefficients of `1, y, y², y³` in the boundary of `body`.
    pub fn coefficients(self, body: Body) -> [f64; 4] {
        match (self, body) {
            (Self::Convex, Body::First) => [0.0, 0.0, 0.25, 0.05],
            (Self::Convex, Body::Second) => [0.0, 0.0, -0.15, 0.0],
            (Self::Concave, Body::First) => [0.15, 0.0, -0.1, -0.05],
            (Self::Concave, Body::Second) => [-0.15, 0.0, 0.1, 0.0],
            (Self::BothSigns, Body::First) => [0.1, 0.0, 0.125, 0.1],
            (Self::BothSigns, Body::Second) => [-0.1, 0.0, 0.125, -0.05],
        }
    }

    /// `f`, `f_y` and `f_yy` of `body` at `y`.
    pub fn boundary(self, body: Body, y: f64) -> [f64; 3] {
        let c = self.coefficients(body);
        let [f, slope] = cubic(&c, y);
        [f, slope, 2.0 * c[2] + 6.0 * c[3] * y]
    }

    /// The contact zone between the two graphs over `−1 ≤ y ≤ 1`, `e_ξ = e_x`. Both graphs run downwards, which has `Ω'`, on the
    /// right of the gap, on the left of its own.
    pub fn contact_line(self) -> ContactLine {
        let graph = |body| -> SharedCurve {
            let [c0, c1, c2, c3] = self.coefficients(body);
            Arc::new(Graph {
                function: Arc::new(move |y| self.boundary(body, y)),
                name: format!("{c0} + {c1} y + {c2} y^2 + {c3} y^3"),
                direction: Vec2::x(),
                from: 1.0,
                to: -1.0,
            })
        };
        ContactLine::Gap { curves: Body::BOTH.map(graph), direction: Vec2::x() }
    }

    /// `f` and `F = f_y` of `body`.
    pub(super) fn graph<D: Real>(self, body: Body, y: D) -> [D; 2] {
        cubic(&self.coefficients(body), y)
    }

    /// `ε = f' − f''` and its derivative; the difference is taken of the coefficients.
    pub(super) fn gap<D: Real>(self, y: D) -> [D; 2] {
        let [first, second] = Body::BOTH.map(|b| self.coefficients(b));
        cubic(&std::array::from_fn(|i| first[i] - second[i]), y)
    }
}

/// A cubic and its derivative.
fn cubic<D: Real>(c: &[f64; 4], y: D) -> [D; 2] {
    let value = ((y * c[3] + c[2]) * y + c[1]) * y + c[0];
    let slope = (y * (3.0 * c[3]) + 2.0 * c[2]) * y + c[1];
    [value, slope]
}
