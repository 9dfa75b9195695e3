//! Which boundary side belongs to which part: polylines laid over the free sides of a body.

use super::triangulation::{FreeSide, Triangulation, at, mesh_error};
use super::{Body, PartOutline};
use crate::Error;
use crate::geometry::{Point, Segment, segments};
use std::collections::BTreeSet;

/// What a boundary side belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Owner {
    /// Index of the part.
    Part(u16),
    /// Index of the segment of the contact polyline.
    Contact(u16),
}

/// A polyline with the name it has in messages and the owner of the sides on its segment `i`.
struct Line<'a> {
    name: String,
    along: &'a [Point],
    owner: fn(usize, usize) -> Owner,
    index: usize,
}

/// All polylines of a body and the tolerance within which a node lies on one.
pub(super) struct Outlines<'a> {
    body: Body,
    lines: Vec<Line<'a>>,
    tolerance: f64,
}

/// Checks the outlines by themselves: lengths of the polylines, unique names, sizes.
pub(super) fn check(parts: &[PartOutline], contact: &[Point], tolerance: f64) -> Result<(), Error> {
    if contact.len() < 2 {
        return Err(mesh_error(format!(
            "the contact polyline has {} points; the contact zone must not be empty: give at least two",
            contact.len()
        )));
    }
    if parts.len().max(contact.len()) > usize::from(u16::MAX) {
        return Err(mesh_error(format!(
            "{} parts and {} contact points; at most {} of each: join some",
            parts.len(),
            contact.len(),
            u16::MAX
        )));
    }
    let mut names = BTreeSet::new();
    for part in parts {
        if !names.insert((part.body, &part.name)) {
            return Err(mesh_error(format!(
                "{} has two parts named \"{}\"; rename one or join their polylines",
                part.body, part.name
            )));
        }
        check_polyline(&format!("part \"{}\" of {}", part.name, part.body), &part.along, tolerance)?;
    }
    check_polyline("the contact polyline", contact, tolerance)
}

fn check_polyline(name: &str, along: &[Point], tolerance: f64) -> Result<(), Error> {
    if along.len() < 2 {
        return Err(mesh_error(format!("{name} has {} points; a polyline needs two", along.len())));
    }
    let bad = |s: &Segment| !s.length().is_finite() || s.length() <= tolerance;
    match segments(along).find(bad) {
        None => Ok(()),
        Some(s) => Err(mesh_error(format!(
            "{name} has a segment of length {} from {} to {}; it must exceed {tolerance:.1e}: remove one of the points",
            s.length(),
            at(s.a),
            at(s.b)
        ))),
    }
}

impl<'a> Outlines<'a> {
    /// The outlines of one body.
    pub fn new(body: Body, parts: &'a [PartOutline], contact: &'a [Point], tolerance: f64) -> Self {
        let own = parts.iter().enumerate().filter(|(_, p)| p.body == body);
        let mut lines: Vec<Line> = own
            .map(|(index, part)| Line {
                name: format!("part \"{}\"", part.name),
                along: &part.along,
                owner: |part, _| Owner::Part(part as u16),
                index,
            })
            .collect();
        lines.push(Line {
            name: "the contact polyline".into(),
            along: contact,
            owner: |_, segment| Owner::Contact(segment as u16),
            index: 0,
        });
        Self { body, lines, tolerance }
    }

    /// The owner of each free side. Refused: a corner or end of a polyline that is no node, a side on no polyline or
    /// on two, a polyline that leaves the boundary.
    pub fn owners(&self, mesh: &Triangulation, free: &[FreeSide]) -> Result<Vec<Owner>, Error> {
        for line in &self.lines {
            self.check_corners(line, mesh, free)?;
        }
        let mut covered = vec![0.0; self.lines.len()];
        let mut owners = Vec::with_capacity(free.len());
        for side in free {
            let ends = side.nodes.map(|i| mesh.points[i as usize]);
            let (line, owner) = self.owner(ends)?;
            covered[line] += (ends[1] - ends[0]).norm();
            owners.push(owner);
        }
        for (line, &covered) in self.lines.iter().zip(&covered) {
            self.check_covered(line, covered)?;
        }
        Ok(owners)
    }

    fn owner(&self, [a, b]: [Point; 2]) -> Result<(usize, Owner), Error> {
        let on = |line: &Line| {
            segments(line.along).position(|s| s.distance(a) <= self.tolerance && s.distance(b) <= self.tolerance)
        };
        let mut hits = (0..self.lines.len()).filter_map(|l| on(&self.lines[l]).map(|s| (l, s)));
        let (first, second) = (hits.next(), hits.next());
        let what = match (first, second) {
            (Some((l, segment)), None) => {
                let line = &self.lines[l];
                return Ok((l, (line.owner)(line.index, segment)));
            }
            (Some((l, _)), Some((k, _))) => format!(
                "is covered by {} and by {}; let one of them end before it",
                self.lines[l].name, self.lines[k].name
            ),
            _ => "is covered by no part and is not in the contact zone; add it to a part".into(),
        };
        Err(mesh_error(format!(
            "the boundary side of {} from {} to {} {what} (distances up to {:.1e} count as covered)",
            self.body,
            at(a),
            at(b),
            self.tolerance
        )))
    }

    fn check_corners(&self, line: &Line, mesh: &Triangulation, free: &[FreeSide]) -> Result<(), Error> {
        for &corner in line.along {
            let (node, distance) = nearest(corner, free.iter().map(|s| s.nodes[0]), &mesh.points);
            if distance > self.tolerance {
                return Err(mesh_error(format!(
                    "the point {} of {} is not a node on the boundary of {}: the nearest is node {node} at {}, \
                     {distance:.3e} away (at most {:.1e}); every corner and end must be a node, so choose divisions \
                     that put one there",
                    at(corner),
                    line.name,
                    self.body,
                    at(mesh.points[node as usize]),
                    self.tolerance
                )));
            }
        }
        Ok(())
    }

    fn check_covered(&self, line: &Line, covered: f64) -> Result<(), Error> {
        let length: f64 = segments(line.along).map(|s| s.length()).sum();
        if covered == 0.0 {
            return Err(mesh_error(format!(
                "{} from {} matches no side of {}; its segments must run along the boundary",
                line.name,
                at(line.along[0]),
                self.body
            )));
        }
        if (covered - length).abs() > 1e-8 * length {
            return Err(mesh_error(format!(
                "{} has the length {length} but the boundary sides of {} on it have {covered}; its segments must run \
                 along the boundary, each once",
                line.name, self.body
            )));
        }
        Ok(())
    }
}

/// The node nearest to `x` among `nodes` and its distance; the first of equals. `nodes` must not be empty.
pub(super) fn nearest(x: Point, nodes: impl Iterator<Item = u32>, points: &[Point]) -> (u32, f64) {
    nodes
        .map(|i| (i, (points[i as usize] - x).norm()))
        .fold((0, f64::INFINITY), |best, next| if next.1 < best.1 { next } else { best })
}
