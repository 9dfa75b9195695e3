//! A triangulation of one body, before its boundary has names.

use super::Body;
use super::sides::{Sides, side_nodes};
use crate::Error;
use crate::geometry::{Point, twice_area};

/// Nodes and triangles of one body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangulation {
    /// Node positions.
    pub points: Vec<Point>,
    /// Corners of each triangle, counterclockwise, as indices into `points`.
    pub triangles: Vec<[u32; 3]>,
}

/// A side that belongs to one triangle only.
#[derive(Clone, Copy)]
pub(super) struct FreeSide {
    /// Ends, the body on the left.
    pub nodes: [u32; 2],
    /// Its triangle.
    pub triangle: u32,
}

/// `2 |T| / (longest side)²` below which a triangle counts as degenerate.
const FLATTEST: f64 = 1e-10;

impl Triangulation {
    /// Checks the triangles one by one and then their neighbourhood.
    pub(super) fn check(&self, body: Body) -> Result<Sides, Error> {
        self.check_sizes(body)?;
        self.check_points(body)?;
        for t in 0..self.triangles.len() {
            self.check_triangle(body, t)?;
        }
        self.check_nodes_used(body)?;
        let sides = Sides::new(&self.triangles);
        for e in 0..sides.len() {
            self.check_side(body, &sides, e)?;
        }
        Ok(sides)
    }

    /// The sides with one triangle, in the order of the triangles.
    pub(super) fn free_sides(&self, sides: &Sides) -> Vec<FreeSide> {
        let mut free = Vec::new();
        for (t, &triangle) in self.triangles.iter().enumerate() {
            for i in 0..3 {
                if sides.owners(sides.of[t][i] as usize).len() == 1 {
                    let nodes = side_nodes(triangle, i);
                    free.push(FreeSide { nodes, triangle: t as u32 });
                }
            }
        }
        free
    }

    fn check_sizes(&self, body: Body) -> Result<(), Error> {
        if self.triangles.is_empty() {
            return Err(mesh_error(format!("{body} has no triangle; give it at least one")));
        }
        let largest = u32::MAX as usize / 8;
        if self.triangles.len().max(self.points.len()) > largest {
            return Err(mesh_error(format!(
                "{body} has {} triangles and {} nodes; numbers of 32 bits reach to {largest}: use a coarser mesh",
                self.triangles.len(),
                self.points.len()
            )));
        }
        Ok(())
    }

    fn check_points(&self, body: Body) -> Result<(), Error> {
        match self.points.iter().position(|p| !(p.x.is_finite() && p.y.is_finite())) {
            None => Ok(()),
            Some(i) => Err(mesh_error(format!(
                "node {i} of {body} lies at {}; coordinates must be finite: check how it was computed",
                at(self.points[i])
            ))),
        }
    }

    fn check_triangle(&self, body: Body, t: usize) -> Result<(), Error> {
        let triangle = self.triangles[t];
        if let Some(i) = triangle.into_iter().find(|&i| i as usize >= self.points.len()) {
            return Err(mesh_error(format!(
                "triangle {t} of {body} has the corner {i}, but there are {} nodes, numbered from 0: \
                 mend the index",
                self.points.len()
            )));
        }
        let [a, b, c] = triangle.map(|i| self.points[i as usize]);
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        let (area, bound) = (twice_area(a, b, c), FLATTEST * longest * longest);
        if area.is_nan() || area <= bound {
            let (what, hint) = if area < -bound {
                ("runs clockwise", "exchange two of its corners")
            } else {
                ("is degenerate", "move or remove one of its corners")
            };
            return Err(mesh_error(format!(
                "triangle {t} of {body} with the corners {}, {}, {} {what}: its Jacobian {area:.3e} must exceed \
                 {bound:.3e}; {hint}",
                at(a),
                at(b),
                at(c)
            )));
        }
        Ok(())
    }

    fn check_nodes_used(&self, body: Body) -> Result<(), Error> {
        let mut used = vec![false; self.points.len()];
        for &i in self.triangles.iter().flatten() {
            used[i as usize] = true;
        }
        match used.iter().position(|u| !u) {
            None => Ok(()),
            Some(i) => Err(mesh_error(format!(
                "node {i} of {body} at {} belongs to no triangle; remove it",
                at(self.points[i])
            ))),
        }
    }

    fn check_side(&self, body: Body, sides: &Sides, e: usize) -> Result<(), Error> {
        let mut starts = sides.owners(e).map(|(t, i)| side_nodes(self.triangles[t as usize], i)[0]);
        let what = match (starts.next(), starts.next(), starts.next()) {
            (Some(_), None, _) | (None, ..) => return Ok(()),
            (Some(first), Some(second), None) if first != second => return Ok(()),
            (_, _, None) => "lies on the same side of both",
            _ => "belongs to more than two",
        };
        let numbers: Vec<String> = sides.owners(e).map(|(t, _)| t.to_string()).collect();
        let [a, b] = sides.ends[e].map(|i| self.points[i as usize]);
        Err(mesh_error(format!(
            "the side from {} to {} (nodes {}, {}) of {body} {what} triangles {}; triangles must not overlap: remove \
             the one that is too many",
            at(a),
            at(b),
            sides.ends[e][0],
            sides.ends[e][1],
            numbers.join(", ")
        )))
    }
}

/// A point as it appears in messages.
pub(super) fn at(p: Point) -> String {
    format!("({}, {})", p.x, p.y)
}

/// An [`Error::Mesh`].
pub(super) fn mesh_error(message: String) -> Error {
    Error::Mesh(message)
}
