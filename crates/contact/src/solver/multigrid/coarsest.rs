//! The linear problem on the coarsest level, solved directly.

use super::super::cholesky::Cholesky;
use super::super::kernel::anchors;
use crate::qp::Bound;
use crate::sparse::BlockMatrix;

/// The factor for one set of frozen components.
#[derive(Default)]
pub struct Coarsest {
    /// Whether there is one.
    factored: bool,
    /// Nothing where the matrix is not positive definite on the free components: then there is no correction.
    factor: Option<Cholesky>,
    factorizations: usize,
}

impl Coarsest {
    /// `x = K⁻¹ f` with the frozen components, and one component for each free motion, held at zero; the first of several sets of
    /// motions counts that leaves a positive definite matrix.
    pub fn solve(
        &mut self,
        matrix: &BlockMatrix,
        bounds: &[Bound],
        frozen: &[bool],
        free: [&[Vec<f64>]; 2],
        x: &mut [f64],
    ) {
        if !self.factored {
            self.factor(matrix, bounds, frozen, free);
        }
        match &self.factor {
            Some(factor) => factor.solve(x),
            None => x.fill(0.0),
        }
    }

    /// The matrix or the frozen components are about to change.
    pub fn forget(&mut self) {
        self.factored = false;
    }

    /// How often a factor was computed.
    pub fn factorizations(&self) -> usize {
        self.factorizations
    }

    fn factor(&mut self, matrix: &BlockMatrix, bounds: &[Bound], frozen: &[bool], free: [&[Vec<f64>]; 2]) {
        self.factored = true;
        self.factorizations += 1;
        let mut removed = vec![false; matrix.dimension()];
        frozen_dofs(bounds, frozen).into_iter().for_each(|i| removed[i] = true);
        let holding = |free: &[Vec<f64>]| {
            let mut removed = removed.clone();
            anchors(free).into_iter().flatten().for_each(|i| removed[i] = true);
            Cholesky::new(matrix, &removed, &[], &[]).ok()
        };
        self.factor = free.into_iter().find_map(holding);
    }
}

/// The components of the frozen bounds.
pub fn frozen_dofs(bounds: &[Bound], frozen: &[bool]) -> Vec<usize> {
    bounds.iter().zip(frozen).filter(|(_, f)| **f).map(|(b, _)| b.dof as usize).collect()
}
