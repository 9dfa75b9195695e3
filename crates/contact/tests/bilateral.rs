//! Bilateral parts of the contact zone and sliding bodies, whole solves: closed forms, nodal equilibrium, two algorithms.

use signorini_contact::basis::BoundOrigin;
use signorini_contact::geometry::{CircularArc, Segment, SharedCurve};
use signorini_contact::mesh::{Mesh, PartOutline, blocks};
use signorini_contact::problem::{Data, Discrete, Problem, SlideCondition, Solution, Support};
use signorini_contact::quadrature::Cubature;
use signorini_contact::solver::{Method, Settings};
use signorini_contact::zone::Zone;
use signorini_contact::{Body, ContactLine, Error, Material, Path, Point, Vec2, assembly, qp, solver};
use std::sync::Arc;

/// A traction on the top of the upper body.
struct Top<F: Fn(Point) -> Vec2 + Sync>(F);

impl<F: Fn(Point) -> Vec2 + Sync> Data for Top<F> {
    fn traction(&self, part: usize, x: Point, _normal: Vec2) -> Vec2 {
        if part == 0 { (self.0)(x) } else { Vec2::zeros() }
    }
}

const MATERIALS: [(f64, f64); 2] = [(1.5, 1.0), (3.0, 2.0)];
const METHODS: [Method; 2] = [Method::Condensed, Method::InteriorPoint];

fn points<const N: usize>(xy: [[f64; 2]; N]) -> Vec<Point> {
    xy.map(|[x, y]| Point::new(x, y)).to_vec()
}

/// Two bodies of width 1 that meet on `y = slope·x`, up to `y = 1.5` and down to `y = −1`; the zone has a corner at `x = 1/4`.
/// Parts: top, upper sides, bottom, lower sides.
fn slanted(n: usize, slope: f64) -> Mesh {
    let at = |x: f64, y: f64| Point::new(x, y);
    let (left, right) = (at(0.0, 0.0), at(1.0, slope));
    let upper = [left, right, at(1.0, 1.5), at(0.0, 1.5)];
    let lower = [at(0.0, -1.0), at(1.0, -1.0), right, left];
    let body = |corners| {
        blocks::triangulate(&[blocks::QuadBlock::straight(corners, [n, n])], blocks::Pattern::Structured).unwrap()
    };
    let part = |body, name: &str, along: &[Point]| PartOutline {
        body,
        name: name.into(),
        along: Path::polyline(along.to_vec()),
    };
    let parts = [
        part(Body::First, "top", &[upper[2], upper[3]]),
        part(Body::First, "left", &[upper[3], upper[0]]),
        part(Body::First, "right", &[upper[1], upper[2]]),
        part(Body::Second, "bottom", &lower[..2]),
        part(Body::Second, "left", &[lower[3], lower[0]]),
        part(Body::Second, "right", &[lower[1], lower[2]]),
    ];
    let line = ContactLine::polyline([left, at(0.25, 0.25 * slope), right]);
    Mesh::build([body(upper), body(lower)], &parts, &line).unwrap()
}

use Support::{Fixed, Free, Sliding, Traction};

fn with_problem<T>(
    mesh: &Mesh,
    supports: &[Support],
    load: impl Fn(Point) -> Vec2 + Sync,
    run: impl FnOnce(&Problem) -> T,
) -> T {
    let materials = MATERIALS.map(|(lambda, mu)| Material::lame(lambda, mu).unwrap());
    run(&Problem { mesh, materials, supports, data: &Top(load), cubature: &Cubature::default() })
}

fn solve(
    mesh: &Mesh,
    supports: &[Support],
    load: impl Fn(Point) -> Vec2 + Sync,
    bilateral: &[usize],
    method: Method,
) -> Result<(Discrete, Solution), Error> {
    with_problem(mesh, supports, load, |problem| {
        let load = assembly::loads(mesh, supports, problem.data, problem.cubature)?;
        let mut zone = Zone::new(mesh);
        zone.make_bilateral(mesh, bilateral);
        let discrete = problem.discretise_zone(load, zone)?;
        let raw = solver::solve(&discrete.qp, &Settings { method, ..Settings::default() });
        let solution = discrete.recover(mesh, &problem.materials, raw);
        Ok((discrete, solution))
    })
}

