//! The first step: TOML text to tables.

use super::error::Fault;
use super::raw::RawStudy;
use crate::nearest::nearest;

/// The tables of the text.
pub fn tables(text: &str) -> Result<RawStudy, Fault> {
    toml::from_str(text).map_err(|e| {
        let span = e.span().unwrap_or(0..0);
        let message = plain(&e.message().trim().replace('\n', "; "));
        let next = next_step(&message);
        Fault::new(span, message, next)
    })
}

/// The parser's message without the names of our types.
fn plain(message: &str) -> String {
    ["usize", "u64"].iter().fold(message.to_owned(), |m, name| {
        m.replace(&format!("expected {name}"), "expected a whole number, zero or positive")
    })
}

/// What to do about the parser's message. It quotes the culprit first, then what it knows, all in backticks.
fn next_step(message: &str) -> String {
    let quoted: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    if let (true, [word, known @ ..]) = (message.starts_with("unknown "), &quoted[..])
        && let Some(meant) = nearest(word, known.iter().copied())
    {
        return format!("did you mean `{meant}`?");
    }
    match &quoted[..] {
        [name] if message.starts_with("missing field") => {
            format!("add `{name} = …`; studies/README.md says what it means")
        }
        [name] if message.starts_with("duplicate") => format!("keep one `{name}`"),
        _ => "correct it; studies/README.md describes every field".into(),
    }
}
