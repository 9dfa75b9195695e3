//! A triangle with one curved side: its exact region, and the points where integrals over it are taken.
//!
//! ```text
//!            S                Corners S, A, B counterclockwise; the arc γ(t) runs from A (t = 0) to B (t = 1).
//!           / \               Bulging: the arc lies beyond the chord. Bitten: it cuts into the chord triangle.
//!          /   \
//!         A     B             Every point has coordinates (ρ, τ) ∈ [0,1]²: ρ = 0 is S, ρ = 1 the arc. How they map
//!          `-γ-´              to the plane, and what the hat functions are, is the element's own affair.
//! ```

use super::isoparametric::Isoparametric;
use super::physical::Physical;
use super::stiffness_block;
use crate::geometry::{Curve, Point, Vec2, cross, twice_area};
use crate::material::Material;
use crate::quadrature::GAUSS_8;

/// What displacements are on a triangle with a curved side.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum CurvedElement {
    /// Linear in the physical coordinates on the exact region (2.4).
    #[default]
    Physical,
    /// Zlámal's map of the reference triangle (2.8).
    Isoparametric {
        /// Share `k` by which the arc's parameter departs from a multiple of the reference coordinate, `t + k t(1−t)`: zero
        /// for traces that are linear in the curve's parameter, as (2.10) needs them.
        skew: f64,
    },
}

/// A triangle whose side opposite the corner `apex` is a piece of a curve.
#[derive(Clone, Copy, Debug)]
pub struct CurvedTriangle<'a> {
    /// Corners, counterclockwise.
    pub corners: [Point; 3],
    /// The corner `S` between the two straight sides.
    pub apex: usize,
    /// The curve of the side opposite.
    pub curve: &'a dyn Curve,
    /// Parameters of the curve at `A` (corner `apex + 1`) and `B` (corner `apex + 2`).
    pub span: [f64; 2],
    /// The element.
    pub element: CurvedElement,
}

/// A point of a curved triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementPoint {
    /// Where it is.
    pub x: Point,
    /// Jacobian determinant `∂x/∂(ρ, τ)`.
    pub jacobian: f64,
    /// Values of the hat functions of the three corners.
    pub hats: [f64; 3],
    /// Their gradients.
    pub gradients: [Vec2; 3],
}

impl ElementPoint {
    /// The displacement with the given values at the corners.
    pub fn value(&self, corners: &[Vec2; 3]) -> Vec2 {
        (0..3).map(|k| self.hats[k] * corners[k]).sum()
    }

    /// Its gradient, `g[i][j] = ∂_j u_i`.
    pub fn gradient(&self, corners: &[Vec2; 3]) -> [[f64; 2]; 2] {
        super::displacement_gradient(&self.gradients, *corners)
    }
}

