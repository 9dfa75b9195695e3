//! `signorini new`: a study file to start from, with a comment on every key.

use crate::failure::Failure;
use clap::{Args, ValueEnum};
use signorini_study::file::{EVERYTHING, Group};
use signorini_study::{schema, store};
use std::path::{Path, PathBuf};

/// Arguments of `new`.
#[derive(Args, Debug, Clone)]
pub struct NewArgs {
    /// Name of the study and of its file: lower-case letters, digits, `-` and `.`.
    #[arg(value_name = "NAME")]
    pub name: String,
    /// What errors are measured against.
    #[arg(long, value_enum, default_value_t = Start::Overkill)]
    pub reference: Start,
}

/// `--reference`.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// A finer mesh: a block pressed on another, whose solution nobody knows.
    Overkill,
    /// An exact solution given by its traces on the contact line: Theorem 3.1.
    Exact,
}

impl Start {
    fn template(self) -> &'static str {
        match self {
            Self::Overkill => include_str!("new/overkill.toml"),
            Self::Exact => include_str!("new/exact.toml"),
        }
    }
}

/// The schema that ships with a checkout, from its root.
const SHIPPED_SCHEMA: &str = "docs/schemas/study.schema.json";
/// The one that is written beside a study elsewhere.
const OWN_SCHEMA: &str = "study.schema.json";

/// Writes the file, into `studies/` where there is one, and says what to do with it.
pub fn new(args: &NewArgs) -> Result<u8, Failure> {
    check_name(&args.name)?;
    let folder = if Path::new("studies").is_dir() { PathBuf::from("studies") } else { PathBuf::new() };
    let path = folder.join(format!("{}.toml", args.name));
    if path.exists() {
        let what = format!("{} is there already", path.display());
        return Err(Failure::new(what, "take another name, or move the file away"));
    }
    let schema = schema_beside(&folder)?;
    let text = args.reference.template().replace("NAME", &args.name).replace("SCHEMA", &schema);
    store::write_atomic(&path, text)?;
    let study = if folder.as_os_str().is_empty() { path.display().to_string() } else { args.name.clone() };
    sayln!("{} written. Next:", path.display());
    sayln!("  signorini check {study}     # everything but the solve");
    sayln!("  signorini run {study}       # solve, measure, judge");
    Ok(0)
}

fn check_name(name: &str) -> Result<(), Failure> {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-' || c == '.';
    if !name.starts_with(|c: char| c.is_ascii_lowercase() || c.is_ascii_digit()) || !name.chars().all(plain) {
        let hint = "use lower-case letters, digits, `-` and `.`, starting with a letter or digit, e.g. my-press";
        return Err(Failure::new(format!("`{name}` cannot name a study"), hint));
    }
    if name.ends_with(".toml") {
        let hint = format!("leave the ending out: {}", name.trim_end_matches(".toml"));
        return Err(Failure::new(format!("`{name}` is the name of a file, not of a study"), hint));
    }
    if name == EVERYTHING || Group::ALL.iter().any(|group| group.folder() == name) {
        return Err(Failure::new(format!("`{name}` names a group of studies"), "take another name"));
    }
    Ok(())
}

/// The schema for the first line of a study in `folder`, as an editor finds it from there: that of the checkout, or one
/// that is written beside the study.
fn schema_beside(folder: &Path) -> Result<String, Failure> {
    if folder == Path::new("studies") && Path::new(SHIPPED_SCHEMA).is_file() {
        return Ok(format!("../{SHIPPED_SCHEMA}"));
    }
    let path = folder.join(OWN_SCHEMA);
    if !path.exists() {
        store::write_atomic(&path, schema::text(&schema::study()))?;
    }
    Ok(format!("./{OWN_SCHEMA}"))
}
