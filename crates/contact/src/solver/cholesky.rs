//! Sparse Cholesky factorisation `P (K + Σ) Pᵀ = L Lᵀ` with chosen unknowns eliminated last.
//!
//! The trailing block of `L` is the Cholesky factor of the Schur complement on those unknowns: with `i` the others and
//! `c` the trailing ones, `L_cc L_ccᵀ = K_cc + Σ − K_ci K_ii⁻¹ K_ic`.

use super::compress::{Numbering, UpperTriangle};
use super::ordering::elimination_order;
use crate::sparse::BlockMatrix;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, Mat, MatMut, Par, Side, Spec};

/// A pivot below this multiple of its diagonal entry counts as zero.
const PIVOT_TOLERANCE: f64 = 1e-12;

/// The matrix has a pivot that is negative, or zero to rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the matrix is not positive definite")]
pub struct NotPositiveDefinite;

/// The factor. About 1.7 kB per unknown on a fine plane mesh.
#[derive(Debug)]
pub struct Cholesky {
    numbering: Numbering,
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    trailing: usize,
}

impl Cholesky {
    /// Factors the rows and columns of `matrix` that are not `removed`, plus `shift[k]` on the diagonal of
    /// `trailing[k]`; the trailing unknowns come last, in the given order, and are not removed.
    ///
    /// # Errors
    /// [`NotPositiveDefinite`] if a pivot is not positive beyond rounding.
    pub fn new(
        matrix: &BlockMatrix,
        removed: &[bool],
        trailing: &[u32],
        shift: &[f64],
    ) -> Result<Self, NotPositiveDefinite> {
        assert_eq!(removed.len(), matrix.dimension());
        assert_eq!(shift.len(), trailing.len());
        let numbering = Numbering::new(removed);
        let mut triangle = UpperTriangle::new(matrix, &numbering);
        for (&full, &sigma) in trailing.iter().zip(shift) {
            // The diagonal is the last entry of its column.
            let column = numbering.reduced[full as usize] as usize;
            triangle.values[triangle.column_start[column + 1] - 1] += sigma;
        }
        let order = elimination_order(matrix, &numbering, trailing);
        let symbolic = analyse(&triangle, &order);
        let values = factorise(&triangle, &symbolic)?;
        let factor = Self { numbering, symbolic, values, trailing: trailing.len() };
        factor.check_order(&order);
        factor.check_pivots(&triangle, &order)?;
        Ok(factor)
    }

    /// Number of unknowns that were not removed.
    pub fn dimension(&self) -> usize {
        self.numbering.kept.len()
    }

    /// Solves `(K + Σ) x = rhs` on the kept unknowns. Takes and leaves a vector over all unknowns; the removed entries
    /// of the right-hand side are not read and become zero.
    pub fn solve(&self, rhs: &mut [f64]) {
        let mut x = self.numbering.gather(rhs);
        let n = x.len();
        if n > 0 {
            let factor = LltRef::<usize, f64>::new(&self.symbolic, &self.values);
            let scratch = self.symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
            factor.solve_in_place_with_conj(
                Conj::No,
                MatMut::from_column_major_slice_mut(&mut x, n, 1),
                Par::Seq,
                MemStack::new(&mut MemBuffer::new(scratch)),
            );
        }
        self.numbering.scatter(&x, rhs);
    }

    /// The lower triangular `L_cc` on the trailing unknowns, in their order; zero above the diagonal.
    pub fn trailing_block(&self) -> Mat<f64> {
        let first = self.dimension() - self.trailing;
        let mut block = Mat::zeros(self.trailing, self.trailing);
        self.for_each_entry(first, |row, column, value| {
            block[(row - first, column - first)] = value;
        });
        block
    }

    /// Calls `visit(row, column, value)` for the stored entries of `L` in the columns `first..`.
    fn for_each_entry(&self, first: usize, mut visit: impl FnMut(usize, usize, f64)) {
        let Some(factor) = self.supernodes() else {
            return;
        };
        for s in (0..factor.symbolic().n_supernodes()).rev() {
            let supernode = factor.supernode(s);
            let (start, values) = (supernode.start(), supernode.val());
            let width = values.ncols();
            if start + width <= first {
                break;
            }
            for j in first.saturating_sub(start)..width {
                (j..width).for_each(|i| visit(start + i, start + j, values[(i, j)]));
                for (k, &row) in supernode.pattern().iter().enumerate() {
                    visit(row, start + j, values[(width + k, j)]);
                }
            }
        }
    }

    /// The numeric factor, unless there is nothing to factor.
    fn supernodes(&self) -> Option<SupernodalLltRef<'_, usize, f64>> {
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Supernodal(symbolic) => Some(SupernodalLltRef::new(symbolic, &self.values)),
            SymbolicCholeskyRaw::Simplicial(_) => {
                assert_eq!(self.dimension(), 0, "a supernodal factor was asked for");
                None
            }
        }
    }

    /// The Schur complement can be read off only if the elimination kept to our order.
    fn check_order(&self, order: &[usize]) {
        let kept_order = self.symbolic.perm().map(|p| p.arrays().0.to_vec());
        assert_eq!(kept_order.as_deref(), Some(order), "elimination order");
    }

    /// A singular matrix often passes with pivots of rounding size: compare `L_jj²` with the diagonal of `K + Σ`.
    fn check_pivots(&self, triangle: &UpperTriangle, order: &[usize]) -> Result<(), NotPositiveDefinite> {
        let diagonal = |unknown: usize| triangle.values[triangle.column_start[unknown + 1] - 1];
        let mut singular = false;
        self.for_each_entry(0, |row, column, value| {
            let too_small = || value * value <= PIVOT_TOLERANCE * diagonal(order[row]);
            singular |= row == column && too_small();
        });
        if singular {
            return Err(NotPositiveDefinite);
        }
        Ok(())
    }
}

/// The symbolic factor for the given elimination order.
fn analyse(triangle: &UpperTriangle, order: &[usize]) -> SymbolicCholesky<usize> {
    let n = order.len();
    let mut inverse = vec![0; n];
    for (step, &unknown) in order.iter().enumerate() {
        inverse[unknown] = step;
    }
    let parameters = CholeskySymbolicParams {
        supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
        ..Default::default()
    };
    factorize_symbolic_cholesky(
        pattern(triangle),
        Side::Upper,
        SymmetricOrdering::Custom(PermRef::new_checked(order, &inverse, n)),
        parameters,
    )
    .expect("the symbolic factor fits in memory")
}

/// The entries of `L`, as the symbolic factor lays them out.
fn factorise(triangle: &UpperTriangle, symbolic: &SymbolicCholesky<usize>) -> Result<Vec<f64>, NotPositiveDefinite> {
    let mut values = vec![0.0; symbolic.len_val()];
    let scratch = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default());
    symbolic
        .factorize_numeric_llt(
            &mut values,
            SparseColMatRef::new(pattern(triangle), &triangle.values),
            Side::Upper,
            Default::default(),
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
            Spec::default(),
        )
        .map_err(|_| NotPositiveDefinite)?;
    Ok(values)
}

/// The pattern in faer's terms.
fn pattern(triangle: &UpperTriangle) -> SymbolicSparseColMatRef<'_, usize> {
    let n = triangle.column_start.len() - 1;
    SymbolicSparseColMatRef::new_checked(n, n, &triangle.column_start, None, &triangle.rows)
}
