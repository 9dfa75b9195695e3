//! The stiffness matrix in the changed basis and the nodal loads.
//!
//! Every row of the matrix is gathered from the elements around its node, so rows are independent: parallel, without locks, and
//! the same to the last bit for any number of threads. Nodal loads are computed in parallel and added element by element, in
//! order. `O(N)` time; beside their results they need about 30 bytes per node.

mod loads;
mod pattern;
mod scatter;
mod shared;
mod stiffness;
mod surroundings;
#[cfg(test)]
mod tests;

pub use loads::{check_load, internal_forces, loads};
pub(crate) use scatter::scatter;
pub(crate) use stiffness::product;
pub use stiffness::stiffness;
