//! Finished draws on disk: one line each, so that a search goes on where it was interrupted.
//!
//! `draws.jsonl` starts with a line that names target, seed and program version; results of another search are discarded. Lines are
//! appended as draws end, in any order; a last line cut short is dropped. A finished search leaves them in order.

use super::measure::Measured;
use super::target::Target;
use crate::store::{StoreError, write_atomic};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

#[derive(PartialEq, Serialize, Deserialize)]
struct Head {
    target: String,
    seed: u64,
    version: String,
}

/// The results of one search.
pub struct State {
    path: PathBuf,
    head: Head,
    /// What was found before, by number.
    pub known: BTreeMap<usize, Measured>,
    file: Mutex<File>,
}

impl State {
    /// Opens the file in `folder`, with the results of the same search if there are any.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn open(folder: &Path, target: Target, seed: u64, version: &str) -> Result<Self, StoreError> {
        let path = folder.join("draws.jsonl");
        let head = Head { target: target.about().id.into(), seed, version: version.into() };
        let known = read(&path, &head);
        write_atomic(&path, text(&head, &known))?;
        let file = OpenOptions::new().append(true).open(&path).map_err(io(&path))?;
        Ok(Self { path, head, known, file: Mutex::new(file) })
    }

    /// Keeps a result.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn keep(&self, measured: &Measured) -> Result<(), StoreError> {
        let mut file = self.file.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        file.write_all(line(measured).as_bytes()).map_err(io(&self.path))
    }

    /// Rewrites the file with all results in order.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(&self, all: &[Measured]) -> Result<(), StoreError> {
        let mut known = self.known.clone();
        known.extend(all.iter().map(|m| (m.index, m.clone())));
        write_atomic(&self.path, text(&self.head, &known))
    }
}

fn io(path: &Path) -> impl FnOnce(std::io::Error) -> StoreError + use<> {
    let path = path.to_path_buf();
    move |source| StoreError::Io { path, source }
}

fn read(path: &Path, head: &Head) -> BTreeMap<usize, Measured> {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let mut lines = text.lines();
    let same = lines.next().and_then(|l| serde_json::from_str::<Head>(l).ok()).is_some_and(|h| h == *head);
    let kept = lines.filter(|_| same).filter_map(|l| serde_json::from_str::<Measured>(l).ok());
    kept.map(|m| (m.index, m)).collect()
}

fn text(head: &Head, known: &BTreeMap<usize, Measured>) -> String {
    let head = serde_json::to_string(head).unwrap_or_default();
    known.values().fold(head + "\n", |text, m| text + &line(m))
}

/// One line; every number in it is finite.
fn line(measured: &Measured) -> String {
    serde_json::to_string(measured).unwrap_or_default() + "\n"
}
