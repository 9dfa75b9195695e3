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
    /// Keeps nothing: for levels that are measured faster than they are kept.
    pub fn none() -> Self {
        Self { folder: None }
    }

    /// The folder of this case under these settings, if the run keeps one.
    pub fn open(study: &Study, case: &Case, settings: &RunSettings, task: &Task) -> Result<Self, RunError> {
        let Some(root) = &settings.partial else { return Ok(Self::none()) };
        let what = format!(
            "{}\n{}\n{}\n{:?}\n{:?}\n{:?}\n{:?}\n{}",
            study.id,
            case.name,
            case.fingerprint(),
            settings.profile,
            task.cells,
            task.settings,
            task.keep,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::Profile;
    use crate::sample;
    use crate::store::scratch::Scratch;

    type Measured = Result<(Level, LevelTimes), RunError>;

    fn measured() -> Measured {
        Ok((sample::level(2, 0.125), LevelTimes { solve: 0.5, ..Default::default() }))
    }

    fn never() -> Measured {
        panic!("a kept level is measured again")
    }

    fn open(root: &Scratch, cells: &[usize]) -> Partial {
        let study = sample::study("theorem-3-1-smooth");
        let case = &study.cases[0];
        let partial = Some(root.0.clone());
        let settings =
            RunSettings { profile: Profile::Quick, levels: None, solver: None, partial, keep: Default::default() };
        let scene = case.scene().unwrap();
        let task = Task { keep: settings.keep.clone(), ..Task::new(case, scene, cells, case.solver) };
        Partial::open(&study, case, &settings, &task).unwrap()
    }

    #[test]
    fn a_finished_level_is_read_back_and_not_measured_again() {
        let root = Scratch::new("resume");
        let first = open(&root, &[8, 16]).level(1, measured).unwrap();
        assert_eq!(open(&root, &[8, 16]).level(1, never).unwrap(), first);
        // another level, other sizes: nothing is kept for them
        assert!(open(&root, &[8, 16]).level(0, || Err(RunError::Study("measured".into()))).is_err());
        assert!(open(&root, &[8, 32]).level(1, || Err(RunError::Study("measured".into()))).is_err());
    }

    #[test]
    fn half_a_level_is_measured_again() {
        let root = Scratch::new("half");
        let partial = open(&root, &[8]);
        partial.level(0, measured).unwrap();
        let file = partial.folder.as_ref().unwrap().join("level-0.json");
        std::fs::write(&file, "{ \"level\":").unwrap();
        assert_eq!(partial.level(0, measured).unwrap(), measured().unwrap());
        assert!(partial.level(0, never).is_ok());
    }

    #[test]
    fn nothing_stays_of_a_finished_case_and_a_failed_level_is_not_kept() {
        let root = Scratch::new("close");
        let partial = open(&root, &[8]);
        assert!(partial.level(0, || Err(RunError::Study("no".into()))).is_err());
        partial.level(1, measured).unwrap();
        let folder = partial.folder.clone().unwrap();
        assert!(folder.join("level-1.json").is_file() && !folder.join("level-0.json").exists());
        partial.discard();
        assert!(!folder.exists());
    }
}
