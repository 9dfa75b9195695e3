//! Point location: which triangle of a body holds a point in the true geometry, and what the hat functions are there.
//!
//! A point belongs to a triangle with a curved side according to its exact region: beyond the chord but on the body's side of
//! the arc it is in the bulging triangle, between chord and arc of a bitten one it is not in the body at all.
//!
//! ```text
//!   +---+---+---+     Each body lies on a grid of square buckets, as many as it has triangles. A bucket lists the
//!   |  /|\  |   |     triangles whose bounding box meets it, in ascending order; the first that holds the point is
//!   +-/-+-\-+---+     taken. A point of no triangle (missed by rounding, or in a part of the plane that only another
//!   |/__|__\|   |     mesh of the same body covers) goes to the one that it lies least outside of, whose function is
//!   +---+---+---+     continued.
//! ```

use super::{Body, Mesh};
use crate::element::{CurvedTriangle, gradients, hats};
use crate::geometry::{Point, Vec2, cross};

/// Points that a triangle misses by this share of a bucket are taken to be in it.
const ROUNDING: f64 = 1e-10;

/// Samples of an arc, from which the bounding box of its triangle is made.
const SAMPLES: u32 = 8;

/// Finds the triangles of a mesh by place. `O(1)` per point on quasi-uniform meshes.
pub struct Locator<'a> {
    mesh: &'a Mesh,
    grids: [Grid; 2],
    /// Of every curved side: between which values the apex' hat function of the chord triangle stays along the arc.
    bands: Vec<[f64; 2]>,
}

/// A point in a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Located {
    /// The triangle.
    pub triangle: usize,
    /// The values of the hat functions of its corners at the point.
    pub hats: [f64; 3],
    /// Their gradients.
    pub gradients: [Vec2; 3],
    /// How far the point lies outside the triangle's exact region, 0 inside.
    pub outside: f64,
}

impl Located {
    /// The value of a nodal field of the mesh.
    pub fn value(&self, mesh: &Mesh, nodal: &[Vec2]) -> Vec2 {
        let nodes = mesh.triangles[self.triangle];
        (0..3).map(|k| self.hats[k] * nodal[nodes[k] as usize]).sum()
    }

    /// Its gradient, `g[i][j] = ∂_j u_i`.
    pub fn gradient(&self, mesh: &Mesh, nodal: &[Vec2]) -> [[f64; 2]; 2] {
        let corners = mesh.triangles[self.triangle].map(|i| nodal[i as usize]);
        crate::element::displacement_gradient(&self.gradients, corners)
    }
}

impl<'a> Locator<'a> {
    /// Sorts the triangles of both bodies into buckets: `O(N)` on quasi-uniform meshes.
    pub fn new(mesh: &'a Mesh) -> Self {
        let (first, all) = (mesh.first_triangles, mesh.triangles.len());
        let bands = mesh.curved_triangles().map(|(_, curved)| band(&curved)).collect();
        Self { mesh, grids: [0..first, first..all].map(|own| Grid::new(mesh, own)), bands }
    }

    /// The mesh that is searched.
    pub fn mesh(&self) -> &'a Mesh {
        self.mesh
    }

    /// The triangle of `body` that holds `x`, or misses it least, and its hat functions at `x`.
    pub fn locate(&self, body: Body, x: Point) -> Located {
        let (triangle, excess) = self.grids[body.index()].search(x, |t| self.excess(t, x));
        let (hats, gradients) = match self.mesh.curved_triangle(triangle) {
            Some(curved) => curved.evaluate(x),
            None => {
                let corners = self.mesh.corners(triangle);
                (hats(corners, x), gradients(corners).0)
            }
        };
        Located { triangle, hats, gradients, outside: excess.max(0.0) }
    }

    /// Calls `visit(t)` once for every triangle of `body` whose bounding box may meet that of the given points, ascending.
    pub fn each_near(&self, body: Body, points: [Point; 3], visit: &mut impl FnMut(usize)) {
        let grid = &self.grids[body.index()];
        let [low, high] = points.into_iter().fold([points[0]; 2], grow);
        let ([i0, j0], [i1, j1]) = (grid.bucket(low), grid.bucket(high));
        let mut found: Vec<u32> = Vec::new();
        for j in j0..=j1 {
            (i0..=i1).for_each(|i| found.extend(grid.members([i, j])));
        }
        found.sort_unstable();
        found.dedup();
        found.into_iter().for_each(|t| visit(t as usize));
    }

    /// How far `x` lies outside of triangle `t`: the largest distance beyond one of its sides; beside a curved triangle
    /// a lower bound of it. Not positive inside.
    pub(super) fn excess(&self, t: usize, x: Point) -> f64 {
        let corners = self.mesh.corners(t);
        // beyond side i, which is opposite corner i
        let beyond = [0, 1, 2].map(|i| {
            let (a, b) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
            cross(x - a, b - a) / (b - a).norm()
        });
        let largest = |of: [f64; 3]| of.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let Ok(k) = self.mesh.curved.sides.binary_search_by_key(&(t as u32), |s| s.triangle) else {
            return largest(beyond);
        };
        let apex = usize::from(self.mesh.curved.sides[k].apex);
        let ([low, high], hat) = (self.bands[k], hats(corners, x)[apex]);
        let beside = f64::max(beyond[(apex + 1) % 3], beyond[(apex + 2) % 3]);
        // only along the arc has the curve itself to be asked
        if hat > high {
            return beside;
        }
        if beside > ROUNDING {
            // beyond / −hat is the height of the chord triangle
            let past = if hat < low { beyond[apex] * (low - hat) / -hat } else { beside };
            return f64::max(beside, past);
        }
        self.mesh.curved_triangle(t).map_or(beside, |curved| curved.excess(x))
    }
}

