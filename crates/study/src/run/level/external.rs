//! A level that another program solves.

use super::{Solved, Task};
use crate::error::RunError;
use crate::external::{External, Handover};
use crate::run::timing::Stopwatch;
use signorini_contact::problem::{Discrete, Problem};

impl Task<'_> {
    /// Hands the level over and takes the answer. The program's own time is the solve, writing and reading files for it no phase.
    pub(super) fn have_solved(
        &self,
        external: &External,
        index: usize,
        problem: &Problem,
        discrete: Discrete,
        watch: &mut Stopwatch,
    ) -> Result<Solved, RunError> {
        let supports = problem.node_supports()?;
        let handover = Handover {
            level: index,
            cells: self.cells[index],
            mesh: problem.mesh,
            materials: &problem.materials,
            conditions: problem.supports,
            supports: &supports,
            discrete: &discrete,
        };
        let (raw, used) = external.solve(&handover)?;
        watch.external(used);
        Ok(Solved::new(problem, discrete, raw))
    }
}
