//! Condensed, interior point and enumeration agree.

use super::examples::{Random, distance, enumerate, problem};
use crate::qp::{BoundQp, CertificateScales, certify, energy};
use crate::solver::{Method, QpSolution, Settings, Status, solve};
use nalgebra::DMatrix;

pub fn condensed(qp: &BoundQp) -> QpSolution {
    solve(qp, &Settings::default())
}

pub fn interior(qp: &BoundQp) -> QpSolution {
    let settings = Settings { method: Method::InteriorPoint, ..Settings::default() };
    solve(qp, &settings)
}

fn monotone(qp: &BoundQp) -> QpSolution {
    let settings = Settings { method: Method::Monotone, ..Settings::default() };
    solve(qp, &settings)
}

/// Asserts that all KKT residuals are at rounding level.
pub fn assert_optimal(qp: &BoundQp, solution: &QpSolution) {
    assert!(solution.status.is_solved(), "{:?}", solution.status);
    let scales = CertificateScales {
        displacement: crate::qp::largest(&solution.x),
        energy: 2.0 * energy(qp, &solution.x).abs(),
    };
    let c = certify(qp, &solution.x, &solution.multipliers, &scales);
    assert!(c.stationarity < 1e-14, "{c:?}");
    assert!(c.penetration < 1e-12, "{c:?}");
    assert!(c.tension == 0.0, "{c:?}");
    assert!(c.complementarity < 1e-12, "{c:?}");
}

#[test]
fn solvers_agree_with_enumeration() {
    let mut random = Random(1);
    let mut mixed = 0;
    for m in 0..=8 {
        for n in [18, 24] {
            let qp = random.problem(n, m);
            let truth = enumerate(&qp);
            for solution in [condensed(&qp), interior(&qp), monotone(&qp)] {
                assert_optimal(&qp, &solution);
                assert!(distance(&solution.x, &truth) < 1e-11, "m = {m}, n = {n}");
            }
            let active = condensed(&qp).multipliers.iter().filter(|l| **l > 0.0).count();
            mixed += usize::from(active > 0 && active < m);
        }
    }
    assert!(mixed >= 5, "too few problems with some bounds active and some not");
}

#[test]
fn a_problem_without_bounds_is_one_linear_solve() {
    let qp = Random(7).problem(30, 0);
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    assert_eq!(solution.factorizations, 1);
    assert_eq!(solution.status, Status::Converged { steps: 1 });
}

#[test]
fn every_unknown_may_be_bounded() {
    let mut random = Random(3);
    let bounds: Vec<(usize, f64)> = (0..6).map(|i| (i, 0.2 * random.next())).collect();
    let qp = problem(&random.matrix(6), &random.vector(6), &bounds);
    for solution in [condensed(&qp), interior(&qp)] {
        assert_optimal(&qp, &solution);
        assert!(distance(&solution.x, &enumerate(&qp)) < 1e-11);
    }
}

#[test]
fn units_do_not_matter() {
    // the same problem in pascals and micrometres: K in 1e11, x in 1e-6
    let qp = Random(5).problem(20, 5);
    let mut scaled = qp.clone();
    scaled.matrix.blocks_mut().iter_mut().flatten().for_each(|k| *k *= 1e11);
    scaled.load.iter_mut().for_each(|f| *f *= 1e5);
    scaled.bounds.iter_mut().for_each(|b| b.upper *= 1e-6);
    let truth: Vec<f64> = enumerate(&qp).iter().map(|x| 1e-6 * x).collect();
    for solution in [condensed(&scaled), interior(&scaled)] {
        assert_optimal(&scaled, &solution);
        assert!(distance(&solution.x, &truth) < 1e-17);
    }
}

#[test]
fn ties_do_not_cycle() {
    // Bound 1 is exactly met with no force: x = (1, 1), λ = (0, 0) whether it counts as active or not.
    let matrix = DMatrix::from_row_slice(2, 2, &[2.0, -1.0, -1.0, 2.0]);
    let qp = problem(&matrix, &[1.0, 1.0], &[(0, 5.0), (1, 1.0)]);
    for solution in [condensed(&qp), interior(&qp)] {
        assert_optimal(&qp, &solution);
        assert!(distance(&solution.x, &[1.0, 1.0]) < 1e-13);
        assert!(!matches!(solution.status, Status::Rescued { .. }));
    }
    // and with data that do not round well, all bounds tied at once
    let mut random = Random(11);
    for _ in 0..20 {
        let mut qp = random.problem(20, 8);
        qp.bounds.iter_mut().for_each(|b| b.upper = 1e9);
        let free = condensed(&qp).x;
        qp.bounds.iter_mut().for_each(|b| b.upper = free[b.dof as usize]);
        let solution = condensed(&qp);
        assert!(matches!(solution.status, Status::Converged { steps: 1..=3 }));
        assert!(distance(&solution.x, &free) < 1e-11);
    }
}

#[test]
fn an_indefinite_matrix_is_refused() {
    let mut qp = Random(9).problem(12, 3);
    qp.matrix.blocks_mut()[0][0] -= 100.0;
    assert_eq!(condensed(&qp).status, Status::NotPositiveDefinite);
    let qp = problem(&DMatrix::from_element(2, 2, 1.0), &[1.0, 1.0], &[]);
    assert_eq!(condensed(&qp).status, Status::NotPositiveDefinite);
    assert_eq!(interior(&qp).status, Status::NotPositiveDefinite);
}

#[test]
fn data_that_are_not_finite_are_never_solved() {
    for method in [Method::Condensed, Method::InteriorPoint] {
        let settings = Settings { method, ..Settings::default() };
        let mut qp = Random(15).problem(12, 3);
        assert!(solve(&qp, &settings).status.is_solved());
        qp.load[4] = f64::NAN;
        assert!(!solve(&qp, &settings).status.is_solved());
        let mut qp = Random(15).problem(12, 3);
        qp.bounds[1].upper = f64::INFINITY;
        assert!(!solve(&qp, &settings).status.is_solved());
    }
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let qp = Random(16).problem(60, 8);
    for method in [condensed, interior] {
        let (first, second) = (method(&qp), method(&qp));
        assert_eq!(first.x, second.x);
        assert_eq!(first.multipliers, second.multipliers);
        assert_eq!(first.history, second.history);
    }
}
