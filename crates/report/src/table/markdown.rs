//! A table for readers: Markdown with aligned columns.

use super::{Row, Table};

impl Table {
    /// A Markdown table. A row that does not count is set in italics and marked `†`, its reason below the table.
    pub fn to_markdown(&self) -> String {
        self.to_markdown_above(&self.footnotes())
    }

    /// The same with other words below the table.
    pub fn to_markdown_above(&self, notes: &str) -> String {
        let headings = self.columns.iter().map(|c| escape(&c.heading)).collect();
        let rules =
            (0..self.columns.len()).map(|c| if self.column_is_words(c) { "---" } else { "---:" }.to_string()).collect();
        let mut out = line(headings) + &line(rules);
        for row in &self.rows {
            out += &line(cells(row));
        }
        out + notes
    }

    /// The rows that do not count, with their reasons, below the table.
    pub(super) fn footnotes(&self) -> String {
        let notes: Vec<String> = self
            .rows
            .iter()
            .filter_map(|row| row.excluded.as_ref().map(|why| (row, why)))
            .map(|(row, why)| format!("† {} {} is left out of the fit: {why}.", self.row_word(), first(row)))
            .collect();
        if notes.is_empty() { String::new() } else { format!("\n{}\n", notes.join("  \n")) }
    }

    /// What a row is: the heading of the first column.
    fn row_word(&self) -> &str {
        self.columns.first().map_or("row", |c| c.heading.as_str())
    }
}

/// Keeps `|` and line breaks inside a cell.
pub(crate) fn escape(text: &str) -> String {
    text.replace('|', "\\|").replace(['\n', '\r'], " ")
}

fn first(row: &Row) -> String {
    row.cells.first().map_or_else(String::new, super::Cell::display)
}

fn cells(row: &Row) -> Vec<String> {
    let greyed = row.excluded.is_some();
    let shown = row.cells.iter().map(|cell| escape(&cell.display()));
    if !greyed {
        return shown.collect();
    }
    shown.enumerate().map(|(i, text)| if i == 0 { format!("*{text}* †") } else { format!("*{text}*") }).collect()
}

fn line(cells: Vec<String>) -> String {
    format!("| {} |\n", cells.join(" | "))
}
