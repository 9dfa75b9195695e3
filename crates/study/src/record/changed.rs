//! What options changed of a study before it ran.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The study of the file, and what `--set` and `--sweep` made of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Changed {
    /// Id of the study in the file.
    pub study: String,
    /// The case of the file; the study's id where the file has no cases.
    pub case: String,
    /// The options, as they are typed in a shell.
    pub options: Vec<String>,
    /// Every key that was changed in this case, `--set` first.
    pub settings: Vec<Setting>,
}

/// A key of the study file and its value in place of the file's.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Setting {
    /// The key, e.g. `body.upper.material.poisson`.
    pub key: String,
    /// A short name, e.g. `poisson`.
    pub name: String,
    /// The value as typed.
    pub value: String,
    /// The same where it is a number.
    pub number: Option<f64>,
    /// Whether it is one of several that were swept.
    pub swept: bool,
}

impl Changed {
    /// The settings that tell the cases of a sweep apart.
    pub fn swept(&self) -> impl Iterator<Item = &Setting> {
        self.settings.iter().filter(|s| s.swept)
    }
}
