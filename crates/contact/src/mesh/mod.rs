//! Triangulations of two bodies with named boundary parts, their refinement and quality.
//!
//! ```text
//!        2                     Corners run counterclockwise. Side i is opposite corner i,
//!       / \    side 0 = 1→2    from corner i+1 to corner i+2. A boundary side keeps its body
//!      / T \   side 1 = 2→0    on the left, so the outward normal is on the right.
//!     0-----1  side 2 = 0→1
//! ```
//!
//! From blocks to meshes: [`blocks`] triangulates quadrilaterals, [`Mesh::build`] joins two triangulations and names
//! their boundary, [`Hierarchy`] refines, [`Quality`] measures and [`Mesh::hash`] identifies.

use crate::geometry::{InitialGap, Path, Point, Vec2};
use std::fmt;

pub mod blocks;
mod build;
mod contact;
pub mod curved;
mod hash;
pub mod hierarchy;
pub mod locate;
mod outline;
pub mod quality;
mod shapes;
pub mod side;
mod sides;
#[cfg(test)]
pub(crate) mod tests;
pub mod triangulation;

pub use curved::{CurvedSide, CurvedSides};
pub use hash::fnv1a;
pub use hierarchy::Hierarchy;
pub use locate::{Located, Locator};
pub use quality::Quality;
pub use shapes::Shapes;
pub use triangulation::Triangulation;

/// One of the two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Body {
    /// `Ω'`, whose outward normal on the contact zone is `n`.
    First,
    /// `Ω''`.
    Second,
}

impl Body {
    /// Both bodies, in order.
    pub const BOTH: [Self; 2] = [Self::First, Self::Second];

    /// 0 for `Ω'`, 1 for `Ω''`.
    pub fn index(self) -> usize {
        self as usize
    }
}

impl fmt::Display for Body {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(["Ω'", "Ω''"][self.index()])
    }
}

/// A side on the boundary, outside the contact zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BoundarySide {
    /// End nodes, the body on the left.
    pub nodes: [u32; 2],
    /// The triangle that owns the side.
    pub triangle: u32,
    /// Index into [`Mesh::parts`].
    pub part: u16,
}

/// A side of the contact zone: the same piece of `Γ_K` seen from both bodies, nodes matched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContactSide {
    /// The two nodes in `Ω'`, in the direction of the contact polyline.
    pub first: [u32; 2],
    /// The two nodes in `Ω''`, each at the same point as its partner in `first`; across a gap, on the same line `η = C_j`.
    pub second: [u32; 2],
    /// The triangles in `Ω'` and `Ω''` that own the side.
    pub triangles: [u32; 2],
    /// Which piece `Γ_K,i` of the zone, from 0.
    pub segment: u16,
}

/// A triangulation of both bodies. Nodes on the contact zone are doubled, one for each body.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Node positions.
    pub points: Vec<Point>,
    /// Which body each node belongs to.
    pub node_bodies: Vec<Body>,
    /// Corners of each triangle, counterclockwise; the triangles of `Ω'` come first.
    pub triangles: Vec<[u32; 3]>,
    /// How many triangles belong to `Ω'`.
    pub first_triangles: usize,
    /// Boundary sides outside the contact zone.
    pub sides: Vec<BoundarySide>,
    /// Names of the boundary parts; a part belongs to one body.
    pub parts: Vec<PartName>,
    /// Sides of the contact zone in the order of the polyline.
    pub contact: Vec<ContactSide>,
    /// Curved sides; none where everything is straight.
    pub curved: CurvedSides,
    /// `e_ξ` of an enlarging contact zone, across whose gap the bodies meet; none where they touch from the start.
    pub direction: Option<Vec2>,
    /// The initial distance along `n` of bodies with common nodes on the zone; none where they just touch.
    pub initial_gap: Option<InitialGap>,
    /// Which triangles repeat the shape of another, where refinement has seen to it.
    pub shapes: Option<Shapes>,
}

/// The name of a boundary part and the body it belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartName {
    /// The body.
    pub body: Body,
    /// The name, unique within the body.
    pub name: String,
}

impl Mesh {
    /// The body of triangle `t`.
    #[inline]
    pub fn body(&self, t: usize) -> Body {
        if t < self.first_triangles { Body::First } else { Body::Second }
    }

    /// The triangles of a body.
    pub fn triangles_of(&self, body: Body) -> std::ops::Range<usize> {
        match body {
            Body::First => 0..self.first_triangles,
            Body::Second => self.first_triangles..self.triangles.len(),
        }
    }

    /// The corner positions of triangle `t`.
    #[inline]
    pub fn corners(&self, t: usize) -> [Point; 3] {
        self.triangles[t].map(|i| self.points[i as usize])
    }
}

/// A boundary part before there is a mesh: every side of `body` that lies on the path belongs to it.
#[derive(Clone, Debug, PartialEq)]
pub struct PartOutline {
    /// The body.
    pub body: Body,
    /// The name, unique within the body.
    pub name: String,
    /// Where it is.
    pub along: Path,
}
