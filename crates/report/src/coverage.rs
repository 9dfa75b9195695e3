//! The table of measured coverage, and the sentence about it that stands beside every fitted rate.

use crate::table::{Cell, Column, Row, Table};
use signorini_study::rate::coverage::{Coverage, STATED_COVERAGE, STATED_LEVELS, STATED_NOISE, Share};

/// The table with its legend, in Markdown.
pub fn coverage_markdown(measured: &[Coverage], draws: usize, seed: u64) -> String {
    format!(
        "# Coverage of the 95 % interval\n\n{draws} made-up series in each row, seed {seed}; the true slope is 1.\n\n{}\n{LEGEND}\n",
        table(measured).to_markdown()
    )
}

const LEGEND: &str = "Errors are t(h) exp(σ ξ) at h = 1/8, 1/16, …, with ξ standard normal. All levels: the line through all of them, \
which covers in 95 of 100 draws where t(h) = h. Window: the line over the window that is chosen from the same errors. Settled: \
the same in those draws whose pairwise rates differ by less than 0.05, with their share; among noisy series these are the lucky ones \
with small residuals, so their intervals are too short. Where a term of lower order is still dying out no interval made from \
residuals covers: the bias is not in the residuals. ± is the standard error of the measured share.";

/// What the interval is worth, in a sentence.
pub(crate) fn sentence() -> String {
    format!(
        "The window is chosen from the same errors: on {STATED_LEVELS} levels with {:.0} % noise the interval of a settled window \
         held the true slope in {:.0} of 100 made-up series, not in 95, and of terms that have not died out yet it knows nothing.",
        100.0 * STATED_NOISE,
        100.0 * STATED_COVERAGE
    )
}

fn table(measured: &[Coverage]) -> Table {
    let headings = ["t(h)", "levels", "noise σ", "all levels", "window", "bias", "settled", "share settled"];
    let row = |c: &Coverage| {
        let s = c.setting;
        let settled = c.settled.drawn as f64 / c.window.drawn.max(1) as f64;
        let cells = vec![
            Cell::text(s.truth.formula()),
            Cell::Count(s.levels),
            Cell::Text(format!("{}", s.noise)),
            share(&c.all_levels),
            share(&c.window),
            Cell::Rate(c.window.bias),
            share(&c.settled),
            Cell::Text(format!("{settled:.2}")),
        ];
        Row { cells, excluded: None }
    };
    Table { columns: headings.map(|h| Column::new(h, h)).to_vec(), rows: measured.iter().map(row).collect() }
}

fn share(s: &Share) -> Cell {
    match s.value().zip(s.stderr()) {
        Some((value, stderr)) => Cell::Text(format!("{value:.3} ± {stderr:.3}")),
        None => Cell::Missing,
    }
}
