//! Fields beside the record of their case.
//!
//! ```text
//! <case>/record.json
//! <case>/fields/level-3.json        everything, for `report` to draw again; arrays are base64 of little-endian numbers
//!               level-3.vtu         both bodies, for ParaView
//!               level-3-zone.vtu    the contact zone
//!               level-3/*.npy       the arrays, for NumPy, of levels that were asked for
//! ```

use super::{Fields, npy, vtu};
use crate::record::RecordError;
use crate::store::{StoreError, read_json, write_atomic};
use serde::de::Error;
use std::fs;
use std::path::{Path, PathBuf};

const FOLDER: &str = "fields";

/// Writes the fields of a case into its folder. What an earlier run left there goes first: it belongs
/// to another record. Returns the files written.
///
/// # Errors
/// [`StoreError::Io`].
pub fn write_fields(case: &Path, levels: &[Fields]) -> Result<Vec<PathBuf>, StoreError> {
    let folder = case.join(FOLDER);
    clear(&folder)?;
    let mut written = Vec::new();
    for fields in levels {
        let name = format!("level-{}", fields.level);
        let json = serde_json::to_vec(fields).map_err(|e| StoreError::content(&folder)(RecordError::from(e)))?;
        let mut files = vec![
            (format!("{name}.json"), json),
            (format!("{name}.vtu"), vtu::bodies(fields).into_bytes()),
            (format!("{name}-zone.vtu"), vtu::zone(fields).into_bytes()),
        ];
        if fields.asked {
            files.extend(npy::files(fields).into_iter().map(|(file, bytes)| (format!("{name}/{file}"), bytes)));
        }
        for (file, bytes) in files {
            let path = folder.join(file);
            write_atomic(&path, bytes)?;
            written.push(path);
        }
    }
    Ok(written)
}

/// The fields that a case's folder holds, coarsest level first; none where it holds none.
///
/// # Errors
/// [`StoreError`] of the first file that cannot be read or holds no fields.
pub fn read_fields(case: &Path) -> Result<Vec<Fields>, StoreError> {
    let folder = case.join(FOLDER);
    if !folder.is_dir() {
        return Ok(Vec::new());
    }
    let mut levels = Vec::new();
    for path in ours(&folder)? {
        if path.extension().is_some_and(|e| e == "json") {
            let fields: Fields = read_json(&path)?;
            fields.check().map_err(|message| StoreError::content(&path)(serde_json::Error::custom(message).into()))?;
            levels.push(fields);
        }
    }
    levels.sort_by_key(|f| f.level);
    Ok(levels)
}

/// Removes what an earlier run wrote, and the folder if nothing else is in it.
fn clear(folder: &Path) -> Result<(), StoreError> {
    if !folder.is_dir() {
        return Ok(());
    }
    for path in ours(folder)? {
        let removed = if path.is_dir() { fs::remove_dir_all(&path) } else { fs::remove_file(&path) };
        removed.map_err(StoreError::io(&path))?;
    }
    // refused where somebody else keeps a file there, which then stays
    let _ = fs::remove_dir(folder);
    Ok(())
}

/// Files and folders that are named after a level.
fn ours(folder: &Path) -> Result<Vec<PathBuf>, StoreError> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(StoreError::io(folder))? {
        let entry = entry.map_err(StoreError::io(folder))?;
        if entry.file_name().to_string_lossy().starts_with("level-") {
            found.push(entry.path());
        }
    }
    found.sort();
    Ok(found)
}
