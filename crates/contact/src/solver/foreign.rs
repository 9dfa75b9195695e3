//! Answers found elsewhere: an `x` and nothing else becomes an answer like any other, to be certified like any other.

use super::kernel::impose_conditions;
use super::{QpSolution, Status};
use crate::qp::{BoundQp, residual};

/// The answer `x` of another program, with the contact forces that it implies.
///
/// A bound presses with `λ_c = r_c`, `r = f − Kx`, where `r_c > K_cc (g_c − x_c)` and `r_c > 0`: as the next step of a primal–dual active
/// set would have it. Elsewhere `λ_c = 0`, and what is left of the row is for the certificate to see. Where a body may slide both ways, the
/// conditions `p(x) = 0` pick the solution as they do for every method. Entries that are not finite leave the answer unsolved.
///
/// # Panics
/// If `x` does not have one entry per unknown.
pub fn adopt(qp: &BoundQp, x: Vec<f64>) -> QpSolution {
    assert_eq!(x.len(), qp.matrix.dimension(), "one entry per unknown");
    let mut answer = QpSolution { x, ..QpSolution::unsolved(qp, Status::IterationLimit { steps: 0 }) };
    if answer.x.iter().any(|v| !v.is_finite()) || impose_conditions(qp, &mut answer.x).is_none() {
        return answer;
    }
    let reaction = residual(qp, &answer.x);
    for (force, bound) in answer.multipliers.iter_mut().zip(&qp.bounds) {
        let c = bound.dof as usize;
        let stiffness = qp.matrix.diagonal_block(c / 2)[3 * (c % 2)];
        if reaction[c] > 0.0 && reaction[c] > stiffness * (bound.upper - answer.x[c]) {
            *force = reaction[c];
        }
    }
    answer.status = Status::Adopted;
    answer
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::qp::{Bound, CertificateScales, certify};
    use crate::solver::tests::examples::Random;
    use crate::solver::{Settings, solve};
    use crate::sparse::BlockMatrix;

    const SCALES: CertificateScales = CertificateScales { displacement: 1.0, energy: 1.0 };

    #[test]
    fn a_solution_keeps_its_forces_and_its_certificate() {
        let qp = Random(3).problem(12, 5);
        let own = solve(&qp, &Settings::default());
        let adopted = adopt(&qp, own.x.clone());
        assert!(adopted.status.is_solved());
        assert_eq!((adopted.x, adopted.multipliers.len()), (own.x.clone(), own.multipliers.len()));
        for (a, b) in adopted.multipliers.iter().zip(&own.multipliers) {
            assert!((a - b).abs() < 1e-14, "{a} {b}");
        }
    }

    #[test]
    fn a_force_on_an_open_bound_is_left_to_the_certificate() {
        // x_0 = 1 at equilibrium, 0.1 below it a rest of 0.1 that does not reach over the gap of 1
        let blocks = vec![[1.0, 0.0, 0.0, 1.0]];
        let matrix = BlockMatrix::new(vec![0, 1], vec![0], blocks);
        let qp = |upper| BoundQp {
            matrix: matrix.clone(),
            load: vec![1.0, 0.0],
            bounds: vec![Bound { dof: 0, upper }],
            ..Default::default()
        };
        let open = adopt(&qp(1.9), vec![0.9, 0.0]);
        assert_eq!(open.multipliers, [0.0]);
        let certificate = certify(&qp(1.9), &open.x, &open.multipliers, &SCALES);
        assert!((certificate.stationarity - 0.1 / 1.9).abs() < 1e-15, "{certificate:?}");
        // on its bound the same rest is a force, and nothing is amiss
        let closed = adopt(&qp(0.9), vec![0.9, 0.0]);
        assert!((closed.multipliers[0] - 0.1).abs() < 1e-15);
        assert!(certify(&qp(0.9), &closed.x, &closed.multipliers, &SCALES).stationarity < 1e-15);
    }

    #[test]
    fn a_wrong_answer_shows_in_its_certificate() {
        let qp = Random(3).problem(12, 5);
        let mut x = solve(&qp, &Settings::default()).x;
        x.iter_mut().for_each(|x| *x += 0.01);
        let adopted = adopt(&qp, x);
        let certificate = certify(&qp, &adopted.x, &adopted.multipliers, &SCALES);
        assert!(certificate.stationarity > 1e-4 || certificate.penetration > 1e-4, "{certificate:?}");
        assert!(!adopt(&qp, vec![f64::NAN; qp.matrix.dimension()]).status.is_solved());
    }
}
