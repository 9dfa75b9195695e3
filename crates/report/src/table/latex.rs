//! A table for papers: LaTeX with the rules of `booktabs`, numbers in scientific notation, no other package.

mod headings;
mod words;

use super::{Cell, Row, Table};
use headings::heading;
pub use words::tex;

/// What stands for a missing value.
const MISSING: &str = "--";

impl Table {
    /// A `table` float with its caption above, both in words that are escaped here. Columns of rates between successive
    /// levels are headed `EOC`. Needs `\usepackage{booktabs}`.
    pub fn to_latex(&self, caption: &str, label: &str) -> String {
        let notes = tex(self.footnotes().trim());
        let notes =
            if notes.is_empty() { String::new() } else { format!("  \\par\\smallskip{{\\footnotesize {notes}}}\n") };
        format!(
            "% needs \\usepackage{{booktabs}}\n\\begin{{table}}\n  \\centering\n  \\caption{{{}}}\n  \\label{{{}}}\n  \
             \\begin{{tabular}}{{{}}}\n    \\toprule\n{}    \\midrule\n{}    \\bottomrule\n  \\end{{tabular}}\n{notes}\\end{{table}}\n",
            tex(caption),
            label_of(label),
            self.alignments(),
            self.heading_line(),
            self.body_lines(),
        )
    }

    /// The same for many rows: a `longtable`, which breaks across pages and repeats its headings. Needs
    /// `\usepackage{booktabs,longtable}`.
    pub fn to_latex_long(&self, caption: &str, label: &str) -> String {
        let heading = self.heading_line();
        format!(
            "% needs \\usepackage{{booktabs,longtable}}\n\\begingroup\\footnotesize\\setlength{{\\tabcolsep}}{{4pt}}\n\\begin{{longtable}}{{{}}}\n    \\caption{{{}}}\\label{{{}}}\\\\\n    \
             \\toprule\n{heading}    \\midrule\n    \\endfirsthead\n    \\toprule\n{heading}    \\midrule\n    \\endhead\n    \
             \\bottomrule\n    \\endfoot\n{}\\end{{longtable}}\n\\endgroup\n",
            self.alignments(),
            tex(caption),
            label_of(label),
            self.body_lines(),
        )
    }

    fn alignments(&self) -> String {
        (0..self.columns.len()).map(|c| if self.column_is_words(c) { 'l' } else { 'r' }).collect()
    }

    fn heading_line(&self) -> String {
        line(self.columns.iter().map(heading))
    }

    fn body_lines(&self) -> String {
        self.rows.iter().map(|row| line(cells(row).into_iter())).collect()
    }
}

/// A row that does not count is slanted and marked.
fn cells(row: &Row) -> Vec<String> {
    let shown = row.cells.iter().map(cell);
    if row.excluded.is_none() {
        return shown.collect();
    }
    let slanted = shown.map(|text| format!("\\textit{{{text}}}"));
    slanted.enumerate().map(|(i, text)| if i == 0 { format!("{text}$^\\dagger$") } else { text }).collect()
}

fn line(cells: impl Iterator<Item = String>) -> String {
    format!("    {} \\\\\n", cells.collect::<Vec<_>>().join(" & "))
}

fn cell(cell: &Cell) -> String {
    match cell {
        Cell::Missing => MISSING.into(),
        Cell::Number(x) => scientific(*x),
        other => tex(&other.display()),
    }
}

/// Five significant digits and an exponent of at least two, as tables of convergence have them: `1.2346e-02`.
fn scientific(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".into() } else { MISSING.into() };
    }
    let text = format!("{:.4e}", x.abs());
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let sign = if x < 0.0 { "$-$" } else { "" };
    let (mark, power) = exponent.strip_prefix('-').map_or(("+", exponent), |power| ("-", power));
    format!("{sign}{digits}e{mark}{power:0>2}")
}

/// What `\label` takes: letters, digits and `-`; anything else becomes `-`.
fn label_of(text: &str) -> String {
    text.chars().map(|c| if c.is_ascii_alphanumeric() || c == ':' || c == '-' { c } else { '-' }).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Column;
    use super::*;

    #[test]
    fn numbers_have_five_digits_and_an_exponent_of_two() {
        for (x, text) in [
            (0.012345678, "1.2346e-02"),
            (-1.5e-9, "$-$1.5000e-09"),
            (12345.67, "1.2346e+04"),
            (1e-120, "1.0000e-120"),
            (0.0, "0"),
            (0.999999, "1.0000e+00"),
        ] {
            assert_eq!(scientific(x), text);
        }
    }

    #[test]
    fn a_table_of_convergence_reads_as_in_the_literature() {
        let columns = vec![Column::new("h", "h"), Column::new("strain", "strain"), Column::new("strain_rate", "rate")];
        let row = |h, e, rate, excluded: Option<&str>| Row {
            cells: vec![Cell::Number(h), Cell::Number(e), Cell::rate(rate)],
            excluded: excluded.map(String::from),
        };
        let rows = vec![row(0.5, 0.2, None, Some("3 % of it is quadrature")), row(0.25, 0.1, Some(1.0), None)];
        let text = Table { columns, rows }.to_latex("A & B", "tab:a_b");
        let expected = r"% needs \usepackage{booktabs}
\begin{table}
  \centering
  \caption{A \& B}
  \label{tab:a-b}
  \begin{tabular}{rrr}
    \toprule
    $h$ & $|u-u_h|$ & EOC \\
    \midrule
    \textit{5.0000e-01}$^\dagger$ & \textit{2.0000e-01} & \textit{--} \\
    2.5000e-01 & 1.0000e-01 & 1.000 \\
    \bottomrule
  \end{tabular}
  \par\smallskip{\footnotesize $\dagger$ h 0.50000 is left out of the fit: 3 \% of it is quadrature.}
\end{table}
";
        assert_eq!(text, expected);
    }
}
