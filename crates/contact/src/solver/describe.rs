//! Solvers and how their solves ended, in the words of the command line and the records.

use super::{Method, Status};
use std::fmt;

impl Method {
    /// `automatic`, `condensed`, `monotone`, `interior-point` or `multigrid`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Automatic => "automatic",
            Self::Condensed => "condensed",
            Self::Monotone => "monotone",
            Self::InteriorPoint => "interior-point",
            Self::Multigrid => "multigrid",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Adopted => f.write_str("answer of another program"),
            Self::Converged { steps: 1 } => f.write_str("converged in 1 step"),
            Self::Converged { steps } => write!(f, "converged in {steps} steps"),
            Self::Rescued { cycle: 0, steps } => write!(f, "step limit, rescued in {steps} monotone steps"),
            Self::Rescued { cycle, steps } => write!(f, "cycle of {cycle}, rescued in {steps} monotone steps"),
            Self::IterationLimit { steps } => write!(f, "no answer within {steps} steps"),
            Self::NotPositiveDefinite => write!(f, "the matrix is not positive definite on the free components"),
        }
    }
}
