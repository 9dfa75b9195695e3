//! Rigid motions that a set of frozen components leaves free.
//!
//! A body that has lifted off, or turns about a single closed pair, is held by nothing: the linear problem on that face has no
//! minimum. The motions span six dimensions at most, so they are found and followed by themselves.

use nalgebra::DMatrix;
use std::collections::BTreeMap;

/// Singular values below this share of the largest belong to a free motion.
const FREE: f64 = 1e-9;
/// Steps of the singular value decomposition, at most.
const STEPS: usize = 1000;

/// `Σ w_i x_i`, by component.
pub type Row = BTreeMap<u32, f64>;

/// A basis of the combinations of `motions` on which every row vanishes.
pub fn free(motions: &[Vec<f64>], rows: &[Row]) -> Vec<Vec<f64>> {
    let count = motions.len();
    if count == 0 {
        return Vec::new();
    }
    // square at least, so that the decomposition spans every combination
    let value = |row: &Row, j: usize| row.iter().map(|(i, w)| w * motions[j][*i as usize]).sum();
    let matrix = DMatrix::from_fn(rows.len().max(count), count, |i, j| rows.get(i).map_or(0.0, |row| value(row, j)));
    let Some(svd) = matrix.try_svd(false, true, f64::EPSILON, STEPS) else { return Vec::new() };
    let Some(directions) = svd.v_t else { return Vec::new() };
    let size = motions.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    let is_free = |k: &usize| svd.singular_values[*k] <= FREE * size;
    (0..count).filter(is_free).map(|k| combine(motions, |j| directions[(k, j)])).collect()
}

/// `Σ c_j y_j`.
fn combine(motions: &[Vec<f64>], coefficient: impl Fn(usize) -> f64) -> Vec<f64> {
    let mut sum = vec![0.0; motions[0].len()];
    for (j, motion) in motions.iter().enumerate() {
        let c = coefficient(j);
        sum.iter_mut().zip(motion).for_each(|(s, y)| *s += c * y);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bar with three vertical components at 0, 1, 2: it may rise and turn.
    fn bar() -> Vec<Vec<f64>> {
        vec![vec![1.0, 1.0, 1.0], vec![0.0, 1.0, 2.0]]
    }

    #[test]
    fn each_row_takes_one_motion() {
        let row = |entries: &[(u32, f64)]| entries.iter().copied().collect::<Row>();
        assert_eq!(free(&bar(), &[]).len(), 2);
        let turn = free(&bar(), &[row(&[(0, 0.5), (2, 0.5)])]);
        assert_eq!(turn.len(), 1);
        assert!(turn[0][1].abs() < 1e-15 && (turn[0][0] + turn[0][2]).abs() < 1e-15 && turn[0][0].abs() > 0.1);
        assert!(free(&bar(), &[row(&[(0, 1.0)]), row(&[(2, 1.0)])]).is_empty());
        assert!(free(&[], &[row(&[(0, 1.0)])]).is_empty());
    }
}
