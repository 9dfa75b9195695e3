//! Which boundary side belongs to which part: paths laid over the free sides of a body.

use super::triangulation::{FreeSide, Triangulation, at, mesh_error};
use super::{Body, PartOutline};
use crate::Error;
use crate::geometry::{ContactLine, Path, Piece, Point};
use std::collections::BTreeSet;

/// What a boundary side belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Owner {
    /// Index of the part.
    Part(u16),
    /// Index of the piece of the contact zone.
    Contact(u16),
}

/// A path with the name it has in messages and the owner of the sides on its piece `i`.
struct Line {
    name: String,
    corners: Vec<Point>,
    pieces: Vec<Piece>,
    owner: fn(usize, usize) -> Owner,
    index: usize,
}

/// All paths of a body and the tolerance within which a node lies on one.
pub(super) struct Outlines {
    body: Body,
    lines: Vec<Line>,
    tolerance: f64,
}

/// Checks the outlines by themselves: lengths of the paths, unique names, sizes.
pub(super) fn check(parts: &[PartOutline], contact: &ContactLine, tolerance: f64) -> Result<(), Error> {
    let corners = contact.corners();
    if corners.len() < 2 {
        return Err(mesh_error(format!(
            "the contact polyline has {} points; the contact zone must not be empty: give at least two",
            corners.len()
        )));
    }
    if parts.len().max(corners.len()) > usize::from(u16::MAX) {
        return Err(mesh_error(format!(
            "{} parts and {} contact points; at most {} of each: join some",
            parts.len(),
            corners.len(),
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
        check_path(&format!("part \"{}\" of {}", part.name, part.body), &part.along, tolerance)?;
    }
    match contact {
        ContactLine::Common(path) => check_path("the contact polyline", path, tolerance),
        ContactLine::Gap { .. } => Ok(()),
    }
}

fn check_path(name: &str, along: &Path, tolerance: f64) -> Result<(), Error> {
    if along.corners.len() < 2 {
        return Err(mesh_error(format!("{name} has {} points; a polyline needs two", along.corners.len())));
    }
    let bad = |length: f64| !length.is_finite() || length <= tolerance;
    match along.pieces().map(|p| (p.length(), p)).find(|(length, _)| bad(*length)) {
        None => Ok(()),
        Some((length, piece)) => Err(mesh_error(format!(
            "{name} has a segment of length {length} from {} to {}; it must exceed {tolerance:.1e}: remove one of the points",
            at(piece.point(0.0)),
            at(piece.point(1.0))
        ))),
    }
}

impl Outlines {
    /// The outlines of one body.
    pub fn new(body: Body, parts: &[PartOutline], contact: &ContactLine, tolerance: f64) -> Self {
        let own = parts.iter().enumerate().filter(|(_, p)| p.body == body);
        let mut lines: Vec<Line> = own
            .map(|(index, part)| Line {
                name: format!("part \"{}\"", part.name),
                corners: part.along.corners.clone(),
                pieces: part.along.pieces().collect(),
                owner: |part, _| Owner::Part(part as u16),
                index,
            })
            .collect();
        let pieces: Vec<Piece> = contact.pieces().into_iter().map(|both| both[body.index()].clone()).collect();
        lines.push(Line {
            name: "the contact polyline".into(),
            corners: pieces.iter().map(|p| p.point(0.0)).chain(pieces.last().map(|p| p.point(1.0))).collect(),
            pieces,
            owner: |_, segment| Owner::Contact(segment as u16),
            index: 0,
        });
        Self { body, lines, tolerance }
    }

    /// The piece that a side of this owner lies on.
    pub fn piece(&self, ends: [Point; 2], owner: Owner) -> Option<&Piece> {
        let line = match owner {
            Owner::Part(part) => self.lines.iter().find(|l| (l.owner)(l.index, 0) == Owner::Part(part)),
            Owner::Contact(_) => self.lines.last(),
        };
        line.and_then(|l| l.pieces.iter().find(|p| self.holds(p, ends)))
    }

    fn holds(&self, piece: &Piece, ends: [Point; 2]) -> bool {
        ends.iter().all(|x| piece.distance(*x) <= self.tolerance)
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
            let (line, owner, length) = self.owner(ends)?;
            covered[line] += length;
            owners.push(owner);
        }
        for (line, &covered) in self.lines.iter().zip(&covered) {
            self.check_covered(line, covered)?;
        }
        Ok(owners)
    }

    /// The line and owner of a side, and the length that it covers.
    fn owner(&self, [a, b]: [Point; 2]) -> Result<(usize, Owner, f64), Error> {
        let on = |line: &Line| line.pieces.iter().position(|p| self.holds(p, [a, b]));
        let mut hits = (0..self.lines.len()).filter_map(|l| on(&self.lines[l]).map(|s| (l, s)));
        let (first, second) = (hits.next(), hits.next());
        let what = match (first, second) {
            (Some((l, segment)), None) => {
                let line = &self.lines[l];
                let length = match &line.pieces[segment] {
                    Piece::Straight(_) => (b - a).norm(),
                    Piece::Curved { curve, .. } => Piece::on_curve(curve, a, b).length(),
                };
                return Ok((l, (line.owner)(line.index, segment), length));
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
        for &corner in &line.corners {
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
        let length: f64 = line.pieces.iter().map(Piece::length).sum();
        if covered == 0.0 {
            return Err(mesh_error(format!(
                "{} from {} matches no side of {}; its segments must run along the boundary",
                line.name,
                at(line.corners[0]),
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