/// Pulled apart between sliding walls: uniaxial strain with the tension `p` on the whole line, which is linear.
#[test]
fn uniform_tension_on_a_bilateral_line_is_reproduced_to_rounding() {
    let mesh = slanted(4, 0.0);
    let supports = [Traction, Sliding, Sliding, Sliding, Sliding, Sliding];
    let p = 0.2;
    for method in METHODS {
        let (discrete, solution) = solve(&mesh, &supports, |_| Vec2::new(0.0, p), &[0, 1], method).unwrap();
        let (upper, lower) = (1.5 + 2.0, 3.0 + 4.0);
        for (i, u) in solution.displacement.iter().enumerate() {
            let y = mesh.points[i].y;
            let up = if mesh.node_bodies[i] == Body::First { p / lower + p * y / upper } else { p * (y + 1.0) / lower };
            assert!((u - Vec2::new(0.0, up)).norm() < 1e-13, "node {i}: {u:?}");
        }
        for (pair, forces) in discrete.zone.pairs.iter().zip(&solution.contact_forces) {
            assert!((forces[0] / pair.constraints[0].mass + p).abs() < 1e-12, "{forces:?}");
        }
        assert_eq!((discrete.qp.bounds.len(), discrete.basis.held.len()), (0, 5));
    }
    // the same load with a line that may open has nothing to hold the upper body
    let refused = solve(&mesh, &supports, |_| Vec2::new(0.0, p), &[], Method::Condensed).map(|_| ()).unwrap_err();
    assert!(refused.to_string().contains("translation of Ω' along (0, 1)"), "{refused}");
}

/// The left quarter in tension, the rest pressed or open; the lower body rests on a smooth floor and is stopped by the
/// bilateral part of the slanted line alone.
fn half_tied(n: usize, method: Method) -> (Mesh, Discrete, Solution) {
    let mesh = slanted(n, 0.3);
    let supports = [Traction, Fixed, Free, Sliding, Free, Free];
    let load = |x: Point| Vec2::new(0.0, 0.3 - 0.9 * x.x);
    let (discrete, solution) = solve(&mesh, &supports, load, &[0], method).unwrap();
    (mesh, discrete, solution)
}

#[test]
fn two_algorithms_agree_on_a_line_tied_in_part() {
    let (_, d, a) = half_tied(16, Method::Condensed);
    let (_, _, b) = half_tied(16, Method::InteriorPoint);
    assert!(a.raw.status.is_solved() && b.raw.status.is_solved());
    let size = a.displacement.iter().map(|u| u.norm()).fold(0.0, f64::max);
    assert!(a.displacement.iter().zip(&b.displacement).all(|(a, b)| (a - b).norm() < 1e-10 * size));
    let flat = |s: &Solution| s.contact_forces.iter().flatten().copied().collect::<Vec<f64>>();
    let (fa, fb) = (flat(&a), flat(&b));
    assert!(fa.iter().zip(&fb).all(|(a, b)| (a - b).abs() < 1e-10), "{fa:?} {fb:?}");
    // tension where it is allowed and nowhere else; contact and an open part beyond
    assert!(fa[0] < -1e-3 && fa[5..].iter().all(|f| *f >= 0.0), "{fa:?}");
    assert!(fa[5..].iter().any(|f| *f > 1e-4) && d.basis.held.len() == 5);
    let scales = qp::CertificateScales { displacement: size, energy: a.strain_energy };
    let k = qp::certify(&d.qp, &a.raw.x, &a.raw.multipliers, &scales);
    assert!(k.tension < 1e-12 && k.penetration < 1e-12 && k.stationarity < 1e-12, "{k:?}");
}

/// `f − A u_h = Σ λ_c n_c (δ_a − δ_b)` at every free node, tied or not, from nodal forces in the axes.
#[test]
fn contact_forces_of_either_sign_balance_every_node() {
    let (mesh, discrete, solution) = half_tied(8, Method::Condensed);
    let materials = MATERIALS.map(|(lambda, mu)| Material::lame(lambda, mu).unwrap());
    let internal = assembly::internal_forces(&mesh, &materials, &solution.displacement);
    let mut rest: Vec<Vec2> = discrete.load.iter().zip(&internal).map(|(f, r)| f - r).collect();
    for (pair, forces) in discrete.zone.pairs.iter().zip(&solution.contact_forces) {
        for (c, force) in pair.constraints.iter().zip(forces) {
            rest[pair.first as usize] -= *force * c.normal;
            rest[pair.second as usize] += *force * c.normal;
            let jump = solution.displacement[pair.first as usize] - solution.displacement[pair.second as usize];
            assert!(c.normal.dot(&jump) < 1e-14);
        }
    }
    for (i, r) in rest.iter().enumerate() {
        let x = mesh.points[i];
        if mesh.node_bodies[i] == Body::First && x.x == 0.0 {
            continue; // held
        }
        // the floor y = −1 takes the vertical part
        let r = Vec2::new(r.x, if x.y == -1.0 { 0.0 } else { r.y });
        assert!(r.norm() < 1e-13, "({}, {}): {r:?}", x.x, x.y);
    }
    for held in &discrete.basis.held {
        let BoundOrigin { pair, constraint } = held.origin;
        let p = &discrete.zone.pairs[pair];
        let jump = solution.displacement[p.first as usize] - solution.displacement[p.second as usize];
        assert!(p.constraints[constraint].normal.dot(&jump).abs() < 1e-15);
    }
}

