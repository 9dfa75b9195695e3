//! Cuts the boundary of a body where the contact zone has a corner or a bilateral part ends inside a side of a block, so that
//! a family that chooses its own boundary nodes puts one there.

use super::delaunay::{Loop, Run};
use signorini_contact::Point;
use signorini_contact::geometry::{Piece, Segment};

/// Shares of a piece, and steps, nearer than this are one.
const SAME: f64 = 1e-9;

/// The same boundary with a run ending at each of these points that lies inside one. Steps on a curve are kept as they
/// are, so that there only a point that is a node already becomes an end.
pub(super) fn at_points(boundary: Loop, points: &[Point]) -> Loop {
    Loop { runs: boundary.runs.into_iter().flat_map(|run| cut(run, points)).collect() }
}

fn cut(run: Run, points: &[Point]) -> Vec<Run> {
    let length = run.piece.length();
    let mut shares: Vec<f64> = (points.iter())
        .filter(|x| run.piece.distance(**x) <= SAME * length)
        .map(|x| run.piece.foot(*x))
        .filter(|t| *t > SAME && *t < 1.0 - SAME && fits(&run, *t))
        .collect();
    shares.sort_by(f64::total_cmp);
    shares.dedup_by(|b, a| *b - *a <= SAME);
    let ends: Vec<f64> = std::iter::once(0.0).chain(shares).chain([1.0]).collect();
    ends.windows(2).map(|w| part(&run, [w[0], w[1]])).collect()
}

fn fits(run: &Run, t: f64) -> bool {
    let steps = t * run.steps as f64;
    run.piece.curve().is_none() || (steps - steps.round()).abs() <= SAME * run.steps as f64
}

fn part(run: &Run, [a, b]: [f64; 2]) -> Run {
    let piece = match &run.piece {
        whole if a == 0.0 && b == 1.0 => whole.clone(),
        Piece::Straight(_) => Piece::Straight(Segment { a: run.piece.point(a), b: run.piece.point(b) }),
        Piece::Curved { curve, span } => {
            let at = |t: f64| span[0] + t * (span[1] - span[0]);
            Piece::Curved { curve: curve.clone(), span: [at(a), at(b)] }
        }
    };
    Run { piece, steps: (((b - a) * run.steps as f64).round() as usize).max(1) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use signorini_contact::geometry::CircularArc;
    use std::sync::Arc;

    fn straight(steps: usize) -> Run {
        let piece = Piece::Straight(Segment { a: Point::new(0.0, 0.0), b: Point::new(2.0, 1.0) });
        Run { piece, steps }
    }

    #[test]
    fn a_straight_run_ends_wherever_it_is_asked_to() {
        let points = [[1.0, 0.5], [0.5, 0.25], [0.0, 0.0], [1.0, 0.6]].map(|[x, y]| Point::new(x, y));
        let parts = at_points(Loop { runs: vec![straight(8)] }, &points).runs;
        assert_eq!(parts.iter().map(|r| r.steps).collect::<Vec<_>>(), [2, 2, 4]);
        let ends: Vec<Point> = parts.iter().map(|r| r.piece.point(1.0)).collect();
        assert!(ends.iter().zip([points[1], points[0], Point::new(2.0, 1.0)]).all(|(a, b)| (a - b).norm() < 1e-15));
        assert_eq!(at_points(Loop { runs: vec![straight(8)] }, &points[2..]).runs, [straight(8)]);
    }

    #[test]
    fn a_curved_run_keeps_its_nodes() {
        let arc = CircularArc { centre: Point::zeros(), radius: 1.0, from: 0.0, to: 1.6 };
        let point = |angle: f64| Point::new(angle.cos(), angle.sin());
        let run = Run { piece: Piece::Curved { curve: Arc::new(arc), span: [0.0, 1.0] }, steps: 8 };
        let before: Vec<Point> = run.nodes().collect();
        let cut = at_points(Loop { runs: vec![run] }, &[point(0.4), point(0.5)]);
        // 0.4 is a node, 0.5 is none
        assert_eq!(cut.runs.iter().map(|r| r.steps).collect::<Vec<_>>(), [2, 6]);
        assert!(cut.nodes().iter().zip(&before).all(|(a, b)| (a - b).norm() < 1e-14));
    }
}
