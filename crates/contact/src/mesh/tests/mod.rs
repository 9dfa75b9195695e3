//! Scenes for the tests of meshes.

use super::blocks::{Pattern, QuadBlock, triangulate};
use super::{Body, Mesh, PartOutline, Triangulation};
use crate::Error;
use crate::element::CurvedElement;
use crate::geometry::{CircularArc, ContactLine, Path, Point, SharedCurve, twice_area};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

mod blocks;
mod build;
mod curved;
mod hierarchy;
mod interiors;
mod locate;
mod onto;
mod quality;
mod refusals;

pub const PATTERNS: [Pattern; 3] = [Pattern::Structured, Pattern::CrissCross, Pattern::UnionJack];

/// Everything that makes a mesh; tests spoil one thing at a time.
#[derive(Clone)]
pub struct Scene {
    pub bodies: [Triangulation; 2],
    pub parts: Vec<PartOutline>,
    pub contact: Vec<Point>,
}

impl Scene {
    pub fn build(self) -> Result<Mesh, Error> {
        Mesh::build(self.bodies, &self.parts, &self.contact.into())
    }
}

pub fn points<const N: usize>(xy: [[f64; 2]; N]) -> [Point; N] {
    xy.map(|[x, y]| Point::new(x, y))
}

pub fn block(corners: [[f64; 2]; 4], cells: [usize; 2]) -> QuadBlock {
    QuadBlock::straight(points(corners), cells)
}

pub fn part<const N: usize>(body: Body, name: &str, along: [[f64; 2]; N]) -> PartOutline {
    PartOutline { body, name: name.into(), along: points(along).to_vec().into() }
}

pub fn square(low: [f64; 2], n: usize) -> QuadBlock {
    let [x, y] = low;
    block([[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]], [n, n])
}

/// Two unit squares, `Ω'` above and `Ω''` below the contact zone `0 < x < 1, y = 0`.
pub fn squares(n: usize, pattern: Pattern) -> Scene {
    let body = |y| triangulate(&[square([0.0, y], n)], pattern).unwrap();
    Scene {
        bodies: [body(0.0), body(-1.0)],
        parts: vec![
            part(Body::First, "top", [[1.0, 1.0], [0.0, 1.0]]),
            part(Body::First, "walls", [[0.0, 0.0], [0.0, 1.0]]),
            part(Body::First, "right", [[1.0, 0.0], [1.0, 1.0]]),
            part(Body::Second, "rest", [[0.0, 0.0], [0.0, -1.0], [1.0, -1.0], [1.0, 0.0]]),
        ],
        contact: points([[0.0, 0.0], [1.0, 0.0]]).to_vec(),
    }
}

/// `|x| < 1`, `Ω'` up to `y = 1.5`, `Ω''` down to `y = −1`, contact on `y = −0.2 x` for `x < 0` and `y = 0.5 x` for `x > 0`.
pub fn kinked(n: usize, pattern: Pattern) -> Scene {
    let upper = [
        block([[-1.0, 0.2], [0.0, 0.0], [0.0, 1.5], [-1.0, 1.5]], [n, n]),
        block([[0.0, 0.0], [1.0, 0.5], [1.0, 1.5], [0.0, 1.5]], [n, n]),
    ];
    let lower = [
        block([[-1.0, -1.0], [0.0, -1.0], [0.0, 0.0], [-1.0, 0.2]], [n, n]),
        block([[0.0, -1.0], [1.0, -1.0], [1.0, 0.5], [0.0, 0.0]], [n, n]),
    ];
    let top = [[1.0, 0.5], [1.0, 1.5], [0.0, 1.5], [-1.0, 1.5], [-1.0, 0.2]];
    let bottom = [[-1.0, 0.2], [-1.0, -1.0], [1.0, -1.0], [1.0, 0.5]];
    Scene {
        bodies: [&upper, &lower].map(|b| triangulate(b, pattern).unwrap()),
        parts: vec![part(Body::First, "top", top), part(Body::Second, "bottom", bottom)],
        contact: points([[-1.0, 0.2], [0.0, 0.0], [1.0, 0.5]]).to_vec(),
    }
}

/// `Ω'` inside the quarter circle `r = 1` and above `x + y = 1/2`, `Ω''` between the circle and the square of side 2.
pub fn quarter_disc(n: usize, element: CurvedElement) -> Mesh {
    let arc: SharedCurve = Arc::new(CircularArc { centre: Point::zeros(), radius: 1.0, from: 0.0, to: FRAC_PI_2 });
    let block = |corners, cells, on: usize| {
        let mut curves = [const { None }; 4];
        curves[on] = Some(arc.clone());
        QuadBlock { curves, ..QuadBlock::straight(points(corners), cells) }
    };
    let m = [std::f64::consts::FRAC_1_SQRT_2; 2];
    let disc = [block([[0.5, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.5]], [n, 2 * n], 1)];
    let frame = [
        block([[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], m], [2 * n, n], 3),
        block([m, [2.0, 2.0], [0.0, 2.0], [0.0, 1.0]], [2 * n, n], 3),
    ];
    let bodies = [&disc[..], &frame[..]].map(|b| triangulate(b, Pattern::Structured).unwrap());
    let parts = [
        part(Body::First, "rest", [[0.0, 1.0], [0.0, 0.5], [0.5, 0.0], [1.0, 0.0]]),
        part(Body::Second, "rest", [[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 1.0]]),
    ];
    let mut mesh = Mesh::build(bodies, &parts, &ContactLine::Common(Path::along(arc))).unwrap();
    mesh.curved.element = element;
    mesh
}

/// Area by the shoelace sum over the triangles of a body.
pub fn area(mesh: &Mesh, body: Body) -> f64 {
    let own = (0..mesh.triangles.len()).filter(|&t| mesh.body(t) == body);
    own.map(|t| mesh.corners(t)).map(|[a, b, c]| 0.5 * twice_area(a, b, c)).sum()
}
