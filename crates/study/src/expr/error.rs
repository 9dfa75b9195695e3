//! What is wrong with an expression, and where.

use std::fmt;

/// An expression that makes no sense.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExprError {
    /// What is wrong and what to do.
    pub message: String,
    /// Where it starts: characters from 1.
    pub column: usize,
    /// The whole expression.
    pub text: String,
}

impl fmt::Display for ExprError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Line breaks and tabs count as one character each, so that the caret stays under its column.
        let line: String = self.text.chars().map(flat).collect();
        let indent = " ".repeat(self.column.saturating_sub(1));
        write!(f, "{} (column {})\n  {line}\n  {indent}^", self.message, self.column)
    }
}

impl std::error::Error for ExprError {}

fn flat(c: char) -> char {
    if c.is_control() { ' ' } else { c }
}
