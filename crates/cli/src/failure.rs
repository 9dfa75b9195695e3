//! What stops the program, in the form `error:` … `hint:` ….

use signorini_report::ReportError;
use signorini_study::error::RunError;
use signorini_study::file::{LibraryError, StudyError};
use signorini_study::store::StoreError;
use std::fmt;

/// Bad input, or a file system that refuses.
#[derive(Debug)]
pub struct Failure {
    what: String,
    hint: Option<String>,
}

impl Failure {
    /// A failure with the next step.
    pub fn new(what: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { what: what.into(), hint: Some(hint.into()) }
    }

    /// An error of a study's run, with the study and case that it belongs to.
    pub fn of_run(study: &str, error: &RunError) -> Self {
        Self {
            what: format!("{study}: {error}"),
            hint: Some(format!("`signorini check {study}` repeats everything but the solve")),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(f, "error: {}", self.what)?;
        self.hint.iter().try_for_each(|hint| writeln!(f, "hint: {hint}"))
    }
}

impl From<StudyError> for Failure {
    fn from(e: StudyError) -> Self {
        // The study's own message ends with `next: …`; that line is the hint.
        let text = e.to_string();
        match text.rsplit_once("\nnext: ") {
            Some((what, next)) => Self::new(what, next),
            None => Self { what: text, hint: None },
        }
    }
}

impl From<(String, RunError)> for Failure {
    fn from((case, error): (String, RunError)) -> Self {
        Self::of_run(&case, &error)
    }
}

impl From<LibraryError> for Failure {
    fn from(e: LibraryError) -> Self {
        Self::new(e.to_string(), "`signorini list` shows every study; `signorini --help` every command")
    }
}

impl From<StoreError> for Failure {
    fn from(e: StoreError) -> Self {
        Self { what: e.to_string(), hint: None }
    }
}

impl From<ReportError> for Failure {
    fn from(e: ReportError) -> Self {
        Self { what: e.to_string(), hint: None }
    }
}
