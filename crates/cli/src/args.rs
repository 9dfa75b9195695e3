//! The command line: what may be typed.

use crate::change::ChangeArgs;
use crate::fields::FieldsArg;
use crate::gate::GateArgs;
use crate::help;
use crate::new::NewArgs;
use crate::schema::Of;
use crate::solver::{ExternalArgs, SolverArgs};
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use std::path::PathBuf;

/// A laboratory for the convergence of finite elements in elastic contact.
///
/// Refines families of triangulations, measures errors against exact or overkill solutions, fits the observed rates and
/// holds them against the bounds of Haslinger & Hlaváček, "Contact between elastic bodies II".
#[derive(Parser, Debug)]
#[command(name = "signorini", version = crate::VERSION, args_conflicts_with_subcommands = true)]
#[command(after_help = help::PROGRAM)]
pub struct Cli {
    /// What to do; without it the studies are run.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Arguments of `run`, which is the default command.
    #[command(flatten)]
    pub run: RunArgs,
}

/// The names of the commands, for who mistypes one.
pub const COMMANDS: [&str; 13] = [
    "run",
    "list",
    "check",
    "bless",
    "report",
    "bench",
    "falsify",
    "coverage",
    "new",
    "explain",
    "schema",
    "completions",
    "man",
];

/// The commands.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Run studies: measure, fit, judge, write records, tables and plots (the default).
    ///
    /// Solves each study on every level of its family, measures the errors against an exact or a finer solution, fits the observed
    /// rate with its 95 % interval, and gives a verdict: pass, fail or inconclusive.
    #[command(after_help = help::RUN)]
    Run(RunArgs),
    /// List every claim and study: id, claim, title.
    ///
    /// The studies are those in studies/ of the current folder or the nearest parent that has some, else those shipped with the
    /// program. Below them stands every statement of the paper, with the studies that judge it.
    List,
    /// Write a commented study file that runs as it is.
    ///
    /// Two straight bodies, loads, a contact zone, a family of meshes and a reference, with a comment on every key: change what you
    /// like and run it. A file that is there is never overwritten.
    #[command(after_help = help::NEW)]
    New(NewArgs),
    /// Explain a claim: statement, hypotheses, bounds, sources, studies.
    ///
    /// Prints what the claim says, what it supposes, the paper's bound and today's with where they come from, how it is judged, and
    /// which studies judge it.
    #[command(after_help = help::EXPLAIN)]
    Explain {
        /// Id of the claim, e.g. theorem-3-1.
        #[arg(value_name = "CLAIM")]
        claim: String,
    },
    /// Parse, mesh, verify, test solvability and count unknowns: everything but the solve.
    ///
    /// Reads the study as `run` would, makes every mesh and measures it against the hypotheses, verifies an exact solution pointwise,
    /// looks for rigid motions that the load excites, and computes the exponents at the corners.
    Check(CheckArgs),
    /// Run studies and store their energies, errors and rates as baselines in reference/.
    ///
    /// Later runs are compared with them: what has moved is reported beside the verdict, and fails a run with --strict. This is the
    /// only command that writes baselines; read the difference before you commit it.
    Bless(RunArgs),
    /// Measure speed against error: seconds and bytes of every solver on refined meshes, beside the floors of the machine.
    ///
    /// Every level under every solver is computed in a process of its own, in rounds that visit all of them; medians are reported,
    /// with the bandwidth of the memory, one product with the matrix and the linear problem on the same mesh beside them.
    #[command(after_help = help::BENCH)]
    Bench(BenchArgs),
    /// Carry out one measurement of `bench`, described on standard input.
    #[command(name = "bench-one", hide = true)]
    BenchOne,
    /// Search for counterexamples: scenes drawn at random within the hypotheses of a claim, the worst kept as a study.
    ///
    /// Keeps the smallest rate and the largest constant, makes both scenes simpler as long as they stay nearly as bad, and saves
    /// them as study files. A candidate for a counterexample ends the command with status 1.
    #[command(after_help = help::FALSIFY)]
    Falsify(FalsifyArgs),
    /// Measure how often the 95 % interval holds the true slope, on made-up errors.
    ///
    /// Draws series of errors with a known slope and noise, fits them as a run does, and counts how often the interval holds the
    /// truth, with and without the choice of the window.
    Coverage(CoverageArgs),
    /// Render tables and plots again from the records in a folder.
    ///
    /// Reads records and nothing else: no study is solved. The exit status is that of the run that wrote them.
    Report {
        /// The folder with the records.
        #[arg(default_value = "reports")]
        dir: PathBuf,
    },
    /// Print the JSON Schema of study files or of records.
    ///
    /// An editor completes and checks study files by the first; programs that read records find every field in the second.
    #[command(after_help = help::SCHEMA)]
    Schema {
        /// What the schema is of.
        #[arg(value_enum)]
        of: Of,
    },
    /// Print completions for a shell.
    ///
    /// Completes commands, options and their words; where to put them depends on the shell.
    #[command(after_help = help::COMPLETIONS)]
    Completions {
        /// The shell.
        #[arg(value_enum)]
        shell: Shell,
    },
    /// Print the man page, or write a page for each command.
    ///
    /// Without --out the page of the program goes to standard output: signorini man | man -l -
    Man {
        /// Write signorini.1 and a page for each command into this folder.
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
}

