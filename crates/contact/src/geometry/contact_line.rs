//! Where the bodies meet: along a common path, or across a gap between two graphs.
//!
//! ```text
//!   bounded zone (P1)                          enlarging zone (P2), e_ξ → right
//!
//!        Ω'                                       Ω''  )  ε(η) (   Ω'
//!   ──•──────•──────•──  one path                 B_j •) ─────→(• A_j     one line η = C_j for both nodes
//!        Ω''                                           )        (
//!   n = outward normal of Ω'                      n = −e_ξ:  n·(v' − v'') = v''_ξ − v'_ξ ≤ ε(η)
//! ```

use super::{Path, Piece, Point, SharedCurve, Vec2};

/// The contact zone `Γ_K` before there is a mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum ContactLine {
    /// One path that belongs to both bodies, `Ω'` on its left.
    Common(Path),
    /// Two graphs over the same interval of `η`, with an initial gap `ε(η) = f'(η) − f''(η) ≥ 0` between them.
    Gap {
        /// The boundary of `Ω'` (at `ξ > f'`) and of `Ω''` (at `ξ < f''`); both run through the interval, in either
        /// direction, with a parameter that is affine in `η`.
        curves: [SharedCurve; 2],
        /// `e_ξ`, a unit vector from `Ω''` to `Ω'`.
        direction: Vec2,
    },
}

/// A point of the contact zone as both bodies see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePoint {
    /// The point on the boundary of `Ω'` and of `Ω''`: the same one in P1.
    pub at: [Point; 2],
    /// `n` of the constraint `n·(v' − v'') ≤ gap`: the outward normal of `Ω'` in P1, `−e_ξ` in P2.
    pub normal: Vec2,
    /// Outward normal of `Ω'` and of `Ω''`, each times `ds/dμ`, where `dμ = ds` in P1 and `dη` in P2: with the stress of the
    /// body, the force per unit of `μ`.
    pub conormals: [Vec2; 2],
    /// The initial gap `ε`, zero in P1.
    pub gap: f64,
    /// `dμ/dt`, the measure of the zone per unit of the parameter.
    pub measure: f64,
}

impl ContactLine {
    /// Straight from corner to corner, `Ω'` on the left.
    pub fn polyline(corners: impl Into<Vec<Point>>) -> Self {
        Self::Common(Path::polyline(corners))
    }

    /// The pieces of the zone, each as `Ω'` and `Ω''` see it, in the direction that has `Ω'` on its left.
    pub fn pieces(&self) -> Vec<[Piece; 2]> {
        match self {
            Self::Common(path) => path.pieces().map(|p| [p.clone(), p]).collect(),
            Self::Gap { curves, direction } => {
                let eta = super::tangent_of(*direction);
                // η falls along the zone, which has Ω' on the left then
                let rises = |c: &SharedCurve| c.point(1.0).dot(&eta) > c.point(0.0).dot(&eta);
                let span = |c: &SharedCurve| if rises(c) { [1.0, 0.0] } else { [0.0, 1.0] };
                vec![curves.each_ref().map(|c| Piece::Curved { curve: c.clone(), span: span(c) })]
            }
        }
    }

    /// `e_ξ` of an enlarging zone.
    pub fn direction(&self) -> Option<Vec2> {
        match self {
            Self::Common(_) => None,
            Self::Gap { direction, .. } => Some(*direction),
        }
    }

    /// Every corner and end of the zone, on either body.
    pub fn corners(&self) -> Vec<Point> {
        match self {
            Self::Common(path) => path.corners.clone(),
            Self::Gap { curves, .. } => curves.iter().flat_map(|c| [c.point(0.0), c.point(1.0)]).collect(),
        }
    }

    /// The zone in words, the same for equal zones; a polyline is the list of its corners.
    pub fn describe(&self) -> String {
        match self {
            Self::Common(path) => path.describe(),
            Self::Gap { curves, direction } => format!(
                "gap along ({:?}, {:?}) between {} and {}",
                direction.x,
                direction.y,
                curves[0].describe(),
                curves[1].describe()
            ),
        }
    }
}

impl LinePoint {
    /// The point at the parameter `t` of a pair of pieces; `direction` is `e_ξ` of an enlarging zone.
    pub fn new(pieces: [&Piece; 2], direction: Option<Vec2>, t: f64) -> Self {
        let at = pieces.map(|p| p.point(t));
        let normals = [pieces[0].normal(t), -pieces[1].normal(t)];
        let speeds = pieces.map(|p| p.velocity(t).norm());
        match direction {
            None => Self { at, normal: normals[0], conormals: [normals[0], -normals[0]], gap: 0.0, measure: speeds[0] },
            Some(xi) => {
                let measure = pieces[0].velocity(t).dot(&super::tangent_of(xi)).abs();
                // n ds/dη = n/cos α
                let conormals = [normals[0] * (speeds[0] / measure), normals[1] * (speeds[1] / measure)];
                Self { at, normal: -xi, conormals, gap: xi.dot(&(at[0] - at[1])), measure }
            }
        }
    }
}

impl From<Vec<Point>> for ContactLine {
    fn from(corners: Vec<Point>) -> Self {
        Self::polyline(corners)
    }
}
