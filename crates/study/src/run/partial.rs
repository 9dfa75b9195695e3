//! Unfinished cases: finished levels are kept until the case is done, so that an interrupted run resumes.
//!
//! `<out>/.partial/<study>@<case>@<key>/level-3.json`, where the key hashes everything that the levels depend on: study
//! text, profile, sizes, solver settings and the program's version. Levels kept under another key belong to another
//! problem and are discarded; the folder of a finished case goes, and at the end of the run the empty `.partial`.

use super::RunSettings;
use super::level::Task;
use super::timing::LevelTimes;
use crate::error::RunError;
use crate::record::{Level, to_json};
use crate::store;
use crate::study::{Case, Study};
use serde::{Deserialize, Serialize};
use std::fs::DirEntry;
use std::path::{Path, PathBuf};

/// Where a case keeps its finished levels.
pub struct Partial {
    folder: Option<PathBuf>,
}

#[derive(Serialize, Deserialize)]
struct Kept {
    level: Level,
    times: LevelTimes,
}

impl Partial {
    /// The folder of this case under these settings, if the run keeps one.
    pub fn open(study: &Study, case: &Case, settings: &RunSettings, task: &Task) -> Result<Self, RunError> {
        let Some(root) = &settings.partial else { return Ok(Self { folder: None }) };
        let what = format!(
            "{}\n{}\n{}\n{:?}\n{:?}\n{:?}\n{}",
            study.id,
            case.name,
            case.fingerprint(),
            settings.profile,
            task.cells,
            task.settings,
            env!("CARGO_PKG_VERSION")
        );
        // No id and no case has an '@' in its name.
        let owner = format!("{}@{}@", study.id, case.name);
        let folder = root.join(format!("{owner}{:016x}", signorini_contact::mesh::fnv1a(what.as_bytes())));
        discard_others(root, &owner, &folder);
        Ok(Self { folder: Some(folder) })
    }

    /// The kept level, or the one that `measure` makes, which is then kept. A kept level that does not parse is measured
    /// again.
    pub fn level(
        &self,
        index: usize,
        measure: impl FnOnce() -> Result<(Level, LevelTimes), RunError>,
    ) -> Result<(Level, LevelTimes), RunError> {
        let Some(folder) = &self.folder else { return measure() };
        let path = folder.join(format!("level-{index}.json"));
        let kept = std::fs::read_to_string(&path).ok().and_then(|text| serde_json::from_str::<Kept>(&text).ok());
        if let Some(kept) = kept {
            return Ok((kept.level, kept.times));
        }
        let (level, times) = measure()?;
        let kept = Kept { level, times };
        store::write_atomic(&path, &to_json(&kept)?)?;
        Ok((kept.level, kept.times))
    }

    /// The case is done and written: its kept levels go.
    pub fn discard(&self) {
        if let Some(folder) = &self.folder {
            // A folder that cannot be removed costs space, not truth: its key no longer matters to a finished case.
            let _ = std::fs::remove_dir_all(folder);
        }
    }
}

/// Removes the folder of unfinished cases, unless one of them still keeps something there.
pub fn tidy(settings: &RunSettings) {
    if let Some(root) = &settings.partial {
        // Refused where it is not empty, which is what is wanted.
        let _ = std::fs::remove_dir(root);
    }
}

/// Removes what the case kept under other settings: nothing will ask for it again.
fn discard_others(root: &Path, owner: &str, folder: &Path) {
    let entries = std::fs::read_dir(root).into_iter().flatten().flatten();
    let stale = |e: &DirEntry| e.file_name().to_string_lossy().starts_with(owner) && e.path() != folder;
    for entry in entries.filter(stale) {
        let _ = std::fs::remove_dir_all(entry.path());
    }
}
