//! Two triangulations become a [`Mesh`]: the boundary gets its names, the contact nodes their partners.

use super::contact::match_sides;
use super::outline::{self, Outlines, Owner};
use super::triangulation::{FreeSide, Triangulation};
use super::{Body, BoundarySide, ContactSide, Mesh, PartName, PartOutline};
use crate::Error;
use crate::geometry::Point;

/// Share of the diameter within which two places are the same.
const TOLERANCE: f64 = 1e-10;

impl Mesh {
    /// Joins the triangulations of `Ω'` and `Ω''`. Nodes and triangles of `Ω'` come first, each body's in the order given;
    /// boundary sides follow the order of their triangles, contact sides the order of the polyline.
    ///
    /// `contact` is the polyline `A_1 … A_{m+1}` with `Ω'` on its left and `Ω''` on its right. Every `A_i`, and every corner and
    /// end of a part, must be a node; every boundary side must lie on exactly one part of its body or on the contact
    /// polyline; contact nodes of the two bodies must coincide. Places count as equal within 1e-10 of the diameter, and
    /// a contact node of `Ω''` then takes the very coordinates of its partner in `Ω'`.
    ///
    /// # Errors
    /// [`Error::Mesh`] for the first of these that fails, and for points that are not finite, indices out of range, clockwise or
    /// degenerate triangles, overlapping triangles, unused nodes, parts that match no side, repeated names.
    pub fn build(bodies: [Triangulation; 2], parts: &[PartOutline], contact: &[Point]) -> Result<Self, Error> {
        let sides = [bodies[0].check(Body::First)?, bodies[1].check(Body::Second)?];
        let free = [0, 1].map(|b| bodies[b].free_sides(&sides[b]));
        let tolerance = TOLERANCE * diameter(&bodies);
        outline::check(parts, contact, tolerance)?;
        let owners = |body: Body| {
            let b = body.index();
            Outlines::new(body, parts, contact, tolerance).owners(&bodies[b], &free[b])
        };
        let owners = [owners(Body::First)?, owners(Body::Second)?];
        let matched = match_sides(&bodies, [&free[0], &free[1]], [&owners[0], &owners[1]], contact, tolerance)?;
        let mut mesh = join(bodies, parts);
        for body in Body::BOTH {
            mesh.name_sides(body, &free[body.index()], &owners[body.index()]);
        }
        mesh.set_contact(matched);
        Ok(mesh)
    }

    /// Appends the sides of a body that belong to a part.
    fn name_sides(&mut self, body: Body, free: &[FreeSide], owners: &[Owner]) {
        let (nodes, triangles) = self.offsets(body);
        for (side, owner) in free.iter().zip(owners) {
            if let Owner::Part(part) = *owner {
                self.sides.push(BoundarySide {
                    nodes: side.nodes.map(|i| i + nodes),
                    triangle: side.triangle + triangles,
                    part,
                });
            }
        }
    }

    /// Takes over the contact sides, numbered in each body by itself, and makes partners coincide to the last bit.
    fn set_contact(&mut self, matched: Vec<ContactSide>) {
        let (offset, _) = self.offsets(Body::Second);
        self.contact = matched;
        for side in &mut self.contact {
            side.second = side.second.map(|i| i + offset);
            for (&a, &b) in side.first.iter().zip(&side.second) {
                self.points[b as usize] = self.points[a as usize];
            }
        }
    }

    /// The numbers of a body's first node and triangle in a mesh made by [`join`].
    fn offsets(&self, body: Body) -> (u32, u32) {
        match body {
            Body::First => (0, 0),
            Body::Second => {
                let nodes = self.node_bodies.partition_point(|&b| b == Body::First);
                (nodes as u32, self.first_triangles as u32)
            }
        }
    }
}

/// Both bodies in one mesh, the boundary still without names.
fn join([first, second]: [Triangulation; 2], parts: &[PartOutline]) -> Mesh {
    let offset = first.points.len() as u32;
    let mut node_bodies = vec![Body::First; first.points.len()];
    node_bodies.resize(first.points.len() + second.points.len(), Body::Second);
    let first_triangles = first.triangles.len();
    let (mut points, mut triangles) = (first.points, first.triangles);
    points.extend(second.points);
    triangles.extend(second.triangles.iter().map(|t| t.map(|i| i + offset)));
    let name = |p: &PartOutline| PartName { body: p.body, name: p.name.clone() };
    Mesh {
        points,
        node_bodies,
        triangles,
        first_triangles,
        sides: Vec::new(),
        parts: parts.iter().map(name).collect(),
        contact: Vec::new(),
    }
}

/// Diagonal of the box around both bodies.
fn diameter(bodies: &[Triangulation; 2]) -> f64 {
    let all = || bodies.iter().flat_map(|b| &b.points);
    let low = all().fold(Point::repeat(f64::INFINITY), |m, p| m.inf(p));
    let high = all().fold(Point::repeat(f64::NEG_INFINITY), |m, p| m.sup(p));
    (high - low).norm()
}