/// Arguments of `run` and `bless`.
#[derive(Args, Debug, Clone)]
pub struct RunArgs {
    /// Ids from `list`, paths to .toml files, or `hard`, `controls`, `everything`; none means every study in studies/.
    #[arg(value_name = "STUDY")]
    pub studies: Vec<String>,
    /// How large the meshes are.
    #[arg(long, value_enum, default_value_t = ProfileArg::Quick, help_heading = "Sizes")]
    pub profile: ProfileArg,
    /// Take N levels, counted from the coarsest, instead of the profile's own number.
    #[arg(long, value_name = "N", value_parser = whole::<u16>, help_heading = "Sizes")]
    pub levels: Option<u16>,
    /// Where records, tables and plots go.
    #[arg(long, value_name = "DIR", default_value = "reports", help_heading = "Output")]
    pub out: PathBuf,
    /// The solver, in place of the study's own.
    #[command(flatten)]
    pub solver: SolverArgs,
    /// Threads; all processors by default. Results do not depend on it.
    #[arg(long, value_name = "N", value_parser = whole::<u16>, help_heading = "Machine")]
    pub threads: Option<u16>,
    /// Let drift from the baselines in reference/ fail the run, and show it as a table.
    #[arg(long, help_heading = "Gate")]
    pub strict: bool,
    /// Print nothing but errors and the summary.
    #[arg(long, help_heading = "Output")]
    pub quiet: bool,
    /// Keys that are overridden.
    #[command(flatten)]
    pub change: ChangeArgs,
    /// Fields of levels.
    #[command(flatten)]
    pub fields: FieldsArg,
    /// What a service of continuous integration is told.
    #[command(flatten)]
    pub gate: GateArgs,
}

/// Arguments of `check`.
#[derive(Args, Debug, Clone)]
pub struct CheckArgs {
    /// Ids from `list` or paths to .toml files; none means every study in studies/.
    #[arg(value_name = "STUDY")]
    pub studies: Vec<String>,
    /// How large the meshes are.
    #[arg(long, value_enum, default_value_t = ProfileArg::Quick)]
    pub profile: ProfileArg,
    /// Keys that are overridden.
    #[command(flatten)]
    pub change: ChangeArgs,
}

/// `--profile`.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProfileArg {
    /// All studies together in well under a minute.
    Quick,
    /// The published tables.
    Full,
}

/// `--solver`.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolverArg {
    /// One factorisation, then an active set on the Schur complement.
    Condensed,
    /// Clarabel with crossover.
    InteriorPoint,
    /// Nested multigrid over the levels of the family.
    Multigrid,
}