#[test]
fn what_a_bilateral_part_holds_is_no_free_motion() {
    // the lower body slides on its floor unless the slanted line holds it on both sides
    let mesh = slanted(4, 0.3);
    let supports = [Fixed, Free, Free, Sliding, Free, Free];
    let kernel = |bilateral: &[usize]| solve(&mesh, &supports, |_| Vec2::zeros(), bilateral, Method::Condensed);
    let refused = kernel(&[]).map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("limit load") && refused.contains("translation of Ω''"), "{refused}");
    assert!(kernel(&[1]).unwrap().0.qp.kernel.is_empty());
    // along a level line it slides in any case
    let level = slanted(4, 0.0);
    let (discrete, _) = solve(&level, &supports, |_| Vec2::zeros(), &[0, 1], Method::Condensed).unwrap();
    assert_eq!(discrete.qp.kernel.len(), 1);
}

/// The lower body slides between a level line and its floor; `p(v) = 0` on the floor.
fn sliding(n: usize, settings: &Settings, condition: SlideCondition) -> Result<(Mesh, Discrete, Solution), Error> {
    let mesh = slanted(n, 0.0);
    let supports = [Traction, Sliding, Sliding, Sliding, Free, Free];
    let load = |x: Point| Vec2::new(0.01, 0.1 - 0.5 * x.x * x.x);
    let solution = with_problem(&mesh, &supports, load, |problem| {
        let mut discrete = problem.discretise()?;
        discrete.fix_slide(&mesh, &condition)?;
        let raw = solver::solve(&discrete.qp, settings);
        let solution = discrete.recover(&mesh, &problem.materials, raw);
        Ok((discrete, solution))
    });
    solution.map(|(d, s)| (mesh, d, s))
}

fn along(body: Body, from: [f64; 2], to: [f64; 2]) -> SlideCondition {
    SlideCondition { body, along: Segment { a: Point::from(from), b: Point::from(to) } }
}

/// Trapezoids over the nodes of the floor: `∫ v_1 ds` of a piecewise linear field.
fn floor_integral(mesh: &Mesh, u: &[Vec2]) -> f64 {
    let mut floor: Vec<(f64, f64)> =
        (0..u.len()).filter(|&i| mesh.points[i].y == -1.0).map(|i| (mesh.points[i].x, u[i].x)).collect();
    floor.sort_by(|a, b| a.0.total_cmp(&b.0));
    floor.windows(2).map(|w| 0.5 * (w[1].0 - w[0].0) * (w[0].1 + w[1].1)).sum()
}

#[test]
fn the_solution_does_not_depend_on_where_the_slide_starts() {
    let floor = along(Body::Second, [0.0, -1.0], [1.0, -1.0]);
    for method in METHODS {
        let at = |start_slide| sliding(12, &Settings { method, start_slide, ..Settings::default() }, floor).unwrap();
        let (mesh, discrete, zero) = at(0.0);
        assert!(zero.raw.status.is_solved() && floor_integral(&mesh, &zero.displacement).abs() < 1e-15);
        let remark = &discrete.warnings[0];
        assert!(remark.contains("translation of Ω''") && remark.contains("p(v) = ∫ v_t ds over (0, -1) to (1, -1)"));
        for start in [0.37, -2.5] {
            let (_, _, other) = at(start);
            let size = zero.displacement.iter().map(|u| u.norm()).fold(0.0, f64::max);
            let apart = zero.displacement.iter().zip(&other.displacement).map(|(a, b)| (a - b).norm());
            let apart = apart.fold(0.0, f64::max);
            assert!(apart < 1e-11 * size, "{method:?} {start}: {apart:e}");
            assert!(apart > 0.0, "the start changes the way, if not the end");
        }
    }
}

#[test]
fn conditions_that_cannot_fix_the_slide_are_refused() {
    let settings = Settings::default();
    let refused = |c: SlideCondition| sliding(4, &settings, c).map(|_| ()).unwrap_err().to_string();
    let off = refused(along(Body::Second, [0.0, -1.0], [0.9, -1.0]));
    assert!(off.contains("cover a length of 0.75") && off.contains("Ω''"), "{off}");
    // the motion is horizontal: the vertical part of u on a side does not see it, nor does the other body
    let across = refused(along(Body::Second, [1.0, -1.0], [1.0, 0.0]));
    assert!(across.contains("vanishes on the motion") && across.contains("translation of Ω''"), "{across}");
    assert!(refused(along(Body::First, [0.0, 1.5], [1.0, 1.5])).contains("vanishes on the motion"));
    let mesh = slanted(4, 0.0);
    let mut held =
        solve(&mesh, &[Traction, Sliding, Free, Fixed, Free, Free], |_| -Vec2::y(), &[], METHODS[0]).unwrap().0;
    let none = held.fix_slide(&mesh, &along(Body::Second, [0.0, -1.0], [1.0, -1.0])).unwrap_err().to_string();
    assert!(none.contains("here there are 0"), "{none}");
}

