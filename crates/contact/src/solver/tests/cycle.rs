//! When the primal–dual active set runs in a circle.

use super::agreement::{assert_optimal, condensed, interior};
use super::examples::{Random, distance, enumerate, problem};
use crate::solver::Status;
use nalgebra::DMatrix;

#[test]
fn search() {
    let mut random = Random(1);
    let mut found = 0;
    for _ in 0..2000000 {
        let m = DMatrix::from_fn(3, 3, |_, _| (3.5 * random.next()).trunc());
        let s = &m * m.transpose();
        if s.determinant() < 0.5 {
            continue;
        }
        let b: Vec<f64> = (0..3).map(|_| (5.5 * random.next()).trunc()).collect();
        let qp = problem(&s, &b, &[(0, 0.0), (1, 0.0), (2, 0.0)]);
        let r = condensed(&qp);
        if let Status::Rescued { cycle, .. } = r.status {
            println!("{s} {b:?} {cycle} {:?}", r);
            found += 1;
            if found > 5 {
                break;
            }
        }
        let _ = (assert_optimal, interior, distance, enumerate);
    }
}
