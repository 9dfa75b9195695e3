//! Families whose meshes are Delaunay triangulations of the bodies: uniform, graded towards a point, or strongly regular for
//! refinement.

use super::delaunay::{BlockOutline, Loop, fill, outer_loop, strongly_regular};
use super::{Domain, cut};
use crate::study::Shape;
use signorini_contact::geometry::Piece;
use signorini_contact::mesh::Triangulation;
use signorini_contact::mesh::blocks::QuadBlock;
use signorini_contact::{Error, Point};

/// The outlines of both bodies, sides divided into their blocks' cells at mesh parameter `n`.
fn loops(domain: &Domain, n: usize) -> Result<[Loop; 2], Error> {
    let of = |shape: &Shape| {
        let outline = |b: &crate::study::Block| {
            let quad = QuadBlock { curves: b.curves.clone(), ..QuadBlock::straight(b.corners, [1, 1]) };
            BlockOutline { sides: [0, 1, 2, 3].map(|k| quad.side(k)), cells: b.divisions.map(|d| d.saturating_mul(n)) }
        };
        let whole = outer_loop(&shape.blocks.iter().map(outline).collect::<Vec<_>>());
        whole.map(|boundary| cut::at_points(boundary, &domain.contact.corners())).map_err(|e| match e {
            Error::Mesh(message) => Error::Mesh(format!("body \"{}\": {message}", shape.name)),
            other => other,
        })
    };
    Ok([of(&domain.shapes[0])?, of(&domain.shapes[1])?])
}

/// Independent Delaunay meshes of both bodies: curved sides keep their steps, straight ones are divided anew, near
/// `c/√2` for the longest chord `c`, or near the shortest step where nothing is curved.
pub(super) fn independent(domain: &Domain, n: usize, seed: u64) -> Result<[Triangulation; 2], Error> {
    let mut loops = loops(domain, n)?;
    let chord = loops.iter().filter_map(Loop::chords).map(|[_, longest]| longest).fold(0.0, f64::max);
    let step = |l: &Loop| l.runs.iter().map(|r| r.piece.length() / r.steps as f64).fold(f64::INFINITY, f64::min);
    let size = if chord > 0.0 { chord * 0.5_f64.sqrt() } else { loops.iter().map(step).fold(f64::INFINITY, f64::min) };
    for run in loops.iter_mut().flat_map(|l| &mut l.runs).filter(|r| r.piece.curve().is_none()) {
        // rounding must not decide between two bodies that share the piece
        run.steps = ((run.piece.length() / size - 1e-9).round() as usize).max(1);
    }
    let mesh = |l: &Loop| fill(&l.nodes(), &move |_| size, seed);
    Ok([mesh(&loops[0])?, mesh(&loops[1])?])
}

/// Meshes whose refinements are strongly regular with `β = 2` on curved bodies; on polygons independent ones.
pub(super) fn coarse(domain: &Domain, n: usize, seed: u64) -> Result<[Triangulation; 2], Error> {
    if !domain.is_curved() {
        return independent(domain, n, seed);
    }
    let loops = loops(domain, n)?;
    Ok(strongly_regular([&loops[0], &loops[1]], seed)?.map(|strong| strong.triangulation))
}

/// Meshes whose sides shrink towards a point: about `h (max(r, h)/R)^γ` long at the distance `r`, `R` the extent of the bodies,
/// so that the ratio of the longest side to the shortest grows like `h^{−γ}`.
pub(super) fn graded(
    domain: &Domain,
    n: usize,
    seed: u64,
    towards: Point,
    strength: f64,
) -> Result<[Triangulation; 2], Error> {
    let loops = loops(domain, n)?;
    let far = |p: Point| (p - towards).norm();
    let corners = || loops.iter().flat_map(|l| l.nodes());
    let extent = corners().map(far).fold(0.0, f64::max);
    let h = loops.iter().flat_map(|l| &l.runs).map(|r| r.piece.length() / r.steps as f64).fold(f64::INFINITY, f64::min);
    let size = move |x: Point| h * (far(x).max(h) / extent).powf(strength);
    let contact: Vec<[Piece; 2]> = domain.contact.pieces();
    let nodes = |body: usize| -> Vec<Point> {
        loops[body].runs.iter().flat_map(|run| graded_run(&run.piece, body, &loops, &contact, &size)).collect()
    };
    let mesh = |body: usize| fill(&nodes(body), &size, seed);
    Ok([mesh(0)?, mesh(1)?])
}

