//! Work and seconds against the swept numbers.

use super::entry::{Entry, keys, values};
use crate::bench::words::{machine, rounds, threads};
use crate::plot::{Colour, Panel, PanelChart, Series, Shape, Style};
use signorini_study::bench::record::BenchRecord;

/// Colours and shapes that can be told apart; further curves are left to the table.
const LOOKS: [(Colour, Shape); 6] = [
    (Colour::Blue, Shape::Circle),
    (Colour::Orange, Shape::Diamond),
    (Colour::Green, Shape::Triangle),
    (Colour::Purple, Shape::Diamond),
    (Colour::Vermillion, Shape::Square),
    (Colour::Black, Shape::Circle),
];

/// The picture of the first solver on the finest mesh: over the key with the most positive numbers, a curve for each value of the
/// other one. None without such a key.
pub(super) fn chart(record: &BenchRecord, name: &str, entries: &[Entry]) -> Option<PanelChart> {
    let numbers = |key: &str| values(entries, key).iter().filter(|s| s.number.is_some_and(|x| x > 0.0)).count();
    let keys = keys(entries);
    let (key, label) =
        keys.iter().copied().rev().max_by_key(|(key, _)| numbers(key)).filter(|(key, _)| numbers(key) > 1)?;
    let other = keys.iter().copied().find(|(k, _)| *k != key);
    let first = &entries.first()?.curve.solver;
    let finest = entries.iter().map(|e| e.size.level).max()?;
    let shown: Vec<&Entry> = entries.iter().filter(|e| e.curve.solver == *first && e.size.level == finest).collect();
    let panel = |y_label: &str, of: fn(&Entry) -> Option<f64>| Panel {
        x_label: label.to_owned(),
        y_label: y_label.to_owned(),
        series: curves(entries, &shown, key, other, of),
    };
    let dofs = shown.first()?.size.dofs;
    Some(PanelChart {
        title: format!("{first} under changed data: {name}"),
        subtitle: vec![format!("{dofs} unknowns; {}; {}, {}", machine(record), threads(record), rounds(record))],
        panels: [
            panel("work (products with the finest matrix)", |e| e.work()),
            panel("CPU of set-up and solve (µs per unknown)", |e| e.cost()),
        ],
        remarks: Vec::new(),
    })
}

/// A curve for each value of the other key, or one.
fn curves(
    entries: &[Entry],
    shown: &[&Entry],
    key: &str,
    other: Option<(&str, &str)>,
    of: fn(&Entry) -> Option<f64>,
) -> Vec<Series> {
    let point = |e: &&Entry| Some((e.value(key)?.number?, of(e)?));
    let series = |label: String, k: usize, points: Vec<(f64, f64)>| {
        let (colour, shape) = LOOKS[k];
        Series { label, colour, style: Style::Marks(shape, 0), points }
    };
    let Some((other, name)) = other else {
        return vec![series(key.to_owned(), 0, shown.iter().filter_map(point).collect())];
    };
    let of_value = |(k, value): (usize, &&signorini_study::record::Setting)| {
        let own = shown.iter().filter(|e| e.value(other) == Some(*value));
        series(format!("{name} = {}", value.value), k, own.filter_map(point).collect())
    };
    values(entries, other).iter().take(LOOKS.len()).enumerate().map(of_value).collect()
}
