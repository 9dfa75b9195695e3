//! The solvers against one another, against enumeration of all active sets, and against dense algebra.

mod agreement;
mod certificate;
mod cycle;
pub mod examples;
mod factor;
mod floating;
mod plate;
