//! Two triangulations become a [`Mesh`]: the boundary gets its names, the contact nodes their partners.

use super::contact::match_sides;
use super::outline::{self, Outlines, Owner};
use super::triangulation::{FreeSide, Triangulation, at, mesh_error};
use super::{Body, BoundarySide, ContactSide, CurvedSide, CurvedSides, Mesh, PartName, PartOutline};
use crate::Error;
use crate::geometry::{ContactLine, Piece, Point};

/// Share of the diameter within which two places are the same.
const TOLERANCE: f64 = 1e-10;

impl Mesh {
    /// Joins the triangulations of `Ω'` and `Ω''`. Nodes and triangles of `Ω'` come first, each body's in the order given;
    /// boundary sides follow the order of their triangles, contact sides the order of the polyline.
    ///
    /// `contact` is the path `A_1 … A_{m+1}` with `Ω'` on its left and `Ω''` on its right, or a gap between two graphs. Every
    /// `A_i`, and every corner and end of a part, must be a node; every boundary side must lie on exactly one part of its
    /// body or on the contact zone; contact nodes of the two bodies must coincide, across a gap in `η`. Places count as
    /// equal within 1e-10 of the diameter, and a contact node of `Ω''` then takes the very coordinates of its partner in `Ω'`.
    /// Sides on curves are curved sides of the mesh.
    ///
    /// # Errors
    /// [`Error::Mesh`] for the first of these that fails, and for points that are not finite, indices out of range, clockwise or
    /// degenerate triangles, overlapping triangles, unused nodes, parts that match no side, repeated names, triangles with
    /// two curved sides, curved elements that fold.
    pub fn build(bodies: [Triangulation; 2], parts: &[PartOutline], contact: &ContactLine) -> Result<Self, Error> {
        let sides = [bodies[0].check(Body::First)?, bodies[1].check(Body::Second)?];
        let free = [0, 1].map(|b| bodies[b].free_sides(&sides[b]));
        let tolerance = TOLERANCE * diameter(&bodies);
        outline::check(parts, contact, tolerance)?;
        let outlines = Body::BOTH.map(|body| Outlines::new(body, parts, contact, tolerance));
        let owners = [outlines[0].owners(&bodies[0], &free[0])?, outlines[1].owners(&bodies[1], &free[1])?];
        let matched = match_sides(&bodies, [&free[0], &free[1]], [&owners[0], &owners[1]], contact, tolerance)?;
        let mut mesh = join(bodies, parts);
        for body in Body::BOTH {
            mesh.name_sides(body, &free[body.index()], &owners[body.index()]);
        }
        mesh.direction = contact.direction();
        mesh.set_contact(matched);
        for body in Body::BOTH {
            let b = body.index();
            mesh.set_curved(body, &outlines[b], &free[b], &owners[b])?;
        }
        mesh.check_curved()?;
        Ok(mesh)
    }

    /// Appends the sides of a body that lie on curves.
    fn set_curved(&mut self, body: Body, lines: &Outlines, free: &[FreeSide], owners: &[Owner]) -> Result<(), Error> {
        let (nodes, triangles) = self.offsets(body);
        for (side, owner) in free.iter().zip(owners) {
            let ends = side.nodes.map(|i| self.points[(i + nodes) as usize]);
            let Some(Piece::Curved { curve, .. }) = lines.piece(ends, *owner) else { continue };
            let corners = self.triangles[(side.triangle + triangles) as usize];
            let apex = corners.iter().position(|c| side.nodes.iter().all(|n| n + nodes != *c)).unwrap_or(0);
            let curved = CurvedSide {
                triangle: side.triangle + triangles,
                apex: apex as u8,
                curve: self.curved.number(curve),
                span: ends.map(|x| curve.foot(x)),
            };
            self.refuse_second_curve(body, &curved)?;
            self.curved.sides.push(curved);
        }
        Ok(())
    }

    /// A triangle with two curved sides has an angle near 180° where they meet.
    fn refuse_second_curve(&self, body: Body, side: &CurvedSide) -> Result<(), Error> {
        if self.curved.sides.last().is_none_or(|last| last.triangle != side.triangle) {
            return Ok(());
        }
        Err(mesh_error(format!(
            "triangle {} of {body} around {} has two curved sides; let each side on a curve have a triangle of its own: turn \
             the diagonal of its neighbour, or divide the body otherwise",
            side.triangle,
            at(self.corners(side.triangle as usize).iter().sum::<Point>() / 3.0)
        )))
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

    /// Takes over the contact sides, numbered in each body by itself, and makes partners that touch coincide to the last bit.
    fn set_contact(&mut self, matched: Vec<ContactSide>) {
        let (offset, _) = self.offsets(Body::Second);
        self.contact = matched;
        for side in &mut self.contact {
            side.second = side.second.map(|i| i + offset);
            side.triangles[1] += self.first_triangles as u32;
            if self.direction.is_none() {
                for (&a, &b) in side.first.iter().zip(&side.second) {
                    self.points[b as usize] = self.points[a as usize];
                }
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
        curved: CurvedSides::default(),
        direction: None,
        initial_gap: None,
        shapes: None,
    }
}

/// Diagonal of the box around both bodies.
fn diameter(bodies: &[Triangulation; 2]) -> f64 {
    let all = || bodies.iter().flat_map(|b| &b.points);
    let low = all().fold(Point::repeat(f64::INFINITY), |m, p| m.inf(p));
    let high = all().fold(Point::repeat(f64::NEG_INFINITY), |m, p| m.sup(p));
    (high - low).norm()
}
