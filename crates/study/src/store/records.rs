//! Records in a tree of folders: `<id>/record.json`, or `<id>/<case>/record.json` where a study has several cases.

use super::{StoreError, read, write_atomic};
use crate::record::StudyRecord;
use std::fs;
use std::path::{Path, PathBuf};

const FILE: &str = "record.json";

/// Folder of a record below `root`.
///
/// # Errors
/// [`StoreError::Name`] where study or case cannot name a folder.
pub fn record_folder(root: &Path, record: &StudyRecord) -> Result<PathBuf, StoreError> {
    let folder = root.join(plain(&record.study)?);
    Ok(if record.several { folder.join(plain(&record.case)?) } else { folder })
}

/// Writes a record to its place below `root` and returns the file.
///
/// # Errors
/// [`StoreError::Content`] for a record with a non-finite number, [`StoreError::Name`], [`StoreError::Io`].
pub fn write_record(root: &Path, record: &StudyRecord) -> Result<PathBuf, StoreError> {
    let path = record_folder(root, record)?.join(FILE);
    let text = record.to_json().map_err(StoreError::content(&path))?;
    write_atomic(&path, &text)?;
    Ok(path)
}

/// Reads one record.
///
/// # Errors
/// [`StoreError::Io`], or [`StoreError::Content`] for a file that is no record of this schema.
pub fn read_record(path: &Path) -> Result<StudyRecord, StoreError> {
    StudyRecord::from_json(&read(path)?).map_err(StoreError::content(path))
}

/// Reads every record below `root`, by study and case in the order of their names. Hidden folders (unfinished cases) are
/// passed over.
///
/// # Errors
/// [`StoreError`] of the first folder or file that cannot be read: a broken record is not left out in silence.
pub fn read_records(root: &Path) -> Result<Vec<StudyRecord>, StoreError> {
    let mut paths = Vec::new();
    for study in folders(root)? {
        paths.push(study.join(FILE));
        paths.extend(folders(&study)?.into_iter().map(|case| case.join(FILE)));
    }
    paths.iter().filter(|p| p.is_file()).map(|p| read_record(p)).collect()
}

/// Folders in `folder` that are not hidden, sorted by name.
fn folders(folder: &Path) -> Result<Vec<PathBuf>, StoreError> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(StoreError::io(folder))? {
        let entry = entry.map_err(StoreError::io(folder))?;
        let hidden = entry.file_name().to_string_lossy().starts_with('.');
        if !hidden && entry.path().is_dir() {
            found.push(entry.path());
        }
    }
    found.sort();
    Ok(found)
}

/// Refuses names that would leave the tree or hide in it.
pub(super) fn plain(name: &str) -> Result<&str, StoreError> {
    let allowed = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.');
    if name.is_empty() || name.starts_with('.') || !name.chars().all(allowed) {
        return Err(StoreError::Name(name.into()));
    }
    Ok(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::RecordError;
    use crate::sample;
    use crate::store::scratch::Scratch;

    fn record(study: &str, case: &str) -> StudyRecord {
        sample::record(study, case, sample::levels(4, |h| h))
    }

    #[test]
    fn a_tree_of_records_is_read_back_in_order() {
        let scratch = Scratch::new("tree");
        let written = [record("a", "a"), record("b", "alpha-1.5"), record("b", "structured"), record("c", "c")];
        for r in written.iter().rev() {
            write_record(&scratch.0, r).unwrap();
        }
        assert!(scratch.0.join("a/record.json").is_file() && scratch.0.join("b/alpha-1.5/record.json").is_file());
        fs::create_dir_all(scratch.0.join("a/.partial")).unwrap();
        fs::write(scratch.0.join("a/.partial/record.json"), "half a rec").unwrap();
        assert_eq!(read_records(&scratch.0).unwrap(), written);
    }

    #[test]
    fn a_broken_record_is_named() {
        let scratch = Scratch::new("broken");
        let path = write_record(&scratch.0, &record("a", "a")).unwrap();
        fs::write(&path, "{").unwrap();
        let error = read_records(&scratch.0).unwrap_err().to_string();
        assert!(error.contains("record.json"), "{error}");
        assert!(matches!(read_records(&scratch.0.join("nowhere")), Err(StoreError::Io { .. })));
    }

    #[test]
    fn a_record_with_a_broken_number_is_not_written() {
        let scratch = Scratch::new("number");
        let mut bad = record("a", "a");
        bad.levels[0].errors.l2 = Some(f64::NAN);
        let refused = write_record(&scratch.0, &bad);
        assert!(matches!(refused, Err(StoreError::Content { source: RecordError::NonFinite { .. }, .. })));
        assert!(!scratch.0.join("a").exists());
    }

    #[test]
    fn names_stay_inside_the_tree() {
        for name in ["", "..", "../a", "/a", ".partial", "a/b", "a\\b", "a b"] {
            assert!(matches!(plain(name), Err(StoreError::Name(_))), "{name}");
        }
        assert!(plain("alpha-1.5").is_ok() && plain("theorem_3-1").is_ok());
    }
}
