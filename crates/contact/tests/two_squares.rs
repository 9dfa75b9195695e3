//! Whole solves of two squares, held against closed forms and against one another.

use signorini_contact::mesh::{Mesh, PartOutline, blocks};
use signorini_contact::problem::{Data, Discrete, Problem, Solution, Support};
use signorini_contact::quadrature::Cubature;
use signorini_contact::solver::{Method, Settings};
use signorini_contact::{Body, ContactLine, Error, Material, Path, Point, Vec2, assembly, norm, qp};

/// A traction on the top of the upper square, whose other sides and the lower square's are as the test says.
struct Top<F: Fn(Point) -> Vec2 + Sync>(F);

impl<F: Fn(Point) -> Vec2 + Sync> Data for Top<F> {
    fn traction(&self, part: usize, x: Point, _normal: Vec2) -> Vec2 {
        if part == TOP { (self.0)(x) } else { Vec2::zeros() }
    }
}

/// Parts in this order: top, left, right of the upper square; bottom, left, right of the lower one.
const TOP: usize = 0;

fn corners(y: f64) -> [Point; 4] {
    [[0.0, y], [1.0, y], [1.0, y + 1.0], [0.0, y + 1.0]].map(|[x, y]| Point::new(x, y))
}

fn squares(n: usize) -> Mesh {
    squares_with(n, corners)
}

/// The two squares with their corners moved by a map of the plane.
fn squares_with(n: usize, corners: impl Fn(f64) -> [Point; 4]) -> Mesh {
    let body = |y| blocks::triangulate(&[blocks::QuadBlock::straight(corners(y), [n, n])], blocks::Pattern::Structured);
    let part = |body, name: &str, ends: [usize; 2], y| PartOutline {
        body,
        name: name.into(),
        along: Path::polyline(ends.map(|k| corners(y)[k])),
    };
    let parts = [
        part(Body::First, "top", [2, 3], 0.0),
        part(Body::First, "left", [3, 0], 0.0),
        part(Body::First, "right", [1, 2], 0.0),
        part(Body::Second, "bottom", [0, 1], -1.0),
        part(Body::Second, "left", [3, 0], -1.0),
        part(Body::Second, "right", [1, 2], -1.0),
    ];
    Mesh::build([body(0.0).unwrap(), body(-1.0).unwrap()], &parts, &ContactLine::polyline(&corners(0.0)[..2])).unwrap()
}

fn solve(
    mesh: &Mesh,
    supports: &[Support; 6],
    load: impl Fn(Point) -> Vec2 + Sync,
    method: Method,
) -> Result<(Discrete, Solution), Error> {
    let settings = Settings { method, ..Settings::default() };
    problem(mesh, supports, &Top(load)).solve(&settings)
}

fn problem<'a>(mesh: &'a Mesh, supports: &'a [Support], data: &'a dyn Data) -> Problem<'a> {
    static CUBATURE: std::sync::LazyLock<Cubature> = std::sync::LazyLock::new(Cubature::default);
    Problem {
        mesh,
        materials: [Material::lame(1.5, 1.0).unwrap(), Material::lame(3.0, 2.0).unwrap()],
        supports,
        data,
        cubature: &CUBATURE,
    }
}

use Support::{Fixed, Free, Sliding, Traction};

/// Uniform pressure between sliding walls: uniaxial strain, `u_2 = −p (y + 1)/L''` below and so on, which is linear.
#[test]
fn uniaxial_strain_is_reproduced_to_rounding() {
    let mesh = squares(5);
    let supports = [Traction, Sliding, Sliding, Sliding, Sliding, Sliding];
    let p = 0.2;
    let (discrete, solution) = solve(&mesh, &supports, |_| Vec2::new(0.0, -p), Method::Condensed).unwrap();
    let (upper, lower) = (1.5 + 2.0, 3.0 + 4.0);
    let exact = |x: Point, body: Body| match body {
        Body::First => Vec2::new(0.0, -p / lower - p * x.y / upper),
        Body::Second => Vec2::new(0.0, -p * (x.y + 1.0) / lower),
    };
    for (i, u) in solution.displacement.iter().enumerate() {
        assert!((u - exact(mesh.points[i], mesh.node_bodies[i])).norm() < 1e-14, "node {i}: {u:?}");
    }
    for (pair, forces) in discrete.zone.pairs.iter().zip(&solution.contact_forces) {
        assert!((forces[0] / pair.constraints[0].mass - p).abs() < 1e-13, "the pressure is uniform");
    }
    assert!((solution.energy + 0.5 * p * (p / upper + p / lower)).abs() < 1e-15);
}

