//! Nodes and their constrained Delaunay triangulation.

use super::{at, refuse};
use signorini_contact::{Error, Point};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

/// A mesh on the way: the first `fixed` nodes are the boundary polygon, counterclockwise.
#[derive(Clone)]
pub(super) struct Draft {
    /// Node positions.
    pub points: Vec<Point>,
    /// Nodes of the boundary.
    pub fixed: usize,
    /// Counterclockwise, smallest node first, ascending: the order does not depend on how they were found.
    pub triangles: Vec<[u32; 3]>,
}

impl From<Draft> for signorini_contact::mesh::Triangulation {
    fn from(draft: Draft) -> Self {
        Self { points: draft.points, triangles: draft.triangles }
    }
}

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

impl Draft {
    /// Triangulates; nodes that are in no triangle, because they lie outside or coincide with others, are left out.
    ///
    /// # Errors
    /// Coordinates out of range; boundary sides that cross or touch.
    pub fn new(points: Vec<Point>, fixed: usize) -> Result<Self, Error> {
        let cdt = triangulate(&points, fixed)?;
        let mut triangles = inner_triangles(&cdt);
        let found: Vec<Point> = cdt.vertices().map(|v| v.position()).map(|p| Point::new(p.x, p.y)).collect();
        let points = keep_used(&found, fixed, &mut triangles);
        triangles.iter_mut().for_each(smallest_first);
        triangles.sort_unstable();
        Ok(Self { points, fixed, triangles })
    }

    /// Every side once, ends ascending, in the order of the triangles; the boundary's last side comes last.
    pub fn sides(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        // An inner side runs once in each direction, and a boundary side once, ascending except for the last one.
        let ascending = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]].into_iter().filter(|[i, j]| i < j);
        self.triangles.iter().flat_map(ascending).chain([[0, self.fixed as u32 - 1]])
    }

    /// Whether two nodes are the ends of a boundary side.
    pub fn is_boundary_side(&self, a: u32, b: u32) -> bool {
        let n = self.fixed as u32;
        a < n && b < n && ((a + 1) % n == b || (b + 1) % n == a)
    }

    /// The corners' places.
    pub fn corners(&self, triangle: [u32; 3]) -> [Point; 3] {
        triangle.map(|i| self.points[i as usize])
    }
}

fn triangulate(points: &[Point], fixed: usize) -> Result<Cdt, Error> {
    let places = points.iter().map(|p| Point2::new(p.x, p.y)).collect();
    let sides: Vec<_> = (0..fixed).map(|k| [k, (k + 1) % fixed]).collect();
    let mut crossing = None;
    let cdt = match Cdt::try_bulk_load_cdt(places, sides.clone(), |side| crossing = crossing.or(Some(side))) {
        Ok(cdt) => cdt,
        Err(error) => {
            return refuse(format!("coordinates out of range for a Delaunay mesh: {error}; change the unit of length"));
        }
    };
    let handles: Vec<_> = cdt.fixed_vertices().take(fixed).collect();
    let broken = || sides.iter().copied().find(|&[a, b]| !cdt.exists_constraint(handles[a], handles[b]));
    match crossing.or_else(broken) {
        None => Ok(cdt),
        Some([a, b]) => refuse(format!(
            "the boundary side from {} to {} (nodes {a}, {b}) meets another side or node; the boundary must not cross or \
             touch itself: check the order of its nodes",
            at(points[a]),
            at(points[b])
        )),
    }
}

/// The triangles that cannot be reached from outside without crossing the boundary.
fn inner_triangles(cdt: &Cdt) -> Vec<[u32; 3]> {
    let mut outside = vec![false; cdt.num_all_faces()];
    outside[cdt.outer_face().index()] = true;
    let hull = cdt.convex_hull().filter(|e| !e.is_constraint_edge()).map(|e| e.rev().face().fix());
    let mut open: Vec<_> = hull.collect();
    while let Some(face) = open.pop() {
        if std::mem::replace(&mut outside[face.index()], true) {
            continue;
        }
        let Some(triangle) = cdt.face(face).as_inner() else { continue };
        let passable = triangle.adjacent_edges().into_iter().filter(|e| !e.is_constraint_edge());
        open.extend(passable.map(|e| e.rev().face().fix()));
    }
    let inside = cdt.inner_faces().filter(|f| !outside[f.fix().index()]);
    inside.map(|f| f.vertices().map(|v| v.fix().index() as u32)).collect()
}

/// Drops inner nodes without triangle and renumbers the rest in order.
fn keep_used(points: &[Point], fixed: usize, triangles: &mut [[u32; 3]]) -> Vec<Point> {
    let mut number = vec![u32::MAX; points.len()];
    number[..fixed].fill(0);
    triangles.iter().flatten().for_each(|&i| number[i as usize] = 0);
    let mut kept = Vec::with_capacity(points.len());
    for (i, number) in number.iter_mut().enumerate().filter(|(_, n)| **n == 0) {
        *number = kept.len() as u32;
        kept.push(points[i]);
    }
    triangles.iter_mut().flatten().for_each(|i| *i = number[*i as usize]);
    kept
}

fn smallest_first(triangle: &mut [u32; 3]) {
    let first = (0..3).min_by_key(|&k| triangle[k]).unwrap_or(0);
    triangle.rotate_left(first);
}
