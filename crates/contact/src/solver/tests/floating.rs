//! Bodies that the supports do not hold: by contact alone, or only up to a two-sided motion.

use super::agreement::{assert_optimal, condensed, interior};
use super::examples::{dense, distance, enumerate, problem};
use super::plate::plate;
use crate::qp::{Bound, BoundQp, residual};
use crate::solver::{Method, Settings, Status, solve};
use nalgebra::DMatrix;

/// A chain of `n` springs of stiffness 1 with no support.
fn chain(n: usize) -> DMatrix<f64> {
    let mut k = DMatrix::zeros(n, n);
    for i in 1..n {
        k[(i - 1, i - 1)] += 1.0;
        k[(i, i)] += 1.0;
        k[(i - 1, i)] -= 1.0;
        k[(i, i - 1)] -= 1.0;
    }
    k
}

#[test]
fn a_chain_pushed_against_one_stop() {
    // all of the load goes through the stop: λ = Σf
    let qp = problem(&chain(6), &[0.5, -0.2, 0.4, 0.1, 0.3, -0.1], &[(5, 0.25)]);
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    assert!((solution.multipliers[0] - 1.0).abs() < 1e-14);
    assert!(distance(&solution.x, &enumerate(&qp)) < 1e-12);
    assert!(distance(&interior(&qp).x, &solution.x) < 1e-11);
}

#[test]
fn a_chain_that_finds_its_stop_by_moving() {
    // Both ends have a stop. The start (both active) pulls at the left one; both sets {left}, {right} hold the chain.
    let load = [-0.9, 0.0, 0.0, 0.0, 0.0, 1.0];
    let qp = problem(&chain(6), &load, &[(0, 3.0), (5, 0.25)]);
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    assert!(distance(&solution.multipliers, &[0.0, 0.1]) < 1e-13);
    // slack everywhere at the first face of the monotone method: the drift has to find the stop
    assert!(distance(&solution.x, &enumerate(&qp)) < 1e-12);
}

#[test]
fn a_load_that_pulls_away_has_no_minimum() {
    let qp = problem(&chain(6), &[-0.1; 6], &[(0, 1.0), (5, 0.25)]);
    assert_eq!(condensed(&qp).status, Status::NotPositiveDefinite);
    assert_eq!(interior(&qp).status, Status::NotPositiveDefinite);
}

/// A multiplier of 1e-13 of the load holds the chain: the interior point does not see it, the crossover must.
#[test]
fn a_whisper_holds_a_chain() {
    let load = [1.0, -1.0, 0.5, -0.5, 0.25, -0.25 + 1e-13];
    let qp = problem(&chain(6), &load, &[(0, 1.0), (5, 0.25)]);
    let total: f64 = load.iter().sum();
    for solution in [condensed(&qp), interior(&qp)] {
        assert!(solution.status.is_solved(), "{:?}", solution.status);
        assert!((solution.multipliers.iter().sum::<f64>() / total - 1.0).abs() < 1e-2, "{:?}", solution.multipliers);
    }
}

#[test]
fn a_limit_load_is_solved_up_to_its_motion() {
    // Σf = 0: the chain rests anywhere at or behind its stop, with no force.
    let load = [1.0, -1.0, 0.5, -0.5, 0.25, -0.25];
    let qp = problem(&chain(6), &load, &[(0, 0.0), (5, 0.25)]);
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    assert_eq!(solution.multipliers, [0.0, 0.0]);
}

#[test]
fn a_bar_on_one_stop_tips_to_the_next() {
    // A bar of three masses that resists bending only, κ = x₁ − 2x₂ + x₃. The middle stop stands out, so the second set
    // is {2}: it leaves the rotation free, and only the bound that this rotation runs into ends it.
    let bend = DMatrix::from_row_slice(3, 1, &[1.0, -2.0, 1.0]);
    let qp = problem(&(&bend * bend.transpose()), &[0.4, 0.2, 0.6], &[(0, 1.0), (1, 0.0), (2, 1.0)]);
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    assert!(matches!(solution.status, Status::Rescued { cycle: 0, .. }), "{:?}", solution.status);
    assert_eq!(solution.history, [3, 1, 2]);
    assert!(distance(&solution.x, &[-0.6, 0.0, 1.0, 0.0]) < 1e-13);
    assert!(distance(&solution.multipliers, &[0.0, 1.0, 0.2]) < 1e-13);
    assert!(distance(&interior(&qp).x, &solution.x) < 1e-11);
}

