//! The search for counterexamples: scenes drawn at random within the hypotheses of a claim.
//!
//! ```text
//! (target, seed, number) ──► draw ──► study file ──► run ──► measured ──► the worst ──► shrink ──► a study file to keep
//! ```
//!
//! A draw is a function of its three numbers alone, and so is everything that follows from it: the result of a search does not depend on
//! threads, and a search that is interrupted or given a larger budget goes on as if it had never stopped.
//!
//! The meshes are small, so the rates are those of a few coarse levels and may lie below a bound that holds for `h → 0`. The
//! verdict of each study takes that into account as any verdict does: rates that have not settled refute nothing. What *can* be
//! refuted by one mesh alone are the inequalities of the proofs.

mod dice;
mod draw;
mod measure;
mod search;
mod shrink;
mod size;
mod state;
mod summary;
mod target;
#[cfg(test)]
mod tests;

pub use draw::{Draw, draw};
pub use measure::Measured;
pub use search::{Found, Plan, Worst, search};
pub use shrink::{Aim, CONSTANT_KEPT, RATE_KEPT, Shrunk};
pub use size::{Size, size};
pub use summary::{Candidate, Row, Saved, Summary};
pub use target::{About, Target};
