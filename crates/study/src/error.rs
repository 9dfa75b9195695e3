//! Why a study could not be run.

use crate::external::ExternalError;
use crate::study::{Case, Study};

/// Meaningless input or a file that cannot be used; a solve that ended badly is part of the record instead.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The discrete problem refused its input.
    #[error(transparent)]
    Contact(#[from] signorini_contact::Error),
    /// The exact solution breaks a condition that it claims.
    #[error("exact solution: {0}")]
    Exact(String),
    /// The same, in one of several cases.
    #[error("case '{case}': {source}")]
    InCase {
        /// Which case.
        case: String,
        /// What is wrong with it.
        source: Box<Self>,
    },
    /// Another program that was to solve a level has not.
    #[error("{0}")]
    External(String),
    /// The run was asked to stop; levels that were done are kept.
    #[error("interrupted")]
    Interrupted,
    /// No reference solution.
    #[error("reference: {0}")]
    Reference(String),
    /// The study asks for something that does not fit together.
    #[error("{0}")]
    Study(String),
    /// A file cannot be read or written.
    #[error(transparent)]
    Store(#[from] crate::store::StoreError),
    /// A record cannot be written or read.
    #[error(transparent)]
    Record(#[from] crate::record::RecordError),
}

impl RunError {
    /// Names the case, where the study has several.
    pub fn in_case(self, study: &Study, case: &Case) -> Self {
        if study.cases.len() == 1 {
            return self;
        }
        Self::InCase { case: case.name.clone(), source: Box::new(self) }
    }

    /// Whether an external solver is to blame.
    pub fn is_of_external(&self) -> bool {
        match self {
            Self::InCase { source, .. } => source.is_of_external(),
            other => matches!(other, Self::External(_)),
        }
    }

    /// Whether the run was asked to stop.
    pub fn is_interruption(&self) -> bool {
        match self {
            Self::InCase { source, .. } => source.is_interruption(),
            other => matches!(other, Self::Interrupted),
        }
    }

    /// Whether a file or folder is to blame, and not the study.
    pub fn is_of_files(&self) -> bool {
        match self {
            Self::InCase { source, .. } => source.is_of_files(),
            other => matches!(other, Self::Store(_)),
        }
    }
}

impl From<ExternalError> for RunError {
    fn from(e: ExternalError) -> Self {
        match e {
            ExternalError::Store(e) => Self::Store(e),
            refused => Self::External(refused.to_string()),
        }
    }
}