/// The same turned by 30°: every wall is a slanted `Γ_0`, and at its ends contact meets it in a rotated basis.
#[test]
fn uniaxial_strain_does_not_mind_being_turned() {
    let (sin, cos) = (std::f64::consts::FRAC_PI_6).sin_cos();
    let turn = |v: Vec2| Vec2::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y);
    let back = |v: Vec2| Vec2::new(cos * v.x + sin * v.y, cos * v.y - sin * v.x);
    let mesh = squares_with(5, |y| corners(y).map(turn));
    let supports = [Traction, Sliding, Sliding, Sliding, Sliding, Sliding];
    let p = 0.2;
    let (discrete, solution) = solve(&mesh, &supports, |_| turn(Vec2::new(0.0, -p)), Method::Condensed).unwrap();
    let (upper, lower) = (1.5 + 2.0, 3.0 + 4.0);
    for (i, u) in solution.displacement.iter().enumerate() {
        let y = back(mesh.points[i]).y;
        let down = if mesh.node_bodies[i] == Body::First { p / lower + p * y / upper } else { p * (y + 1.0) / lower };
        assert!((u - turn(Vec2::new(0.0, -down))).norm() < 1e-14, "node {i}: {u:?}");
    }
    // Every wall takes one component of each of its nodes; the corners of the bottom lose both.
    assert_eq!(discrete.dofs(), 2 * 72 - 4 * 6 - 6);
    let carried: f64 = solution.contact_forces.iter().flatten().sum();
    assert!((carried - p).abs() < 1e-14);
}

/// The scene without an exact solution: the upper square is held vertically by contact alone and opens on the right.
fn opening(n: usize, method: Method) -> (Mesh, Discrete, Solution) {
    let mesh = squares(n);
    let supports = [Traction, Sliding, Free, Fixed, Free, Free];
    let load = |x: Point| Vec2::new(0.0, -0.1 * (1.0 - 1.75 * x.x));
    let (discrete, solution) = solve(&mesh, &supports, load, method).unwrap();
    (mesh, discrete, solution)
}

#[test]
fn two_algorithms_agree_where_the_zone_opens() {
    for n in [8, 16, 32] {
        let (_, d1, s1) = opening(n, Method::Condensed);
        let (_, _, s2) = opening(n, Method::InteriorPoint);
        assert!(s1.raw.status.is_solved() && s2.raw.status.is_solved(), "{} / {}", s1.raw.status, s2.raw.status);
        assert!((s1.energy - s2.energy).abs() <= 1e-9 * 0.5 * s1.strain_energy, "n = {n}: {} {}", s1.energy, s2.energy);
        let active = s1.raw.multipliers.iter().filter(|l| **l > 0.0).count();
        assert!(active > 0 && active < d1.qp.bounds.len(), "the zone opens in part: {active} active");
    }
}

#[test]
fn the_certificate_holds_and_contact_carries_the_resultant() {
    let (_, discrete, solution) = opening(32, Method::Condensed);
    let largest = solution.displacement.iter().map(|u| u.norm()).fold(0.0, f64::max);
    let scales = qp::CertificateScales { displacement: largest, energy: solution.strain_energy };
    let c = qp::certify(&discrete.qp, &solution.raw.x, &solution.raw.multipliers, &scales);
    assert!(c.stationarity < 1e-13 && c.penetration < 1e-13 && c.tension < 1e-13 && c.complementarity < 1e-13, "{c:?}");
    let carried: f64 = solution.contact_forces.iter().flatten().sum();
    assert!((carried - 0.0125).abs() < 1e-13, "{carried}");
}

