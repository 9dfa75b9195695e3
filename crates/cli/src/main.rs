//! The `signorini` program: arguments, progress and exit status. No mathematics.

#[macro_use]
mod say;

mod args;
mod bench;
mod bless;
mod change;
mod check;
mod coverage;
mod explain;
mod failure;
mod falsify;
mod fields;
mod gate;
mod help;
mod interrupt;
mod list;
mod new;
mod pages;
mod progress;
mod report;
mod run;
mod schema;
mod solver;

use args::{Cli, Command};
use clap::Parser;
use std::process::ExitCode;

/// Version and commit.
pub const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), " (", env!("SIGNORINI_COMMIT"), ")");

fn main() -> ExitCode {
    let cli = Cli::parse();
    let result = match cli.command.unwrap_or(Command::Run(cli.run)) {
        Command::Run(args) => run::run(&args),
        Command::List => list::list(),
        Command::Check(args) => check::check(&args),
        Command::Bless(args) => bless::bless(&args),
        Command::Bench(args) => bench::bench(&args),
        Command::BenchOne => bench::one(),
        Command::Falsify(args) => falsify::falsify(&args),
        Command::Coverage(args) => coverage::coverage(&args),
        Command::Report { dir } => report::report(&dir),
        Command::New(args) => new::new(&args),
        Command::Explain { claim } => explain::explain(&claim),
        Command::Schema { of } => schema::schema(of),
        Command::Completions { shell } => pages::completions(shell),
        Command::Man { out } => pages::man(out.as_deref()),
    };
    match result {
        Ok(status) => ExitCode::from(status),
        Err(failure) => {
            complain!("{failure}");
            ExitCode::from(failure.status())
        }
    }
}
