//! Files: records of a run, its summary, and the baselines of the repository.
//!
//! ```text
//! reports/                          reference/
//!   <id>/record.json                  <id>.json        a Baseline, written by bless
//!   <id>/<case>/record.json
//!   summary.json
//! ```
//!
//! Every file is written whole or not at all.

mod atomic;
pub mod baseline;
mod drift;
mod records;
mod summary;

pub use atomic::{remove_if_present, write_atomic};
pub use baseline::Baseline;
pub use drift::{Drift, drift};
pub use records::{read_record, read_records, record_folder, write_record};
pub use summary::{SummaryRow, read_summary, write_summary};

use crate::record::RecordError;
use std::path::{Path, PathBuf};

/// A file that cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// The file system refused.
    #[error("{}: {source}", path.display())]
    Io {
        /// Which file or folder.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The contents cannot be stored, or are no record, summary or baseline.
    #[error("{}: {source}", path.display())]
    Content {
        /// Which file.
        path: PathBuf,
        /// What is wrong with it.
        source: RecordError,
    },
    /// An id or case that is no plain folder name.
    #[error("'{0}' cannot name a folder: use letters, digits, '-', '_' and '.', not first")]
    Name(String),
}

impl StoreError {
    pub(crate) fn io(path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| Self::Io { path, source }
    }

    pub(crate) fn content(path: &Path) -> impl FnOnce(RecordError) -> Self {
        let path = path.to_path_buf();
        move |source| Self::Content { path, source }
    }
}

/// Reads a text file.
fn read(path: &Path) -> Result<String, StoreError> {
    std::fs::read_to_string(path).map_err(StoreError::io(path))
}

/// Reads a JSON file.
pub(crate) fn read_json<T: serde::de::DeserializeOwned>(path: &Path) -> Result<T, StoreError> {
    serde_json::from_str(&read(path)?).map_err(|e| StoreError::content(path)(e.into()))
}

/// Writes any value as JSON.
fn write_json(path: &Path, value: &impl serde::Serialize) -> Result<(), StoreError> {
    let text = crate::record::to_json(value).map_err(StoreError::content(path))?;
    write_atomic(path, &text)
}

#[cfg(test)]
pub(crate) mod scratch {
    //! A folder for one test, removed at its end.

    use std::path::PathBuf;

    pub(crate) struct Scratch(pub PathBuf);

    impl Scratch {
        pub fn new(test: &str) -> Self {
            let path = std::env::temp_dir().join(format!("signorini-{test}-{}", std::process::id()));
            std::fs::create_dir_all(&path).expect("the temporary folder can be written");
            Self(path)
        }
    }

    impl Drop for Scratch {
        fn drop(&mut self) {
            let _ = std::fs::remove_dir_all(&self.0);
        }
    }
}
