//! Study files: TOML in, a [`Study`] with everything resolved out, or a [`StudyError`] that shows the place.
//!
//! ```text
//! text ──parse──► tables (raw) ──layer: case over study──► resolve ──► Study { cases }
//! ```
//!
//! `studies/README.md` describes every field. [`library`] finds the files.

mod bilateral;
mod boundary;
mod canonical;
mod curve;
mod degenerate;
mod discretisation;
mod error;
mod exact;
mod expected;
mod field;
mod fixed;
mod formula;
mod imported;
mod initial_gap;
mod judge;
mod layer;
mod lemma;
pub mod library;
mod material;
mod mesh_file;
mod number;
mod parse;
mod plan;
pub(crate) mod raw;
mod resolve;
mod shape;
pub(crate) mod shipped;
mod slide;
mod spanned;
mod splitting;
#[cfg(test)]
mod tests;
mod traces;
mod words;

pub use error::{Position, StudyError};
pub use library::{EVERYTHING, Group, Library, LibraryError, Source, find_studies};

use crate::study::{Case, Study};
use mesh_file::Files;
use signorini_contact::mesh::fnv1a;
use std::path::Path;

impl Study {
    /// Reads the study file at `path`.
    ///
    /// # Errors
    /// The first thing in the file that makes no sense, with its place; or that the file cannot be read.
    pub fn load(path: &Path) -> Result<Self, StudyError> {
        Self::parse(&text(path)?, path)
    }

    /// Resolves the text of a study file. `path` is named in messages, and its stem must be the study's id; mesh files are
    /// looked for in its folder.
    ///
    /// # Errors
    /// As [`Study::load`].
    pub fn parse(text: &str, path: &Path) -> Result<Self, StudyError> {
        Self::parse_with(text, path, &Files::Beside(path))
    }

    /// Resolves the text of a study file whose mesh files are in `files`.
    fn parse_with(text: &str, path: &Path, files: &Files<'_>) -> Result<Self, StudyError> {
        let resolved = parse::tables(text).and_then(|mut raw| {
            mesh_file::attach(&mut raw, files)?;
            resolve::study(&raw, path)
        });
        resolved.map_err(|fault| fault.locate(path, text))
    }
}

/// The text of the file at `path`.
fn text(path: &Path) -> Result<String, StudyError> {
    std::fs::read_to_string(path).map_err(|e| StudyError {
        path: path.to_path_buf(),
        position: None,
        message: format!("cannot read the study: {e}"),
        next: "check the path, and that the file is UTF-8 text".into(),
    })
}

impl Case {
    /// 16 hex digits that change whenever anything changes that can move a number or the verdict: the FNV-1a hash of
    /// [`Case::canonical`].
    pub fn fingerprint(&self) -> String {
        format!("{:016x}", fnv1a(self.canonical.as_bytes()))
    }
}
