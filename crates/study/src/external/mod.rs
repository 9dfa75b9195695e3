//! Solvers that are other programs: a level is handed over as files, the answer is read back and graded like our own.
//!
//! ```text
//! FOLDER/mesh.msh       the mesh, Gmsh 4.1 ASCII; node i of the files below has the tag i + 1
//!        problem.json   materials, supports, nodal loads, contact pairs with normals and gaps: see [`problem`]
//!        K.mtx f.mtx upper.mtx T.mtx u_D.mtx [N.mtx]   min ½xᵀKx − fᵀx, x ≤ upper;  u = T x + u_D
//! ──────────────────────  the command runs in FOLDER, and leaves there one of
//!        displacement.csv   node,ux,uy   every node once
//!        x.mtx              the unknowns of the quadratic problem
//! ```
//!
//! Whatever wrote the answer, displacements are taken as they are: energies, contact forces, certificate and errors are computed from
//! them here.

mod answer;
mod command;
mod handover;
mod matrix_market;
pub mod problem;
mod process;

pub use command::CommandError;
pub use handover::Handover;
pub use process::stop_all;

use crate::store::StoreError;
use serde::{Deserialize, Serialize};
use signorini_contact::solver::{self, QpSolution};
use std::path::{Path, PathBuf};

/// A command that solves, and what it may use up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct External {
    /// What tables and plots call it: the stem of the first word that is a file, else of the program.
    pub name: String,
    /// The program and its arguments; words that name files are absolute, since the program runs in a folder of its own.
    pub words: Vec<String>,
    /// What it may use up.
    pub limits: Limits,
    /// Where the folders of its levels go.
    pub folder: PathBuf,
    /// Whether the folder of a level stays when it has been answered; that of a failure always does.
    pub keeps: bool,
}

/// What a program may use up on one level.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Wall seconds.
    pub seconds: f64,
    /// Bytes that it may print.
    pub printed: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { seconds: 600.0, printed: 1 << 24 }
    }
}

/// What the program used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Used {
    /// Wall seconds.
    pub seconds: f64,
    /// Processor seconds, with those of the processes it waited for.
    pub processor: f64,
    /// Largest resident memory of any of its processes, bytes.
    pub peak_bytes: u64,
}

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum ExternalError {
    /// The program could not be run, was stopped or failed; or its answer cannot be used.
    #[error("{name}: {why}\nits files are in {}", folder.display())]
    Refused {
        /// The program.
        name: String,
        /// What happened, with what it last said.
        why: String,
        /// The folder of the level, left as it was.
        folder: PathBuf,
    },
    /// The problem could not be written down.
    #[error(transparent)]
    Store(#[from] StoreError),
}

impl External {
    /// Reads a command line: words are split as a shell splits them, and nothing else of a shell is done.
    ///
    /// # Errors
    /// [`CommandError`]: no words, an open quotation, a program that is not there.
    pub fn parse(text: &str, folder: PathBuf, limits: Limits) -> Result<Self, CommandError> {
        let words = command::words(text)?;
        Ok(Self { name: command::name(&words), words, limits, folder, keeps: false })
    }

    /// The same program for one case: folders of its levels go to a folder of the case.
    pub fn for_case(&self, study: &str, case: &str) -> Self {
        Self { folder: self.folder.join(format!("{study}@{case}")), ..self.clone() }
    }

    /// Hands a level over, runs the program and takes its answer.
    ///
    /// # Errors
    /// [`ExternalError::Refused`] for a program that fails and for an answer that is none: too long, partial, not finite, or in conflict
    /// with the supports.
    pub fn solve(&self, handover: &Handover) -> Result<(QpSolution, Used), ExternalError> {
        let folder = self.folder.join(format!("level-{}", handover.level));
        handover.write(&folder)?;
        let refuse = |why: String| ExternalError::Refused { name: self.name.clone(), why, folder: folder.clone() };
        let used = process::run(&self.words, &folder, self.limits).map_err(refuse)?;
        let x = answer::read(&folder, handover.discrete).map_err(refuse)?;
        let adopted = solver::adopt(&handover.discrete.qp, x);
        if !self.keeps {
            remove(&folder, &self.folder);
        }
        Ok((adopted, used))
    }
}

/// Removes the folder of a level, and that of its case and of all of them once they are empty. What cannot be removed costs space, not truth.
fn remove(level: &Path, case: &Path) {
    let _ = std::fs::remove_dir_all(level);
    let _ = std::fs::remove_dir(case);
    case.parent().map(std::fs::remove_dir);
}
