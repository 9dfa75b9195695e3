//! `hard.md`: the hard cases on one page. What was tried, what happened, what the certificate says; one row per case.

use crate::format;
use crate::norm;
use crate::summary::name;
use crate::table::{Cell, Column, Row, Table};
use crate::verdict;
use signorini_study::record::{ClaimKind, Level, SecondOpinion, StudyRecord};

/// The page, if any record belongs on it: a claim of the kind `certificate`, or a case that was to be refused.
pub fn page(records: &[StudyRecord]) -> Option<String> {
    let hard: Vec<&StudyRecord> = records.iter().filter(|r| r.kind == ClaimKind::Certificate).collect();
    if hard.is_empty() {
        return None;
    }
    let (refused, solved): (Vec<&StudyRecord>, Vec<&StudyRecord>) = hard.iter().partition(|r| r.refusal.is_some());
    let mut out = format!("# Hard cases\n\n{INTRODUCTION}\n");
    if !solved.is_empty() {
        out += &format!("\n## Solved\n\n{}\n{LEGEND}\n", certificates(&solved).to_markdown());
        out += &format!("\n### Confirmed by a second solver\n\n{}\n{SECOND_LEGEND}\n", opinions(&solved).to_markdown());
    }
    if !refused.is_empty() {
        out += &format!("\n## Refused\n\n{}\n", refusals(&refused).to_markdown());
    }
    out += "\n## What was tried\n";
    for (i, record) in hard.iter().enumerate() {
        if i == 0 || hard[i - 1].study != record.study {
            out += &format!("\n### {}\n\n{}\n\n{}\n\n", record.title, record.question.trim(), record.setup.trim());
        }
        out += &format!("- **{}**, {}: {}\n", record.case, verdict::words(record), verdict::why(record));
    }
    Some(out)
}

const INTRODUCTION: &str = "Scenes in which a solver may fail: every solve has to end, its optimality conditions are recomputed \
from the raw data, and another solver answers the same discrete problem. Scenes without a solution have to be refused.";

const LEGEND: &str = "Largest value over the levels of a case; status, dofs and steps are those of the finest. Residuals have no \
units: stationarity against the largest terms of the system, row by row against the terms of each row; penetration against the \
largest displacement, complementarity against the strain energy. Weakly active: nodes that touch without pressing. Error: on the \
finest level in the energy norm, over the norm of the solution; rate: how it falls; both where there is a reference.";

const SECOND_LEGEND: &str = "Energy: difference over half the strain energy. Displacement: largest difference of nodal values over the \
largest value. Contact: constraints that press in one answer and are open in the other. Cancellation: how many times the terms of the \
strain energy exceed their sum, in powers of ten the digits that rounding takes from any solver. Falls: whether the energy falls \
from each mesh to the next, where the meshes are nested and so are the constraints.";

/// A rise of the energy by this share of half the strain energy is rounding.
const ROUNDING: f64 = 1e-10;

type CellOf = fn(&StudyRecord) -> Cell;

fn table(records: &[&StudyRecord], columns: &[(&str, CellOf)]) -> Table {
    let row = |r: &&StudyRecord| Row { cells: columns.iter().map(|(_, cell)| cell(r)).collect(), excluded: None };
    Table {
        columns: columns.iter().map(|(heading, _)| Column::new(*heading, *heading)).collect(),
        rows: records.iter().map(row).collect(),
    }
}

