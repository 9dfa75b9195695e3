//! Many switches: `u_N = N^{-3/2} U({Nx}, Ny)`, one cell repeated `N` times along the contact line.
//!
//! `|u_N|_2` is the same for every `N` while the number of switch points grows with it: a bound that counts switch points
//! must show, one that does not must hold uniformly.

use super::Field;
use super::cell::{SIGMA, cell};
use super::parameters;
use super::polynomial::vertical;
use crate::expr::Real;
use signorini_contact::{Body, Point, geometry::Segment, material::Lame};

/// `N` cells on the unit square.
#[derive(Clone, Copy, Debug)]
pub struct ManySwitches {
    cells: f64,
    lame: [Lame; 2],
}

impl ManySwitches {
    /// By the number of cells, `N = 1 … 4096`.
    ///
    /// # Errors
    /// If `N` is not a whole number in its range.
    pub fn new(cells: f64, lame: [Lame; 2]) -> Result<Self, String> {
        parameters::whole("cells", cells, 1.0, 4096.0)?;
        Ok(Self { cells, lame })
    }

    fn numbers(&self) -> impl Iterator<Item = f64> {
        (0..self.cells as u32).map(f64::from)
    }
}

impl Field for ManySwitches {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let n = self.cells;
        // The right end x = 1 belongs to the last cell.
        let number = (x.re() * n).floor().clamp(0.0, n - 1.0);
        let u = cell(body, self.lame[body.index()], x * n - number, y * n);
        let scale = n.powf(-1.5);
        u.map(|c| c * scale)
    }

    /// The edges of the strip `|y| < 1/N` too, where third derivatives jump: they spare quadrature long slivers.
    fn break_lines(&self) -> Vec<Segment> {
        let n = self.cells;
        let edge = |y: f64| Segment { a: Point::new(0.0, y), b: Point::new(1.0, y) };
        let within = self.numbers().flat_map(|j| [j / n, (j + SIGMA) / n]).skip(1).map(|x| vertical(x, 1.0 / n));
        [edge(1.0 / n), edge(-1.0 / n)].into_iter().chain(within).collect()
    }

    fn switch_points(&self) -> Vec<Point> {
        let n = self.cells;
        self.numbers().flat_map(|j| [j / n, (j + SIGMA) / n]).skip(1).map(|x| Point::new(x, 0.0)).collect()
    }
}