#[test]
fn the_energy_of_the_problem_is_that_of_the_displacements() {
    let (mesh, discrete, solution) = opening(8, Method::Condensed);
    let by_problem = qp::energy(&discrete.qp, &solution.raw.x);
    assert!((by_problem - solution.energy).abs() < 1e-15);
    let materials = [Material::lame(1.5, 1.0).unwrap(), Material::lame(3.0, 2.0).unwrap()];
    let forces = assembly::internal_forces(&mesh, &materials, &solution.displacement);
    let twice: f64 = forces.iter().zip(&solution.displacement).map(|(r, u)| r.dot(u)).sum();
    assert!((twice - norm::of_linear(&mesh, &materials, &solution.displacement).energy).abs() < 1e-15);
}

#[test]
fn loads_that_contact_cannot_bear_are_refused_with_the_motion() {
    let mesh = squares(4);
    let floating = [Traction, Sliding, Free, Fixed, Free, Free];
    let refuse =
        |supports: &[Support; 6], load: fn(Point) -> Vec2| match solve(&mesh, supports, load, Method::Condensed) {
            Err(Error::Solvability(message)) => message,
            other => panic!("must be refused, got {:?}", other.map(|(_, s)| s.raw.status)),
        };
    let pulled = refuse(&floating, |_| Vec2::new(0.0, 0.1));
    assert!(pulled.contains("translation of Ω' along (0, 1)") && pulled.contains("no solution"), "{pulled}");
    let idle = refuse(&floating, |_| Vec2::zeros());
    assert!(idle.contains("limit load"), "{idle}");
    let free = [Traction, Free, Free, Fixed, Free, Free];
    let pushed = refuse(&free, |_| Vec2::new(0.05, -0.1));
    assert!(pushed.contains("no equilibrium") && pushed.contains("translation of Ω' along"), "{pushed}");
    // Pressing beyond the left edge tips the body over its corner.
    let tipped = refuse(&free, |x| Vec2::new(0.0, -0.1 * (4.0 - 6.0 * x.x) / 1.0));
    assert!(tipped.contains("rotation of Ω' about"), "{tipped}");
}

#[test]
fn a_body_that_may_slide_both_ways_is_solved_up_to_the_slide() {
    let mesh = squares(6);
    let free = [Traction, Free, Free, Fixed, Free, Free];
    for method in [Method::Condensed, Method::InteriorPoint] {
        let (discrete, solution) = solve(&mesh, &free, |x| Vec2::new(0.0, -0.1 - 0.02 * x.x), method).unwrap();
        assert!(solution.raw.status.is_solved(), "{}", solution.raw.status);
        assert_eq!(discrete.qp.kernel.len(), 1);
        assert!(discrete.warnings[0].contains("translation of Ω' along"), "{:?}", discrete.warnings);
        let p: f64 = discrete.qp.conditions[0].iter().map(|(i, p)| p * solution.raw.x[*i as usize]).sum();
        assert!(p.abs() < 1e-13, "the mean slide is {p}");
        let y = &discrete.qp.kernel[0];
        let mut image = vec![0.0; y.len()];
        discrete.qp.matrix.apply(y, &mut image);
        assert!(image.iter().all(|r| r.abs() < 1e-13), "the kernel has no energy");
    }
}

#[test]
fn loads_and_data_that_are_no_numbers_are_refused_with_their_place() {
    let mesh = squares(4);
    let supports = [Traction, Sliding, Free, Fixed, Free, Free];
    let result = solve(&mesh, &supports, |x| Vec2::new(0.0, (0.6 - x.x).sqrt()), Method::Condensed);
    assert!(
        matches!(&result, Err(Error::Load(m)) if m.contains("part 'top'")),
        "{:?}",
        result.map(|(_, s)| s.raw.status)
    );
}

#[test]
fn the_stiffness_is_the_same_for_any_number_of_threads_and_symmetric() {
    let mesh = squares(12);
    let supports = [Traction, Sliding, Free, Fixed, Free, Free];
    let data = Top(|_| Vec2::new(0.0, -0.1));
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| problem(&mesh, &supports, &data).discretise().unwrap().qp)
    };
    let (one, two) = (with(1), with(2));
    assert_eq!(one.matrix, two.matrix);
    assert_eq!(one.load, two.load);
    for i in 0..one.matrix.rows() {
        for (j, b) in one.matrix.row(i) {
            let (_, t) = one.matrix.row(j).find(|(k, _)| *k == i).expect("a symmetric pattern");
            assert!((b[1] - t[2]).abs() < 1e-14 && (b[0] - t[0]).abs() < 1e-14);
        }
    }
}
