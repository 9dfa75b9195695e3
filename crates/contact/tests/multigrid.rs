//! Multigrid against the direct solver, on scenes that ask for every part of it.

use signorini_contact::geometry::{CircularArc, SharedCurve};
use signorini_contact::mesh::{Hierarchy, Mesh, PartOutline, blocks};
use signorini_contact::problem::{Data, Discrete, Problem, Support};
use signorini_contact::quadrature::Cubature;
use signorini_contact::solver::{Accuracy, Method, Prepared, QpSolution, Settings};
use signorini_contact::zone::Zone;
use signorini_contact::{Body, ContactLine, Material, Path, Point, Vec2, assembly, qp};
use std::sync::Arc;

/// A traction on the top of the upper body.
struct Top(Load);

type Load = fn(Point) -> Vec2;

impl Data for Top {
    fn traction(&self, part: usize, x: Point, _normal: Vec2) -> Vec2 {
        if part == 0 { (self.0)(x) } else { Vec2::zeros() }
    }
}

use Support::{Fixed, Free, Sliding, Traction};

/// Supports of top, left, right of the upper body and bottom, left, right of the lower one.
const GUIDED: [Support; 6] = [Traction, Sliding, Free, Fixed, Free, Free];
const FLOATING: [Support; 6] = [Traction, Free, Free, Fixed, Free, Free];

struct Scene {
    name: &'static str,
    coarse: Mesh,
    supports: [Support; 6],
    load: Load,
    materials: [Material; 2],
    bilateral: &'static [usize],
    /// The mesh of `n` cells, where every level is mapped anew; elsewhere levels are refinements.
    mapped: Option<fn(usize) -> Mesh>,
}

/// Young's modulus and Poisson's ratio in plane strain.
fn material(young: f64, nu: f64) -> Material {
    Material::lame(young * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), young / (2.0 * (1.0 + nu))).unwrap()
}

