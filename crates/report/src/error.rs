//! Why a report could not be made.

use signorini_study::store::StoreError;

/// What stops a table, a picture or a page from being made or written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file cannot be written, or would hold a number that is none.
    #[error("report: {0}")]
    Store(#[from] StoreError),
    /// The CSV writer refused.
    #[error("report: csv: {0}")]
    Csv(#[from] csv::Error),
    /// The XML writer refused.
    #[error("report: junit: {0}")]
    Junit(String),
    /// The JSON writer refused.
    #[error("report: json: {0}")]
    Json(#[from] serde_json::Error),
    /// The page could not be put together.
    #[error("report: page: {0}")]
    Page(String),
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
