//! Names: which are allowed, and which was probably meant.

use super::error::{Fault, refuse};
use crate::nearest::nearest;
use std::ops::Range;

/// `did you mean …?` if a candidate is near, else the list of all, if there are any.
pub fn suggestion(word: &str, candidates: &[&str]) -> String {
    if candidates.is_empty() {
        return "there is none yet: add it, or leave the name out".into();
    }
    match nearest(word, candidates.iter().copied()) {
        Some(c) => format!("did you mean `{c}`?"),
        None => format!("use one of: {}", candidates.join(", ")),
    }
}

/// Checks a name that becomes the name of a folder.
pub fn folder_name(what: &str, word: &str, span: Range<usize>) -> Result<(), Fault> {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-' || c == '.';
    if word.starts_with(|c: char| c.is_ascii_alphanumeric()) && word.chars().all(plain) {
        return Ok(());
    }
    let next = "use lower-case letters, digits, `-` and `.`, starting with a letter or digit: it names a folder";
    refuse(span, format!("{what} `{word}` cannot name a folder"), next)
}
