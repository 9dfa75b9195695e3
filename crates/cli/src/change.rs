//! `--set` and `--sweep`: keys of study files overridden.

use crate::failure::Failure;
use crate::run::library;
use clap::Args;
use signorini_study::change::{Changes, Refused};
use signorini_study::study::Study;

/// Arguments of every command that reads studies.
#[derive(Args, Debug, Clone, Default)]
#[command(next_help_heading = "Keys of the study")]
pub struct ChangeArgs {
    /// Give a key of the study file another value, e.g. body.upper.material.poisson=0.49; repeatable.
    ///
    /// A key is a path through the file: names of fields, and of a list's entries their name, their number from 0, or * for all. Values are
    /// TOML; words that are none are text. The records of a changed study go to a folder of their own.
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Make a case for each of these values of a key, e.g. 'body.*.material.poisson=0.3,0.4'; repeatable: every combination.
    #[arg(long, value_name = "KEY=A,B,…")]
    pub sweep: Vec<String>,
}

impl ChangeArgs {
    /// What they ask for.
    pub fn changes(&self) -> Result<Changes, Failure> {
        Ok(Changes::read(&self.set, &self.sweep)?)
    }
}

/// Reads the studies that the names stand for, changed.
pub fn load_changed(names: &[String], changes: &Changes) -> Result<Vec<Study>, Failure> {
    let sources = library()?.select(names)?;
    sources.iter().map(|s| s.load_changed(changes).map_err(Failure::from)).collect()
}

impl From<Refused> for Failure {
    fn from(refused: Refused) -> Self {
        Self::new(refused.message, refused.next)
    }
}
