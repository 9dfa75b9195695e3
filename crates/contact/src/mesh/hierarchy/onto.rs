//! Levels mapped anew: the neighbours of the refinement, nodes in places of their own.
//!
//! Blocks that are divided twice as finely and mapped again keep the nodes of the coarse mesh and get one more for every side of it,
//! which lies in the middle of the side no longer once a side of the block is curved:
//!
//! ```text
//!      o           o           o  node of both meshes
//!     / \         / \          •  new node: its neighbours among the old ones are the
//!    /   \       •---•            ends of one side, its parents
//!   /     \     / \ / \
//!  o-------o   o---•---o
//! ```
//!
//! So refinement says how nodes and triangles are numbered and what belongs to what, and the fresh mesh says where the nodes are.
//! That it is such a mesh is checked in everything.

use super::super::triangulation::{at, mesh_error};
use super::super::{Body, Mesh};
use super::Hierarchy;
use crate::Error;
use crate::geometry::Point;
use rayon::slice::ParallelSliceMut;

/// Share of the diameter within which two places are the same.
const TOLERANCE: f64 = 1e-10;
/// No node.
const NONE: u32 = u32::MAX;

impl Hierarchy {
    /// Adds a level with the nodes of `fresh`, a mesh that was made by itself and has the connectivity of the refined finest mesh,
    /// whose nodes are also nodes of `fresh`. The new level is `fresh` with nodes and triangles numbered as [`refine`](Self::refine)
    /// numbers them; [`prolong`](Self::prolong) still takes the mean of the parents, which on levels mapped anew is no longer
    /// the same function. `O(N log N)`.
    ///
    /// # Errors
    /// [`Error::Mesh`], with the hierarchy as it was, where an old node is no node of `fresh` within 1e-10 of the diameter, where
    /// the old nodes next to a new one are not the ends of one side, and where bodies, triangles, boundary parts, contact zone or
    /// curves differ.
    pub fn refine_onto(&mut self, fresh: &Mesh) -> Result<(), Error> {
        let old = old_nodes(self.finest(), fresh)?;
        let (mut fine, parents) = self.refined();
        let number = numbers(&old, &parents, fresh)?;
        compare(&fine, fresh, &number)?;
        take_curves(&mut fine, fresh, &number)?;
        for (place, &i) in fresh.points.iter().zip(&number) {
            fine.points[i as usize] = *place;
        }
        fine.shapes = None;
        self.levels.push(fine);
        self.parents.push(parents);
        Ok(())
    }
}

/// For each node of `fresh` the node of `coarse` at its place, or none.
fn old_nodes(coarse: &Mesh, fresh: &Mesh) -> Result<Vec<u32>, Error> {
    let lattice = Lattice::new(fresh);
    let mut old = vec![NONE; fresh.points.len()];
    for (i, (&x, &body)) in coarse.points.iter().zip(&coarse.node_bodies).enumerate() {
        let found = lattice.find(x, body).filter(|&k| old[k] == NONE);
        let Some(k) = found else {
            return refuse(format!(
                "node {i} of {body} at {} is no node of the finer one, or one of two there; map the same blocks with twice as many \
                 cells in each direction",
                at(x)
            ));
        };
        old[k] = i as u32;
    }
    Ok(old)
}

/// The nodes of a mesh sorted into the cells of a lattice, body by body.
struct Lattice<'a> {
    mesh: &'a Mesh,
    low: Point,
    tolerance: f64,
    nodes: Vec<(Body, [u32; 2], u32)>,
}

impl<'a> Lattice<'a> {
    fn new(mesh: &'a Mesh) -> Self {
        let low = mesh.points.iter().fold(Point::repeat(f64::INFINITY), |m, p| m.inf(p));
        let high = mesh.points.iter().fold(Point::repeat(f64::NEG_INFINITY), |m, p| m.sup(p));
        let mut lattice = Self { mesh, low, tolerance: TOLERANCE * (high - low).norm(), nodes: Vec::new() };
        let node = |i: usize| (mesh.node_bodies[i], lattice.cell(mesh.points[i]), i as u32);
        let mut nodes: Vec<_> = (0..mesh.points.len()).map(node).collect();
        nodes.par_sort_unstable();
        lattice.nodes = nodes;
        lattice
    }

    /// The cell of a place; cells are four tolerances wide, so that 32 bits count them.
    fn cell(&self, x: Point) -> [u32; 2] {
        let share = (x - self.low) / (4.0 * self.tolerance);
        [share.x as u32, share.y as u32]
    }

    /// The first node of `body` within the tolerance of `x`.
    fn find(&self, x: Point, body: Body) -> Option<usize> {
        let reach = Point::repeat(self.tolerance);
        let ([left, below], [right, above]) = (self.cell(x - reach), self.cell(x + reach));
        let cells = [[left, below], [left, above], [right, below], [right, above]];
        cells.into_iter().find_map(|cell| {
            let start = self.nodes.partition_point(|n| (n.0, n.1) < (body, cell));
            let mut there = self.nodes[start..].iter().take_while(|n| (n.0, n.1) == (body, cell)).map(|n| n.2 as usize);
            there.find(|&k| (self.mesh.points[k] - x).norm() <= self.tolerance)
        })
    }
}

