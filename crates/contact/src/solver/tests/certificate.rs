//! The certificate sees every way of being wrong, each in its own residual.

use super::agreement::condensed;
use super::examples::{Random, enumerate, problem};
use super::plate::plate;
use crate::qp::{BoundQp, Certificate, CertificateScales, algebraic_error, certify, energy, residual};
use crate::solver::QpSolution;
use nalgebra::{DMatrix, DVector};

fn certificate(qp: &BoundQp, solution: &QpSolution) -> Certificate {
    let scales = CertificateScales { displacement: 1.0, energy: 1.0 };
    certify(qp, &solution.x, &solution.multipliers, &scales)
}

/// A solved problem with some bounds active and some not.
fn solved() -> (BoundQp, QpSolution, usize, usize) {
    let qp = plate(9).qp;
    let solution = condensed(&qp);
    let presses = |l: &f64| *l > 0.0;
    let active = solution.multipliers.iter().position(presses).expect("contact");
    let open = solution.multipliers.iter().position(|l| *l == 0.0).expect("an open gap");
    (qp, solution, active, open)
}

#[test]
fn a_solution_has_a_clean_certificate() {
    let (qp, solution, ..) = solved();
    let c = certificate(&qp, &solution);
    assert!(c.stationarity < 1e-15 && c.penetration < 1e-15, "{c:?}");
    assert!(c.tension == 0.0 && c.complementarity < 1e-15, "{c:?}");
    let active = solution.multipliers.iter().filter(|l| **l > 0.0).count();
    assert_eq!((c.active, c.weakly_active), (active, 0));
    assert_eq!(c.max_multiplier, solution.multipliers.iter().copied().fold(0.0, f64::max));
}

/// The force on a soft unknown is not rounding beside a stiff one, and an error in it is not hidden by the stiff one's terms.
#[test]
fn a_soft_unknown_counts_beside_a_stiff_one() {
    let matrix = DMatrix::from_diagonal(&DVector::from_row_slice(&[1e16, 1.0, 1.0, 1.0]));
    let qp = problem(&matrix, &[1e16, 0.5, 0.0, 0.0], &[(1, 0.25)]);
    let mut solution = condensed(&qp);
    assert_eq!(solution.multipliers, [0.25]);
    assert!(certificate(&qp, &solution).componentwise < 1e-15);
    solution.multipliers[0] = 0.2;
    let c = certificate(&qp, &solution);
    assert!(c.stationarity < 1e-16 && (c.componentwise - 0.05 / 0.75).abs() < 1e-12, "{c:?}");
}

#[test]
fn a_perturbed_displacement_shows_in_stationarity() {
    let (qp, mut solution, ..) = solved();
    let free = 2 * 40;
    solution.x[free] += 1e-6;
    let c = certificate(&qp, &solution);
    // ‖K e_i‖_∞ 1e-6 over its scale
    let scale = qp.matrix.norm_inf() * crate::qp::largest(&solution.x) + crate::qp::largest(&qp.load);
    let expected = 1e-6 * qp.matrix.diagonal_block(40)[0] / scale;
    assert!((c.stationarity / expected - 1.0).abs() < 1e-6, "{c:?}");
    assert!(c.penetration < 1e-15 && c.tension == 0.0 && c.complementarity < 1e-15);
}

#[test]
fn penetration_shows_as_such() {
    let (qp, mut solution, active, _) = solved();
    solution.x[qp.bounds[active].dof as usize] += 1e-5;
    let c = certificate(&qp, &solution);
    assert!((c.penetration - 1e-5).abs() < 1e-15, "{c:?}");
    assert!(c.tension == 0.0);
}

#[test]
fn tension_shows_as_such() {
    let (qp, mut solution, active, _) = solved();
    let largest = crate::qp::largest(&solution.multipliers);
    solution.multipliers[active] = -0.01 * largest;
    let c = certificate(&qp, &solution);
    let scale = crate::qp::largest(&solution.multipliers);
    assert!((c.tension - 0.01 * largest / scale).abs() < 1e-15, "{c:?}");
    assert!(c.penetration < 1e-15 && c.complementarity < 1e-15);
}

