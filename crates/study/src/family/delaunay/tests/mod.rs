//! Shapes to fill, and what is measured on the meshes.

use super::*;
use signorini_contact::geometry::{CircularArc, Piece, Segment, SharedCurve, twice_area};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use std::sync::Arc;

mod chain;
mod fill;
mod refusals;
mod score;
mod strong;

fn points(xy: &[[f64; 2]]) -> Vec<Point> {
    xy.iter().map(|&[x, y]| Point::new(x, y)).collect()
}

fn straight(a: Point, b: Point) -> Piece {
    Piece::Straight(Segment { a, b })
}

/// The part of the quarter circle between two parameters.
fn arc(span: [f64; 2]) -> Piece {
    let circle = CircularArc { centre: Point::zeros(), radius: 1.0, from: 0.0, to: FRAC_PI_2 };
    let curve: SharedCurve = Arc::new(circle);
    Piece::Curved { curve, span }
}

/// An arc of `m` steps closed by straight pieces with steps of about `size`.
fn closed_by(arc: Piece, m: usize, corners: &[[f64; 2]], size: f64) -> Loop {
    let straights = corners.windows(2).map(|w| [0, 1].map(|k| Point::new(w[k][0], w[k][1])));
    let runs = straights.map(|[a, b]| Run { piece: straight(a, b), steps: ((b - a).norm() / size).round() as usize });
    Loop { runs: [Run { piece: arc, steps: m }].into_iter().chain(runs).collect() }
}

/// `{x, y > 0, x + y > ½, r < 1}`.
fn inside(m: usize, size: f64) -> Loop {
    closed_by(arc([0.0, 1.0]), m, &[[0.0, 1.0], [0.0, 0.5], [0.5, 0.0], [1.0, 0.0]], size)
}

/// `(0, 2)²` without the unit disc.
fn outside(m: usize, size: f64) -> Loop {
    closed_by(arc([1.0, 0.0]), m, &[[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 1.0]], size)
}

/// The chord of a quarter circle in `m` steps.
fn chord(m: usize) -> f64 {
    2.0 * (FRAC_PI_4 / m as f64).sin()
}

/// A polygon whose sides are divided so that each step has about the length that `size` gives in its middle.
fn divided(corners: &[[f64; 2]], size: &dyn Fn(Point) -> f64) -> Vec<Point> {
    let corners = points(corners);
    let mut nodes = Vec::new();
    for (k, &a) in corners.iter().enumerate() {
        let b = corners[(k + 1) % corners.len()];
        // Nodes where the number of steps counted from a, ∫ ds/size, is a whole share of its total.
        let fine = 4000;
        let place = |i: usize| a + (b - a) * (i as f64 / fine as f64);
        let mut counted = vec![0.0];
        (0..fine).for_each(|i| counted.push(counted[i] + (place(i + 1) - place(i)).norm() / size(place(i))));
        let steps = counted[fine].round().max(1.0);
        nodes.extend(
            (0..steps as usize).map(|s| place(counted.partition_point(|&c| c < counted[fine] * s as f64 / steps))),
        );
    }
    nodes
}

/// What a mesh is like.
#[derive(Debug)]
struct Measured {
    /// The smallest angle in degrees.
    angle: f64,
    /// The longest side over the shortest.
    ratio: f64,
    /// The longest side with at least one inner end.
    longest_inner: f64,
}

fn measure(mesh: &Triangulation, boundary: usize) -> Measured {
    let (mut angle, mut longest, mut shortest, mut inner) = (180.0, 0.0, f64::INFINITY, 0.0);
    for t in &mesh.triangles {
        for k in 0..3 {
            let [i, j, l] = [0, 1, 2].map(|s| t[(k + s) % 3] as usize);
            let [a, b, c] = [i, j, l].map(|i| mesh.points[i]);
            angle = f64::min(angle, (b - a).angle(&(c - a)).to_degrees());
            let side = (b - a).norm();
            longest = f64::max(longest, side);
            shortest = f64::min(shortest, side);
            if i >= boundary || j >= boundary {
                inner = f64::max(inner, side);
            }
        }
    }
    Measured { angle, ratio: longest / shortest, longest_inner: inner }
}

/// Twice the area of a polygon by the trapezoidal formula.
fn shoelace(polygon: &[Point]) -> f64 {
    let n = polygon.len();
    (0..n).map(|k| (polygon[k].x - polygon[(k + 1) % n].x) * (polygon[k].y + polygon[(k + 1) % n].y)).sum()
}
