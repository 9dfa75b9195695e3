//! `--junit` and `--annotations`: a run as a gate of continuous integration.

use crate::failure::Failure;
use crate::run::seconds_of;
use clap::{Args, ValueEnum};
use signorini_report::annotations::{github, github_bad_input, relative};
use signorini_report::junit::{Judged, junit, junit_of_bad_input};
use signorini_report::{CaseDrift, ReportError};
use signorini_study::run::CaseRun;
use signorini_study::store;
use signorini_study::study::Study;
use std::path::{Path, PathBuf};

/// What a service of continuous integration is told beside the exit status.
#[derive(Args, Debug, Clone, Default)]
#[command(next_help_heading = "Gate")]
pub struct GateArgs {
    /// Write JUnit XML: a suite for each study, a test case for each case, with reasons and times.
    ///
    /// A gate that failed is a `failure`, with --strict drift too; what could not be judged is an `error`; what is announced as
    /// inconclusive at this size is `skipped`. Bad input is an `error` of its own.
    #[arg(long, value_name = "FILE")]
    pub junit: Option<PathBuf>,
    /// Print a line for each case that did not pass, in the form that a service shows beside the study's file.
    #[arg(long, value_name = "SERVICE", value_enum)]
    pub annotations: Option<Service>,
}

/// `--annotations`.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Eq)]
pub enum Service {
    /// `::error file=…::…` and `::warning file=…::…`, as GitHub's workflows read them.
    Github,
}

const OTHER_FILE: &str = "free the path, or name another file with --junit";

impl GateArgs {
    /// Whether anything is asked for.
    pub fn is_asked(&self) -> bool {
        self.junit.is_some() || self.annotations.is_some()
    }

    /// Makes the folder of the file, before anything is solved for it.
    pub fn prepare(&self) -> Result<(), Failure> {
        let folder = self.junit.as_deref().and_then(Path::parent).filter(|f| !f.as_os_str().is_empty());
        let Some(folder) = folder else { return Ok(()) };
        std::fs::create_dir_all(folder)
            .map_err(|e| Failure::new(format!("--junit: {}: {e}", folder.display()), OTHER_FILE))
    }

    /// Tells of a run that came to its end. `drift` is that of the runs, in their order.
    pub fn tell(
        &self,
        studies: &[Study],
        runs: &[Vec<CaseRun>],
        drift: &[CaseDrift],
        strict: bool,
    ) -> Result<(), Failure> {
        let pairs: Vec<(&Study, &CaseRun)> =
            studies.iter().zip(runs).flat_map(|(study, runs)| runs.iter().map(move |run| (study, run))).collect();
        let judged: Vec<Judged> = pairs
            .iter()
            .zip(drift)
            .map(|((_, run), drift)| Judged { record: &run.record, seconds: seconds_of(run), drift })
            .collect();
        self.write(|| junit(&judged, strict))?;
        if self.annotations.is_some() {
            let place = |case: &Judged| {
                let study =
                    pairs.iter().find(|(_, run)| std::ptr::eq(&run.record, case.record)).map(|(study, _)| *study);
                study.map_or_else(|| (String::new(), 1), |study| place(study, &case.record.case))
            };
            say!("{}", github(&judged, strict, place));
        }
        Ok(())
    }

    /// Tells of what stopped a run. The failure itself is told by whoever called, so what cannot be written is dropped.
    pub fn tell_failure(&self, failure: &Failure) {
        let message = failure.to_string();
        let _ = self.write(|| junit_of_bad_input(&message));
        if self.annotations.is_some() {
            say!("{}", github_bad_input(&message));
        }
    }

    fn write(&self, text: impl FnOnce() -> Result<String, ReportError>) -> Result<(), Failure> {
        let Some(path) = &self.junit else { return Ok(()) };
        store::write_atomic(path, text()?).map_err(|e| Failure::new(e.to_string(), OTHER_FILE))
    }
}

/// The study's file, from the current folder, and the line on which the case begins.
fn place(study: &Study, case: &str) -> (String, usize) {
    let root = std::env::current_dir().unwrap_or_default();
    let text = std::fs::read_to_string(&study.source).unwrap_or_default();
    (relative(Path::new(&study.source), &root), line_of_case(&text, case))
}

/// The line of the case's `name` after a line `[[case]]`; 1 where it has none.
fn line_of_case(text: &str, case: &str) -> usize {
    let name = format!("name=\"{case}\"");
    let bare = |line: &str| line.split('#').next().unwrap_or_default().replace([' ', '\t'], "");
    let mut in_case = false;
    for (number, line) in text.lines().enumerate() {
        let line = bare(line);
        if line.starts_with('[') {
            in_case = line == "[[case]]";
        } else if in_case && line == name {
            return number + 1;
        }
    }
    1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_begins_where_its_name_stands() {
        let text = "id = \"a\"\n[[body]]\nname = \"b\"\n\n[[case]]\nname = \"a\"\n[[case]]\nname  = \"b\" # second\n[[case.body]]\nname = \"c\"\n";
        assert_eq!(["a", "b", "c"].map(|case| line_of_case(text, case)), [6, 8, 1]);
    }
}
