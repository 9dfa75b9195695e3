//! One table model for every output: [Markdown](Table::to_markdown), [LaTeX](Table::to_latex), [CSV](Table::to_csv),
//! [JSON](Table::to_json) and [plain text](Table::to_text).

mod data;
mod latex;
mod markdown;
pub(crate) mod text;

use crate::format;
pub use data::json_text;
pub use latex::tex;

/// Columns, rows, and which rows are only shown, not used.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The columns, from the left.
    pub columns: Vec<Column>,
    /// The rows; each has one cell per column.
    pub rows: Vec<Row>,
}

/// A column: its key for programs, its heading for readers.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name in CSV and JSON.
    pub key: String,
    /// Heading in Markdown and plain text.
    pub heading: String,
}

impl Column {
    /// A column of that key and heading.
    pub fn new(key: impl Into<String>, heading: impl Into<String>) -> Self {
        Self { key: key.into(), heading: heading.into() }
    }
}

/// One row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// One cell per column.
    pub cells: Vec<Cell>,
    /// Why the row does not count; `None` if it does.
    pub excluded: Option<String>,
}

/// One value.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// No value: `–` for readers, empty in CSV, `null` in JSON.
    Missing,
    /// A count.
    Count(usize),
    /// A measured number: five significant digits for readers, all of them in CSV and JSON.
    Number(f64),
    /// A rate: three decimals for readers.
    Rate(f64),
    /// A bound: a fraction for readers.
    Bound(f64),
    /// Words.
    Text(String),
    /// A number in words, as with its spread: set like a number.
    Figure(String),
    /// Yes or no.
    Flag(bool),
}

impl Cell {
    /// A measured number, or none.
    pub fn number(x: Option<f64>) -> Self {
        x.map_or(Self::Missing, Self::Number)
    }

    /// A rate, or none.
    pub fn rate(x: Option<f64>) -> Self {
        x.map_or(Self::Missing, Self::Rate)
    }

    /// A bound, or none.
    pub fn bound(x: Option<f64>) -> Self {
        x.map_or(Self::Missing, Self::Bound)
    }

    /// A count, or none.
    pub fn count(n: Option<usize>) -> Self {
        n.map_or(Self::Missing, Self::Count)
    }

    /// Words.
    pub fn text(words: impl Into<String>) -> Self {
        Self::Text(words.into())
    }

    /// A number in words.
    pub fn figure(words: impl Into<String>) -> Self {
        Self::Figure(words.into())
    }

    /// As a reader sees it.
    pub fn display(&self) -> String {
        match self {
            Self::Missing => format::MISSING.into(),
            Self::Count(n) => n.to_string(),
            Self::Number(x) => format::significant(*x, 5),
            Self::Rate(x) => format::rate(*x),
            Self::Bound(x) => format::bound(*x),
            Self::Text(words) | Self::Figure(words) => words.clone(),
            Self::Flag(true) => "yes".into(),
            Self::Flag(false) => "no".into(),
        }
    }

    /// The `f64` behind the cell, if there is one.
    fn float(&self) -> Option<f64> {
        match self {
            Self::Number(x) | Self::Rate(x) | Self::Bound(x) => Some(*x),
            _ => None,
        }
    }

    /// Whether words, which are set flush left; numbers are set flush right.
    fn is_words(&self) -> bool {
        matches!(self, Self::Text(_))
    }
}

impl Table {
    /// The table without the columns of these keys.
    pub(crate) fn without(self, keys: &[&str]) -> Self {
        let keep: Vec<usize> =
            (0..self.columns.len()).filter(|&c| !keys.contains(&self.columns[c].key.as_str())).collect();
        let of = |row: Row| Row { cells: keep.iter().map(|&c| row.cells[c].clone()).collect(), ..row };
        let columns = keep.iter().map(|&c| self.columns[c].clone()).collect();
        Self { columns, rows: self.rows.into_iter().map(of).collect() }
    }

    /// Whether words stand in the column.
    fn column_is_words(&self, column: usize) -> bool {
        self.rows.iter().any(|row| row.cells.get(column).is_some_and(Cell::is_words))
    }
}
