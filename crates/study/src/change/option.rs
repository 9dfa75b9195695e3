//! What was typed: `key=value`, `key=a,b,c`.

use super::Refused;
use std::fmt;
use toml::Value;

/// A key and the values that it gets.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Assignment {
    /// The argument.
    pub text: String,
    /// What stands before `=`.
    pub key: String,
    /// The key cut at its dots.
    pub steps: Vec<String>,
    /// The values as typed, and as TOML.
    pub values: Vec<(String, Value)>,
    /// Whether the values are swept.
    pub swept: bool,
}

impl Assignment {
    /// The argument of `--set`: one value.
    pub fn set(text: &str) -> Result<Self, Refused> {
        Self::read(text, false)
    }

    /// The argument of `--sweep`: values with commas between them.
    pub fn sweep(text: &str) -> Result<Self, Refused> {
        Self::read(text, true)
    }

    fn read(text: &str, swept: bool) -> Result<Self, Refused> {
        let (name, form) = if swept { ("--sweep", "--sweep key=a,b,c") } else { ("--set", "--set key=value") };
        let example = format!(
            "write `{form}`, e.g. `{name} body.upper.material.poisson={}`",
            if swept { "0.3,0.4" } else { "0.4" }
        );
        let refuse = |what: &str| Err(Refused::new(format!("{name} {text}: {what}"), example.clone()));
        let Some((key, value)) = text.split_once('=') else { return refuse("no `=`") };
        let steps: Vec<String> = split(key.trim(), '.').iter().map(|s| unquoted(s)).collect();
        if steps.iter().any(String::is_empty) {
            return refuse("a key, or a part of it between dots, is empty");
        }
        let words = if swept { split(value, ',') } else { vec![value] };
        let values: Vec<(String, Value)> = words.iter().map(|w| (w.trim().to_owned(), read_value(w.trim()))).collect();
        if values.iter().any(|(word, _)| word.is_empty()) {
            return refuse("a value is missing");
        }
        if let Some(k) = (1..values.len()).find(|&k| values[..k].iter().any(|v| v.1 == values[k].1)) {
            return refuse(&format!("the value {} stands there twice", values[k].0));
        }
        Ok(Self { text: text.to_owned(), key: key.trim().to_owned(), steps, values, swept })
    }
}

impl fmt::Display for Assignment {
    /// As it is typed in a shell.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain = |c: char| c.is_ascii_alphanumeric() || ".,=-+_/".contains(c);
        let option = if self.swept { "--sweep" } else { "--set" };
        if self.text.chars().all(plain) {
            write!(f, "{option} {}", self.text)
        } else {
            write!(f, "{option} '{}'", self.text.replace('\'', r"'\''"))
        }
    }
}

/// A value of TOML; a word that is none is text, so that names and expressions need no quotes.
fn read_value(word: &str) -> Value {
    let parsed: Option<toml::Table> = format!("v = {word}").parse().ok();
    let value = parsed.filter(|t| t.len() == 1).and_then(|mut t| t.remove("v"));
    value.unwrap_or_else(|| Value::String(word.to_owned()))
}

/// The pieces between separators, but for those within brackets or quotes.
fn split(text: &str, separator: char) -> Vec<&str> {
    let (mut depth, mut quote, mut start) = (0_usize, None, 0);
    let mut pieces = Vec::new();
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(q), _) if c == q => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, '(' | '[' | '{') => depth += 1,
            (None, ')' | ']' | '}') => depth = depth.saturating_sub(1),
            (None, _) if c == separator && depth == 0 => {
                pieces.push(&text[start..at]);
                start = at + c.len_utf8();
            }
            (None, _) => {}
        }
    }
    pieces.push(&text[start..]);
    pieces
}

/// A step of a key, which needs quotes where it holds a dot.
fn unquoted(step: &str) -> String {
    let within = |q: char| step.strip_prefix(q).and_then(|s| s.strip_suffix(q));
    within('"').or_else(|| within('\'')).unwrap_or(step).to_owned()
}
