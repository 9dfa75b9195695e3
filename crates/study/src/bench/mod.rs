//! Speed against error: how long solvers take on refined meshes, beside what no solver can beat.
//!
//! ```text
//! Plan ──► jobs ──► one process each, round after round, forwards and backwards ──► Outcome ──► BenchRecord
//! ```
//!
//! A [`Job`] is one level of one case under one solver, computed by [`run::Alone`](crate::run::Alone) in the phases of a run,
//! or one of the floors: the same mesh with every pair tied (a linear problem), one product with the finest matrix, the
//! bandwidth of the memory. Each job runs in a process of its own, because the largest resident memory of a process never falls; who
//! starts the processes is up to the caller of [`measure`]. A round visits every job once, so that a machine that becomes slower
//! hits all alike; medians, least and largest values over the rounds are recorded.
//!
//! Reading order: [`plan`] (sizes and jobs), [`job`] (what one process does), [`bandwidth`], [`measure`], [`curve`] (what
//! follows from the runs of a solver), [`record`].

pub mod bandwidth;
mod collect;
pub mod curve;
pub mod job;
pub mod machine;
mod measure;
pub mod plan;
pub mod record;
pub mod spread;
#[cfg(test)]
mod tests;

pub use job::{Job, Outcome, Task, carry_out};
pub use measure::measure;
pub use plan::{Plan, Sizes, Subject};
pub use record::BenchRecord;