fn certificates(records: &[&StudyRecord]) -> Table {
    table(
        records,
        &[
            ("case", |r| Cell::text(link(r))),
            ("dofs", |r| Cell::count(r.levels.last().map(|l| l.dofs))),
            ("status", |r| r.levels.last().map_or(Cell::Missing, |l| Cell::text(&l.solver.status))),
            ("steps", |r| Cell::count(r.levels.last().map(|l| l.solver.iterations))),
            ("stationarity", |r| largest(r, |l| Some(l.kkt.stationarity))),
            ("row by row", |r| largest(r, |l| l.kkt.componentwise)),
            ("penetration", |r| largest(r, |l| Some(l.kkt.penetration))),
            ("compl.", |r| largest(r, |l| Some(l.kkt.complementarity))),
            ("weakly active", |r| Cell::count(r.levels.iter().map(|l| l.kkt.weakly_active).max())),
            ("error", |r| error(r).map_or(Cell::Missing, |e| Cell::text(format::significant(e, 2)))),
            ("rate", |r| {
                Cell::rate(
                    r.rates.get("energy").filter(|f| norm::Trust::of(f) != norm::Trust::Scattered).map(|f| f.slope),
                )
            }),
            ("verdict", |r| Cell::text(verdict::words(r))),
        ],
    )
}

fn opinions(records: &[&StudyRecord]) -> Table {
    table(
        records,
        &[
            ("case", |r| Cell::text(name(r))),
            ("solver", |r| second(r).map_or(Cell::Missing, |s| Cell::text(&s.name))),
            ("status", |r| second(r).map_or(Cell::Missing, |s| Cell::text(&s.status))),
            ("energy", |r| largest(r, |l| Some(l.second.as_ref()?.energy_difference))),
            ("displacement", |r| largest(r, |l| Some(l.second.as_ref()?.displacement_difference))),
            ("contact", |r| {
                Cell::count(r.levels.iter().filter_map(|l| Some(l.second.as_ref()?.active_difference)).max())
            }),
            ("cancellation", |r| largest(r, |l| Some(l.second.as_ref()?.cancellation))),
            ("falls", |r| falls(r).map_or(Cell::Missing, Cell::Flag)),
        ],
    )
}

fn refusals(records: &[&StudyRecord]) -> Table {
    table(
        records,
        &[
            ("case", |r| Cell::text(link(r))),
            ("levels refused", |r| {
                r.refusal.as_ref().map_or(Cell::Missing, |f| Cell::text(format!("{} of {}", f.refused, f.levels)))
            }),
            ("what the program says", |r| {
                let message = r.refusal.as_ref().and_then(|f| f.message.as_ref());
                message.map_or(Cell::Missing, Cell::text)
            }),
            ("verdict", |r| Cell::text(verdict::words(r))),
        ],
    )
}

/// The second opinion on the finest level.
fn second(record: &StudyRecord) -> Option<&SecondOpinion> {
    record.levels.last()?.second.as_ref()
}

/// The energy error of the finest level over the energy norm of the solution, where that is known.
fn error(record: &StudyRecord) -> Option<f64> {
    let finest = record.levels.last()?;
    Some(finest.errors.energy? / finest.solution_energy.filter(|norm| *norm > 0.0)?)
}

/// To two digits: a residual is a size.
fn largest(record: &StudyRecord, of: fn(&Level) -> Option<f64>) -> Cell {
    let largest = record.levels.iter().filter_map(of).reduce(f64::max);
    largest.map_or(Cell::Missing, |x| Cell::text(format::significant(x, 2)))
}

/// Whether the energy falls, or rises by rounding alone, from each level to the next whose spaces and constraints hold the coarser
/// ones; `None` where there are no such levels.
fn falls(record: &StudyRecord) -> Option<bool> {
    let nested = |w: &&[Level]| w[1].nested && w[0].inside == Some(true);
    let rises = |w: &[Level]| {
        let size = w[1].solution_energy.map_or(0.0, |norm| 0.5 * norm * norm);
        w[1].energy - w[0].energy > ROUNDING * size
    };
    let mut pairs = record.levels.windows(2).filter(nested).peekable();
    pairs.peek()?;
    Some(!pairs.any(rises))
}

fn link(record: &StudyRecord) -> String {
    let folder = if record.several { format!("{}/{}", record.study, record.case) } else { record.study.clone() };
    format!("[{}]({folder}/report.md)", name(record))
}