/// The free plate over an obstacle below and a wall on its right: translations and the rotation are one-sided.
fn free_plate(n: usize) -> BoundQp {
    let plate = plate(n);
    let mut bounds: Vec<Bound> = (0..n).map(|i| Bound { dof: 2 * i as u32 + 1, upper: 0.01 }).collect();
    bounds.extend((0..n).map(|j| Bound { dof: 2 * (n * j + n - 1) as u32, upper: 0.02 }));
    bounds.sort_by_key(|b| b.dof);
    let mut load = vec![0.0; 2 * n * n];
    for j in 0..n {
        // pushed to the wall on its left side, to the obstacle on the side across, more towards the right
        load[2 * n * j] = 0.1 / n as f64;
        load[2 * (n * (n - 1) + j) + 1] = (0.1 + 0.2 * j as f64 / n as f64) / n as f64;
    }
    BoundQp { matrix: plate.free, load, bounds, ..Default::default() }
}

#[test]
fn a_plate_held_by_contact_alone() {
    let qp = free_plate(9);
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    let second = interior(&qp);
    assert_optimal(&qp, &second);
    assert!(distance(&second.x, &solution.x) < 1e-10);
    // equilibrium: the contact forces balance the load in both directions
    for component in 0..2 {
        let load: f64 = qp.load.iter().skip(component).step_by(2).sum();
        let pairs = qp.bounds.iter().zip(&solution.multipliers);
        let held: f64 = pairs.filter(|(b, _)| b.dof as usize % 2 == component).map(|(_, l)| l).sum();
        assert!((load - held).abs() < 1e-13, "{load} {held}");
    }
}

#[test]
fn two_one_sided_rigid_motions_at_once() {
    // two separate chains, each with its own stops; the first faces tried leave either or both of them loose
    let mut matrix = DMatrix::zeros(8, 8);
    matrix.view_mut((0, 0), (4, 4)).copy_from(&chain(4));
    matrix.view_mut((4, 4), (4, 4)).copy_from(&(1e6 * chain(4)));
    let load = [0.0, 2.0, -1.0, -0.5, 0.1, -3.0, 0.0, 3.2];
    let bounds = [(0, 0.5), (3, -0.5), (4, 1.0), (5, 0.0), (7, 2.0)];
    let qp = problem(&matrix, &load, &bounds);
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    assert!(distance(&solution.x, &enumerate(&qp)) < 1e-10);
}

/// The plate on a smooth straight obstacle and pressed by a smooth straight stamp: free to slide.
fn sliding_plate(n: usize) -> BoundQp {
    let mut qp = free_plate(n);
    qp.bounds.retain(|b| b.dof % 2 == 1);
    let zero_mean = |k: usize| 0.02 * ((k * k % 11) as f64 - 4.0);
    let side: Vec<f64> = (0..n).map(zero_mean).collect();
    let mean = side.iter().sum::<f64>() / n as f64;
    for j in 0..n {
        qp.load[2 * n * j] = (side[j] - mean) / n as f64;
    }
    let slide = |i: usize| f64::from(u8::from(i.is_multiple_of(2)));
    qp.kernel = vec![(0..2 * n * n).map(slide).collect()];
    qp.conditions = vec![(0..n).map(|j| (2 * (n * j + n - 1) as u32, 1.0)).collect()];
    qp
}

