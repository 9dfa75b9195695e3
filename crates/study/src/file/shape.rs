//! Bodies of a study file: quadrilateral blocks.

use super::curve::Curves;
use super::error::{Fault, refuse};
use super::fixed::Fixed;
use super::number::Finite;
use super::raw::{RawBlock, RawBody, RawPoint};
use super::spanned::Spanned;
use crate::study::{Block, Shape};
use signorini_contact::Point;
use signorini_contact::geometry::{Path, Piece, SharedCurve, twice_area};
use signorini_contact::mesh::blocks::{EVEN, QuadBlock};
use std::ops::Range;

/// Steepest grading of a block: beyond it cells are needles.
const STEEPEST: f64 = 1e4;

/// The point of two coordinates.
pub fn point(p: &RawPoint) -> Point {
    Point::new(p[0].0, p[1].0)
}

/// The shape of a body given by a rectangle or by blocks.
pub fn shape(raw: &Spanned<RawBody>, curves: &Curves) -> Result<Shape, Fault> {
    let body = raw.get_ref();
    if let Some(physical) = &body.physical {
        let message =
            format!("body `{}` is said to be a physical surface, and there is no [mesh]", body.name.get_ref());
        return refuse(physical.span(), message, "add [mesh] with `file = \"….msh\"`, or give `rectangle` or `blocks`");
    }
    let blocks = match (&body.rectangle, &body.blocks) {
        (Some(rectangle), None) => vec![rectangle_block(rectangle, body.divisions.as_ref())?],
        (None, Some(blocks)) => {
            if let Some(d) = &body.divisions {
                let message = "`divisions` of a body belong to its `rectangle`";
                return refuse(d.span(), message, "give each block its own `divisions`");
            }
            listed(blocks, curves)?
        }
        _ => {
            let message = format!("body `{}` needs either `rectangle` or `blocks`", body.name.get_ref());
            return refuse(body.name.span(), message, "give exactly one of the two");
        }
    };
    Ok(Shape { name: body.name.get_ref().clone(), blocks, imported: None })
}

fn rectangle_block(
    raw: &Spanned<Fixed<RawPoint, 2>>,
    split: Option<&Spanned<Fixed<usize, 2>>>,
) -> Result<Block, Fault> {
    let [a, b] = raw.get_ref().each_ref().map(point);
    if !(a.x < b.x && a.y < b.y) {
        let message = format!("rectangle ({}, {}) – ({}, {}) has no area", a.x, a.y, b.x, b.y);
        return refuse(raw.span(), message, "give the lower left corner, then the upper right one");
    }
    Ok(Block {
        corners: [a, Point::new(b.x, a.y), b, Point::new(a.x, b.y)],
        divisions: divisions(split)?,
        curves: Default::default(),
        grading: EVEN,
    })
}

fn listed(raw: &Spanned<Vec<RawBlock>>, curves: &Curves) -> Result<Vec<Block>, Fault> {
    if raw.get_ref().is_empty() {
        return refuse(raw.span(), "a body without blocks", "give at least one block");
    }
    raw.get_ref().iter().map(|b| block(b, curves)).collect()
}

fn block(raw: &RawBlock, curves: &Curves) -> Result<Block, Fault> {
    let corners = raw.corners.get_ref().each_ref().map(point);
    for i in 0..4 {
        // A convex quadrilateral turns left at every corner; only then its bilinear map folds nowhere.
        let turn = twice_area(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]);
        if turn <= 0.0 {
            let c = corners[(i + 1) % 4];
            let message = format!("block: no left turn at the corner ({}, {}), (b−a)×(c−b) = {turn} ≤ 0", c.x, c.y);
            return refuse(raw.corners.span(), message, "give four corners of a convex block, counterclockwise");
        }
    }
    let mut sides: [Option<SharedCurve>; 4] = Default::default();
    if let Some(names) = &raw.curves {
        for (k, name) in names.0.iter().enumerate() {
            sides[k] = curves.between(name, [corners[k], corners[(k + 1) % 4]])?;
        }
    }
    Ok(Block {
        corners,
        divisions: divisions(raw.divisions.as_ref())?,
        curves: sides,
        grading: grading(raw.grading.as_ref())?,
    })
}