/// Arguments of `bench`.
#[derive(Args, Debug, Clone)]
pub struct BenchArgs {
    /// Ids from `list` or paths to .toml files, each with `/CASE` behind it for another case than its first. None means
    /// theorem-3-1-smooth, measured against its exact solution, and two-squares, measured by its energies.
    #[arg(value_name = "STUDY[/CASE]")]
    pub studies: Vec<String>,
    /// Sizes by unknowns, e.g. 1e3..1e7; either end may be left out. Cells double from the study's coarsest mesh on.
    #[arg(long, value_name = "A..B", value_parser = dofs_range, default_value = "500..1e5")]
    pub dofs: DofsRange,
    /// The largest size, in place of the end of --dofs.
    #[arg(long, value_name = "B", value_parser = count)]
    pub max_dofs: Option<usize>,
    /// Take N levels only, counted from the coarsest within the sizes.
    #[arg(long, value_name = "N", value_parser = whole::<u16>)]
    pub levels: Option<u16>,
    /// Solvers, separated by commas; all by default. Each is left out where it has no hope: interior-point above 20 000
    /// unknowns, condensed above 1 500 000.
    #[arg(long, value_enum, value_name = "NAME,…", value_delimiter = ',')]
    pub solvers: Vec<SolverArg>,
    /// Programs beside them.
    #[command(flatten)]
    pub external: ExternalArgs,
    /// Measure everything R times, in rounds; medians are reported.
    #[arg(long, value_name = "R", default_value_t = 3, value_parser = whole::<u16>)]
    pub repeat: u16,
    /// Where bench.json, bench.csv, bench.md, work-precision.png and scaling.png go.
    #[arg(long, value_name = "DIR", default_value = "reports/bench")]
    pub out: PathBuf,
    /// Threads of each measurement; all processors by default.
    #[arg(long, value_name = "N", value_parser = whole::<u16>)]
    pub threads: Option<u16>,
    /// Print nothing but errors and the tables.
    #[arg(long)]
    pub quiet: bool,
    /// Keys that are overridden.
    #[command(flatten)]
    pub change: ChangeArgs,
}

/// `--dofs`: least and most unknowns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DofsRange {
    /// Fewest.
    pub least: usize,
    /// Most.
    pub most: usize,
}

/// Most unknowns where `--dofs` names no end: what fits in the memory of large machines.
const ENDLESS: usize = 2_000_000_000;

fn dofs_range(text: &str) -> Result<DofsRange, String> {
    let (a, b) = text.split_once("..").ok_or("two numbers with .. between them, e.g. 1e3..1e5")?;
    let end = |text: &str, missing: usize| if text.is_empty() { Ok(missing) } else { count(text) };
    let range = DofsRange { least: end(a, 0)?, most: end(b, ENDLESS)? };
    if range.least > range.most {
        return Err(format!("it ends at {} before it begins at {}; swap the two", range.most, range.least));
    }
    Ok(range)
}

/// A whole number from 1 on.
fn whole<T: TryFrom<u64>>(text: &str) -> Result<T, String> {
    let number = text.parse::<u64>().ok().filter(|n| *n > 0).and_then(|n| T::try_from(n).ok());
    let most = (1_u64 << (8 * size_of::<T>())) - 1;
    number.ok_or_else(|| format!("`{text}` is no whole number from 1 to {most}"))
}

/// A number of unknowns: `100000`, `1e5`.
fn count(text: &str) -> Result<usize, String> {
    match text.parse::<f64>() {
        Ok(x) if (1.0..=ENDLESS as f64).contains(&x) && x.fract() == 0.0 => Ok(x as usize),
        _ => Err(format!("`{text}` is no whole number from 1 to 2e9, such as 100000 or 1e5")),
    }
}

/// Arguments of `falsify`.
#[derive(Args, Debug, Clone)]
pub struct FalsifyArgs {
    /// A claim (theorem-3-1, remark-3-2a, remark-3-2b, theorem-3-3, theorem-3-4, lemma-2-1, many-switches), `falk` for the
    /// inequality of the ledger, `all` for every one of them, or `bent-theorem-3-1`, which must be found out.
    #[arg(value_name = "CLAIM")]
    pub claim: String,
    /// Scenes to draw for each claim.
    #[arg(long, value_name = "N", value_parser = whole::<u32>)]
    pub budget: u32,
    /// Seed of the draws.
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Results go to the folder `falsify` in it.
    #[arg(long, value_name = "DIR", default_value = "reports")]
    pub out: PathBuf,
    /// Threads; all processors by default. Results do not depend on it.
    #[arg(long, value_name = "T", value_parser = whole::<u16>)]
    pub threads: Option<u16>,
    /// Print nothing but errors and the tables.
    #[arg(long)]
    pub quiet: bool,
}

/// Arguments of `coverage`.
#[derive(Args, Debug, Clone)]
pub struct CoverageArgs {
    /// Series to draw for each row of the table.
    #[arg(long, value_name = "N", default_value_t = 10_000, value_parser = whole::<u32>)]
    pub draws: u32,
    /// Seed of the draws.
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}