#[test]
fn a_force_across_an_open_gap_shows_in_complementarity() {
    // the load changed so that everything but λ (g − x) = 0 holds
    let (mut qp, mut solution, _, open) = solved();
    let bound = qp.bounds[open];
    solution.multipliers[open] = 0.02;
    qp.load[bound.dof as usize] += 0.02;
    let c = certificate(&qp, &solution);
    let slack = bound.upper - solution.x[bound.dof as usize];
    assert!((c.complementarity - 0.02 * slack).abs() < 1e-14 && slack > 1e-3, "{c:?}");
    assert!(c.stationarity < 1e-14 && c.penetration < 1e-15 && c.tension == 0.0);
}

#[test]
fn a_tie_is_weakly_active() {
    let mut qp = Random(8).problem(20, 4);
    qp.bounds.iter_mut().for_each(|b| b.upper = 1e3);
    let free = condensed(&qp);
    assert_eq!(certificate(&qp, &free).weakly_active, 0);
    qp.bounds[2].upper = free.x[qp.bounds[2].dof as usize];
    let c = certificate(&qp, &condensed(&qp));
    assert_eq!((c.weakly_active, c.active), (1, 0));
}

#[test]
fn nothing_and_nan_are_told_apart() {
    let (mut qp, mut solution, ..) = solved();
    solution.x[30] = f64::NAN;
    assert!(certificate(&qp, &solution).stationarity.is_nan());
    assert!(algebraic_error(&qp, &solution.x, &solution.multipliers).is_nan());
    solution.x.fill(0.0);
    solution.multipliers.fill(0.0);
    qp.load.fill(0.0);
    let scales = CertificateScales { displacement: 0.0, energy: 0.0 };
    let c = certify(&qp, &solution.x, &solution.multipliers, &scales);
    assert_eq!([c.stationarity, c.penetration, c.tension, c.complementarity], [0.0; 4]);
}

#[test]
fn energy_and_residual_are_consistent() {
    let qp = Random(12).problem(16, 3);
    let (x, step) = (Random(13).vector(16), Random(14).vector(16));
    let moved = |t: f64| -> Vec<f64> { x.iter().zip(&step).map(|(x, s)| x + t * s).collect() };
    // a quadratic: central differences are exact
    let slope = (energy(&qp, &moved(1.0)) - energy(&qp, &moved(-1.0))) / 2.0;
    let work: f64 = residual(&qp, &x).iter().zip(&step).map(|(r, s)| r * s).sum();
    assert!((slope + work).abs() < 1e-13);
}

/// `√(eᵀKe)` of `x` against enumeration.
fn true_error(qp: &BoundQp, x: &[f64]) -> f64 {
    let e: Vec<f64> = x.iter().zip(enumerate(qp)).map(|(a, b)| a - b).collect();
    let no_load = BoundQp { load: vec![0.0; e.len()], ..qp.clone() };
    (2.0 * energy(&no_load, &e)).sqrt()
}

#[test]
fn the_algebraic_error_is_of_the_size_of_the_true_one() {
    let mut random = Random(31);
    for m in [0, 3, 6] {
        let qp = random.problem(24, m);
        let solution = condensed(&qp);
        for size in [1e-1, 1e-4, 1e-8] {
            // any wrong x, with the multipliers that the residual suggests
            let noise = random.vector(24);
            let x: Vec<f64> = solution.x.iter().zip(&noise).map(|(x, d)| x + size * d).collect();
            let (error, estimate) = (true_error(&qp, &x), algebraic_error(&qp, &x, &solution.multipliers));
            assert!(estimate > 0.99 * error, "m = {m}: {estimate} for {error}");
            assert!(estimate < 10.0 * error, "m = {m}: {estimate} for {error}");
        }
    }
}

#[test]
fn a_wrong_multiplier_has_an_algebraic_error() {
    let (qp, mut solution, active, _) = solved();
    let clean = algebraic_error(&qp, &solution.x, &solution.multipliers);
    solution.multipliers[active] *= -1.0;
    let wrong = algebraic_error(&qp, &solution.x, &solution.multipliers);
    assert!(clean < 1e-13 && wrong > 1e-3, "{clean} {wrong}");
}
