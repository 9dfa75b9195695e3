//! References that errors are measured against: an exact solution, or a discrete one on a finer mesh.

pub mod exact;
pub mod located;
pub mod overkill;
