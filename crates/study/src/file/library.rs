//! Where study files are: `studies/` in the current folder or one of its parents, else the shipped ones.
//!
//! ```text
//! studies/*.toml            run by default
//! studies/hard/*.toml       run when named, or by the group `hard`
//! studies/controls/*.toml   planted defects; run when named, or by the group `controls`
//! ```

use super::error::StudyError;
use super::mesh_file::Files;
use super::shipped::SHIPPED;
use super::words::suggestion;
use crate::change::Changes;
use crate::study::Study;
use std::path::{Path, PathBuf};

/// A group of studies that runs under one name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// `studies/`: what runs when nothing is named.
    Standard,
    /// `studies/hard/`.
    Hard,
    /// `studies/controls/`.
    Controls,
}

impl Group {
    /// All groups in the order in which they are listed and run.
    pub const ALL: [Self; 3] = [Self::Standard, Self::Hard, Self::Controls];

    /// The folder below `studies/`, empty for the standard group.
    pub fn folder(self) -> &'static str {
        match self {
            Self::Standard => "",
            Self::Hard => "hard",
            Self::Controls => "controls",
        }
    }
}

/// The word that stands for all groups.
pub const EVERYTHING: &str = "everything";

/// A study that can be read.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// Its id: the stem of its file.
    pub id: String,
    /// The group that its folder makes it belong to.
    pub group: Group,
    /// Its file; for a shipped study the file that it was when the program was built.
    pub path: PathBuf,
    /// The text of a shipped study.
    shipped: Option<&'static str>,
}

impl Source {
    /// Reads and resolves the study.
    ///
    /// # Errors
    /// As [`Study::load`].
    pub fn load(&self) -> Result<Study, StudyError> {
        self.load_changed(&Changes::default())
    }

    /// The same with what options change of it.
    ///
    /// # Errors
    /// As [`Changes::apply`].
    pub fn load_changed(&self, changes: &Changes) -> Result<Study, StudyError> {
        match self.shipped {
            Some(text) => {
                let files = Files::Shipped(self.group.folder());
                changes.apply_by(text, &self.path, |text| Study::parse_with(text, &self.path, &files))
            }
            None => changes.apply(&super::text(&self.path)?, &self.path),
        }
    }

    fn of_file(path: &Path, group: Group) -> Self {
        let id = path.file_stem().map_or_else(String::new, |s| s.to_string_lossy().into_owned());
        Self { id, group, path: path.to_path_buf(), shipped: None }
    }
}

/// The studies at hand.
#[derive(Clone, Debug, PartialEq)]
pub struct Library {
    /// The folder they come from; `None`: shipped with the program.
    pub folder: Option<PathBuf>,
    /// By group, then by id.
    pub sources: Vec<Source>,
}

/// Names that select no study.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LibraryError {
    /// Neither an id, nor a group, nor a file.
    #[error("there is no study `{name}`; {hint}")]
    Unknown {
        /// What was asked for.
        name: String,
        /// The nearest id, or all of them.
        hint: String,
    },
    /// A group without studies.
    #[error("the group `{0}` holds no study; put one into studies/{0}/")]
    Empty(String),
}

/// The studies in `studies/` of `start` or of its nearest parent that has some, else the shipped ones.
pub fn find_studies(start: &Path) -> Library {
    let found = start.ancestors().map(|f| f.join("studies")).map(|f| (files(&f), f)).find(|(s, _)| !s.is_empty());
    match found {
        Some((sources, folder)) => Library { folder: Some(folder), sources },
        None => shipped(),
    }
}

/// The studies that were built into the program.
pub fn shipped() -> Library {
    let source = |(group, id, text): &(Group, &str, &'static str)| Source {
        id: (*id).into(),
        group: *group,
        path: Path::new("studies").join(group.folder()).join(format!("{id}.toml")),
        shipped: Some(text),
    };
    Library { folder: None, sources: SHIPPED.iter().map(source).collect() }
}

fn files(studies: &Path) -> Vec<Source> {
    Group::ALL.into_iter().flat_map(|group| files_of(&studies.join(group.folder()), group)).collect()
}

fn files_of(folder: &Path, group: Group) -> Vec<Source> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path());
    let mut paths: Vec<PathBuf> = entries.filter(|p| p.extension().is_some_and(|e| e == "toml")).collect();
    // The system lists files in any order.
    paths.sort();
    paths.iter().map(|p| Source::of_file(p, group)).collect()
}

impl Library {
    /// The studies of one group, by id.
    pub fn group(&self, group: Group) -> impl Iterator<Item = &Source> {
        self.sources.iter().filter(move |s| s.group == group)
    }

    /// The studies that the names stand for, each once, in the order of the names. A name is an id, a path to a `.toml`,
    /// `hard`, `controls` or `everything`; no names mean the standard group.
    ///
    /// # Errors
    /// A name that stands for nothing, with the nearest id.
    pub fn select(&self, names: &[String]) -> Result<Vec<Source>, LibraryError> {
        if names.is_empty() {
            return Ok(self.group(Group::Standard).cloned().collect());
        }
        let mut selected: Vec<Source> = Vec::new();
        for name in names {
            for source in self.named(name)? {
                if !selected.iter().any(|s| s.path == source.path) {
                    selected.push(source);
                }
            }
        }
        Ok(selected)
    }

    fn named(&self, name: &str) -> Result<Vec<Source>, LibraryError> {
        if name == EVERYTHING {
            return Ok(self.sources.clone());
        }
        if let Some(group) = Group::ALL.into_iter().find(|g| !name.is_empty() && g.folder() == name) {
            let members: Vec<Source> = self.group(group).cloned().collect();
            return if members.is_empty() { Err(LibraryError::Empty(name.into())) } else { Ok(members) };
        }
        if Path::new(name).extension().is_some_and(|e| e == "toml") {
            return Ok(vec![Source::of_file(Path::new(name), Group::Standard)]);
        }
        match self.sources.iter().find(|s| s.id == name) {
            Some(source) => Ok(vec![source.clone()]),
            None => Err(self.unknown(name)),
        }
    }

    fn unknown(&self, name: &str) -> LibraryError {
        let mut known: Vec<&str> = self.sources.iter().map(|s| s.id.as_str()).collect();
        known.extend(["hard", "controls", EVERYTHING]);
        LibraryError::Unknown { name: name.into(), hint: suggestion(name, &known) }
    }
}