/// The ratio of the last cell to the first in each direction.
fn grading(raw: Option<&Spanned<Fixed<Finite, 2>>>) -> Result<[f64; 2], Fault> {
    let Some(raw) = raw else { return Ok(EVEN) };
    let g = raw.get_ref().0.map(|x| x.0);
    if g.iter().any(|g| !(STEEPEST.recip()..=STEEPEST).contains(g)) {
        let message = format!("grading {g:?} must lie between {} and {STEEPEST}", STEEPEST.recip());
        return refuse(raw.span(), message, "give how many times as long the last cell is as the first; 1 is even");
    }
    Ok(g)
}

fn divisions(raw: Option<&Spanned<Fixed<usize, 2>>>) -> Result<[usize; 2], Fault> {
    let Some(raw) = raw else { return Ok([1, 1]) };
    let d = raw.get_ref().0;
    if d.iter().any(|n| !(1..=1024).contains(n)) {
        return refuse(raw.span(), format!("divisions {d:?} must lie between 1 and 1024"), "divide by whole numbers");
    }
    Ok(d)
}

/// A polyline of at least two different points whose corners lie on sides of `shape`'s blocks.
fn polyline(raw: &Spanned<Vec<RawPoint>>, shapes: &[&Shape]) -> Result<Vec<Point>, Fault> {
    let points: Vec<Point> = raw.get_ref().iter().map(point).collect();
    if points.len() < 2 {
        let message = format!("a polyline of {} point(s)", points.len());
        return refuse(raw.span(), message, "give at least two points");
    }
    if let Some(w) = points.windows(2).find(|w| w[0] == w[1]) {
        let message = format!("the point ({}, {}) stands twice in a row", w[0].x, w[0].y);
        return refuse(raw.span(), message, "leave one of them out");
    }
    for shape in shapes {
        on_sides(&points, shape, raw.span())?;
    }
    Ok(points)
}

/// A path of straight segments and curves whose corners lie on sides of the shapes' blocks.
pub fn path(
    along: &Spanned<Vec<RawPoint>>,
    names: &[Spanned<String>],
    curves: &Curves,
    shapes: &[&Shape],
) -> Result<Path, Fault> {
    let corners = polyline(along, shapes)?;
    if let Some(extra) = names.get(corners.len() - 1) {
        let message = format!("{} curves for {} segments", names.len(), corners.len() - 1);
        return refuse(extra.span(), message, "name at most one curve for each segment; \"\" is straight");
    }
    let curve = |(k, name): (usize, &Spanned<String>)| curves.between(name, [corners[k], corners[k + 1]]);
    let named: Result<Vec<_>, Fault> = names.iter().enumerate().map(curve).collect();
    Ok(Path { curves: named?, corners })
}

/// Refuses a point that lies on no side of the body.
pub fn on_sides(points: &[Point], shape: &Shape, span: Range<usize>) -> Result<(), Fault> {
    let boundary = shape.imported.iter().flat_map(|i| i.boundary.clone());
    let pieces: Vec<Piece> = shape.blocks.iter().flat_map(sides).chain(boundary).collect();
    let reach = |p: &Piece| (p.point(1.0) - p.point(0.0)).norm();
    let size = shape.blocks.iter().map(|b| (b.corners[2] - b.corners[0]).norm()).chain(pieces.iter().map(reach));
    let tolerance = 1e-9 * size.fold(0.0, f64::max);
    let off = |p: &Point| pieces.iter().all(|s| s.distance(*p) > tolerance);
    match points.iter().find(|p| off(p)) {
        None => Ok(()),
        Some(p) => {
            let message = format!("the point ({}, {}) lies on no side of body `{}`", p.x, p.y, shape.name);
            refuse(span, message, "move it onto the body's boundary, or correct the body")
        }
    }
}

fn sides(block: &Block) -> [Piece; 4] {
    let quad = QuadBlock { curves: block.curves.clone(), ..QuadBlock::straight(block.corners, [1, 1]) };
    [0, 1, 2, 3].map(|k| quad.side(k))
}
