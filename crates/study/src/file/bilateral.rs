//! The bilateral part of a study's contact zone: the zone is cut where it begins and ends, so that these points are corners
//! of it, which every family keeps as nodes and every mesh is asked for.

use super::error::{Fault, refuse};
use super::fixed::Fixed;
use super::raw::RawPoint;
use super::shape::point;
use super::spanned::Spanned;
use signorini_contact::geometry::Piece;
use signorini_contact::{ContactLine, Path, Point};

/// Share of the zone's length within which a point lies on it, and of a piece within which two places are one.
const SAME: f64 = 1e-9;

/// A part of the zone, from its first to its last point.
type RawPart = Spanned<Fixed<RawPoint, 2>>;

/// The zone with further corners where bilateral parts end, and the numbers of the pieces that lie on them.
pub fn split(line: ContactLine, parts: &[RawPart]) -> Result<(ContactLine, Vec<usize>), Fault> {
    let Some(first) = parts.first() else { return Ok((line, Vec::new())) };
    let ContactLine::Common(path) = line else {
        let next = "give the zone by `along`, or leave `bilateral` out";
        return refuse(first.span(), "`bilateral` across a `gap`: bodies that are apart are not tied", next);
    };
    let pieces: Vec<Piece> = path.pieces().collect();
    let tied: Vec<[f64; 2]> = parts.iter().map(|p| ends(p, &pieces)).collect::<Result<_, _>>()?;
    let cuts = cuts(pieces.len(), &tied);
    let corners = cuts.iter().map(|&s| at(&path, &pieces, s)).collect();
    let middles = cuts.windows(2).map(|w| 0.5 * (w[0] + w[1]));
    let curves = middles.clone().map(|s| pieces[s as usize].curve().cloned()).collect();
    let is_tied = |s: f64| tied.iter().any(|[a, b]| *a < s && s < *b);
    let bilateral = middles.enumerate().filter(|(_, s)| is_tied(*s)).map(|(k, _)| k).collect();
    Ok((ContactLine::Common(Path { corners, curves }), bilateral))
}

/// The two ends of a part as numbers: piece plus share of its parameter; the smaller first.
fn ends(part: &RawPart, pieces: &[Piece]) -> Result<[f64; 2], Fault> {
    let mut ends = [0.0; 2];
    for (end, raw) in ends.iter_mut().zip(&part.get_ref().0) {
        let x = point(raw);
        *end = place(x, pieces).ok_or_else(|| {
            let message = format!("the end ({}, {}) of a bilateral part is not on the contact zone", x.x, x.y);
            Fault::new(part.span(), message, "give two points of the path `along`, with all their digits on a curve")
        })?;
    }
    ends.sort_by(f64::total_cmp);
    if ends[1] - ends[0] > SAME {
        return Ok(ends);
    }
    refuse(part.span(), "a bilateral part of no length", "give its first and its last point")
}

/// Where on the zone `x` lies; corners are whole numbers.
fn place(x: Point, pieces: &[Piece]) -> Option<f64> {
    let length: f64 = pieces.iter().map(Piece::length).sum();
    let on = pieces.iter().position(|p| p.distance(x) <= SAME * length)?;
    let s = on as f64 + pieces[on].foot(x);
    Some(if (s - s.round()).abs() <= SAME { s.round() } else { s })
}

/// The corners of the path and the ends of the parts, each once, in order.
fn cuts(pieces: usize, tied: &[[f64; 2]]) -> Vec<f64> {
    let mut cuts: Vec<f64> = (0..=pieces).map(|k| k as f64).chain(tied.iter().flatten().copied()).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|b, a| *b - *a <= SAME);
    cuts
}

fn at(path: &Path, pieces: &[Piece], s: f64) -> Point {
    if s.fract() == 0.0 { path.corners[s as usize] } else { pieces[s as usize].point(s.fract()) }
}
