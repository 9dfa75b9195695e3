//! Symmetric sparse matrices of 2×2 blocks: one block row per node, rows that repeat stored once.

use rayon::prelude::*;

/// A square sparse matrix of 2×2 blocks in compressed rows with `u32` columns.
///
/// Columns of a row ascend. A block is stored by rows, `[xx, xy, yx, yy]`. The scalar unknowns of block `i` are `2i` and
/// `2i + 1`. Both triangles are stored. Rows may share their blocks: on a mesh whose triangles repeat a few shapes nearly all
/// do, and a row then costs its columns alone, 36 bytes in place of 260.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BlockMatrix {
    /// Block row `i` has the columns `columns[row_start[i]..row_start[i + 1]]`.
    row_start: Vec<u32>,
    columns: Vec<u32>,
    /// Where the blocks of each row start; empty where no row shares them, and they start like the columns.
    block_start: Vec<u32>,
    blocks: Vec<[f64; 4]>,
}

impl BlockMatrix {
    /// A matrix whose rows share nothing.
    ///
    /// # Panics
    /// If the lengths contradict one another.
    pub fn new(row_start: Vec<u32>, columns: Vec<u32>, blocks: Vec<[f64; 4]>) -> Self {
        assert_eq!(columns.len(), blocks.len(), "one column for each block");
        assert_eq!(row_start.last().map_or(0, |&end| end as usize), columns.len(), "rows end with the columns");
        Self { row_start, columns, block_start: Vec::new(), blocks }
    }

    /// A matrix whose row `i` has the blocks from `block_start[i]` on, as many as columns.
    ///
    /// # Panics
    /// If the lengths contradict one another.
    pub fn with_shared_rows(
        row_start: Vec<u32>,
        columns: Vec<u32>,
        block_start: Vec<u32>,
        blocks: Vec<[f64; 4]>,
    ) -> Self {
        assert_eq!(block_start.len() + 1, row_start.len(), "a start for each row");
        assert_eq!(row_start.last().map_or(0, |&end| end as usize), columns.len(), "rows end with the columns");
        let matrix = Self { row_start, columns, block_start, blocks };
        let fits = |i: usize| matrix.block_start[i] as usize + matrix.columns_of(i).len() <= matrix.blocks.len();
        assert!((0..matrix.rows()).into_par_iter().with_min_len(4096).all(fits), "blocks for each row");
        matrix
    }

    /// Number of block rows.
    pub fn rows(&self) -> usize {
        self.row_start.len().saturating_sub(1)
    }

    /// Number of scalar unknowns, `2 · rows`.
    pub fn dimension(&self) -> usize {
        2 * self.rows()
    }

    /// Number of blocks, shared ones counted for each row: what a product visits.
    pub fn entries(&self) -> usize {
        self.columns.len()
    }

    /// Bytes that the matrix occupies.
    pub fn bytes(&self) -> usize {
        4 * (self.row_start.len() + self.columns.len() + self.block_start.len()) + 32 * self.blocks.len()
    }

    /// The columns of block row `i`, ascending.
    #[inline]
    pub fn columns_of(&self, i: usize) -> &[u32] {
        &self.columns[self.row_start[i] as usize..self.row_start[i + 1] as usize]
    }

    /// The columns and blocks of block row `i`.
    #[inline]
    pub fn parts(&self, i: usize) -> (&[u32], &[[f64; 4]]) {
        let (start, end) = (self.row_start[i] as usize, self.row_start[i + 1] as usize);
        let first = if self.block_start.is_empty() { start } else { self.block_start[i] as usize };
        (&self.columns[start..end], &self.blocks[first..first + (end - start)])
    }

    /// The columns and blocks of block row `i`.
    pub fn row(&self, i: usize) -> impl Iterator<Item = (usize, &[f64; 4])> + '_ {
        let (columns, blocks) = self.parts(i);
        columns.iter().map(|&j| j as usize).zip(blocks)
    }

    /// The diagonal block of row `i` (zero if it is not stored).
    pub fn diagonal_block(&self, i: usize) -> [f64; 4] {
        self.row(i).find(|&(j, _)| j == i).map_or([0.0; 4], |(_, b)| *b)
    }

    /// All stored blocks.
    #[cfg(test)]
    pub(crate) fn blocks_mut(&mut self) -> &mut [[f64; 4]] {
        &mut self.blocks
    }

    /// Block `k` of row `i`, to be changed, with every row that shares it.
    pub(crate) fn block_mut(&mut self, i: usize, k: usize) -> &mut [f64; 4] {
        let first = if self.block_start.is_empty() { self.row_start[i] } else { self.block_start[i] };
        &mut self.blocks[first as usize + k]
    }

    /// `y = K x`, both of length [`dimension`](Self::dimension). About 36 bytes read per block, 4 where rows are shared.
    pub fn apply(&self, x: &[f64], y: &mut [f64]) {
        let x = x.as_chunks::<2>().0;
        y.as_chunks_mut::<2>().0.par_iter_mut().with_min_len(1024).enumerate().for_each(|(i, y)| {
            *y = self.times_row(i, |j| x[j]);
        });
    }

    /// Row `i` of `K x`, with `x(j)` the two unknowns of block `j`.
    #[inline]
    pub fn times_row(&self, i: usize, x: impl Fn(usize) -> [f64; 2]) -> [f64; 2] {
        let (columns, blocks) = self.parts(i);
        let mut sum = [0.0; 2];
        for (&j, b) in columns.iter().zip(blocks) {
            let [u, v] = x(j as usize);
            sum[0] += b[0] * u + b[1] * v;
            sum[1] += b[2] * u + b[3] * v;
        }
        sum
    }

    /// `‖K‖_∞`, the largest row sum of absolute values.
    pub fn norm_inf(&self) -> f64 {
        let row_sum = |i: usize| {
            let s = self
                .row(i)
                .fold([0.0, 0.0], |s, (_, b)| [s[0] + b[0].abs() + b[1].abs(), s[1] + b[2].abs() + b[3].abs()]);
            f64::max(s[0], s[1])
        };
        (0..self.rows()).into_par_iter().with_min_len(4096).map(row_sum).reduce(|| 0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shared_row_is_the_row() {
        let blocks = [[2.0, 0.5, 0.5, 3.0], [-1.0, 0.0, 0.25, -1.0], [-1.0, 0.25, 0.0, -1.0]];
        // a ring of three slots with equal rows would need equal orders of columns; slots 0 and 1 repeat, 2 does not
        let plain = BlockMatrix::new(
            vec![0, 2, 4, 6],
            vec![0, 1, 1, 2, 0, 2],
            vec![blocks[0], blocks[1], blocks[0], blocks[1], blocks[2], blocks[0]],
        );
        let shared = BlockMatrix::with_shared_rows(
            vec![0, 2, 4, 6],
            vec![0, 1, 1, 2, 0, 2],
            vec![0, 0, 2],
            vec![blocks[0], blocks[1], blocks[2], blocks[0]],
        );
        for i in 0..3 {
            assert!(plain.row(i).eq(shared.row(i)), "row {i}");
            assert_eq!(plain.diagonal_block(i), shared.diagonal_block(i));
        }
        let x = [1.0, -2.0, 0.5, 3.0, -1.5, 0.25];
        let (mut a, mut b) = ([0.0; 6], [0.0; 6]);
        plain.apply(&x, &mut a);
        shared.apply(&x, &mut b);
        assert_eq!(a, b);
        assert_eq!((plain.norm_inf(), plain.entries()), (shared.norm_inf(), shared.entries()));
        assert!(shared.bytes() < plain.bytes());
    }
}
