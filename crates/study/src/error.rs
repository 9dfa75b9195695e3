//! Why a study could not be run.

/// Meaningless input or a file that cannot be used; a solve that ended badly is part of the record instead.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The discrete problem refused its input.
    #[error(transparent)]
    Contact(#[from] signorini_contact::Error),
    /// The exact solution breaks a condition that it claims.
    #[error("exact solution: {0}")]
    Exact(String),
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