/// A straight part beside an arc that leaves it smoothly (`turn = 0`) or at a corner.
fn straight_and_arc(n: usize, turn: f64) -> Mesh {
    let (sin, cos) = (turn - std::f64::consts::FRAC_PI_2).sin_cos();
    let arc = CircularArc {
        centre: -2.0 * Point::new(cos, sin),
        radius: 2.0,
        from: turn - std::f64::consts::FRAC_PI_2,
        to: turn - std::f64::consts::FRAC_PI_3,
    };
    let curve: SharedCurve = Arc::new(arc);
    let end = curve.point(1.0);
    let at = |x: f64, y: f64| Point::new(x, y);
    let block = |corners: [Point; 4], curved: Option<usize>| {
        let mut curves = [const { None }; 4];
        curved.into_iter().for_each(|k| curves[k] = Some(curve.clone()));
        blocks::QuadBlock { curves, ..blocks::QuadBlock::straight(corners, [n, n]) }
    };
    let upper = [
        block([at(-1.0, 0.0), at(0.0, 0.0), at(0.0, 1.5), at(-1.0, 1.5)], None),
        block([at(0.0, 0.0), end, at(end.x, 1.5), at(0.0, 1.5)], Some(0)),
    ];
    let lower = [
        block([at(-1.0, -1.0), at(0.0, -1.0), at(0.0, 0.0), at(-1.0, 0.0)], None),
        block([at(0.0, -1.0), at(end.x, -1.0), end, at(0.0, 0.0)], Some(2)),
    ];
    let part = |body, name: &str, along: Vec<Point>| PartOutline { body, name: name.into(), along: along.into() };
    let parts = [
        part(Body::First, "top", vec![at(end.x, 1.5), at(-1.0, 1.5)]),
        part(Body::First, "left", points([[-1.0, 1.5], [-1.0, 0.0]])),
        part(Body::First, "right", vec![end, at(end.x, 1.5)]),
        part(Body::Second, "bottom", vec![at(-1.0, -1.0), at(end.x, -1.0)]),
        part(Body::Second, "left", points([[-1.0, 0.0], [-1.0, -1.0]])),
        part(Body::Second, "right", vec![at(end.x, -1.0), end]),
    ];
    let line = Path { corners: vec![at(-1.0, 0.0), at(0.0, 0.0), end], curves: vec![None, Some(curve)] };
    let bodies = [&upper[..], &lower[..]].map(|b| blocks::triangulate(b, blocks::Pattern::Structured).unwrap());
    Mesh::build(bodies, &parts, &ContactLine::Common(line)).unwrap()
}

#[test]
fn a_straight_part_beside_an_arc_is_one_zone() {
    for (turn, at_joint) in [(0.0, 1), (0.2, 2)] {
        let mesh = straight_and_arc(6, turn);
        let zone = Zone::new(&mesh);
        let counts: Vec<usize> = zone.pairs.iter().map(|p| p.constraints.len()).collect();
        assert_eq!((counts.len(), counts[6]), (13, at_joint));
        assert!(counts.iter().enumerate().all(|(i, c)| i == 6 || *c == 1));
        let mass: f64 = zone.pairs.iter().flat_map(|p| &p.constraints).map(|c| c.mass).sum();
        assert!((mass - (1.0 + 2.0 * std::f64::consts::FRAC_PI_6)).abs() < 1e-12, "the length of the zone: {mass}");
        assert_eq!(mesh.curved.sides.len(), 12);
        // pressed on the straight part, lifted from the arc; tied on the arc, it stays
        let supports = [Traction, Sliding, Free, Fixed, Free, Free];
        let load = |x: Point| Vec2::new(0.0, if x.x < 0.0 { -0.3 } else { 0.05 });
        let (_, open) = solve(&mesh, &supports, load, &[], Method::Condensed).unwrap();
        let (d, tied) = solve(&mesh, &supports, load, &[1], Method::Condensed).unwrap();
        let last = d.zone.pairs.last().unwrap();
        let jump = |s: &Solution| {
            let [a, b] = [last.first, last.second].map(|i| s.displacement[i as usize]);
            last.constraints[0].normal.dot(&(a - b))
        };
        assert!(jump(&open) < -1e-3 && jump(&tied).abs() < 1e-15, "{} {}", jump(&open), jump(&tied));
        assert!(tied.contact_forces.iter().flatten().any(|f| *f < -1e-3) && tied.energy > open.energy);
    }
}