fn at(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

fn part(body: Body, name: &str, along: &[Point]) -> PartOutline {
    PartOutline { body, name: name.into(), along: Path::polyline(along.to_vec()) }
}

/// Two bodies of width 1 that meet on `y = slope·|x − ¼|`-like legs, with a corner at `x = ¼` where `slope ≠ 0`.
fn bodies(n: usize, slope: f64) -> Mesh {
    let quad = |corners, cells| blocks::QuadBlock::straight(corners, cells);
    let (left, bend, right) = (at(0.0, 0.25 * slope), at(0.25, 0.0), at(1.0, 0.75 * slope));
    let upper = [
        quad([left, bend, at(0.25, 1.0), at(0.0, 1.0)], [n / 4, n]),
        quad([bend, right, at(1.0, 1.0), at(0.25, 1.0)], [n - n / 4, n]),
    ];
    let lower = [
        quad([at(0.0, -1.0), at(0.25, -1.0), bend, left], [n / 4, n]),
        quad([at(0.25, -1.0), at(1.0, -1.0), right, bend], [n - n / 4, n]),
    ];
    let parts = around(left, right);
    let line = if slope == 0.0 { vec![left, right] } else { vec![left, bend, right] };
    let body = |blocks: &[_]| blocks::triangulate(blocks, blocks::Pattern::Structured).unwrap();
    Mesh::build([body(&upper), body(&lower)], &parts, &ContactLine::polyline(line)).unwrap()
}

/// The boundary of two bodies, one above the other, whose zone goes from `left` to `right`.
fn around(left: Point, right: Point) -> [PartOutline; 6] {
    [
        part(Body::First, "top", &[at(1.0, 1.0), at(0.0, 1.0)]),
        part(Body::First, "left", &[at(0.0, 1.0), left]),
        part(Body::First, "right", &[right, at(1.0, 1.0)]),
        part(Body::Second, "bottom", &[at(0.0, -1.0), at(1.0, -1.0)]),
        part(Body::Second, "left", &[left, at(0.0, -1.0)]),
        part(Body::Second, "right", &[at(1.0, -1.0), right]),
    ]
}

/// The same with an arc of 60° in place of the line: a round hollow below, the upper body fills it.
fn hollow(n: usize) -> Mesh {
    let sixth = std::f64::consts::FRAC_PI_6;
    let middle = 1.5 * std::f64::consts::PI;
    let arc = CircularArc { centre: at(0.5, 0.9), radius: 1.0, from: middle - sixth, to: middle + sixth };
    let curve: SharedCurve = Arc::new(arc);
    let (left, right) = (curve.point(0.0), curve.point(1.0));
    let block = |corners, k: usize| {
        let mut curves = [const { None }; 4];
        curves[k] = Some(curve.clone());
        blocks::QuadBlock { curves, ..blocks::QuadBlock::straight(corners, [n, n]) }
    };
    let upper = block([left, right, at(1.0, 1.0), at(0.0, 1.0)], 0);
    let lower = block([at(0.0, -1.0), at(1.0, -1.0), right, left], 2);
    let parts = around(left, right);
    let line = Path { corners: vec![left, right], curves: vec![Some(curve)] };
    let body = |b| blocks::triangulate(&[b], blocks::Pattern::Structured).unwrap();
    Mesh::build([body(upper), body(lower)], &parts, &ContactLine::Common(line)).unwrap()
}

fn scenes() -> Vec<Scene> {
    let steel = [material(1.0, 0.3); 2];
    let scene = |name, coarse, supports, load: Load, materials| Scene {
        name,
        coarse,
        supports,
        load,
        materials,
        bilateral: &[],
        mapped: None,
    };
    let bending: Load = |x| Vec2::new(0.0, -0.1 * (1.0 - 1.75 * x.x));
    let pressing: Load = |x| Vec2::new(0.0, -0.1 - 0.02 * x.x);
    let flat = || bodies(4, 0.0);
    vec![
        scene("bending", flat(), GUIDED, bending, steel),
        scene("closed everywhere", flat(), GUIDED, pressing, steel),
        scene("close to lift-off", flat(), GUIDED, |x| Vec2::new(0.0, -0.1 * (1.0 - 1.98 * x.x)), steel),
        scene("soft on hard", flat(), GUIDED, bending, [material(1e-3, 0.3), material(1.0, 0.3)]),
        scene("hard on soft", flat(), GUIDED, bending, [material(1e3, 0.3), material(1.0, 0.3)]),
        scene("nearly incompressible", flat(), GUIDED, bending, [material(1.0, 0.49); 2]),
        scene("free to slide", flat(), FLOATING, pressing, steel),
        scene("free to turn", flat(), FLOATING, |x| Vec2::new(0.0, -0.1 * (x.x - 0.2)), steel),
        scene("in a notch", bodies(4, 0.5), FLOATING, |x| Vec2::new(0.01, -0.1 - 0.05 * x.x), steel),
        scene("on a ridge", bodies(4, -0.5), GUIDED, pressing, steel),
        scene("in a hollow", hollow(4), FLOATING, |_| Vec2::new(0.0, -0.1), steel),
        scene("guided in a hollow", hollow(4), GUIDED, bending, steel),
        Scene {
            mapped: Some(hollow),
            ..scene("in a mapped hollow", hollow(4), FLOATING, |_| Vec2::new(0.0, -0.1), steel)
        },
        Scene { mapped: Some(hollow), ..scene("guided in a mapped hollow", hollow(4), GUIDED, bending, steel) },
        Scene {
            bilateral: &[1],
            ..scene("held on one leg", bodies(4, 0.5), GUIDED, |x| Vec2::new(0.0, 0.1 - 0.5 * x.x), steel)
        },
    ]
}

/// The problem on the finest of `refinements` + 1 levels.
fn with_problem<T>(scene: &Scene, refinements: usize, run: impl FnOnce(&Hierarchy, &Problem, &Discrete) -> T) -> T {
    let mut hierarchy = Hierarchy::new(scene.coarse.clone());
    for step in 1..=refinements {
        match scene.mapped {
            Some(mesh) => hierarchy.refine_onto(&mesh(4 << step)).unwrap(),
            None => hierarchy.refine(),
        }
    }
    let (data, cubature) = (Top(scene.load), Cubature::default());
    let mesh = hierarchy.finest();
    let problem =
        Problem { mesh, materials: scene.materials, supports: &scene.supports, data: &data, cubature: &cubature };
    let load = assembly::loads(mesh, &scene.supports, &data, &cubature).unwrap();
    let mut zone = Zone::new(mesh);
    zone.make_bilateral(mesh, scene.bilateral);
    let discrete = problem.discretise_zone(load, zone).unwrap_or_else(|e| panic!("{}: {e}", scene.name));
    run(&hierarchy, &problem, &discrete)
}

fn multigrid(hierarchy: &Hierarchy, problem: &Problem, discrete: &Discrete, accuracy: Accuracy) -> QpSolution {
    let levels = discrete.levels(hierarchy, &problem.materials);
    let settings = Settings { method: Method::Multigrid, accuracy, ..Settings::default() };
    Prepared::with_levels(&discrete.qp, levels).solve(&settings)
}

fn condensed(discrete: &Discrete) -> QpSolution {
    Prepared::new(&discrete.qp, Method::Condensed).solve(&Settings::default())
}

/// `½ xᵀKx`.
fn half_strain_energy(discrete: &Discrete, x: &[f64]) -> f64 {
    let mut image = vec![0.0; x.len()];
    discrete.qp.matrix.apply(x, &mut image);
    0.5 * image.iter().zip(x).map(|(k, x)| k * x).sum::<f64>()
}

#[test]
fn at_the_floor_it_is_the_direct_solution() {
    for scene in scenes() {
        with_problem(&scene, 3, |hierarchy, problem, discrete| {
            let (fast, direct) = (multigrid(hierarchy, problem, discrete, Accuracy::Floor), condensed(discrete));
            let name = scene.name;
            assert!(fast.status.is_solved() && fast.iterations > 1, "{name}: {}", fast.status);
            let scale = half_strain_energy(discrete, &direct.x);
            let apart: Vec<f64> = fast.x.iter().zip(&direct.x).map(|(a, b)| a - b).collect();
            let distance = half_strain_energy(discrete, &apart);
            assert!(distance <= 1e-16 * scale, "{name}: {distance:e} of {scale:e}");
            let size = direct.x.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            let apart = fast.x.iter().zip(&direct.x).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
            assert!(apart <= 1e-8 * size, "{name}: {apart:e} of {size:e}");
            let force = direct.multipliers.iter().fold(0.0, |m: f64, l| m.max(*l));
            let apart =
                fast.multipliers.iter().zip(&direct.multipliers).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
            assert!(apart <= 1e-8 * force, "{name}: forces {apart:e} of {force:e}");
        });
    }
}

#[test]
fn the_algebraic_error_is_the_share_that_was_asked_for() {
    for scene in scenes() {
        let energy = |refinements, accuracy| {
            with_problem(&scene, refinements, |hierarchy, problem, discrete| {
                let solution = match accuracy {
                    Some(accuracy) => multigrid(hierarchy, problem, discrete, accuracy),
                    None => condensed(discrete),
                };
                (qp::energy(&discrete.qp, &solution.x), solution)
            })
        };
        let (coarse, fine) = (energy(3, None).0, energy(4, None).0);
        let (stopped, solution) = energy(4, Some(Accuracy::Discretisation(0.01)));
        // J_h − J of order h² at best: a third of the fall from the level below
        let share = ((stopped - fine) / ((coarse - fine) / 3.0)).sqrt();
        // on curved bodies the level below is another body with another load, and its energy a rougher measure
        let most = if scene.name.contains("hollow") { 0.05 } else { 0.02 };
        assert!(share <= most, "{}: {share}, {:?}", scene.name, solution.history);
        assert!(solution.work <= 120.0, "{}: {} work units", scene.name, solution.work);
        // its own word on the distance is the truth within a factor
        let (said, truth) = (solution.distance.expect("a distance"), (2.0 * (stopped - fine)).sqrt());
        assert!(said >= 0.3 * truth && said <= 2.0 * truth, "{}: {said:e} of {truth:e}", scene.name);
    }
}

#[test]
fn the_work_does_not_grow_with_refinement() {
    let scene = &scenes()[0];
    let solve = |refinements| {
        with_problem(scene, refinements, |hierarchy, problem, discrete| {
            multigrid(hierarchy, problem, discrete, Accuracy::Discretisation(0.01))
        })
    };
    for refinements in [4, 5, 6] {
        let solution = solve(refinements);
        assert!(solution.iterations <= 6 && solution.work <= 32.0, "{}: {}", solution.iterations, solution.work);
    }
}

#[test]
fn the_answer_does_not_depend_on_the_number_of_threads() {
    let scene = &scenes()[0];
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            with_problem(scene, 6, |hierarchy, problem, discrete| {
                assert!(discrete.qp.matrix.rows() > 40_000, "large enough for sweeps to be divided");
                multigrid(hierarchy, problem, discrete, Accuracy::Discretisation(0.01))
            })
        })
    };
    let (one, two) = (with(1), with(2));
    assert!(one.x.iter().zip(&two.x).all(|(a, b)| a.to_bits() == b.to_bits()));
    assert_eq!((one.history, one.work.to_bits()), (two.history, two.work.to_bits()));
}

#[test]
fn without_coarser_levels_it_is_a_direct_solution() {
    with_problem(&scenes()[0], 0, |hierarchy, problem, discrete| {
        let fast = multigrid(hierarchy, problem, discrete, Accuracy::Floor);
        assert_eq!(fast.x, condensed(discrete).x);
    });
}
