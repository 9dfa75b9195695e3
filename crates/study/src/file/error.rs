//! What is wrong with a study file, where, and what to do next.

use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A study file that cannot be used.
///
/// Prints `path:line:column: what is wrong`, the line with a caret below the culprit, and the next step.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyError {
    /// The file.
    pub path: PathBuf,
    /// Where in the file; `None` if it cannot be read at all.
    pub position: Option<Position>,
    /// What is wrong, with the value and the bound that it breaks.
    pub message: String,
    /// What to do next.
    pub next: String,
}

/// A place in a text file.
#[derive(Clone, Debug, PartialEq)]
pub struct Position {
    /// From 1.
    pub line: usize,
    /// In characters, from 1.
    pub column: usize,
    /// The whole line.
    pub source: String,
    /// Characters of the line that are meant, at least 1.
    pub width: usize,
}

impl std::error::Error for StudyError {}

impl fmt::Display for StudyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.path.display())?;
        if let Some(p) = &self.position {
            write!(f, "{}:{}:", p.line, p.column)?;
        }
        writeln!(f, " {}", self.message)?;
        if let Some(p) = &self.position {
            let margin = " ".repeat(p.line.to_string().len());
            writeln!(f, " {margin} |\n {} | {}", p.line, p.source)?;
            writeln!(f, " {margin} | {}{}", " ".repeat(p.column - 1), "^".repeat(p.width))?;
        }
        write!(f, "next: {}", self.next)
    }
}

/// The place of the bytes `span` in `text`.
pub(super) fn position(text: &str, span: Range<usize>) -> Position {
    let start = floor_to_char(text, span.start);
    let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
    let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
    let end = floor_to_char(text, span.end).clamp(start, line_end);
    Position {
        line: text[..start].matches('\n').count() + 1,
        column: text[line_start..start].chars().count() + 1,
        // A tab counts as one column, so it is shown as one blank.
        source: text[line_start..line_end].trim_end_matches('\r').replace('\t', " "),
        width: text[start..end].chars().count().max(1),
    }
}

fn floor_to_char(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0)
}

/// An error before it knows its file: the culprit's bytes, the complaint, the next step.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fault {
    pub span: Range<usize>,
    pub message: String,
    pub next: String,
}

impl Fault {
    pub fn new(span: Range<usize>, message: impl Into<String>, next: impl Into<String>) -> Self {
        Self { span, message: message.into(), next: next.into() }
    }

    /// The error of the file `path` with the given text.
    pub fn locate(self, path: &Path, text: &str) -> StudyError {
        StudyError {
            path: path.to_path_buf(),
            position: Some(position(text, self.span)),
            message: self.message,
            next: self.next,
        }
    }
}

/// `Err` with a [`Fault`].
pub(super) fn refuse<T>(span: Range<usize>, message: impl Into<String>, next: impl Into<String>) -> Result<T, Fault> {
    Err(Fault::new(span, message, next))
}
