//! What is wrong with a mesh file, where, and what to do next.

use std::fmt;

/// A mesh file that cannot be used. Prints `line 12: what is wrong`, or `byte 345: …` in a binary part of the file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}{message}")]
pub struct MshError {
    /// Where in the file.
    pub place: Place,
    /// What is wrong, with the value and the bound that it breaks.
    pub message: String,
    /// What to do next.
    pub next: String,
}

/// A place in a mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Line of a text, from 1.
    Line(usize),
    /// Offset in a binary file, from 0.
    Byte(usize),
    /// The file as a whole; nodes and elements are then named by their tags.
    Whole,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(n) => write!(f, "line {n}: "),
            Self::Byte(n) => write!(f, "byte {n}: "),
            Self::Whole => Ok(()),
        }
    }
}

impl MshError {
    /// An error at a place.
    pub(super) fn at(place: Place, message: impl Into<String>, next: impl Into<String>) -> Self {
        Self { place, message: message.into(), next: next.into() }
    }

    /// An error of the mesh as a whole, or of nodes and elements that the message names.
    pub(super) fn whole(message: impl Into<String>, next: impl Into<String>) -> Self {
        Self::at(Place::Whole, message, next)
    }
}

/// `Err` of the mesh as a whole.
pub(crate) fn refuse<T>(message: impl Into<String>, next: impl Into<String>) -> Result<T, MshError> {
    Err(MshError::whole(message, next))
}
