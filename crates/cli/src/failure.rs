//! What stops the program, in the form `error:` … `hint:` ….

use crate::args::COMMANDS;
use crate::interrupt;
use signorini_report::ReportError;
use signorini_study::error::RunError;
use signorini_study::file::{LibraryError, StudyError};
use signorini_study::nearest::nearest;
use signorini_study::store::StoreError;
use signorini_study::study::Study;
use signorini_study::verdict::BAD_INPUT;
use std::fmt;

const OTHER_FOLDER: &str = "free the path, or name another folder with --out";

const MEND_SOLVER: &str =
    "run the command by hand in that folder; docs/own-solver.md says what it finds there and what it must leave";

/// Bad input, or a file system that refuses.
#[derive(Debug)]
pub struct Failure {
    what: String,
    hint: Option<String>,
    status: u8,
}

impl Failure {
    /// A failure with the next step.
    pub fn new(what: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { what: what.into(), hint: Some(hint.into()), status: BAD_INPUT }
    }

    /// A failure that speaks for itself.
    fn bare(what: impl Into<String>) -> Self {
        Self { what: what.into(), hint: None, status: BAD_INPUT }
    }

    /// The same with another exit status than that of bad input.
    pub fn with_status(self, status: u8) -> Self {
        Self { status, ..self }
    }

    /// The exit status.
    pub fn status(&self) -> u8 {
        self.status
    }

    /// Whether the user asked to stop.
    pub fn is_interruption(&self) -> bool {
        self.status == interrupt::STATUS
    }

    /// An error of a study's run, with the file that the study was read from.
    pub fn of_run(study: &Study, error: &RunError) -> Self {
        if error.is_interruption() {
            return Self::bare("interrupted").with_status(interrupt::STATUS);
        }
        if error.is_of_files() {
            // the study is not to blame, so it is not named
            return Self::new(error.to_string(), OTHER_FOLDER);
        }
        let what = format!("{}: {error}", study.source.display());
        if error.is_of_external() {
            return Self::new(what, MEND_SOLVER);
        }
        Self::new(
            what,
            format!("mend the study; `signorini check {}` tries everything but the solve", study.id_of_file()),
        )
    }
}

impl From<RunError> for Failure {
    fn from(e: RunError) -> Self {
        Self::bare(e.to_string())
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
            None => Self::bare(text),
        }
    }
}

impl From<LibraryError> for Failure {
    fn from(e: LibraryError) -> Self {
        let list = "`signorini list` shows every study, `signorini --help` every command";
        // A mistyped command is taken for a study.
        let command = match &e {
            LibraryError::Unknown { name, .. } => nearest(name, COMMANDS),
            LibraryError::Empty(_) => None,
        };
        match command {
            Some(command) => Self::new(e.to_string(), format!("or did you mean `signorini {command}`? {list}")),
            None => Self::new(e.to_string(), list),
        }
    }
}

impl From<StoreError> for Failure {
    fn from(e: StoreError) -> Self {
        let what = e.to_string();
        match e {
            StoreError::Io { .. } => Self::new(what, OTHER_FOLDER),
            StoreError::Content { .. } => {
                Self::new(what, "delete the file and write it anew: `run` for records, `bless` for baselines")
            }
            StoreError::Name(_) => Self::bare(what),
        }
    }
}

impl From<ReportError> for Failure {
    fn from(e: ReportError) -> Self {
        match e {
            ReportError::Store(e) => Self::from(e),
            other => Self::bare(other.to_string()),
        }
    }
}
