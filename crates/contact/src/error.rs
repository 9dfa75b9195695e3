//! What makes an input meaningless. How a solve ended is not an error but a [`Status`](crate::solver::Status).

/// Meaningless input: what, where, the value and the bound that it breaks, and what to do next.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// The mesh is not a triangulation of two bodies with matching contact nodes.
    #[error("mesh: {0}")]
    Mesh(String),
    /// The elastic constants break symmetry or positivity (2.7).
    #[error("material: {0}")]
    Material(String),
    /// Boundary conditions contradict one another.
    #[error("boundary conditions: {0}")]
    Boundary(String),
    /// A load or a prescribed displacement is not a number.
    #[error("load: {0}")]
    Load(String),
    /// No solution exists, or it is a limit load.
    #[error("solvability: {0}")]
    Solvability(String),
}
