//! The solvers against one another, against enumeration of all active sets, and against dense algebra.

mod agreement;
mod certificate;
mod cycle;
mod examples;
mod factor;
mod floating;
mod plate;
