//! Properties of the parts: transfers, coarse matrices, energies that only fall.

use super::cycle::{Cycle, Grid};
use super::iterate::Iteration;
use super::*;
use crate::mesh::blocks::Pattern;
use crate::mesh::tests::kinked;
use crate::mesh::{Hierarchy, Mesh};
use crate::problem::{Data, Discrete, Problem, Support};
use crate::quadrature::Cubature;
use crate::solver::tests::examples::Random;
use crate::{Body, Material, Point, Vec2};

struct Pull;

impl Data for Pull {
    fn has_body_force(&self, body: Body) -> bool {
        body == Body::First
    }

    fn body_force(&self, _: Body, x: Point) -> Vec2 {
        Vec2::new(0.1 * x.y, -1.0 + 1.5 * x.x)
    }
}

/// A body in a notch, held by nothing else.
fn with_levels(refinements: usize, run: impl FnOnce(&Mesh, &Discrete, Levels)) {
    let coarse: Mesh = kinked(4, Pattern::Structured).build().expect("a mesh");
    let supports = [Support::Free, Support::Fixed];
    let mut hierarchy = Hierarchy::new(coarse);
    (0..refinements).for_each(|_| hierarchy.refine());
    let materials = [Material::lame(1.5, 1.0).unwrap(), Material::lame(3.0, 2.0).unwrap()];
    let cubature = Cubature::default();
    let problem =
        Problem { mesh: hierarchy.finest(), materials, supports: &supports, data: &Pull, cubature: &cubature };
    let discrete = problem.discretise().expect("a load that presses");
    run(hierarchy.finest(), &discrete, discrete.levels(&hierarchy, &materials));
}

#[test]
fn restriction_is_the_transpose_of_prolongation() {
    with_levels(2, |_, discrete, levels| {
        let matrices = [&levels.coarse[1].matrix, &discrete.qp.matrix];
        for (level, fine) in levels.coarse.iter().zip(matrices) {
            let mut random = Random(7);
            let (c, mut f) = (random.vector(level.matrix.dimension()), random.vector(fine.dimension()));
            let (mut pc, mut ptf) = (f.clone(), c.clone());
            level.transfer.prolong(&c, &mut pc);
            let left: f64 = pc.iter().zip(&f).map(|(a, b)| a * b).sum();
            level.transfer.restrict(fine, &mut f, &mut ptf);
            let right: f64 = ptf.iter().zip(&c).map(|(a, b)| a * b).sum();
            assert!((left - right).abs() < 1e-12 * left.abs().max(1.0), "{left} {right}");
            assert!(!level.transfer.special.is_empty());
        }
    });
}

/// On straight bodies a coarse matrix is `PᵀKP`: pairs, corners, rotated and clamped nodes included.
#[test]
fn coarse_matrices_are_those_of_galerkin() {
    with_levels(2, |_, discrete, levels| {
        let matrices = [&levels.coarse[1].matrix, &discrete.qp.matrix];
        for (level, fine) in levels.coarse.iter().zip(matrices) {
            let mut c = Random(3).vector(level.matrix.dimension());
            // a fixed component has an entry of its own on the diagonal and nothing else
            (0..c.len()).filter(|&i| discrete.basis.fixed[i]).for_each(|i| c[i] = 0.0);
            let mut direct = c.clone();
            level.matrix.apply(&c, &mut direct);
            let (mut pc, mut kpc) = (vec![0.0; fine.dimension()], vec![0.0; fine.dimension()]);
            level.transfer.prolong(&c, &mut pc);
            fine.apply(&pc, &mut kpc);
            let mut galerkin = c.clone();
            level.transfer.restrict(fine, &mut kpc, &mut galerkin);
            let far = direct.iter().zip(&galerkin).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
            let size = direct.iter().fold(0.0, |m: f64, a| m.max(a.abs()));
            assert!(far <= 1e-13 * size, "{far:e} of {size:e}");
        }
    });
}

