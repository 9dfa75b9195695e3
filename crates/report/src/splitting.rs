//! The table of Falk's splitting: the terms for every kind of `v` and `v_h` on the finest level, the least slack on each.

use crate::format;
use crate::table::{Cell, Column, Row, Table};
use signorini_study::record::{Level, Splitting, StudyRecord};

const LEGEND: &str = "v ∈ K, vₕ ∈ Kₕ; of several random fields the pair with the least slack, right − left. δ: what quadrature, \
the algebraic error and rounding may make of it. The slack is the sum of the residuals of the two variational inequalities, so it \
is as small as the fields are close to the solutions.";

/// Formula, table and legend; empty where no level measured the splitting.
pub fn body(record: &StudyRecord) -> String {
    let Some(finest) = record.levels.iter().rev().find(|l| !l.splitting.is_empty()) else {
        return String::new();
    };
    let head = format!("{} on level {}:", finest.splitting[0].estimate.formula(), finest.level);
    let least: Vec<String> = record.levels.iter().filter_map(least_slack).collect();
    let all = format!("Least slack, as a share of the left side: {}.", least.join("; "));
    format!("{head}\n\n{}\n{LEGEND}\n\n{all}", table(finest).to_markdown())
}

fn table(level: &Level) -> Table {
    let columns = [
        ("v", "v"),
        ("v_h", "vₕ"),
        ("tried", "pairs"),
        ("load_u", "f(u−vₕ)"),
        ("load_v", "f(uₕ−v)"),
        ("energy", "energy term"),
        ("stress_v", "A(u,v−uₕ)"),
        ("stress_u", "A(u,vₕ−u)"),
        ("left", "left"),
        ("right", "right"),
        ("delta", "δ"),
        ("holds", "holds"),
    ];
    Table {
        columns: columns.map(|(key, heading)| Column::new(key, heading)).to_vec(),
        rows: level.splitting.iter().map(row).collect(),
    }
}

fn row(s: &Splitting) -> Row {
    let numbers = [s.load_u, s.load_v, s.energy, s.stress_v, s.stress_u, s.left, s.right, s.delta];
    let words = [Cell::text(&s.v), Cell::text(&s.v_h), Cell::text(s.tried.to_string())];
    let holds = s.holds.map_or(Cell::Missing, Cell::Flag);
    let cells = words.into_iter().chain(numbers.map(|x| Cell::number(Some(x)))).chain([holds]).collect();
    Row { cells, excluded: None }
}

/// `level 2: 1.2e-3 (v = …, vₕ = …)`.
fn least_slack(level: &Level) -> Option<String> {
    let share = |s: &Splitting| s.slack() / s.left.max(f64::MIN_POSITIVE);
    let least = level.splitting.iter().reduce(|a, b| if share(b) < share(a) { b } else { a })?;
    Some(format!(
        "level {}: {} (v = {}, vₕ = {})",
        level.level,
        format::significant(share(least), 2),
        least.v,
        least.v_h
    ))
}