/// The buckets of one body.
struct Grid {
    low: Point,
    /// Side of a bucket.
    size: f64,
    cells: [usize; 2],
    /// Bucket `k` lists `members[start[k]..start[k + 1]]`.
    start: Vec<u32>,
    members: Vec<u32>,
}

impl Grid {
    fn new(mesh: &Mesh, own: std::ops::Range<usize>) -> Self {
        let boxes: Vec<[Point; 2]> = own.clone().map(|t| bounding_box(mesh, t)).collect();
        let whole = boxes.iter().copied().reduce(|[a, b], [c, d]| [a.inf(&c), b.sup(&d)]);
        let [low, high] = whole.unwrap_or([Point::zeros(); 2]);
        let extent = high - low;
        let size = (extent.x * extent.y / boxes.len().max(1) as f64).sqrt().max(f64::MIN_POSITIVE);
        let cells = [extent.x, extent.y].map(|e| (e / size).ceil().max(1.0) as usize);
        let mut grid = Self { low, size, cells, start: vec![0; cells[0] * cells[1] + 1], members: Vec::new() };
        boxes.iter().for_each(|b| grid.each_bucket(b, |grid, k| grid.start[k + 1] += 1));
        (1..grid.start.len()).for_each(|k| grid.start[k] += grid.start[k - 1]);
        grid.members = vec![0; grid.start[grid.start.len() - 1] as usize];
        let mut next = grid.start.clone();
        for (t, b) in own.zip(&boxes) {
            grid.each_bucket(b, |grid, k| {
                grid.members[next[k] as usize] = t as u32;
                next[k] += 1;
            });
        }
        grid
    }

    fn each_bucket(&mut self, [low, high]: &[Point; 2], mut visit: impl FnMut(&mut Self, usize)) {
        let ([i0, j0], [i1, j1]) = (self.bucket(*low), self.bucket(*high));
        for j in j0..=j1 {
            (i0..=i1).for_each(|i| visit(self, j * self.cells[0] + i));
        }
    }

    fn members(&self, [i, j]: [usize; 2]) -> &[u32] {
        let k = j * self.cells[0] + i;
        &self.members[self.start[k] as usize..self.start[k + 1] as usize]
    }

    /// The bucket of a point, the nearest one for points beside the grid.
    fn bucket(&self, x: Point) -> [usize; 2] {
        [0, 1].map(|k| (((x[k] - self.low[k]) / self.size).max(0.0) as usize).min(self.cells[k] - 1))
    }

    /// The first triangle with an excess of at most 0 in the bucket of `x`; else the one with the least excess in the
    /// buckets around, ring after ring until no farther one can do better.
    fn search(&self, x: Point, excess: impl Fn(usize) -> f64) -> (usize, f64) {
        let [i, j] = self.bucket(x);
        let mut best = (0, f64::INFINITY);
        for ring in 0..self.cells[0].max(self.cells[1]) {
            for [i, j] in self.ring([i, j], ring) {
                for &t in self.members([i, j]) {
                    let found = excess(t as usize);
                    if found <= 0.0 {
                        return (t as usize, found);
                    }
                    best = if found < best.1 { (t as usize, found) } else { best };
                }
            }
            let reach = if ring == 0 { ROUNDING } else { ring as f64 };
            if best.1 <= reach * self.size {
                break;
            }
        }
        best
    }

    /// The buckets whose larger distance in rows and columns from the middle one is `ring`, row by row.
    fn ring(&self, [i, j]: [usize; 2], ring: usize) -> impl Iterator<Item = [usize; 2]> + use<> {
        let around = |k: usize, cells: usize| k.saturating_sub(ring)..=(k + ring).min(cells - 1);
        let columns = around(i, self.cells[0]);
        let rim = move |[a, b]: &[usize; 2]| a.abs_diff(i).max(b.abs_diff(j)) == ring;
        around(j, self.cells[1]).flat_map(move |b| columns.clone().map(move |a| [a, b])).filter(rim)
    }
}

fn grow([low, high]: [Point; 2], x: Point) -> [Point; 2] {
    [low.inf(&x), high.sup(&x)]
}

/// Between which values the apex' hat function stays along the arc, with room for what it does between two samples.
fn band(curved: &CurvedTriangle) -> [f64; 2] {
    let at = |k: u32| hats(curved.corners, curved.arc(f64::from(k) / f64::from(SAMPLES)).0)[curved.apex];
    let [low, high] = (0..=SAMPLES).map(at).fold([0.0_f64; 2], |[low, high], h| [low.min(h), high.max(h)]);
    let room = 0.1 * (high - low) + ROUNDING;
    [low - room, high + room]
}

/// A box that holds the exact region of a triangle.
fn bounding_box(mesh: &Mesh, t: usize) -> [Point; 2] {
    let corners = mesh.corners(t);
    let straight = corners.into_iter().fold([corners[0]; 2], grow);
    let Some(curved) = mesh.curved_triangle(t) else { return straight };
    let arc = (0..=SAMPLES).map(|k| curved.arc(f64::from(k) / f64::from(SAMPLES)).0);
    let [low, high] = arc.fold(straight, grow);
    // what the arc does between two samples
    let margin = 0.05 * (high - low).max() * Vec2::new(1.0, 1.0);
    [low - margin, high + margin]
}
