//! A table for the terminal: aligned plain text of a bounded width.

use super::Table;

/// Blanks between columns.
const GAP: usize = 2;
/// No column of words is cut below this.
const NARROWEST: usize = 8;

impl Table {
    /// Aligned plain text with a rule under the headings. Columns of words are cut, widest first, with `…` until
    /// every line has at most `width` characters or nothing is left to cut.
    pub fn to_text(&self, width: usize) -> String {
        let widths = self.fitted_widths(width);
        let headings: Vec<String> = self.columns.iter().map(|c| c.heading.clone()).collect();
        let rules: Vec<String> = widths.iter().map(|w| "─".repeat(*w)).collect();
        let mut out = self.text_line(&headings, &widths) + &self.text_line(&rules, &widths);
        for row in &self.rows {
            let cells: Vec<String> = row.cells.iter().map(super::Cell::display).collect();
            out += &self.text_line(&cells, &widths);
        }
        out
    }

    fn text_line(&self, cells: &[String], widths: &[usize]) -> String {
        let padded: Vec<String> = (cells.iter().zip(widths).enumerate())
            .map(|(c, (text, &width))| pad(&shorten(text, width), width, self.column_is_words(c)))
            .collect();
        padded.join(&" ".repeat(GAP)).trim_end().to_string() + "\n"
    }

    fn fitted_widths(&self, width: usize) -> Vec<usize> {
        let mut widths: Vec<usize> = (0..self.columns.len()).map(|c| self.natural_width(c)).collect();
        let gaps = GAP * widths.len().saturating_sub(1);
        while widths.iter().sum::<usize>() + gaps > width {
            let widest = (0..widths.len())
                .filter(|&c| self.column_is_words(c) && widths[c] > NARROWEST)
                .max_by_key(|&c| (widths[c], usize::MAX - c));
            match widest {
                Some(c) => widths[c] -= 1,
                None => break,
            }
        }
        widths
    }

    fn natural_width(&self, column: usize) -> usize {
        let heading = self.columns[column].heading.chars().count();
        let cells = self.rows.iter().filter_map(|row| row.cells.get(column));
        let widest = cells.map(|cell| cell.display().chars().count()).max();
        widest.unwrap_or(0).max(heading)
    }
}

/// `text`, or its beginning and `…` if it has more than `width` characters.
pub(crate) fn shorten(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_string();
    }
    let mut cut: String = text.chars().take(width.saturating_sub(1)).collect();
    cut.push('…');
    cut
}

/// `text` in lines of at most `width` characters, broken at blanks, later lines indented by `indent` blanks.
pub(crate) fn wrap(text: &str, width: usize, indent: usize) -> String {
    let mut out = String::new();
    let mut length = 0;
    for word in text.split_whitespace() {
        let size = word.chars().count();
        if length > 0 && length + 1 + size > width {
            out += &format!("\n{}", " ".repeat(indent));
            length = indent;
        } else if length > 0 {
            out.push(' ');
            length += 1;
        }
        out += word;
        length += size;
    }
    out
}

fn pad(text: &str, width: usize, left: bool) -> String {
    let blanks = " ".repeat(width.saturating_sub(text.chars().count()));
    if left { format!("{text}{blanks}") } else { format!("{blanks}{text}") }
}
