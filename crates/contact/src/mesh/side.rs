//! Boundary sides as integrals along the boundary see them: where they run and what the hat functions are on them.

use super::{BoundarySide, Mesh};
use crate::element::CurvedTriangle;
use crate::geometry::{InitialGap, LinePoint, Piece, Point, Segment, Vec2};
use crate::quadrature::Cubature;

/// A side of a triangle on the boundary, with a direction.
#[derive(Clone, Debug)]
pub struct SideView<'a> {
    /// Its two ends in its direction, and the node opposite.
    pub nodes: [u32; 3],
    /// Where it runs.
    pub piece: Piece,
    /// Its triangle, if the side is curved.
    triangle: Option<CurvedTriangle<'a>>,
    /// Positions of `nodes` among the triangle's corners.
    corners: [usize; 3],
}

impl SideView<'_> {
    /// The hat functions of `nodes` at the share `t` of the side's parameter. On a straight side, and on an isoparametric
    /// one, the third vanishes.
    pub fn hats(&self, t: f64) -> [f64; 3] {
        match &self.triangle {
            None => [1.0 - t, t, 0.0],
            Some(triangle) => {
                // the triangle's own arc runs from corner apex + 1 to apex + 2
                let forward = self.corners[0] == (triangle.apex + 1) % 3;
                let hats = triangle.trace(if forward { t } else { 1.0 - t });
                self.corners.map(|c| hats[c])
            }
        }
    }

    /// The value of a nodal field at the share `t`.
    pub fn value(&self, t: f64, nodal: &[Vec2]) -> Vec2 {
        let hats = self.hats(t);
        (0..3).map(|k| hats[k] * nodal[self.nodes[k] as usize]).sum()
    }

    /// Length of the side.
    pub fn length(&self) -> f64 {
        self.piece.length()
    }

    /// Calls `visit(x, n, hats, ds)` at quadrature points, `n` the normal to the right of the side's direction.
    pub fn points(&self, cubature: &Cubature, visit: &mut impl FnMut(Point, Vec2, [f64; 3], f64)) {
        match &self.piece {
            Piece::Straight(side) => cubature.side(side.a, side.b, &mut |x, ds| {
                visit(x, self.piece.normal(0.0), self.hats(side.parameter(x)), ds);
            }),
            curved => cubature.along(curved, &mut |t, w| {
                visit(curved.point(t), curved.normal(t), self.hats(t), w * curved.velocity(t).norm());
            }),
        }
    }
}

impl Mesh {
    /// The side of triangle `t` from node `a` to node `b`.
    pub fn side_view(&self, t: usize, [a, b]: [u32; 2]) -> SideView<'_> {
        let triangle = self.triangles[t];
        let opposite = triangle.into_iter().find(|i| *i != a && *i != b).unwrap_or(triangle[0]);
        let nodes = [a, b, opposite];
        let corners = nodes.map(|n| triangle.iter().position(|i| *i == n).unwrap_or(0));
        let curved = self.curved.of(t).filter(|side| usize::from(side.apex) == corners[2]);
        let piece = match curved {
            None => Piece::Straight(Segment { a: self.points[a as usize], b: self.points[b as usize] }),
            Some(side) => {
                let [from, to] = side.span;
                let forward = corners[0] == (corners[2] + 1) % 3;
                let curve = self.curved.curves[usize::from(side.curve)].clone();
                Piece::Curved { curve, span: if forward { [from, to] } else { [to, from] } }
            }
        };
        let triangle = curved.and_then(|_| self.curved_triangle(t));
        SideView { nodes, piece, triangle, corners }
    }

    /// A boundary side, the body on its left: its normal points outward.
    pub fn boundary_view(&self, side: &BoundarySide) -> SideView<'_> {
        self.side_view(side.triangle as usize, side.nodes)
    }

    /// A side of the contact zone as both bodies see it, in the direction of the zone.
    pub fn contact_view(&self, side: usize) -> ContactView<'_> {
        let s = &self.contact[side];
        let [f, g] = s.triangles.map(|t| t as usize);
        ContactView {
            sides: [self.side_view(f, s.first), self.side_view(g, s.second)],
            direction: self.direction,
            initial_gap: self.initial_gap.as_ref(),
        }
    }
}

/// A side of the contact zone as both bodies see it. The parameter `0 ≤ t ≤ 1` runs in the direction of the zone; at the same
/// `t` the two bodies face each other.
#[derive(Clone, Debug)]
pub struct ContactView<'a> {
    /// The side in `Ω'` and in `Ω''`.
    pub sides: [SideView<'a>; 2],
    /// `e_ξ` across a gap.
    direction: Option<Vec2>,
    /// `g` on a common zone.
    initial_gap: Option<&'a InitialGap>,
}

impl ContactView<'_> {
    /// Points, normals and gap at `t`.
    pub fn at(&self, t: f64) -> LinePoint {
        let mut point = LinePoint::new([&self.sides[0].piece, &self.sides[1].piece], self.direction, t);
        if let Some(gap) = self.initial_gap {
            point.gap += gap.at(point.at[0]);
        }
        point
    }

    /// `n·(v' − v'')` at `t` for a nodal field, without the gap.
    pub fn jump(&self, t: f64, point: &LinePoint, nodal: &[Vec2]) -> f64 {
        point.normal.dot(&(self.sides[0].value(t, nodal) - self.sides[1].value(t, nodal)))
    }

    /// The measure `μ` of the side: its length, or across a gap its width in `η`.
    pub fn measure(&self) -> f64 {
        match self.direction {
            None => self.sides[0].length(),
            Some(_) => self.at(0.5).measure,
        }
    }

    /// Calls `visit(t, point, dμ)` at quadrature points.
    pub fn points(&self, cubature: &Cubature, visit: &mut impl FnMut(f64, &LinePoint, f64)) {
        match (&self.sides[0].piece, self.direction) {
            (Piece::Straight(side), None) => cubature.side(side.a, side.b, &mut |x, ds| {
                let t = side.parameter(x);
                visit(t, &self.at(t), ds);
            }),
            (piece, _) => cubature.along(piece, &mut |t, w| {
                let point = self.at(t);
                visit(t, &point, w * point.measure);
            }),
        }
    }
}
