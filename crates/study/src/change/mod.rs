//! Keys of a study file that options override: `--set key=value`, and `--sweep key=a,b,c`, which makes cases of the values.
//!
//! ```text
//! text ──► tables ──set──► every case complete in the keys ──sweep──► a case for each combination ──► text ──► Study
//! ```
//!
//! The changed tables go through the same reader as a file, so that everything that is refused there is refused here, in the name of the
//! options. A changed study has an id of its own, with a `_` that no file's id may hold: its records, the levels that it keeps and its
//! baselines never meet those of the plain study.
//!
//! Reading order: `option` (what was typed), `edit` (one key), `cases` (all keys), `label` (names).

mod cases;
mod edit;
mod label;
mod option;
#[cfg(test)]
mod tests;

use crate::file::StudyError;
use crate::record::Changed;
use crate::study::Study;
use cases::Made;
use option::Assignment;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What options change of a study; nothing by default.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Typed", into = "Typed")]
pub struct Changes {
    set: Vec<Assignment>,
    sweep: Vec<Assignment>,
}

/// The options as they were typed.
#[derive(Clone, Default, Serialize, Deserialize)]
struct Typed {
    set: Vec<String>,
    sweep: Vec<String>,
}

/// An option that cannot be carried out: what is wrong, and what to do next.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct Refused {
    /// The option, the key, and what is wrong.
    pub message: String,
    /// What to do next.
    pub next: String,
}

impl Refused {
    fn new(message: impl Into<String>, next: impl Into<String>) -> Self {
        Self { message: message.into(), next: next.into() }
    }
}

impl Changes {
    /// The changes that these arguments of `--set` and `--sweep` ask for.
    ///
    /// # Errors
    /// An argument that is no `key=value`, or a key that is given twice.
    pub fn read(set: &[String], sweep: &[String]) -> Result<Self, Refused> {
        let one = |text: &String| Assignment::set(text);
        let several = |text: &String| Assignment::sweep(text);
        let changes = Self {
            set: set.iter().map(one).collect::<Result<_, _>>()?,
            sweep: sweep.iter().map(several).collect::<Result<_, _>>()?,
        };
        changes.each_key_once()?;
        Ok(changes)
    }

    /// Whether nothing is changed.
    pub fn is_none(&self) -> bool {
        self.set.is_empty() && self.sweep.is_empty()
    }

    /// Whether values are swept, so that a study may have more cases than its file.
    pub fn sweeps(&self) -> bool {
        !self.sweep.is_empty()
    }

    /// The study of the text with the changes. `path` is named in messages.
    ///
    /// # Errors
    /// What the file itself is refused for, with its place; a key that does not exist; what the changed study is refused for, with the
    /// options.
    pub fn apply(&self, text: &str, path: &Path) -> Result<Study, StudyError> {
        self.apply_by(text, path, |text| Study::parse(text, path))
    }

    /// The same where another reader knows where the study's mesh files are.
    pub(crate) fn apply_by(
        &self,
        text: &str,
        path: &Path,
        read: impl Fn(&str) -> Result<Study, StudyError>,
    ) -> Result<Study, StudyError> {
        let plain = read(text)?;
        if self.is_none() {
            return Ok(plain);
        }
        let (changed, made) = cases::changed(text, &plain, self).map_err(|refused| of_option(path, refused))?;
        let mut study = read(&changed).map_err(|e| self.blamed(e))?;
        self.name(&mut study, made);
        Ok(study)
    }

    fn all(&self) -> impl Iterator<Item = &Assignment> {
        self.set.iter().chain(&self.sweep)
    }

    fn each_key_once(&self) -> Result<(), Refused> {
        let all: Vec<&Assignment> = self.all().collect();
        for (k, option) in all.iter().enumerate() {
            if all[..k].iter().any(|other| other.steps == option.steps) {
                let message = format!("{option}: `{}` is given twice", option.key);
                return Err(Refused::new(message, "name each key once"));
            }
        }
        Ok(())
    }

    /// The options, as they are typed.
    fn options(&self) -> Vec<String> {
        self.all().map(ToString::to_string).collect()
    }

    /// An error of the changed study: its lines are no lines of the file, so the options stand in place of the place.
    fn blamed(&self, e: StudyError) -> StudyError {
        let near = e.position.map(|p| p.source.trim().to_owned()).filter(|s| s.chars().count() <= LONGEST_EXCERPT);
        let near = near.map_or(String::new(), |s| format!(", in `{s}`"));
        let message = format!("with {}: {}{near}", self.options().join(" "), e.message);
        StudyError { position: None, message, ..e }
    }

    /// Gives the changed study its own id, and its cases what was changed in them.
    fn name(&self, study: &mut Study, made: Vec<Made>) {
        let id = label::id(&study.id, self);
        for (case, made) in study.cases.iter_mut().zip(made) {
            // a parameter of the file keeps its name
            for (name, number) in made.numbers {
                case.parameters.entry(name).or_insert(number);
            }
            case.changed = Some(Changed {
                study: study.id.clone(),
                case: made.from,
                options: self.options(),
                settings: made.settings,
            });
            if case.name == study.id {
                case.name.clone_from(&id);
            }
        }
        study.id = id;
    }
}

/// A line of the changed study that is longer helps nobody.
const LONGEST_EXCERPT: usize = 80;

fn of_option(path: &Path, refused: Refused) -> StudyError {
    StudyError { path: path.to_path_buf(), position: None, message: refused.message, next: refused.next }
}

impl TryFrom<Typed> for Changes {
    type Error = Refused;

    fn try_from(typed: Typed) -> Result<Self, Refused> {
        Self::read(&typed.set, &typed.sweep)
    }
}

impl From<Changes> for Typed {
    fn from(changes: Changes) -> Self {
        let texts = |list: Vec<Assignment>| list.into_iter().map(|a| a.text).collect();
        Self { set: texts(changes.set), sweep: texts(changes.sweep) }
    }
}