/// Cut short or frozen, coarse functions keep the matrix of Galerkin, level by level, whatever is frozen.
#[test]
fn truncated_matrices_are_those_of_galerkin() {
    for pattern in 0..6_usize {
        with_levels(3, |_, discrete, levels| {
            let motions = levels.motions.clone();
            let grids = Grid::all(&discrete.qp, levels);
            let mut cycle = Cycle::new(&grids, &motions);
            let finest = grids.len() - 1;
            // runs of closed pairs of every length, single ones among them
            let mut frozen: Vec<bool> =
                (0..discrete.qp.bounds.len()).map(|k| (k * (pattern + 3) / 7) % 3 == 0 || k % 11 == pattern).collect();
            cycle.freeze(finest, &frozen);
            for k in (0..finest).rev() {
                let (coarse, fine) = (&grids[k], &grids[k + 1]);
                let transfer = fine.transfer.as_ref().expect("a transfer");
                let below = cycle.frozen(k).to_vec();
                let held = |bounds: &[crate::qp::Bound], frozen: &[bool], x: &mut [f64]| {
                    bounds.iter().zip(frozen).filter(|(_, f)| **f).for_each(|(b, _)| x[b.dof as usize] = 0.0);
                    (0..x.len()).filter(|&i| discrete.basis.fixed[i]).for_each(|i| x[i] = 0.0);
                };
                let mut c = Random(5).vector(coarse.dimension());
                held(&coarse.bounds, &below, &mut c);
                let mut direct = c.clone();
                coarse.matrix().apply(&c, &mut direct);
                let (mut pc, mut kpc) = (vec![0.0; fine.dimension()], vec![0.0; fine.dimension()]);
                transfer.prolong(&c, &mut pc);
                held(&fine.bounds, &frozen, &mut pc);
                fine.matrix().apply(&pc, &mut kpc);
                held(&fine.bounds, &frozen, &mut kpc);
                let mut galerkin = c.clone();
                transfer.restrict(&fine.matrix(), &mut kpc, &mut galerkin);
                held(&coarse.bounds, &below, &mut direct);
                held(&coarse.bounds, &below, &mut galerkin);
                let far = direct.iter().zip(&galerkin).enumerate().fold((0.0, 0), |m: (f64, usize), (i, (a, b))| {
                    if (a - b).abs() > m.0 { ((a - b).abs(), i) } else { m }
                });
                let size = direct.iter().fold(0.0, |m: f64, a| m.max(a.abs()));
                assert!(far.0 <= 1e-12 * size, "pattern {pattern}, level {k}: {far:?} of {size:e}");
                frozen = below;
            }
        });
    }
}

#[test]
fn the_energy_falls_in_every_iteration_and_by_as_much_as_is_said() {
    with_levels(3, |_, discrete, levels| {
        let motions = levels.motions.clone();
        let grids = Grid::all(&discrete.qp, levels);
        let mut cycle = Cycle::new(&grids, &motions);
        let finest = grids.len() - 1;
        // far from the solution, within the bounds
        let mut random = Random(11);
        let mut x: Vec<f64> = random.vector(grids[finest].dimension()).iter().map(|v| 0.1 * v).collect();
        (0..x.len()).filter(|&i| discrete.basis.fixed[i]).for_each(|i| x[i] = 0.0);
        discrete.qp.bounds.iter().for_each(|b| x[b.dof as usize] = x[b.dof as usize].min(b.upper));
        let mut energy = crate::qp::energy(&discrete.qp, &x);
        let mut iteration = Iteration::new(&grids[finest], finest, &discrete.qp.load, x);
        let (first, mut total) = (energy, 0.0);
        for step in 0..40 {
            let progress = iteration.advance(&mut cycle);
            let next = crate::qp::energy(&discrete.qp, &iteration.x);
            total += progress.decrease;
            assert!(next <= energy + 1e-13 * energy.abs(), "step {step}: {energy} {next}");
            assert!(progress.decrease >= 0.0);
            let within = |b: &crate::qp::Bound| iteration.x[b.dof as usize] <= b.upper;
            assert!(discrete.qp.bounds.iter().all(within), "step {step}");
            energy = next;
        }
        assert!((total - (first - energy)).abs() <= 1e-12 * first.abs(), "{total} {}", first - energy);
        let direct = crate::solver::solve(&discrete.qp, &Settings::default());
        let least = crate::qp::energy(&discrete.qp, &direct.x);
        assert!((energy - least).abs() <= 1e-12 * least.abs(), "{energy} {least}");
    });
}

/// A body far above its support: nothing is in contact, no linear problem has a minimum.
#[test]
fn a_body_that_has_lifted_off_comes_back_in_one_iteration() {
    with_levels(2, |mesh, discrete, levels| {
        let motions = levels.motions.clone();
        let grids = Grid::all(&discrete.qp, levels);
        assert_eq!(motions.len(), 3, "Ω' is held by contact alone");
        let mut cycle = Cycle::new(&grids, &motions);
        let finest = grids.len() - 1;
        let lifted = |b: &Body| if *b == Body::First { Vec2::new(0.0, 5.0) } else { Vec2::zeros() };
        let up = discrete.basis.coordinates(&mesh.node_bodies.iter().map(lifted).collect::<Vec<_>>());
        let mut iteration = Iteration::new(&grids[finest], finest, &discrete.qp.load, up);
        let progress = iteration.advance(&mut cycle);
        assert!(progress.active > 0, "in contact again");
        let least = crate::qp::energy(&discrete.qp, &crate::solver::solve(&discrete.qp, &Settings::default()).x);
        for _ in 0..40 {
            iteration.advance(&mut cycle);
        }
        let energy = crate::qp::energy(&discrete.qp, &iteration.x);
        assert!((energy - least).abs() <= 1e-8 * least.abs(), "{energy} {least}");
    });
}
