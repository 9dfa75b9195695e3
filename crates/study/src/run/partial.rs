//! Unfinished cases: finished levels are kept until the case is done, so that an interrupted run resumes.
//!
//! `<out>/.partial/<key>/level-3.json`, where the key hashes everything that the levels depend on: study text, profile,
//! sizes, solver settings and the program's version. Another key is another folder; the folder of a finished case goes.

use super::RunSettings;
use super::level::Task;
use super::timing::LevelTimes;
use crate::error::RunError;
use crate::record::{Level, to_json};
use crate::store;
use crate::study::{Case, Study};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

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
        let folder = root.join(format!("{:016x}", signorini_contact::mesh::fnv1a(what.as_bytes())));
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