#[test]
fn a_two_sided_motion_is_fixed_by_its_condition() {
    let qp = sliding_plate(9);
    let k_y = residual(&BoundQp { load: vec![0.0; 162], ..qp.clone() }, &qp.kernel[0]);
    assert!(distance(&k_y, &[0.0; 162]) < 1e-14, "the motion costs energy");
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    let condition: f64 = qp.conditions[0].iter().map(|&(i, p)| p * solution.x[i as usize]).sum();
    assert!(condition.abs() < 1e-13);
    let second = interior(&qp);
    assert_optimal(&qp, &second);
    assert!(distance(&second.x, &solution.x) < 1e-10);
    // the raw interior point obeys the condition too
    let settings = Settings { method: Method::InteriorPoint, crossover: false, ..Settings::default() };
    let raw = solve(&qp, &settings);
    assert!(distance(&raw.x, &solution.x) < 1e-6 && raw.x != second.x);
    // the bordered system [K_II Pᵀ; P 0] on the same active set
    let truth = bordered(&qp, &solution.multipliers);
    assert!(distance(&truth, &solution.x) < 1e-11);
}

/// The solution of the bordered system by dense elimination, the bounds with a force fixed.
fn bordered(qp: &BoundQp, multipliers: &[f64]) -> Vec<f64> {
    let k = dense(qp);
    let n = k.nrows();
    let mut matrix = k.resize(n + 1, n + 1, 0.0);
    let mut rhs = nalgebra::DVector::from_column_slice(&qp.load).push(0.0);
    for &(i, p) in &qp.conditions[0] {
        matrix[(n, i as usize)] = p;
        matrix[(i as usize, n)] = p;
    }
    for (bound, _) in qp.bounds.iter().zip(multipliers).filter(|(_, l)| **l > 0.0) {
        let i = bound.dof as usize;
        matrix.row_mut(i).fill(0.0);
        matrix[(i, i)] = 1.0;
        rhs[i] = bound.upper;
    }
    let x = matrix.full_piv_lu().solve(&rhs).expect("regular");
    x.as_slice()[..n].to_vec()
}

#[test]
fn a_condition_that_does_not_see_the_motion_is_refused() {
    let mut qp = sliding_plate(5);
    // the difference of two sliding displacements is the same for every slide
    qp.conditions = vec![vec![(0, 1.0), (8, -1.0)]];
    assert_eq!(condensed(&qp).status, Status::NotPositiveDefinite);
    assert_eq!(interior(&qp).status, Status::NotPositiveDefinite);
    qp.conditions.clear();
    assert_eq!(condensed(&qp).status, Status::NotPositiveDefinite);
    // nor does a kernel that is not told
    qp.kernel.clear();
    assert_eq!(condensed(&qp).status, Status::NotPositiveDefinite);
}

#[test]
fn two_kernel_vectors_in_any_basis() {
    // two chains with no bound at all, kernel vectors mixed, conditions on the ends
    let mut matrix = DMatrix::zeros(6, 6);
    matrix.view_mut((0, 0), (3, 3)).copy_from(&chain(3));
    matrix.view_mut((3, 3), (3, 3)).copy_from(&chain(3));
    let mut qp = problem(&matrix, &[1.0, 0.0, -1.0, 2.0, -1.0, -1.0], &[]);
    qp.kernel = vec![vec![1.0, 1.0, 1.0, 1.0, 1.0, 1.0], vec![2.0, 2.0, 2.0, -1.0, -1.0, -1.0]];
    qp.conditions = vec![vec![(0, 1.0), (3, 1.0)], vec![(5, 1.0)]];
    // x = (a, a−1, a−2), (b, b−2, b−3) with a + b = 0, b = 3
    let truth = [-3.0, -4.0, -5.0, 3.0, 1.0, 0.0];
    for solution in [condensed(&qp), interior(&qp)] {
        assert_optimal(&qp, &solution);
        assert!(distance(&solution.x, &truth) < 1e-12);
    }
    qp.kernel[1] = vec![3.0; 6];
    assert_eq!(condensed(&qp).status, Status::NotPositiveDefinite);
}
