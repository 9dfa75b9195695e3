//! The kernels that grow with the mesh, each by itself: `cargo bench -p signorini-contact`.
//!
//! Two unit squares of `n × n` cells press on each other, clamped below, loaded above: `4(n + 1)²` unknowns, less those held.

use divan::{Bencher, black_box, counter::ItemsCount};
use signorini_contact::assembly::stiffness;
use signorini_contact::material::Plane;
use signorini_contact::mesh::blocks::{Pattern, QuadBlock, triangulate};
use signorini_contact::mesh::{Hierarchy, Mesh, PartOutline};
use signorini_contact::problem::{Data, Discrete, Problem, Support};
use signorini_contact::quadrature::Cubature;
use signorini_contact::solver::{Accuracy, Method, Prepared, Settings};
use signorini_contact::zone::Zone;
use signorini_contact::{Body, ContactLine, Error, Material, Path, Point, Vec2};

/// Cells per side: matrices inside and beyond the caches.
const CELLS: [usize; 3] = [32, 128, 512];

fn main() {
    divan::main();
}

/// A traction of 0.1 downwards on every loaded part.
struct Press;

impl Data for Press {
    fn traction(&self, _part: usize, _x: Point, _normal: Vec2) -> Vec2 {
        Vec2::new(0.0, -0.1)
    }
}

/// Corners of the square that stands at height `y`.
fn corners(y: f64) -> [Point; 4] {
    [[0.0, y], [1.0, y], [1.0, y + 1.0], [0.0, y + 1.0]].map(|[x, y]| Point::new(x, y))
}

fn parts() -> (Vec<PartOutline>, Vec<Support>) {
    let part = |body, name: &str, y: f64, ends: [usize; 2]| PartOutline {
        body,
        name: name.into(),
        along: Path::polyline(ends.map(|k| corners(y)[k])),
    };
    let all = [
        (part(Body::First, "right", 0.0, [1, 2]), Support::Free),
        (part(Body::First, "top", 0.0, [2, 3]), Support::Traction),
        (part(Body::First, "left", 0.0, [3, 0]), Support::Sliding),
        (part(Body::Second, "left", -1.0, [3, 0]), Support::Free),
        (part(Body::Second, "bottom", -1.0, [0, 1]), Support::Fixed),
        (part(Body::Second, "right", -1.0, [1, 2]), Support::Free),
    ];
    all.into_iter().unzip()
}

fn mesh(n: usize) -> Result<Mesh, Error> {
    let block = |y| triangulate(&[QuadBlock::straight(corners(y), [n, n])], Pattern::Structured);
    Mesh::build([block(0.0)?, block(-1.0)?], &parts().0, &ContactLine::polyline(&corners(0.0)[..2]))
}

/// The mesh, the materials and the discrete problem on it.
fn discrete(n: usize) -> Result<(Mesh, [Material; 2], Discrete), Error> {
    let (mesh, materials) = (mesh(n)?, [Material::isotropic(1.0, 0.3, Plane::Strain)?; 2]);
    let (supports, cubature) = (parts().1, Cubature::default());
    let problem = Problem { mesh: &mesh, materials, supports: &supports, data: &Press, cubature: &cubature };
    let discrete = problem.discretise()?;
    Ok((mesh, materials, discrete))
}

/// `y = K x`.
#[divan::bench(args = CELLS)]
fn product(bencher: Bencher, n: usize) {
    let (_, _, discrete) = discrete(n).expect("two squares");
    let matrix = discrete.qp.matrix;
    let x = vec![1.0; matrix.dimension()];
    let mut y = vec![0.0; matrix.dimension()];
    bencher.counter(ItemsCount::new(x.len())).bench_local(|| matrix.apply(black_box(&x), black_box(&mut y)));
}

/// `Tᵀ A T`.
#[divan::bench(args = CELLS)]
fn assembly(bencher: Bencher, n: usize) {
    let (mesh, materials, discrete) = discrete(n).expect("two squares");
    let unknowns = ItemsCount::new(discrete.qp.load.len());
    bencher.counter(unknowns).bench_local(|| stiffness(black_box(&mesh), &materials, &discrete.basis));
}

/// The contact problem by nested multigrid from 8 cells on, to one per cent of the discretisation error; coarse matrices included.
#[divan::bench(args = CELLS)]
fn multigrid(bencher: Bencher, n: usize) {
    let mut hierarchy = Hierarchy::new(mesh(8).expect("two squares"));
    (0..(n / 8).ilog2()).for_each(|_| hierarchy.refine());
    let materials = [Material::isotropic(1.0, 0.3, Plane::Strain).expect("a material"); 2];
    let (supports, cubature) = (parts().1, Cubature::default());
    let mesh = hierarchy.finest();
    let problem = Problem { mesh, materials, supports: &supports, data: &Press, cubature: &cubature };
    let discrete = problem.discretise().expect("two squares");
    let accuracy = Accuracy::Discretisation(0.01);
    let settings = Settings { method: Method::Multigrid, accuracy, ..Settings::default() };
    let solve =
        || Prepared::with_levels(&discrete.qp, discrete.levels(black_box(&hierarchy), &materials)).solve(&settings);
    bencher.counter(ItemsCount::new(discrete.dofs())).bench_local(solve);
}

/// Red refinement to `n` cells.
#[divan::bench(args = CELLS)]
fn refinement(bencher: Bencher, n: usize) {
    let coarse = || Hierarchy::new(mesh(n / 2).expect("two squares"));
    let triangles = ItemsCount::new(4 * n * n);
    bencher.counter(triangles).with_inputs(coarse).bench_local_values(|mut hierarchy| {
        hierarchy.refine();
        hierarchy
    });
}

/// Pairs, normals and gaps.
#[divan::bench(args = CELLS)]
fn zone(bencher: Bencher, n: usize) {
    let mesh = mesh(n).expect("two squares");
    bencher.counter(ItemsCount::new(n + 1)).bench_local(|| Zone::new(black_box(&mesh)));
}
