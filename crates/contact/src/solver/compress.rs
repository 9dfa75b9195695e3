//! A block matrix, with some unknowns left out, as compressed columns.

use crate::sparse::BlockMatrix;

/// Marks an unknown that is left out in [`Numbering::reduced`].
pub const REMOVED: u32 = u32::MAX;

/// Numbering of the unknowns that stay.
#[derive(Clone, Debug)]
pub struct Numbering {
    /// The full number of each kept unknown, ascending.
    pub kept: Vec<u32>,
    /// The reduced number of each unknown, or [`REMOVED`].
    pub reduced: Vec<u32>,
}

impl Numbering {
    /// Numbers the unknowns `i` with `!removed[i]`.
    pub fn new(removed: &[bool]) -> Self {
        let mut reduced = vec![REMOVED; removed.len()];
        let mut kept = Vec::with_capacity(removed.len());
        for (i, _) in removed.iter().enumerate().filter(|(_, r)| !**r) {
            reduced[i] = kept.len() as u32;
            kept.push(i as u32);
        }
        Self { kept, reduced }
    }

    /// The kept entries of a full vector.
    pub fn gather(&self, full: &[f64]) -> Vec<f64> {
        self.kept.iter().map(|&i| full[i as usize]).collect()
    }

    /// Writes a reduced vector back into a full one; the removed entries become zero.
    pub fn scatter(&self, reduced: &[f64], full: &mut [f64]) {
        full.fill(0.0);
        for (&i, &value) in self.kept.iter().zip(reduced) {
            full[i as usize] = value;
        }
    }
}

/// The upper triangle of a symmetric matrix in compressed columns, rows ascending.
#[derive(Clone, Debug)]
pub struct UpperTriangle {
    /// Length `n + 1`.
    pub column_start: Vec<usize>,
    /// Row of each stored entry, at most its column.
    pub rows: Vec<usize>,
    /// The entries.
    pub values: Vec<f64>,
}

impl UpperTriangle {
    /// The kept rows and columns of `matrix`. Stored zeros stay in the pattern.
    pub fn new(matrix: &BlockMatrix, numbering: &Numbering) -> Self {
        let room = numbering.kept.len() + 2 * matrix.entries();
        let mut triangle = Self {
            column_start: Vec::with_capacity(numbering.kept.len() + 1),
            rows: Vec::with_capacity(room),
            values: Vec::with_capacity(room),
        };
        triangle.column_start.push(0);
        for &full in &numbering.kept {
            triangle.push_column(matrix, numbering, full as usize);
        }
        triangle
    }

    /// Column `full` of the upper triangle is the left part of row `full`, by symmetry.
    fn push_column(&mut self, matrix: &BlockMatrix, numbering: &Numbering, full: usize) {
        let (node, part) = (full / 2, full % 2);
        for (j, block) in matrix.row(node) {
            for b in 0..2 {
                let column = 2 * j + b;
                let row = numbering.reduced[column];
                if column <= full && row != REMOVED {
                    self.rows.push(row as usize);
                    self.values.push(block[2 * part + b]);
                }
            }
        }
        self.column_start.push(self.rows.len());
    }
}
