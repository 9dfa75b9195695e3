//! A file is there whole or not at all.

use super::StoreError;
use std::fs::{self, File};
use std::io::Write;
use std::path::Path;

/// Writes `contents`, text or bytes, to `path`: into a temporary file of the same folder, to the disk, then under its name. A reader sees the
/// old file or the new one. Creates missing folders.
///
/// # Errors
/// [`StoreError::Io`]; the old file then stays as it was.
pub fn write_atomic(path: &Path, contents: impl AsRef<[u8]>) -> Result<(), StoreError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    if !folder.as_os_str().is_empty() {
        fs::create_dir_all(folder).map_err(StoreError::io(folder))?;
    }
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    // the process id keeps two programs that write the same file apart
    let temporary = folder.join(format!(".{name}.{}.tmp", std::process::id()));
    let written = write_through(&temporary, contents.as_ref()).and_then(|()| fs::rename(&temporary, path));
    written.map_err(|source| {
        // the first error is the one to report; the leftover may not even exist
        let _ = fs::remove_file(&temporary);
        StoreError::io(path)(source)
    })
}

/// Removes what an earlier run left at `path`; no file is no error.
///
/// # Errors
/// [`StoreError::Io`] if the file is there and stays.
pub fn remove_if_present(path: &Path) -> Result<(), StoreError> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(StoreError::io(path)(e)),
        _ => Ok(()),
    }
}

fn write_through(path: &Path, contents: &[u8]) -> std::io::Result<()> {
    let mut file = File::create(path)?;
    file.write_all(contents)?;
    file.sync_all()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::scratch::Scratch;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn a_file_is_replaced_and_nothing_else_is_left() {
        let scratch = Scratch::new("replace");
        let path = scratch.0.join("a/b/record.json");
        write_atomic(&path, "old").unwrap();
        write_atomic(&path, "new").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
        assert_eq!(names(path.parent().unwrap()), ["record.json"]);
    }

    #[test]
    fn a_failed_write_leaves_what_was_there() {
        let scratch = Scratch::new("failed");
        // a folder with contents cannot be replaced by a file
        let path = scratch.0.join("record.json");
        fs::create_dir_all(path.join("inside")).unwrap();
        assert!(matches!(write_atomic(&path, "new"), Err(StoreError::Io { .. })));
        assert_eq!(names(&scratch.0), ["record.json"]);
        assert_eq!(names(&path), ["inside"]);
    }
}
