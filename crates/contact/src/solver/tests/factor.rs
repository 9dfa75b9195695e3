//! The sparse factor and the Schur complement, against dense algebra.

use super::examples::{Random, dense, distance};
use super::plate;
use crate::qp::BoundQp;
use crate::solver::cholesky::{Cholesky, NotPositiveDefinite};
use crate::solver::schur::Condensation;
use nalgebra::{DMatrix, DVector};

/// `K_cc − K_ci K_ii⁻¹ K_ic` by dense elimination.
fn schur_complement(qp: &BoundQp) -> DMatrix<f64> {
    let k = dense(qp);
    let c: Vec<usize> = qp.bounds.iter().map(|b| b.dof as usize).collect();
    let i: Vec<usize> = (0..k.nrows()).filter(|i| !c.contains(i)).collect();
    let part = |rows: &[usize], columns: &[usize]| k.select_rows(rows).select_columns(columns);
    let inner = part(&i, &i).cholesky().expect("positive definite");
    part(&c, &c) - part(&c, &i) * inner.solve(&part(&i, &c))
}

#[test]
fn the_schur_complement_is_that_of_dense_elimination() {
    let mut problems: Vec<BoundQp> = (1..8).map(|m| Random(m).problem(60, m as usize)).collect();
    problems.push(plate::plate(9).qp);
    for qp in problems {
        let condensation = Condensation::new(&qp, &[]).expect("positive definite");
        let schur = condensation.schur_complement();
        let truth = schur_complement(&qp);
        let m = qp.bounds.len();
        let read = DMatrix::from_fn(m, m, |i, j| schur[(i, j)]);
        assert!((read - &truth).amax() < 1e-12 * truth.amax(), "m = {m}");
    }
}

#[test]
fn the_trailing_block_is_triangular_in_the_given_order() {
    // last unknowns in an order of our own choice: L_cc L_ccᵀ = ((K⁻¹)_cc)⁻¹
    let qp = Random(2).problem(40, 0);
    let trailing = [31, 4, 17, 8];
    let factor = Cholesky::new(&qp.matrix, &[false; 40], &trailing, &[0.0; 4]).expect("definite");
    let block = factor.trailing_block();
    let lower = DMatrix::from_fn(4, 4, |i, j| block[(i, j)]);
    let c = trailing.map(|i| i as usize);
    let inverse = dense(&qp).try_inverse().expect("definite");
    let truth = inverse.select_rows(&c).select_columns(&c);
    let product = &lower * lower.transpose() * truth;
    assert!((product - DMatrix::identity(4, 4)).amax() < 1e-12);
    assert!((0..4).all(|j| (0..j).all(|i| lower[(i, j)] == 0.0)));
}

#[test]
fn removed_unknowns_are_held_at_zero() {
    let qp = Random(4).problem(30, 0);
    let removed: Vec<bool> = (0..30).map(|i| i % 7 == 3).collect();
    let factor = Cholesky::new(&qp.matrix, &removed, &[6], &[2.5]).expect("definite");
    let load = Random(5).vector(30);
    let mut x = load.clone();
    factor.solve(&mut x);
    let mut matrix = dense(&qp);
    let mut rhs = DVector::from_vec(load);
    matrix[(6, 6)] += 2.5;
    for i in (0..30).filter(|&i| removed[i]) {
        matrix.row_mut(i).fill(0.0);
        matrix[(i, i)] = 1.0;
        rhs[i] = 0.0;
    }
    let truth = matrix.lu().solve(&rhs).expect("regular");
    assert!(distance(&x, truth.as_slice()) < 1e-12);
}

#[test]
fn a_pivot_of_rounding_size_is_a_zero() {
    // a free plate: three rigid motions, pivots of size 1e-16
    let plate = plate::plate(6);
    let free = vec![false; plate.free.dimension()];
    let factor = Cholesky::new(&plate.free, &free, &[], &[]);
    assert_eq!(factor.err(), Some(NotPositiveDefinite));
    // everything removed: nothing to factor, nothing to refuse
    let nothing = Cholesky::new(&plate.free, &vec![true; free.len()], &[], &[]).expect("empty");
    let mut x = vec![1.0; free.len()];
    nothing.solve(&mut x);
    assert_eq!(x, vec![0.0; free.len()]);
}
