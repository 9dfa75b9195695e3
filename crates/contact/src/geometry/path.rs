//! Chains of straight and curved pieces: boundary parts and contact zones.

use super::{Point, Segment, SharedCurve, Vec2, arc_length, right_normal};

/// A part of a boundary between two corners.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// A straight segment.
    Straight(Segment),
    /// The part of a curve between two parameters, in the direction from the first to the second.
    Curved {
        /// The curve.
        curve: SharedCurve,
        /// Parameters at the piece's start and end.
        span: [f64; 2],
    },
}

impl Piece {
    /// The part of `curve` between the points nearest to `a` and `b`.
    pub fn on_curve(curve: &SharedCurve, a: Point, b: Point) -> Self {
        Self::Curved { curve: curve.clone(), span: [curve.foot(a), curve.foot(b)] }
    }

    /// The point at the share `t` of the piece's parameter, `0 ≤ t ≤ 1`.
    pub fn point(&self, t: f64) -> Point {
        match self {
            Self::Straight(s) => (1.0 - t) * s.a + t * s.b,
            Self::Curved { curve, span } => curve.point(at(span, t)),
        }
    }

    /// The derivative of [`Piece::point`] with respect to `t`.
    pub fn velocity(&self, t: f64) -> Vec2 {
        match self {
            Self::Straight(s) => s.b - s.a,
            Self::Curved { curve, span } => (span[1] - span[0]) * curve.derivatives(at(span, t))[0],
        }
    }

    /// The unit normal to the right of the piece's direction.
    pub fn normal(&self, t: f64) -> Vec2 {
        match self {
            Self::Straight(s) => right_normal(s.a, s.b),
            Self::Curved { curve, span } => (span[1] - span[0]).signum() * curve.normal(at(span, t)),
        }
    }

    /// The share `t ∈ [0, 1]` of the piece's point nearest to `x`.
    pub fn foot(&self, x: Point) -> f64 {
        let t = match self {
            Self::Straight(s) => s.parameter(x),
            Self::Curved { curve, span } => (curve.foot(x) - span[0]) / (span[1] - span[0]),
        };
        t.clamp(0.0, 1.0)
    }

    /// Distance of `x` from the piece.
    pub fn distance(&self, x: Point) -> f64 {
        match self {
            Self::Straight(s) => s.distance(x),
            Self::Curved { .. } => (self.point(self.foot(x)) - x).norm(),
        }
    }

    /// Length of the piece.
    pub fn length(&self) -> f64 {
        match self {
            Self::Straight(s) => s.length(),
            Self::Curved { curve, span } => arc_length(curve.as_ref(), *span).abs(),
        }
    }

    /// The curve, if the piece lies on one.
    pub fn curve(&self) -> Option<&SharedCurve> {
        match self {
            Self::Straight(_) => None,
            Self::Curved { curve, .. } => Some(curve),
        }
    }
}

fn at(span: &[f64; 2], t: f64) -> f64 {
    span[0] + t * (span[1] - span[0])
}

/// Corners `A_1, A_2, …` joined by straight segments or by parts of curves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// The corners.
    pub corners: Vec<Point>,
    /// The curve between corner `i` and `i + 1`; where the list ends, everything is straight.
    pub curves: Vec<Option<SharedCurve>>,
}

impl Path {
    /// Straight from corner to corner.
    pub fn polyline(corners: impl Into<Vec<Point>>) -> Self {
        Self { corners: corners.into(), curves: Vec::new() }
    }

    /// Along the whole of one curve.
    pub fn along(curve: SharedCurve) -> Self {
        Self { corners: vec![curve.point(0.0), curve.point(1.0)], curves: vec![Some(curve)] }
    }

    /// The pieces in order.
    pub fn pieces(&self) -> impl Iterator<Item = Piece> + '_ {
        self.corners.windows(2).enumerate().map(|(i, w)| match self.curves.get(i).and_then(Option::as_ref) {
            Some(curve) => Piece::on_curve(curve, w[0], w[1]),
            None => Piece::Straight(Segment { a: w[0], b: w[1] }),
        })
    }

    /// Whether any piece is curved.
    pub fn is_curved(&self) -> bool {
        self.curves.iter().any(Option::is_some)
    }

    /// The path in words, the same for equal paths; a polyline is the list of its corners.
    pub fn describe(&self) -> String {
        let corners: String = self.corners.iter().map(|p| format!("({:?}, {:?})", p.x, p.y)).collect();
        let curve = |c: &Option<SharedCurve>| c.as_ref().map_or(" straight".into(), |c| format!(" {}", c.describe()));
        let curves: String = self.curves.iter().map(curve).collect();
        corners + if self.is_curved() { &curves } else { "" }
    }
}

impl From<Vec<Point>> for Path {
    fn from(corners: Vec<Point>) -> Self {
        Self::polyline(corners)
    }
}