impl CurvedTriangle<'_> {
    /// The corners `S, A, B`.
    pub fn from_apex(&self) -> [Point; 3] {
        [0, 1, 2].map(|k| self.corners[(self.apex + k) % 3])
    }

    /// The arc's point `γ` and derivative `dγ/dt` at the share `t` of its parameter.
    pub fn arc(&self, t: f64) -> (Point, Vec2) {
        let width = self.span[1] - self.span[0];
        let s = self.span[0] + t * width;
        let (point, velocity) = self.curve.point_and_velocity(s);
        (point, width * velocity)
    }

    /// The point with the coordinates `(ρ, τ)`.
    pub fn at(&self, rho: f64, tau: f64) -> ElementPoint {
        match self.element {
            CurvedElement::Physical => Physical(self).at(rho, tau),
            CurvedElement::Isoparametric { skew } => Isoparametric { triangle: self, skew }.at(rho, tau),
        }
    }

    /// The hat functions on the arc, at the share `t` of its parameter.
    pub fn trace(&self, t: f64) -> [f64; 3] {
        match self.element {
            CurvedElement::Physical => Physical(self).trace(t),
            CurvedElement::Isoparametric { skew } => Isoparametric { triangle: self, skew }.trace(t),
        }
    }

    /// The exact area: chord triangle and segment between chord and arc.
    pub fn area(&self) -> f64 {
        let [s, a, b] = self.from_apex();
        // |T| = |SAB| + ½ ∫ (γ − A) × γ' dt
        let sector = |t: f64| {
            let (x, v) = self.arc(t);
            0.5 * cross(x - a, v)
        };
        const PARTS: u32 = 4;
        let part = |k: u32| {
            let left = f64::from(k) / f64::from(PARTS);
            GAUSS_8.iter().map(|&(x, w)| w / f64::from(PARTS) * sector(left + x / f64::from(PARTS))).sum::<f64>()
        };
        0.5 * twice_area(s, a, b) + (0..PARTS).map(part).sum::<f64>()
    }

    /// The largest distance of two of its points, seen from the corners and along the arc.
    pub fn diameter(&self) -> f64 {
        const SAMPLES: u32 = 8;
        let arc: Vec<Point> = (0..=SAMPLES).map(|k| self.arc(f64::from(k) / f64::from(SAMPLES)).0).collect();
        let from = |x: &Point| arc.iter().map(|y| (x - y).norm()).fold(0.0, f64::max);
        arc.iter().chain([&self.corners[self.apex]]).map(from).fold(0.0, f64::max)
    }

    /// Calls `visit(point, weight)` at 64 points, enough for smooth integrands.
    pub fn points(&self, visit: &mut impl FnMut(&ElementPoint, f64)) {
        self.points_within([0.0, 1.0], [0.0, 1.0], visit);
    }

    /// The same on a patch of the coordinates `(ρ, τ)`.
    pub fn points_within(&self, rho: [f64; 2], tau: [f64; 2], visit: &mut impl FnMut(&ElementPoint, f64)) {
        self.points_by(&GAUSS_8, rho, tau, visit);
    }

    /// The same by the product of another rule on `(0, 1)` with itself: `rule` holds nodes and weights.
    pub fn points_by(
        &self,
        rule: &[(f64, f64)],
        rho: [f64; 2],
        tau: [f64; 2],
        visit: &mut impl FnMut(&ElementPoint, f64),
    ) {
        let (dr, dt) = (rho[1] - rho[0], tau[1] - tau[0]);
        for &(r, wr) in rule {
            for &(t, wt) in rule {
                let point = self.at(rho[0] + r * dr, tau[0] + t * dt);
                visit(&point, wr * wt * dr * dt * point.jacobian);
            }
        }
    }

    /// The smallest Jacobian determinant of the map at the quadrature points, over that of the chord triangle, `2 ρ |T_h|`.
    /// Positive where the element is sound: for the physical element this says that its region is star-shaped about `S`.
    pub fn least_jacobian(&self) -> f64 {
        let [s, a, b] = self.from_apex();
        let chord = twice_area(s, a, b);
        let mut least = f64::INFINITY;
        for (rho, _) in GAUSS_8 {
            for (tau, _) in GAUSS_8 {
                let ratio = self.at(rho, tau).jacobian / (rho * chord);
                least = if ratio < least || ratio.is_nan() { ratio } else { least };
            }
        }
        least
    }

    /// One block row of the stiffness, `∫ B_iᵀ C B_j dx` for `i = corner` and the three `j`.
    pub fn stiffness_row(&self, material: &Material, corner: usize) -> [[f64; 4]; 3] {
        let mut row = [[0.0; 4]; 3];
        let mut add = |gradients: &[Vec2; 3], weight: f64| {
            for (entry, &gradient) in row.iter_mut().zip(gradients) {
                let block = stiffness_block(material, weight, gradients[corner], gradient);
                entry.iter_mut().zip(block).for_each(|(sum, b)| *sum += b);
            }
        };
        match self.element {
            CurvedElement::Physical => add(&super::gradients(self.corners).0, self.area()),
            CurvedElement::Isoparametric { .. } => self.points(&mut |p, w| add(&p.gradients, w)),
        }
        row
    }
}