/// For each node of `fresh` its number on the refined level: old ones keep theirs, a new one has that of the midpoint with the same
/// parents.
fn numbers(old: &[u32], parents: &[[u32; 2]], fresh: &Mesh) -> Result<Vec<u32>, Error> {
    let near = neighbours(old, fresh)?;
    let new = (0..old.len()).filter(|&k| old[k] == NONE);
    let mut found: Vec<([u32; 2], u32)> = new.map(|k| (near[k], k as u32)).collect();
    drop(near);
    let first = (old.len() - found.len()) as u32;
    let mut midpoints: Vec<([u32; 2], u32)> = (first..).zip(parents).map(|(i, p)| (*p, i)).collect();
    found.par_sort_unstable();
    midpoints.par_sort_unstable();
    if let Some(((near, k), _)) = found.iter().zip(&midpoints).find(|(f, m)| f.0 != m.0) {
        return refuse(format!(
            "beside the new node at {} {}, where the ends of one side must lie that no other new node halves; cut the halved \
             cells like the whole ones",
            at(fresh.points[*k as usize]),
            match near {
                [NONE, _] => "lies no old node".into(),
                [a, NONE] => format!("lies the old node {a} alone"),
                [a, b] => format!("lie the old nodes {a} and {b}"),
            }
        ));
    }
    if found.len() != midpoints.len() {
        let (new, sides) = (found.len(), midpoints.len());
        return refuse(format!(
            "the finer one has {new} new nodes, but there are {sides} sides; divide every cell in four"
        ));
    }
    let mut number = old.to_vec();
    for ((_, k), (_, i)) in found.iter().zip(&midpoints) {
        number[*k as usize] = *i;
    }
    Ok(number)
}

/// The two old nodes next to each new one, lower number first.
fn neighbours(old: &[u32], fresh: &Mesh) -> Result<Vec<[u32; 2]>, Error> {
    let mut near = vec![[NONE; 2]; old.len()];
    for corners in &fresh.triangles {
        for (i, j) in [(0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)] {
            let (k, neighbour) = (corners[i] as usize, old[corners[j] as usize]);
            if old[k] != NONE || neighbour == NONE || near[k].contains(&neighbour) {
                continue;
            }
            // NONE is the largest number, so pairs fill from below and stay in order
            let [lower, higher] = near[k];
            if higher != NONE {
                return refuse(format!(
                    "beside the new node at {} lie the old nodes {lower}, {higher} and {neighbour}, where two make a side; use a \
                     pattern whose halved cells are cut like the whole ones",
                    at(fresh.points[k])
                ));
            }
            near[k] = [lower.min(neighbour), if lower == NONE { NONE } else { lower.max(neighbour) }];
        }
    }
    Ok(near)
}

/// Whether `fresh`, with the numbers that its nodes get, is the refined mesh in all but places.
fn compare(fine: &Mesh, fresh: &Mesh, number: &[u32]) -> Result<(), Error> {
    let of = |i: u32| number[i as usize];
    let bodies = (0..number.len()).all(|k| fresh.node_bodies[k] == fine.node_bodies[number[k] as usize]);
    if !bodies || fresh.first_triangles != fine.first_triangles {
        return refuse("their bodies differ".into());
    }
    let same =
        sorted(fine.triangles.iter().map(|t| turned(*t))) == sorted(fresh.triangles.iter().map(|t| turned(t.map(of))));
    if !same {
        return refuse("the triangles of the finer one are not a quarter each of those of the coarser one".into());
    }
    let same = sorted(fine.sides.iter().map(|s| (s.nodes, s.part)))
        == sorted(fresh.sides.iter().map(|s| (s.nodes.map(of), s.part)));
    if !same || fine.parts != fresh.parts {
        return refuse("their boundary parts differ".into());
    }
    let zone = fine.contact.iter().map(|c| (c.first, c.second, c.segment));
    let same = zone.eq(fresh.contact.iter().map(|c| (c.first.map(of), c.second.map(of), c.segment)));
    if !same || fine.direction != fresh.direction || fine.initial_gap != fresh.initial_gap {
        return refuse("their contact zones differ".into());
    }
    Ok(())
}

/// Curved sides stay with their triangles and get the ends that they have in `fresh`.
fn take_curves(fine: &mut Mesh, fresh: &Mesh, number: &[u32]) -> Result<(), Error> {
    let place = |curve| fine.curved.curves.iter().position(|c| c == curve);
    let curves: Vec<Option<usize>> = fresh.curved.curves.iter().map(place).collect();
    let ends = |mesh: &Mesh, k: usize| {
        let side = &mesh.curved.sides[k];
        let apex = usize::from(side.apex);
        [1, 2].map(|i| mesh.triangles[side.triangle as usize][(apex + i) % 3])
    };
    let own = sorted((0..fine.curved.sides.len()).map(|k| (ends(fine, k), k)));
    let theirs = sorted((0..fresh.curved.sides.len()).map(|k| (ends(fresh, k).map(|i| number[i as usize]), k)));
    if own.len() != theirs.len() || fine.curved.element != fresh.curved.element {
        return refuse("their curved sides differ".into());
    }
    for ((a, k), (b, l)) in own.into_iter().zip(theirs) {
        let theirs = &fresh.curved.sides[l];
        let side = &mut fine.curved.sides[k];
        if a != b || curves[usize::from(theirs.curve)] != Some(usize::from(side.curve)) {
            let [x, y] = a.map(|i| at(fine.points[i as usize]));
            return refuse(format!("the side between {x} and {y} lies on another curve in the finer one, or on none"));
        }
        side.span = theirs.span;
    }
    Ok(())
}

fn sorted<T: Ord + Send>(items: impl Iterator<Item = T>) -> Vec<T> {
    let mut items: Vec<T> = items.collect();
    items.par_sort_unstable();
    items
}

/// A triangle from its lowest corner on.
fn turned([a, b, c]: [u32; 3]) -> [u32; 3] {
    match a.min(b).min(c) {
        least if least == a => [a, b, c],
        least if least == b => [b, c, a],
        _ => [c, a, b],
    }
}

fn refuse<T>(what: String) -> Result<T, Error> {
    Err(mesh_error(format!("a mesh mapped anew is no refinement of the coarser one: {what}")))
}
