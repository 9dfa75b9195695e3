//! Shrinking tiles: infinitely many switch points that accumulate at `x* = 1/√6`.
//!
//! ```text
//! u = Σ_j 1.5 (j+1)^{−β} d_j^q U((x−x*−d_j)/d_j, y/d_j),    d_j = 2^{−j}/4,    tile j = (x*+d_j, x*+2d_j)
//!
//! ──────┊▏▎▌│ tile 2 │     tile 1      │              tile 0               │──────
//!       x*                                                                x*+1/2
//! ```
//!
//! For `q = 1` the sum is in `H²` iff `β > 1/2`, and in no better Sobolev space; in general each tile adds
//! `(j+1)^{−2β} d_j^{2(q+1−s)}` to `|u|_s²`. A computation keeps finitely many tiles.

use super::Field;
use super::cell::{SIGMA, cell};
use super::parameters;
use super::polynomial::{switch, vertical};
use crate::expr::Real;
use signorini_contact::{Body, Point, geometry::Segment, material::Lame};

/// Most tiles that rounding leaves room for: `d_j` stays above 1e-8.
pub(super) const MOST_TILES: f64 = 24.0;

/// The first tiles of the sum.
#[derive(Clone, Debug)]
pub struct Tiles {
    beta: f64,
    power: f64,
    /// `1.5 (j+1)^{−β} d_j^q` for the tiles that are kept.
    weights: Vec<f64>,
    lame: [Lame; 2],
}

impl Tiles {
    /// By the decay `0 ≤ β ≤ 4`, the power `½ < q ≤ 2` of `d_j`, and the number of tiles kept, `1 … 24`.
    ///
    /// # Errors
    /// If a number is outside its range.
    pub fn new(beta: f64, power: f64, tiles: f64, lame: [Lame; 2]) -> Result<Self, String> {
        parameters::within("beta", beta, 0.0, 4.0)?;
        parameters::above("power", power, 0.5, 2.0)?;
        parameters::whole("tiles", tiles, 1.0, MOST_TILES)?;
        let weights = (0..tiles as i32).map(|j| weight(beta, power, j)).collect();
        Ok(Self { beta, power, weights, lame })
    }

    /// How many tiles a mesh of size `h` can see: up to and with the first `d_j < h/8`.
    ///
    /// # Errors
    /// If `h` is so small or so large that the number is not in `1 … 24`.
    pub fn visible(smallest_h: f64) -> Result<f64, String> {
        // 1/4 · 2^{−23} is the smallest tile that may be kept.
        parameters::within("smallest", smallest_h, 1e-6, 1.0)?;
        let last = (0..).find(|&j| size(j) < smallest_h / 8.0).unwrap_or(0);
        Ok(f64::from(last + 1))
    }

    /// The share of the strain seminorm of the whole sum that the dropped tiles hold. Tiles are copies of one another on
    /// disjoint supports, so their seminorms relate like their weights.
    pub fn dropped_share(&self) -> f64 {
        let squares = |from: usize, to: usize| -> f64 {
            (from..to).rev().map(|j| weight(self.beta, self.power, j as i32).powi(2)).sum()
        };
        // d_j^{2q} falls at least like 2^{−j}: beyond 200 more tiles nothing is left.
        let kept = self.weights.len();
        let tail = squares(kept, kept + 200);
        (tail / (tail + squares(0, kept))).sqrt()
    }

    /// The tile that holds `x* + t`.
    fn tile_of(&self, t: f64) -> Option<usize> {
        // d_j ≤ t < 2 d_j, d_j = 2^{−j−2}
        if !(t > 0.0 && t < 0.5) {
            return None;
        }
        let guess = (-2.0 - t.log2().floor()).max(0.0) as i32;
        let j = if t < size(guess) {
            guess + 1
        } else if t >= 2.0 * size(guess) {
            guess - 1
        } else {
            guess
        };
        usize::try_from(j).ok().filter(|&j| j < self.weights.len())
    }

    fn sizes(&self) -> impl Iterator<Item = f64> {
        (0..self.weights.len() as i32).map(size)
    }
}

/// `d_j = 2^{−j}/4`.
fn size(j: i32) -> f64 {
    0.25 * 0.5f64.powi(j)
}

fn weight(beta: f64, power: f64, j: i32) -> f64 {
    1.5 * f64::from(j + 1).powf(-beta) * size(j).powf(power)
}

impl Field for Tiles {
    fn eval<D: Real>(&self, body: Body, x: D, y: D) -> [D; 2] {
        let Some(j) = self.tile_of(x.re() - switch()) else {
            return [D::from(0.0); 2];
        };
        let d = size(j as i32);
        let xi = (x - (switch() + d)) * (1.0 / d);
        cell(body, self.lame[body.index()], xi, y * (1.0 / d)).map(|u| u * self.weights[j])
    }

    fn singular_points(&self) -> Vec<Point> {
        vec![Point::new(switch(), 0.0)]
    }

    fn break_lines(&self) -> Vec<Segment> {
        self.sizes()
            .flat_map(|d| {
                // A tile's left edge is the right edge of the next one: its lines reach as far as the larger tile does.
                [(1.0, d), (1.0 + SIGMA, d)].map(|(k, half)| vertical(switch() + k * d, half))
            })
            .chain(std::iter::once(vertical(switch() + 0.5, 0.25)))
            .collect()
    }

    fn switch_points(&self) -> Vec<Point> {
        self.sizes().flat_map(|d| [(1.0 + SIGMA) * d, d]).map(|t| Point::new(switch() + t, 0.0)).collect()
    }

    fn notes(&self) -> Vec<String> {
        let kept = self.weights.len();
        vec![format!(
            "the sum is cut after {kept} tiles, the last of width {:.3e}; the dropped ones hold {:.2e} of the whole \
             sum's strain seminorm",
            size(kept as i32 - 1),
            self.dropped_share()
        )]
    }
}
