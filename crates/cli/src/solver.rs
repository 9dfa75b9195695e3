//! `--solver`: a method of this program, or a command.

use crate::args::SolverArg;
use crate::failure::Failure;
use crate::run::method;
use clap::{Args, ValueEnum};
use signorini_study::external::{External, Limits};
use signorini_study::nearest::nearest;
use signorini_study::run::Solver;
use std::path::Path;

/// Who solves.
#[derive(Args, Debug, Clone)]
#[command(next_help_heading = "Solver")]
pub struct SolverArgs {
    /// Solve with a method, condensed, interior-point or multigrid, or with another program: a command such as 'python3 solve.py'.
    ///
    /// The command runs once for each level, without a shell, in a folder of its own that holds the mesh (mesh.msh, Gmsh 4.1), the
    /// problem (problem.json) and the quadratic problem (K.mtx, f.mtx, upper.mtx, T.mtx, u_D.mtx), and leaves displacement.csv
    /// (node,ux,uy) or x.mtx there. Its answer is certified and judged like our own.
    #[arg(long, value_name = "NAME|COMMAND")]
    pub solver: Option<String>,
    /// Seconds that an external solver may take for one level.
    #[arg(long, value_name = "SECONDS", default_value_t = Limits::default().seconds, value_parser = seconds)]
    pub solver_limit: f64,
    /// Keep the files that were exchanged with an external solver, in DIR/.external; those of a failure always stay.
    #[arg(long)]
    pub keep_exchange: bool,
}

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(s) if s > 0.0 && s.is_finite() => Ok(s),
        _ => Err(format!("`{text}` is no positive number of seconds")),
    }
}

impl SolverArgs {
    /// The solver that the words mean; files are exchanged below `out`.
    pub fn solver(&self, out: &Path) -> Result<Option<Solver>, Failure> {
        let Some(text) = &self.solver else { return Ok(None) };
        if let Ok(own) = SolverArg::from_str(text, false) {
            return Ok(Some(Solver::Own(method(own))));
        }
        let limits = Limits { seconds: self.solver_limit, ..Limits::default() };
        let external = External::parse(text, out.join(EXCHANGE), limits)
            .map_err(|e| Failure::new(format!("--solver: {e}"), hint(text)))?;
        Ok(Some(Solver::External(External { keeps: self.keep_exchange, ..external })))
    }
}

/// Other programs that `bench` times beside our own solvers.
#[derive(Args, Debug, Clone)]
pub struct ExternalArgs {
    /// Time another program as well: a command as for `run --solver`, e.g. 'python3 solve.py'. Can be repeated.
    ///
    /// Its process, from start to end, is its solve; writing the level down for it and reading its answer count nowhere.
    #[arg(long = "external", value_name = "COMMAND")]
    pub commands: Vec<String>,
    /// Seconds that such a program may take for one level; what takes longer, or fails, is left out with the reason, finer levels with it.
    #[arg(long, value_name = "SECONDS", default_value_t = Limits::default().seconds, value_parser = seconds)]
    pub solver_limit: f64,
}

impl ExternalArgs {
    /// The programs, each with a name of its own; files are exchanged below `out`.
    pub fn solvers(&self, out: &Path) -> Result<Vec<Solver>, Failure> {
        let mut found: Vec<External> = Vec::new();
        for text in &self.commands {
            let limits = Limits { seconds: self.solver_limit, ..Limits::default() };
            let external = External::parse(text, out.join(EXCHANGE), limits)
                .map_err(|e| Failure::new(format!("--external: {e}"), "give a command in quotation marks, as in --external 'python3 solve.py'; our own solvers are for --solvers"))?;
            let name = distinct(&external.name, &found);
            found.push(External { folder: external.folder.join(&name), name, ..external });
        }
        Ok(found.into_iter().map(Solver::External).collect())
    }
}

/// The folder of `--out` in which files are exchanged.
pub const EXCHANGE: &str = ".external";

/// The name, with a number behind it if one of the programs, or a solver of ours, has it already.
fn distinct(name: &str, others: &[External]) -> String {
    let is_taken = |n: &str| SolverArg::from_str(n, false).is_ok() || others.iter().any(|o| o.name == n);
    let numbered = (2..).map(|k| format!("{name}-{k}"));
    std::iter::once(name.to_owned()).chain(numbered).find(|n| !is_taken(n)).unwrap_or_default()
}

/// What a mistyped solver may have meant.
fn hint(text: &str) -> String {
    let names = SolverArg::value_variants().iter().filter_map(ValueEnum::to_possible_value);
    let names: Vec<String> = names.map(|v| v.get_name().to_owned()).collect();
    let list = format!("{}, or a command in quotation marks, as in --solver 'python3 solve.py'", names.join(", "));
    match nearest(text, names.iter().map(String::as_str)) {
        Some(name) => format!("did you mean {name}? There are {list}"),
        None => format!("there are {list}"),
    }
}
