//! What a measurement leaves behind: plain numbers, `null` where there is none.
//!
//! Times and bytes differ from run to run; everything else in it is the same.

use super::machine::Machine;
use super::spread::Spread;
use crate::record::{Changed, RecordError};
use serde::{Deserialize, Serialize};

/// Version of the layout.
pub const SCHEMA: u32 = 1;

/// Everything that was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BenchRecord {
    /// [`SCHEMA`].
    pub schema: u32,
    /// Version and commit of the program.
    pub version: String,
    /// The machine.
    pub machine: Machine,
    /// Threads of each process.
    pub threads: usize,
    /// Rounds, each of which visited every measurement once.
    pub repeat: usize,
    /// Bytes per second of `a = b + s c`.
    pub bandwidth: Bandwidth,
    /// One entry per case.
    pub studies: Vec<BenchStudy>,
}

/// Bandwidth of the memory, in bytes per second.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Bandwidth {
    /// On one thread.
    pub one_thread: Option<Spread>,
    /// On all threads.
    pub all_threads: Option<Spread>,
}

/// One case under several solvers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BenchStudy {
    /// Id of the study.
    pub study: String,
    /// Name of the case.
    pub case: String,
    /// Title of the study.
    pub title: String,
    /// Family of the meshes.
    pub family: String,
    /// Where the errors come from.
    pub error: ErrorSource,
    /// The meshes, coarsest first.
    pub sizes: Vec<Size>,
    /// Round relative errors that a time is given for, largest first.
    pub targets: Vec<f64>,
    /// One entry per solver.
    pub solvers: Vec<SolverCurve>,
    /// What options changed of the study.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub changed: Option<Changed>,
}

/// What the errors are measured against.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ErrorSource {
    /// The exact solution.
    Exact,
    /// The extrapolated limit of the energies of nested levels: `√(2(L(u_h) − L*))`, a bound of the error.
    Energies,
    /// Nothing: no exact solution, and too few nested levels to extrapolate.
    None,
}

/// One mesh and the floors on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Size {
    /// From 0, the coarsest that was measured.
    pub level: usize,
    /// Cells per unit of the coarse division.
    pub cells: usize,
    /// Largest side; `None` where no solver was tried.
    pub h: Option<f64>,
    /// Displacement components that are not fixed.
    pub dofs: usize,
    /// Wall seconds of one product with the stiffness matrix.
    pub product: Option<Spread>,
    /// Bytes of that matrix.
    pub matrix_bytes: Option<u64>,
}

/// One solver on all meshes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SolverCurve {
    /// Its name.
    pub solver: String,
    /// The solver of the linear problem that it is compared with; none of another program.
    pub linear_solver: Option<String>,
    /// What was solved, coarsest first.
    pub runs: Vec<Measured>,
    /// What was not, and why.
    pub left_out: Vec<LeftOut>,
    /// Exponent `p` of the growth of the wall seconds of all phases, `c N^p`.
    pub growth_total: Option<Exponent>,
    /// The same of set-up and solve alone.
    pub growth_system: Option<Exponent>,
    /// Wall seconds to the solution at each of the targets, interpolated; `None` where the measured levels do not reach it.
    pub seconds_to_target: Vec<Option<f64>>,
}

/// A level that no time is known of.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LeftOut {
    /// Number of the mesh in `sizes`.
    pub level: usize,
    /// Why.
    pub reason: String,
}

/// A fitted exponent.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Exponent {
    /// The slope in logarithms.
    pub value: f64,
    /// Its standard error.
    pub stderr: f64,
    /// How many of the finest meshes it was fitted on.
    pub sizes: usize,
}

/// A solved level with what it took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Number of the mesh in `sizes`.
    pub level: usize,
    /// How the solve ended.
    pub status: String,
    /// Iterations; 0 of another program, which does not tell.
    pub iterations: usize,
    /// Sparse factorisations.
    pub factorizations: usize,
    /// Products with the finest matrix that the iteration took; none for direct solvers.
    pub work: Option<f64>,
    /// Error in the energy norm.
    pub error: Option<f64>,
    /// That over `‖u‖_A`.
    pub relative_error: Option<f64>,
    /// Wall seconds.
    pub wall: Seconds,
    /// Processor seconds of all threads together.
    pub processor: Option<Seconds>,
    /// Largest resident memory of a process that did nothing else.
    pub peak_bytes: Option<Spread>,
    /// The linear problem on the same mesh.
    pub linear: Option<Linear>,
    /// Share of the constraints that press, between 0 (lifted off) and 1.
    #[serde(default)]
    pub closed: Option<f64>,
}

/// Seconds of a level, phase by phase.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Seconds {
    /// Triangulation and refinement.
    pub mesh: Spread,
    /// Loads, with the quadrature of an exact solution, and stiffness.
    pub assembly: Spread,
    /// What the solver does before it looks at a bound.
    pub setup: Spread,
    /// The solve.
    pub solve: Spread,
    /// Errors, ledger, certificate.
    pub error: Spread,
    /// Set-up and solve.
    pub system: Spread,
    /// Everything until the solution is there: all but the error.
    pub solution: Spread,
    /// Everything.
    pub total: Spread,
}

/// The linear problem, `n·d = g` at every pair.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Linear {
    /// Iterations.
    pub iterations: usize,
    /// Products with the finest matrix.
    pub work: Option<f64>,
    /// Wall seconds of set-up and solve.
    pub wall: Spread,
    /// Processor seconds of the same.
    pub processor: Option<Spread>,
    /// The contact problem's wall seconds of set-up and solve over these, median over median.
    pub ratio: f64,
    /// The same of processor seconds.
    pub ratio_processor: Option<f64>,
}

impl BenchRecord {
    /// The record as indented JSON.
    ///
    /// # Errors
    /// [`RecordError::NonFinite`] names the first NaN or infinite number.
    pub fn to_json(&self) -> Result<String, RecordError> {
        crate::record::to_json(self)
    }

    /// Whether something was to be measured and could not be.
    pub fn is_incomplete(&self) -> bool {
        self.studies.iter().flat_map(|s| &s.solvers).any(|c| c.left_out.iter().any(|l| !l.is_by_limit()))
    }
}

impl LeftOut {
    /// How a reason of a limit begins; every other one is a failure.
    const BY_LIMIT: &'static str = "more than ";

    /// Left out because the solver is not meant for so many unknowns.
    pub(super) fn by_limit(level: usize, most: usize) -> Self {
        Self { level, reason: format!("{}{most} unknowns", Self::BY_LIMIT) }
    }

    /// Whether no fault but a limit kept the level away.
    pub fn is_by_limit(&self) -> bool {
        self.reason.starts_with(Self::BY_LIMIT)
    }
}
