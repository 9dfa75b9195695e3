//! Numbers out of a file, written as text or as bytes: the sections of both forms list the same ones.

use super::error::{MshError, Place};
use std::str::FromStr;

/// How the numbers of a section are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Decimal, between blanks.
    Text,
    /// `i32`, `u64` and `f64`, lowest byte first.
    LittleEndian,
    /// The same, highest byte first.
    BigEndian,
}

/// A place in a file and what follows it.
pub struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    /// The form of the numbers that follow.
    pub form: Form,
    /// Whether places are offsets: a binary file has no lines.
    pub binary: bool,
    /// Line of `at`, counted as far as `counted`.
    line: usize,
    counted: usize,
}

const WHOLE_FILE: &str = "the file ends too early or is damaged: save the mesh again";

impl<'a> Cursor<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, form: Form::Text, binary: false, line: 1, counted: 0 }
    }

    /// Where the cursor stands.
    pub fn place(&mut self) -> Place {
        if self.binary {
            return Place::Byte(self.at);
        }
        self.line += self.bytes[self.counted..self.at].iter().filter(|b| **b == b'\n').count();
        self.counted = self.at;
        Place::Line(self.line)
    }

    /// `Err` at the cursor.
    pub fn refuse<T>(&mut self, message: impl Into<String>, next: impl Into<String>) -> Result<T, MshError> {
        Err(MshError::at(self.place(), message, next))
    }

    /// The next word of the text; none at the end of the file.
    pub fn word(&mut self) -> Option<&'a [u8]> {
        while self.bytes.get(self.at)?.is_ascii_whitespace() {
            self.at += 1;
        }
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.at += length;
        Some(&rest[..length])
    }

    /// The rest of the line, without the blanks around it.
    pub fn rest_of_line(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len());
        self.at += length;
        rest[..length].trim_ascii()
    }

    /// Goes behind the line's end, where bytes begin.
    pub fn end_line(&mut self) {
        self.rest_of_line();
        self.at = (self.at + 1).min(self.bytes.len());
    }

    /// Goes behind the next occurrence of `mark`; whether there is one.
    pub fn skip_behind(&mut self, mark: &[u8]) -> bool {
        let found = self.bytes[self.at..].windows(mark.len()).position(|w| w == mark);
        self.at = found.map_or(self.bytes.len(), |k| self.at + k + mark.len());
        found.is_some()
    }

    /// The word that has to stand here.
    pub fn expect(&mut self, word: &str) -> Result<(), MshError> {
        let found = self.word();
        if found == Some(word.as_bytes()) {
            return Ok(());
        }
        let message = format!("{} where {word} should stand", shown(found));
        self.refuse(message, "correct the count of what stands before it, or save the mesh again")
    }

    /// A whole number with sign: tags of entities and of physical groups, kinds, dimensions.
    pub fn int(&mut self, what: &str) -> Result<i32, MshError> {
        match self.form {
            Form::Text => self.parsed(what),
            Form::LittleEndian => self.take(what).map(i32::from_le_bytes),
            Form::BigEndian => self.take(what).map(i32::from_be_bytes),
        }
    }

    /// A number that counts, or the tag of a node or element.
    pub fn size(&mut self, what: &str) -> Result<u64, MshError> {
        match self.form {
            Form::Text => self.parsed(what),
            Form::LittleEndian => self.take(what).map(u64::from_le_bytes),
            Form::BigEndian => self.take(what).map(u64::from_be_bytes),
        }
    }

    /// A coordinate, which must be finite.
    pub fn real(&mut self, what: &str) -> Result<f64, MshError> {
        let x = match self.form {
            Form::Text => self.parsed(what),
            Form::LittleEndian => self.take(what).map(f64::from_le_bytes),
            Form::BigEndian => self.take(what).map(f64::from_be_bytes),
        }?;
        if x.is_finite() {
            return Ok(x);
        }
        self.refuse(format!("{what} is {x}"), "coordinates must be finite: correct the geometry and mesh it again")
    }

    fn parsed<T: FromStr>(&mut self, what: &str) -> Result<T, MshError> {
        let word = self.word();
        let number = word.and_then(|w| std::str::from_utf8(w).ok()).and_then(|w| w.parse().ok());
        match number {
            Some(number) => Ok(number),
            None if word.is_none() => self.refuse(format!("the file ends where {what} should stand"), WHOLE_FILE),
            None => self.refuse(format!("{} is no number, where {what} should stand", shown(word)), "correct it"),
        }
    }

    fn take<const N: usize>(&mut self, what: &str) -> Result<[u8; N], MshError> {
        match self.bytes[self.at..].first_chunk() {
            Some(chunk) => {
                self.at += N;
                Ok(*chunk)
            }
            None => self.refuse(format!("the file ends where {what} should stand"), WHOLE_FILE),
        }
    }
}

/// A word as it appears in a message.
pub fn shown(word: Option<&[u8]>) -> String {
    match word {
        None => "the end of the file".into(),
        Some(word) => {
            let text: String = String::from_utf8_lossy(word).chars().take(40).flat_map(char::escape_default).collect();
            format!("`{text}`")
        }
    }
}
