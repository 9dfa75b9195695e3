//! Symmetric sparse matrices of 2×2 blocks: one block row per node.

/// A square sparse matrix of 2×2 blocks in compressed rows with `u32` columns.
///
/// Block row `i` owns the entries `row_start[i]..row_start[i+1]`; its columns ascend. A block is stored by rows,
/// `[xx, xy, yx, yy]`. The scalar unknowns of block `i` are `2i` and `2i+1`. Both triangles are stored.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockMatrix {
    /// Length `rows + 1`.
    pub row_start: Vec<usize>,
    /// Block column of each stored block.
    pub columns: Vec<u32>,
    /// The blocks.
    pub blocks: Vec<[f64; 4]>,
}

impl BlockMatrix {
    /// Number of block rows.
    pub fn rows(&self) -> usize {
        self.row_start.len().saturating_sub(1)
    }

    /// Number of scalar unknowns, `2 · rows`.
    pub fn dimension(&self) -> usize {
        2 * self.rows()
    }

    /// The columns and blocks of block row `i`.
    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, &[f64; 4])> + '_ {
        let range = self.row_start[i]..self.row_start[i + 1];
        self.columns[range.clone()].iter().map(|&j| j as usize).zip(&self.blocks[range])
    }

    /// The diagonal block of row `i` (zero if it is not stored).
    pub fn diagonal_block(&self, i: usize) -> [f64; 4] {
        self.row(i).find(|&(j, _)| j == i).map_or([0.0; 4], |(_, b)| *b)
    }

    /// `y = K x`, both of length [`dimension`](Self::dimension). About 40 bytes read per block.
    pub fn apply(&self, x: &[f64], y: &mut [f64]) {
        use rayon::prelude::*;
        y.par_chunks_mut(2).with_min_len(1024).enumerate().for_each(|(i, y)| {
            let mut sum = [0.0; 2];
            for (j, b) in self.row(i) {
                let (x0, x1) = (x[2 * j], x[2 * j + 1]);
                sum[0] += b[0] * x0 + b[1] * x1;
                sum[1] += b[2] * x0 + b[3] * x1;
            }
            y.copy_from_slice(&sum);
        });
    }

    /// `‖K‖_∞`, the largest row sum of absolute values.
    pub fn norm_inf(&self) -> f64 {
        let row_sum = |i: usize| {
            let s = self
                .row(i)
                .fold([0.0, 0.0], |s, (_, b)| [s[0] + b[0].abs() + b[1].abs(), s[1] + b[2].abs() + b[3].abs()]);
            f64::max(s[0], s[1])
        };
        (0..self.rows()).map(row_sum).fold(0.0, f64::max)
    }
}
