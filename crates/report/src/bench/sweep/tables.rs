//! The tables of a sweep.

use super::entry::{Entry, keys, values};
use crate::bench::words::number;
use crate::format::{MISSING, significant};
use crate::table::{Cell, Column, Row, Table};

/// Significant digits of times and ratios.
const DIGITS: usize = 3;

/// Every case on every mesh under every solver.
pub(super) fn all(entries: &[Entry]) -> Table {
    let swept = keys(entries);
    let headings = [
        "solver",
        "unknowns",
        "error (%)",
        "closed (%)",
        "iterations",
        "work",
        "CPU (s)",
        "linear: iterations",
        "linear: work",
        "ratio (work)",
        "ratio (CPU)",
        "status",
    ];
    let names = swept.iter().map(|(_, name)| *name).chain(headings);
    let rows = entries.iter().map(|e| row(e, &swept)).collect();
    Table { columns: names.map(|n| Column::new(n, n)).collect(), rows }
}

fn row(entry: &Entry, swept: &[(&str, &str)]) -> Row {
    let percent = |x: Option<f64>| Cell::figure(number(x.map(|x| 100.0 * x)));
    let figure = |x: Option<f64>| Cell::figure(number(x));
    let run = entry.run.ok();
    let linear = run.and_then(|r| r.linear);
    let mut cells: Vec<Cell> =
        swept.iter().map(|(key, _)| Cell::figure(entry.value(key).map_or(MISSING, |s| &s.value))).collect();
    cells.extend([
        Cell::text(&entry.curve.solver),
        Cell::Count(entry.size.dofs),
        percent(run.and_then(|r| r.relative_error)),
        percent(run.and_then(|r| r.closed)),
        Cell::count(run.map(|r| r.iterations)),
        figure(entry.work()),
        figure(entry.processor()),
        Cell::count(linear.map(|l| l.iterations)),
        figure(linear.and_then(|l| l.work)),
        figure(entry.over_linear()),
        figure(linear.and_then(|l| l.ratio_processor)),
        Cell::text(entry.run.map_or_else(|reason| reason.trim(), |r| r.status.as_str())),
    ]);
    Row { cells, excluded: None }
}

/// For each swept key, by its short name, a row for each value and solver.
pub(super) fn by_key<'a>(entries: &[Entry<'a>]) -> Vec<(&'a str, Table)> {
    keys(entries).into_iter().map(|(key, name)| (name, of_key(entries, key, name))).collect()
}

fn of_key(entries: &[Entry], key: &str, name: &str) -> Table {
    let found = values(entries, key);
    let first = found.first().map_or(String::new(), |s| s.value.clone());
    let against = format!("work over that at {first}");
    let headings = ["solver", "solved", "iterations", "work", "CPU (µs per unknown)", "work over linear", &against];
    let mut rows = Vec::new();
    for value in &found {
        for solver in solvers(entries) {
            let here: Vec<&Entry> =
                entries.iter().filter(|e| e.value(key) == Some(*value) && e.curve.solver == solver).collect();
            let solved = here.iter().filter(|e| e.run.is_ok()).count();
            let over = |of: fn(&Entry) -> Option<f64>| Cell::figure(span(here.iter().filter_map(|e| of(e))));
            let cells = vec![
                Cell::figure(&value.value),
                Cell::text(solver),
                Cell::figure(format!("{solved} of {}", here.len())),
                over(|e| e.iterations()),
                over(|e| e.work()),
                over(|e| e.cost()),
                over(|e| e.over_linear()),
                Cell::figure(span(here.iter().filter_map(|e| over_first(e, entries, key, &first)))),
            ];
            rows.push(Row { cells, excluded: None });
        }
    }
    Table { columns: std::iter::once(name).chain(headings).map(|n| Column::new(n, n)).collect(), rows }
}

/// Work over that of the entry with the first value, all else equal.
fn over_first(entry: &Entry, entries: &[Entry], key: &str, first: &str) -> Option<f64> {
    let beside = |e: &&Entry| e.value(key).is_some_and(|s| s.value == first) && e.is_beside(entry, key);
    Some(entry.work()? / entries.iter().find(beside)?.work()?)
}

fn solvers<'a>(entries: &[Entry<'a>]) -> Vec<&'a str> {
    let mut found: Vec<&str> = Vec::new();
    for entry in entries {
        if !found.contains(&entry.curve.solver.as_str()) {
            found.push(&entry.curve.solver);
        }
    }
    found
}

/// `24.0–33.1`, one number where there is no difference.
fn span(numbers: impl Iterator<Item = f64>) -> String {
    let all: Vec<f64> = numbers.collect();
    let ends = all.iter().copied().reduce(f64::min).zip(all.iter().copied().reduce(f64::max));
    let whole = all.iter().all(|x| x.fract() == 0.0);
    let word = |x: f64| if whole { format!("{x}") } else { significant(x, DIGITS) };
    match ends.map(|(low, high)| [word(low), word(high)]) {
        None => MISSING.into(),
        Some([low, high]) if low == high => low,
        Some([low, high]) => format!("{low}–{high}"),
    }
}
