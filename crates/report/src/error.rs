//! Why a report could not be made.

use std::path::PathBuf;

/// What stops a table, a picture or a page from being made or written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The file system refused.
    #[error("report: cannot write {path}: {source}")]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The CSV writer refused.
    #[error("report: csv: {0}")]
    Csv(#[from] csv::Error),
    /// The JSON writer refused.
    #[error("report: json: {0}")]
    Json(#[from] serde_json::Error),
    /// The picture could not be drawn or encoded.
    #[error("report: picture: {0}")]
    Picture(String),
    /// A number is NaN or infinite: the record is not to be trusted, and JSON has no word for it.
    #[error("report: {place} is {value}; a missing number must be null")]
    NonFinite {
        /// Where, e.g. `column strain, row 3`.
        place: String,
        /// `NaN`, `inf` or `-inf`.
        value: f64,
    },
}
