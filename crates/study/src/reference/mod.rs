//! References that errors are measured against: an exact solution, or a discrete one on a finer nested mesh.

pub mod exact;
pub mod overkill;
