//! `signorini schema`: JSON Schema of what is read and written.

use crate::failure::Failure;
use clap::ValueEnum;
use signorini_study::schema;

/// What the schema is of.
#[derive(ValueEnum, Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// Study files: for completion and checks in an editor.
    Study,
    /// Records, `record.json`: for programs that read them.
    Record,
}

/// Prints it.
pub fn schema(of: Of) -> Result<u8, Failure> {
    let schema = match of {
        Of::Study => schema::study(),
        Of::Record => schema::record(),
    };
    say!("{}", schema::text(&schema));
    Ok(0)
}
