//! `signorini coverage`: how often the interval of a fitted rate holds the true slope.

use crate::args::CoverageArgs;
use crate::failure::Failure;
use signorini_study::rate::coverage::{measure, settings};

/// Prints the table.
pub fn coverage(args: &CoverageArgs) -> Result<u8, Failure> {
    let draws = args.draws as usize;
    let measured: Vec<_> = settings().into_iter().map(|s| measure(s, draws, args.seed)).collect();
    say!("{}", signorini_report::coverage_markdown(&measured, draws, args.seed));
    Ok(0)
}
