//! The scenes that families are tried on.

use super::super::{Domain, Family, Level, build_level, build_reference};
use crate::study::{Block, Shape};
use signorini_contact::geometry::{CircularArc, Path, SharedCurve};
use signorini_contact::mesh::{Hierarchy, PartOutline};
use signorini_contact::{Body, ContactLine, Error, Point};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};
use std::sync::Arc;

/// Two bodies and what is known of them.
pub struct Scene {
    pub name: &'static str,
    pub shapes: [Shape; 2],
    pub outlines: Vec<PartOutline>,
    pub contact: ContactLine,
    /// Areas of the bodies, by hand.
    pub areas: [f64; 2],
    /// Smallest angle of the structured mesh of one cell, in degrees.
    pub angle: f64,
}

impl Scene {
    pub fn domain(&self) -> Domain<'_> {
        Domain {
            shapes: &self.shapes,
            outlines: self.outlines.clone(),
            contact: &self.contact,
            initial_gap: None,
            discretisation: Default::default(),
        }
    }

    pub fn level(&self, family: Family, cells: &[usize], index: usize) -> Result<Level, Error> {
        build_level(&family, &self.domain(), cells, index)
    }

    pub fn reference(&self, family: Family, cells: &[usize], n: usize) -> Result<Hierarchy, Error> {
        build_reference(&family, &self.domain(), cells, n)
    }
}

pub fn points(xy: &[[f64; 2]]) -> Vec<Point> {
    xy.iter().map(|&[x, y]| Point::new(x, y)).collect()
}

pub fn shape(name: &str, blocks: &[[[f64; 2]; 4]]) -> Shape {
    let block = |c: &[[f64; 2]; 4]| Block {
        corners: c.map(|[x, y]| Point::new(x, y)),
        divisions: [1, 1],
        curves: Default::default(),
        grading: [1.0, 1.0],
    };
    Shape { name: name.into(), blocks: blocks.iter().map(block).collect(), imported: None }
}

pub fn part(body: Body, name: &str, along: &[[f64; 2]]) -> PartOutline {
    PartOutline { body, name: name.into(), along: points(along).into() }
}

pub fn rectangle(x: [f64; 2], y: [f64; 2]) -> [[f64; 2]; 4] {
    [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]]
}

pub fn squares() -> Scene {
    Scene {
        name: "squares",
        shapes: [
            shape("upper", &[rectangle([0.0, 1.0], [0.0, 1.0])]),
            shape("lower", &[rectangle([0.0, 1.0], [-1.0, 0.0])]),
        ],
        outlines: vec![
            part(Body::First, "top", &[[1.0, 1.0], [0.0, 1.0]]),
            part(Body::First, "left", &[[0.0, 1.0], [0.0, 0.0]]),
            part(Body::First, "right", &[[1.0, 0.0], [1.0, 1.0]]),
            part(Body::Second, "rest", &[[0.0, 0.0], [0.0, -1.0], [1.0, -1.0], [1.0, 0.0]]),
        ],
        contact: points(&[[0.0, 0.0], [1.0, 0.0]]).into(),
        areas: [1.0, 1.0],
        angle: 45.0,
    }
}

/// Contact with a kink, two blocks to a body.
pub fn kinked() -> Scene {
    let upper = [[[-1.0, 0.2], [0.0, 0.0], [0.0, 1.5], [-1.0, 1.5]], [[0.0, 0.0], [1.0, 0.5], [1.0, 1.5], [0.0, 1.5]]];
    let lower =
        [[[-1.0, -1.0], [0.0, -1.0], [0.0, 0.0], [-1.0, 0.2]], [[0.0, -1.0], [1.0, -1.0], [1.0, 0.5], [0.0, 0.0]]];
    let top = [[1.0, 0.5], [1.0, 1.5], [-1.0, 1.5], [-1.0, 0.2]];
    let bottom = [[-1.0, 0.2], [-1.0, -1.0], [1.0, -1.0], [1.0, 0.5]];
    Scene {
        name: "kinked",
        shapes: [shape("upper", &upper), shape("lower", &lower)],
        outlines: vec![part(Body::First, "top", &top), part(Body::Second, "bottom", &bottom)],
        contact: points(&[[-1.0, 0.2], [0.0, 0.0], [1.0, 0.5]]).into(),
        areas: [2.65, 2.35],
        // Upper right block, at (0, 0) between the diagonal and the contact side: atan 1.5 − atan 0.5.
        angle: 29.74488129694223,
    }
}

/// A punch `1 × 1` on a block `3 × 1`; contact ends inside a straight side of `Ω''`.
pub fn punch() -> Scene {
    let lower = [0.0, 1.0, 2.0].map(|x| rectangle([x, x + 1.0], [-1.0, 0.0]));
    let rest = [[1.0, 0.0], [0.0, 0.0], [0.0, -1.0], [3.0, -1.0], [3.0, 0.0], [2.0, 0.0]];
    Scene {
        name: "punch",
        shapes: [shape("punch", &[rectangle([1.0, 2.0], [0.0, 1.0])]), shape("base", &lower)],
        outlines: vec![
            part(Body::First, "rest", &[[2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 0.0]]),
            part(Body::Second, "rest", &rest),
        ],
        contact: points(&[[1.0, 0.0], [2.0, 0.0]]).into(),
        areas: [1.0, 3.0],
        angle: 45.0,
    }
}

/// A parallelogram whose other diagonals would make angles of 12°.
pub fn sheared() -> Scene {
    let upper = [[0.0, 0.0], [1.0, 0.0], [-0.5, 1.0], [-1.5, 1.0]];
    let lower = [[0.0, -1.0], [1.0, -1.0], [1.0, 0.0], [0.0, 0.0]];
    Scene {
        name: "sheared",
        shapes: [shape("upper", &[upper]), shape("lower", &[lower])],
        outlines: vec![
            part(Body::First, "rest", &[upper[1], upper[2], upper[3], upper[0]]),
            part(Body::Second, "rest", &[lower[3], lower[0], lower[1], lower[2]]),
        ],
        contact: points(&[[0.0, 0.0], [1.0, 0.0]]).into(),
        areas: [1.0, 1.0],
        // At (−0.5, 1), between the diagonal and the right side: atan 2 − atan (2/3).
        angle: 29.744_881_296_942_22,
    }
}

/// A quarter of the unit disc in a square of side 2 with a round hole.
pub fn disc() -> Scene {
    let arc: SharedCurve = Arc::new(CircularArc { centre: Point::zeros(), radius: 1.0, from: 0.0, to: FRAC_PI_2 });
    let c = FRAC_1_SQRT_2;
    let inside = [[0.5, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.5]];
    let outside = [[[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [c, c]], [[c, c], [2.0, 2.0], [0.0, 2.0], [0.0, 1.0]]];
    let mut shapes = [shape("inside", &[inside]), shape("outside", &outside)];
    shapes[0].blocks[0].divisions = [1, 2];
    shapes[0].blocks[0].curves[1] = Some(arc.clone());
    shapes[1].blocks.iter_mut().for_each(|b| b.curves[3] = Some(arc.clone()));
    let rest = [[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 1.0]];
    Scene {
        name: "disc",
        shapes,
        outlines: vec![
            part(Body::First, "rest", &[[0.0, 1.0], [0.0, 0.5], [0.5, 0.0], [1.0, 0.0]]),
            part(Body::Second, "rest", &rest),
        ],
        contact: ContactLine::Common(Path::along(arc)),
        areas: [0.5 * FRAC_PI_2 - 0.125, 4.0 - 0.5 * FRAC_PI_2],
        angle: f64::NAN,
    }
}