/// The nodes of a run from its first end on, without the last. On the contact zone they are those of the zone, which both bodies
/// see: placed on `Ω'` and carried over by the parameter.
fn graded_run(
    run: &Piece,
    body: usize,
    loops: &[Loop; 2],
    contact: &[[Piece; 2]],
    size: &dyn Fn(Point) -> f64,
) -> Vec<Point> {
    let tolerance = 1e-9 * run.length();
    let on = |p: &&[Piece; 2]| [0.0, 0.5, 1.0].iter().all(|t| p[body].distance(run.point(*t)) <= tolerance);
    let Some(zone) = contact.iter().find(on) else {
        return graded_shares(run, size).into_iter().map(|t| run.point(t)).collect();
    };
    // Both bodies must end a run at every corner of either.
    let mut cuts = vec![0.0, 1.0];
    for b in 0..2 {
        let ends = loops[b].runs.iter().map(|r| r.piece.point(0.0)).filter(|x| zone[b].distance(*x) <= tolerance);
        cuts.extend(ends.map(|x| zone[b].foot(x)));
    }
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let part = |w: &[f64]| {
        let (a, b) = (w[0], w[1]);
        let piece = |t: f64| zone[0].point(a + t * (b - a));
        shares(&piece, size).into_iter().map(move |t| a + t * (b - a)).collect::<Vec<f64>>()
    };
    let all: Vec<f64> = cuts.windows(2).flat_map(part).chain([1.0]).collect();
    let (from, to) = (zone[body].foot(run.point(0.0)), zone[body].foot(run.point(1.0)));
    let within = |t: &f64| *t >= from.min(to) - 1e-9 && *t <= from.max(to) + 1e-9;
    let mut own: Vec<f64> = all.into_iter().filter(within).collect();
    if from > to {
        own.reverse();
    }
    own.pop();
    own.into_iter().map(|t| zone[body].point(t)).collect()
}

fn graded_shares(piece: &Piece, size: &dyn Fn(Point) -> f64) -> Vec<f64> {
    shares(&|t| piece.point(t), size)
}

/// Parameters `0 = t_0 < t_1 < …`, without the last, such that steps have about the wished length: equal shares of
/// `∫ ds/size`.
fn shares(piece: &dyn Fn(f64) -> Point, size: &dyn Fn(Point) -> f64) -> Vec<f64> {
    const FINE: usize = 4096;
    let mut sums = Vec::with_capacity(FINE + 1);
    sums.push(0.0);
    for k in 0..FINE {
        let [a, b] = [k, k + 1].map(|i| piece(i as f64 / FINE as f64));
        sums.push(sums[k] + (b - a).norm() / size(0.5 * (a + b)));
    }
    let total = sums[FINE];
    let steps = (total.round() as usize).max(1);
    let at = |k: usize| {
        let wanted = total * k as f64 / steps as f64;
        let i = sums.partition_point(|s| *s <= wanted).clamp(1, FINE);
        (i as f64 - 1.0 + (wanted - sums[i - 1]) / (sums[i] - sums[i - 1])) / FINE as f64
    };
    (0..steps).map(|k| if k == 0 { 0.0 } else { at(k) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;
    use signorini_contact::mesh::Mesh;

    fn mesh(case: &crate::study::Case, bodies: [Triangulation; 2]) -> Mesh {
        let domain = case.scene().unwrap().domain();
        Mesh::build(bodies, &domain.outlines, domain.contact).unwrap()
    }

    #[test]
    fn independent_meshes_of_the_squares_match_on_the_zone() {
        let case = sample::case("theorem-3-1-smooth", "structured");
        let domain = case.scene().unwrap().domain();
        for n in [4, 9] {
            let mesh = mesh(&case, independent(&domain, n, 1).unwrap());
            let quality = mesh.quality();
            assert_eq!(mesh.contact.len(), n);
            assert!(quality.min_angle > 30.0 && quality.side_ratio < 2.0, "{quality:?}");
            let area: f64 = (0..mesh.triangles.len()).map(|t| mesh.area(t)).sum();
            assert!((area - 2.0).abs() < 1e-13);
        }
    }

    #[test]
    fn graded_meshes_are_regular_but_not_quasi_uniform() {
        let case = sample::case("theorem-3-1-smooth", "structured");
        let domain = case.scene().unwrap().domain();
        let towards = Point::new(1.0 / 6.0f64.sqrt(), 0.0);
        let ratios = [4, 16].map(|n| {
            let mesh = mesh(&case, graded(&domain, n, 1, towards, 0.5).unwrap());
            let quality = mesh.quality();
            assert!(quality.min_angle >= 20.0, "{quality:?}");
            quality.side_ratio
        });
        // β ~ h^{−1/2}: doubles when h falls to a quarter
        assert!(ratios[1] > 1.6 * ratios[0], "{ratios:?}");
    }

    #[test]
    fn shares_are_even_where_the_size_is_and_crowd_where_it_is_small() {
        let line = |t: f64| Point::new(2.0 * t, 0.0);
        let even = shares(&line, &|_| 0.5);
        assert!(even.len() == 4 && even.iter().enumerate().all(|(k, t)| (t - 0.25 * k as f64).abs() < 1e-12));
        let crowded = shares(&line, &|x: Point| 0.02 + 0.1 * x.x);
        assert!(crowded[1] < 0.02 && 1.0 - crowded[crowded.len() - 1] > 0.05, "{crowded:?}");
    }
}
