//! Small problems, and their solution by enumeration.

use crate::qp::{Bound, BoundQp};
use crate::sparse::BlockMatrix;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// A linear congruential generator.
pub struct Random(pub u64);

impl Random {
    /// The next number in `[−1, 1)`.
    pub fn next(&mut self) -> f64 {
        let (a, c) = (6_364_136_223_846_793_005, 1_442_695_040_888_963_407);
        self.0 = self.0.wrapping_mul(a).wrapping_add(c);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.next()).collect()
    }

    /// A sparse symmetric positive definite matrix: a chain of springs, some long springs, a weak ground.
    pub fn matrix(&mut self, n: usize) -> DMatrix<f64> {
        let mut k = DMatrix::from_diagonal_element(n, n, 0.05);
        let mut spring = |i: usize, j: usize, stiffness: f64, sign: f64| {
            k[(i, i)] += stiffness;
            k[(j, j)] += stiffness;
            k[(i, j)] -= sign * stiffness;
            k[(j, i)] -= sign * stiffness;
        };
        for i in 1..n {
            spring(i - 1, i, 1.5 + self.next(), 1.0);
        }
        for i in 0..n {
            let j = (i + 2 + (4.0 * (1.0 + self.next())) as usize) % n;
            if i != j {
                spring(i, j, 1.0 + self.next(), self.next().signum());
            }
        }
        k
    }

    /// A problem with `n` unknowns (even) and bounds on the first `m` odd components.
    pub fn problem(&mut self, n: usize, m: usize) -> BoundQp {
        let bounds = (0..m).map(|k| (2 * k + 1, 0.3 * self.next()));
        let bounds = bounds.collect::<Vec<_>>();
        let matrix = self.matrix(n);
        problem(&matrix, &self.vector(n), &bounds)
    }
}

/// The problem with a dense matrix; an odd one gets a last row of the identity.
pub fn problem(matrix: &DMatrix<f64>, load: &[f64], bounds: &[(usize, f64)]) -> BoundQp {
    let mut load = load.to_vec();
    load.resize(load.len().next_multiple_of(2), 0.0);
    let bound = |&(dof, upper): &(usize, f64)| Bound { dof: dof as u32, upper };
    BoundQp { matrix: block_matrix(matrix), load, bounds: bounds.iter().map(bound).collect(), ..Default::default() }
}

fn block_matrix(matrix: &DMatrix<f64>) -> BlockMatrix {
    let n = matrix.nrows();
    let entry = |i: usize, j: usize| match i.max(j) < n {
        true => matrix[(i, j)],
        false => f64::from(u8::from(i == j)),
    };
    let mut entries = BTreeMap::new();
    for i in 0..n.div_ceil(2) {
        for j in 0..n.div_ceil(2) {
            let block = [0, 1, 2, 3].map(|k| entry(2 * i + k / 2, 2 * j + k % 2));
            if i == j || block != [0.0; 4] {
                entries.insert((i, j), block);
            }
        }
    }
    from_blocks(n.div_ceil(2), &entries)
}

/// The block matrix of these blocks.
pub fn from_blocks(rows: usize, blocks: &BTreeMap<(usize, usize), [f64; 4]>) -> BlockMatrix {
    let mut row_start = vec![0; rows + 1];
    for (i, _) in blocks.keys() {
        row_start[i + 1] += 1;
    }
    for i in 0..rows {
        row_start[i + 1] += row_start[i];
    }
    let columns = blocks.keys().map(|(_, j)| *j as u32).collect();
    BlockMatrix::new(row_start, columns, blocks.values().copied().collect())
}

/// The dense matrix of a problem.
pub fn dense(qp: &BoundQp) -> DMatrix<f64> {
    let n = qp.matrix.dimension();
    let mut matrix = DMatrix::zeros(n, n);
    for i in 0..qp.matrix.rows() {
        for (j, block) in qp.matrix.row(i) {
            for k in 0..4 {
                matrix[(2 * i + k / 2, 2 * j + k % 2)] = block[k];
            }
        }
    }
    matrix
}

/// The solution by trial of all `2^m` active sets.
pub fn enumerate(qp: &BoundQp) -> Vec<f64> {
    let m = qp.bounds.len();
    let candidates = (0..1_usize << m).filter_map(|set| face_solution(qp, set));
    candidates.into_iter().next().expect("a solution exists")
}

/// The solution on one face, if it is optimal.
fn face_solution(qp: &BoundQp, set: usize) -> Option<Vec<f64>> {
    let mut matrix = dense(qp);
    let full = matrix.clone();
    let mut rhs = DVector::from_column_slice(&qp.load);
    for (k, bound) in qp.bounds.iter().enumerate().filter(|(k, _)| set >> k & 1 == 1) {
        let i = bound.dof as usize;
        matrix.row_mut(i).fill(0.0);
        matrix[(i, i)] = 1.0;
        rhs[i] = qp.bounds[k].upper;
    }
    let x = matrix.full_piv_lu().solve(&rhs)?;
    let reaction = DVector::from_column_slice(&qp.load) - full * &x;
    // elimination of a singular matrix may end with noise: look at the equations that it should have solved
    let fixed = |i: usize| (0..qp.bounds.len()).any(|k| set >> k & 1 == 1 && qp.bounds[k].dof as usize == i);
    if (0..x.len()).any(|i| !fixed(i) && reaction[i].abs() > 1e-8) {
        return None;
    }
    let optimal = qp.bounds.iter().enumerate().all(|(k, bound)| {
        let i = bound.dof as usize;
        match set >> k & 1 {
            1 => reaction[i] >= -1e-11,
            _ => x[i] <= bound.upper + 1e-11,
        }
    });
    optimal.then(|| x.as_slice().to_vec())
}

/// `max|a − b|`.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let difference: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    crate::qp::largest(&difference)
}
