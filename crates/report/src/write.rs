//! Files that are either whole or not there.

use crate::error::ReportError;
use std::fs;
use std::path::{Path, PathBuf};

/// Writes `bytes` to a temporary file beside `path`, then renames it; makes the folder if it is missing.
///
/// A reader sees the old file or the new one, never a part.
///
/// # Errors
/// [`ReportError::Io`] with the path that failed.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), ReportError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|e| at(folder, e))?;
    }
    let partial = partial_name(path);
    fs::write(&partial, bytes).map_err(|e| at(&partial, e))?;
    fs::rename(&partial, path).map_err(|e| at(path, e))
}

/// Removes what an earlier run left at `path`; no file is no error.
///
/// # Errors
/// [`ReportError::Io`] if the file is there and stays.
pub fn remove_if_present(path: &Path) -> Result<(), ReportError> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(at(path, e)),
        _ => Ok(()),
    }
}

/// `folder/.name.partial`
fn partial_name(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.partial"))
}

fn at(path: &Path, source: std::io::Error) -> ReportError {
    ReportError::Io { path: path.to_path_buf(), source }
}
