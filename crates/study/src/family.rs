//! Families of triangulations: level → hierarchy and certificate.

/// Which family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Family {
    /// Right triangles, diagonal from lower left to upper right.
    Structured,
    /// Each cell cut by both diagonals.
    CrissCross,
    /// Diagonals alternate like a chessboard.
    UnionJack,
    /// `Structured` with nodes moved at random; angles guarded.
    Perturbed {
        /// Seed of the random moves.
        seed: u64,
        /// Largest move as a share of the cell, below 0.5.
        amount: f64,
    },
    /// Red refinement of one irregular coarse mesh.
    Refined {
        /// Seed of the coarse mesh.
        seed: u64,
        /// Largest move as a share of the coarse cell.
        amount: f64,
    },
}
