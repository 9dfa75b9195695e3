//! Where inner nodes start: a lattice of equilateral triangles, halved where the wished length asks for it.
//!
//! ```text
//!    (i, j+h)                 a cell (i, j, h) in lattice coordinates; h < 0 is the same upside down.
//!      / \                    Four halves: three at its corners and one, upside down, in the middle.
//!     /___\
//!    / \ / \
//!  (i,j)───(i+h, j)
//! ```

use super::wish::Wish;
use super::{Random, refuse};
use signorini_contact::{Error, Point, Vec2};

/// How often a cell may be halved.
const DEPTH: u32 = 20;

/// Most cells of a lattice.
const MOST: usize = 1 << 22;

/// Place, direction and density of a lattice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// First direction, a unit vector.
    direction: Vec2,
    /// Shift as a share of the spacing.
    shift: Vec2,
    /// Spacing as a share of the wished length.
    spacing: f64,
    /// Nodes nearer to the boundary than this share of the wished length are left out.
    margin: f64,
}

impl Start {
    /// A start with a spacing between the given bounds.
    pub fn random(random: &mut Random, spacings: [f64; 2]) -> Self {
        let [u, v] = random.in_disc();
        let [x, y] = random.in_disc();
        let mut between = |low: f64, high: f64| low + (high - low) * 0.5 * (1.0 + random.signed());
        let spacing = between(spacings[0], spacings[1]);
        let length = (u * u + v * v).sqrt();
        // The centre of the disc has no direction; it comes up once in 2^100.
        let direction = if length > 0.0 { Vec2::new(u, v) / length } else { Vec2::new(1.0, 0.0) };
        Self { direction, shift: Vec2::new(x, y), spacing, margin: between(0.5, 0.7) }
    }
}

/// The nodes of the lattice that lie in the bounding box and not too near to the boundary, row by row. Some are outside the
/// polygon; the triangulation leaves them out.
///
/// # Errors
/// A wished length that is not positive and finite, or too many cells.
pub(super) fn inner_nodes(wish: &Wish, start: &Start) -> Result<Vec<Point>, Error> {
    let lattice = Lattice::new(wish, start);
    let mut corners = Vec::new();
    let mut open = lattice.coarsest()?;
    while let Some(cell) = open.pop() {
        if lattice.misses(cell) {
            continue;
        }
        if lattice.is_long(cell)? {
            open.extend(halves(cell));
        } else {
            corners.extend(corners_of(cell));
        }
        if corners.len() > 3 * MOST {
            return too_many();
        }
    }
    corners.sort_unstable();
    corners.dedup();
    let margin = |x| start.margin * wish.size(x);
    let inner = |x: &Point| lattice.holds(*x) && !wish.near.within(*x, margin(*x));
    Ok(corners.into_iter().map(|[j, i]| lattice.point(i, j)).filter(inner).collect())
}

fn too_many<T>() -> Result<T, Error> {
    refuse(format!("the wished side length asks for more than {MOST} triangles; ask for longer sides"))
}

/// `[i, j, h]`.
type Cell = [i64; 3];

struct Lattice<'a> {
    wish: &'a Wish<'a>,
    spacing: f64,
    /// Length of the coarsest cells' sides.
    length: f64,
    origin: Point,
    axes: [Vec2; 2],
}

impl<'a> Lattice<'a> {
    fn new(wish: &'a Wish<'a>, start: &Start) -> Self {
        let length = wish.largest() * start.spacing;
        let e = start.direction;
        // e turned by 60°
        let f = 0.5 * e + 0.75_f64.sqrt() * Vec2::new(-e.y, e.x);
        let unit = length / f64::from(1 << DEPTH);
        let origin = 0.5 * (wish.bounds[0] + wish.bounds[1]) + length * start.shift;
        Self { wish, spacing: start.spacing, length, origin, axes: [e * unit, f * unit] }
    }

    /// The cells of the coarsest lattice around the bounding box.
    fn coarsest(&self) -> Result<Vec<Cell>, Error> {
        // In a rhombus of 60° with half diagonal r, coordinates reach 2r/√3; the shift and the cell itself add two each.
        let reach = (1.2 * (self.wish.bounds[1] - self.wish.bounds[0]).norm() / self.length).ceil() + 4.0;
        if reach * reach > MOST as f64 {
            return too_many();
        }
        let (reach, h) = (reach as i64, 1_i64 << DEPTH);
        let rows = (-reach..=reach).rev().flat_map(|j| (-reach..=reach).rev().map(move |i| (i * h, j * h)));
        let cells = rows.flat_map(|(i, j)| [[i + h, j + h, -h], [i, j, h]]);
        Ok(cells.filter(|&cell| !self.misses(cell)).collect())
    }

    fn point(&self, i: i64, j: i64) -> Point {
        self.origin + self.axes[0] * i as f64 + self.axes[1] * j as f64
    }

    fn centre(&self, [i, j, h]: Cell) -> Point {
        self.point(3 * i + h, 3 * j + h) / 3.0 + self.origin * (2.0 / 3.0)
    }

    fn side(&self, cell: Cell) -> f64 {
        self.length * cell[2].unsigned_abs() as f64 / f64::from(1 << DEPTH)
    }

    fn holds(&self, x: Point) -> bool {
        let [low, high] = self.wish.bounds;
        low.x <= x.x && x.x <= high.x && low.y <= x.y && x.y <= high.y
    }

    /// Whether a cell lies outside the bounding box.
    fn misses(&self, cell: Cell) -> bool {
        let (centre, [low, high]) = (self.centre(cell), self.wish.bounds);
        (centre - centre.sup(&low).inf(&high)).norm() > self.side(cell)
    }

    /// Whether halving brings a cell nearer to the wished length.
    fn is_long(&self, cell: Cell) -> Result<bool, Error> {
        let size = self.spacing * self.wish.checked(self.centre(cell))?;
        Ok(self.side(cell) > std::f64::consts::SQRT_2 * size && cell[2].abs() > 1)
    }
}

fn halves([i, j, h]: Cell) -> [Cell; 4] {
    let k = h / 2;
    [[i, j, k], [i + k, j, k], [i, j + k, k], [i + k, j + k, -k]]
}

/// Row before column, so that sorting goes row by row.
fn corners_of([i, j, h]: Cell) -> [[i64; 2]; 3] {
    [[j, i], [j, i + h], [j + h, i]]
}
