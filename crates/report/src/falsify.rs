//! The table of a search for counterexamples, for readers and for the terminal.

use crate::format;
use crate::table::{Cell, Column, Row as TableRow, Table, text};
use signorini_study::falsify::{CONSTANT_KEPT, RATE_KEPT, Row, Saved, Summary};

const TEXT_WIDTH: usize = 110;

/// `summary.md` of a search.
pub fn falsify_markdown(summary: &Summary) -> String {
    let mut out = format!("# Search for counterexamples\n\n{}\n\n", head(summary));
    out += &rates(summary).to_markdown();
    out += &format!("\n{}\n\n{}", RATES_LEGEND, constants(summary).to_markdown());
    out += &format!("\n{CONSTANTS_LEGEND}\n\n## What was drawn\n\n");
    for row in &summary.rows {
        out += &format!("- **{}**: {}\n", row.target, row.scenes);
    }
    let worst: String =
        summary.rows.iter().flat_map(|r| [&r.worst_rate, &r.worst_constant]).flatten().map(saved).collect();
    out += &format!("\n## The worst, simplified and saved\n\n{worst}\n{}", shrink_legend());
    let candidates = candidates(summary);
    if !candidates.is_empty() {
        out += &format!("\n## Candidates\n\n{candidates}");
    }
    let skipped = summary.rows.iter().filter_map(|r| Some(format!("- **{}**, {}\n", r.target, r.not_judged.as_ref()?)));
    let skipped: String = skipped.collect();
    if !skipped.is_empty() {
        out += &format!("\n## Not judged, the first of each\n\n{skipped}");
    }
    let names: Vec<&str> = summary.rows.iter().map(|r| r.target.as_str()).collect();
    let what = if let [one] = names[..] { one } else { "all" };
    let budget = summary.rows.first().map_or(0, |r| r.draws);
    out + &format!(
        "\n## Reproduce it\n\n```sh\nsignorini falsify {what} --budget {budget} --seed {}\n```\n",
        summary.seed
    )
}

/// The same for the terminal.
pub fn falsify_text(summary: &Summary) -> String {
    let mut out = format!("{}\n{}\n", rates(summary).to_text(TEXT_WIDTH), constants(summary).to_text(TEXT_WIDTH));
    for line in candidates(summary).lines() {
        out += &text::wrap(&format!("CANDIDATE {}", line.trim_start_matches("- ")), TEXT_WIDTH, 4);
        out.push('\n');
    }
    out + &head(summary) + "\n"
}

const RATES_LEGEND: &str = "Rates of the strain seminorm on a few coarse meshes, so local rates and not asymptotic ones. Judged: solved, \
certified and within the error budget. Settled: successive pairwise rates differ by less than 0.05; the worst rate is taken among them. \
Smallest pair: the smallest of the last three pairwise rates of any draw, settled or not. Candidates: draws that break an inequality of \
the proof, or whose rate stays below the bound when a level twice as fine is added.";

const CONSTANTS_LEGEND: &str = "The largest constant over all levels of all draws; stresses in units of the smaller shear modulus. \
Slack: the smallest (a + b + c − ½A(e,e)) / ½A(e,e); below zero the estimate of the error would be broken.";

fn shrink_legend() -> String {
    format!(
        "Each was made simpler, one step after the other, as long as its rate rose by at most {RATE_KEPT} or its constant kept {:.0} %.\n",
        100.0 * CONSTANT_KEPT
    )
}

fn head(summary: &Summary) -> String {
    let draws: usize = summary.rows.iter().map(|r| r.draws).sum();
    let broken: usize = summary.rows.iter().map(|r| r.candidates.len()).sum();
    let words = match broken {
        0 => "no counterexample found".to_owned(),
        n => format!("{n} CANDIDATES FOR A COUNTEREXAMPLE"),
    };
    format!("{draws} draws, seed {}: {words}.", summary.seed)
}

fn rates(summary: &Summary) -> Table {
    let columns = [
        ("target", "claim"),
        ("draws", "draws"),
        ("judged", "judged"),
        ("settled", "settled"),
        ("worst_rate", "worst rate [95 %]"),
        ("smallest_pair", "smallest pair"),
        ("paper", "paper"),
        ("today", "today"),
        ("candidates", "candidates"),
    ];
    let of = |r: &Row| {
        let worst = r.worst_rate.as_ref().map(|w| match w.interval {
            Some([low, high]) => format::interval(w.figure, low, high),
            None => format::rate(w.figure),
        });
        vec![
            Cell::text(&r.target),
            Cell::Count(r.draws),
            Cell::Count(r.judged),
            // where no rate is claimed none is fitted
            if worst.is_some() { Cell::Count(r.settled) } else { Cell::Missing },
            worst.map_or(Cell::Missing, Cell::Text),
            Cell::rate(r.smallest_pair),
            Cell::bound(r.bounds.paper),
            Cell::bound(r.bounds.today),
            Cell::Count(r.candidates.len()),
        ]
    };
    table(&columns, summary, of)
}

fn constants(summary: &Summary) -> Table {
    let columns = [
        ("target", "claim"),
        ("worst_constant", "largest constant"),
        ("constant_bound", "proven"),
        ("least_slack", "least slack"),
        ("constant", "the constant"),
    ];
    let of = |r: &Row| {
        let figure = |x: Option<f64>| x.map_or(Cell::Missing, |x| Cell::Text(format::significant(x, 3)));
        vec![
            Cell::text(&r.target),
            figure(r.worst_constant.as_ref().map(|w| w.figure)),
            figure(r.constant_bound),
            figure(r.least_slack),
            Cell::text(&r.constant),
        ]
    };
    table(&columns, summary, of)
}

fn table(columns: &[(&str, &str)], summary: &Summary, of: impl Fn(&Row) -> Vec<Cell>) -> Table {
    Table {
        columns: columns.iter().map(|(key, heading)| Column::new(*key, *heading)).collect(),
        rows: summary.rows.iter().map(|r| TableRow { cells: of(r), excluded: None }).collect(),
    }
}

fn saved(s: &Saved) -> String {
    format!(
        "- [{}]({}): draw {}, {} ({}); saved after {} steps: {} ({})\n",
        s.file,
        s.file,
        s.index,
        s.scene,
        format::significant(s.figure, 4),
        s.steps,
        s.saved_scene,
        format::significant(s.saved_figure, 4),
    )
}

fn candidates(summary: &Summary) -> String {
    let of = |r: &Row| -> String {
        let one = |c: &signorini_study::falsify::Candidate| {
            format!("- **{}**, draw {} ({}): {}\n", r.target, c.index, c.scene, c.reason)
        };
        r.candidates.iter().map(one).collect()
    };
    summary.rows.iter().map(of).collect()
}
