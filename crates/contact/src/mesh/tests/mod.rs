//! Scenes for the tests of meshes.

use super::blocks::{Pattern, QuadBlock, triangulate};
use super::{Body, Mesh, PartOutline, Triangulation};
use crate::Error;
use crate::geometry::{Point, twice_area};

mod blocks;
mod build;
mod curved;
mod hierarchy;
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

/// Area by the shoelace sum over the triangles of a body.
pub fn area(mesh: &Mesh, body: Body) -> f64 {
    let own = (0..mesh.triangles.len()).filter(|&t| mesh.body(t) == body);
    own.map(|t| mesh.corners(t)).map(|[a, b, c]| 0.5 * twice_area(a, b, c)).sum()
}
