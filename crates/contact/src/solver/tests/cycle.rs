//! When the primal–dual active set runs in a circle.

use super::agreement::{assert_optimal, condensed, interior};
use super::examples::{Random, distance, enumerate, problem};
use crate::qp::BoundQp;
use crate::solver::active_set::{PrimalDual, primal_dual};
use crate::solver::dense::DenseQp;
use crate::solver::monotone::{Monotone, monotone};
use crate::solver::{Method, Settings, Status, solve};
use faer::Mat;
use nalgebra::DMatrix;

/// Found by a search through small integers. From {1,2,3} the method goes to {2,3}, frees that too, finds all three
/// bounds violated and is back at {1,2,3}: without a memory it would run for ever. The solution presses on the first
/// bound only: `x = (0, −7/86, −73/86)`, `λ = (4/43, 0, 0)`.
fn three_bounds_in_a_circle() -> BoundQp {
    let matrix = DMatrix::from_row_slice(3, 3, &[4.0, 6.0, -4.0, 6.0, 19.0, -3.0, -4.0, -3.0, 5.0]);
    problem(&matrix, &[3.0, 1.0, -4.0], &[(0, 0.0), (1, 0.0), (2, 0.0)])
}

#[test]
fn a_cycle_is_seen_and_rescued() {
    let qp = three_bounds_in_a_circle();
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    assert!(matches!(solution.status, Status::Rescued { cycle: 3, .. }), "{:?}", solution.status);
    assert_eq!(solution.history[..3], [3, 2, 0]);
    let truth = [0.0, -7.0 / 86.0, -73.0 / 86.0, 0.0];
    assert!(distance(&solution.x, &truth) < 1e-14);
    assert!(distance(&solution.multipliers, &[4.0 / 43.0, 0.0, 0.0]) < 1e-14);
    assert!(distance(&interior(&qp).x, &truth) < 1e-12);
}

#[test]
fn the_step_limit_is_rescued_too() {
    let qp = three_bounds_in_a_circle();
    let settings = Settings { method: Method::Condensed, max_steps: 1, ..Settings::default() };
    let solution = solve(&qp, &settings);
    assert_optimal(&qp, &solution);
    assert!(matches!(solution.status, Status::Rescued { cycle: 0, .. }));
}

#[test]
fn the_monotone_method_solves_alone() {
    let mut random = Random(21);
    for m in 1..=8 {
        let matrix = random.matrix(m);
        let (load, upper) = (random.vector(m), random.vector(m));
        let dense =
            DenseQp { matrix: Mat::from_fn(m, m, |i, j| matrix[(i, j)]), load: load.clone(), upper: upper.clone() };
        let bounds: Vec<(usize, f64)> = upper.iter().copied().enumerate().collect();
        let truth = enumerate(&problem(&matrix, &load, &bounds));
        // from a point far outside, from the bounds, from far inside
        for start in [1e3, 0.0, -1e3] {
            let start: Vec<f64> = upper.iter().map(|g| g + start).collect();
            let Monotone::Solved(solution) = monotone(&dense, &start, &mut Vec::new()) else {
                panic!("no solution for m = {m}");
            };
            assert!(distance(&solution.x, &truth[..m]) < 1e-11);
        }
    }
}

#[test]
fn random_problems_that_cycle_are_solved() {
    // ill-conditioned matrices of full rank: one in some thousand makes the primal–dual sets cycle
    let mut random = Random(1);
    let mut cycles = 0;
    for _ in 0..20_000 {
        let m = 6;
        let root = DMatrix::from_fn(m, m, |_, _| random.next());
        let matrix = &root * root.transpose();
        let load = random.vector(m);
        let dense =
            DenseQp { matrix: Mat::from_fn(m, m, |i, j| matrix[(i, j)]), load: load.clone(), upper: vec![0.0; m] };
        if let PrimalDual::Stopped { cycle, .. } = primal_dual(&dense, 50, &mut Vec::new()) {
            assert!(cycle > 1);
            cycles += 1;
            let bounds: Vec<(usize, f64)> = (0..m).map(|i| (i, 0.0)).collect();
            let qp = problem(&matrix, &load, &bounds);
            let solution = condensed(&qp);
            assert_optimal(&qp, &solution);
            assert!(matches!(solution.status, Status::Rescued { .. }));
            assert!(distance(&solution.x, &enumerate(&qp)) < 1e-11);
        }
    }
    assert!(cycles > 4, "{cycles}");
}
