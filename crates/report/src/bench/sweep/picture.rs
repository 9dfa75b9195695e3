//! Work and seconds against the swept numbers.

use super::entry::{Entry, keys, values};
use crate::bench::words::{machine, rounds, threads};
use crate::plot::{Colour, Panel, PanelChart, Series, Shape, Style};
use signorini_study::bench::record::BenchRecord;
use signorini_study::record::Setting;

/// Colours and shapes that can be told apart; further curves are left to the table.
const LOOKS: [(Colour, Shape); 6] = [
    (Colour::Blue, Shape::Circle),
    (Colour::Orange, Shape::Diamond),
    (Colour::Green, Shape::Triangle),
    (Colour::Purple, Shape::Diamond),
    (Colour::Vermillion, Shape::Square),
    (Colour::Black, Shape::Circle),
];

/// The picture of the first solver on the finest mesh: over the key whose numbers span the most, a curve for each value of the
/// other one. None without a key of several positive numbers.
pub(super) fn chart(record: &BenchRecord, name: &str, entries: &[Entry]) -> Option<PanelChart> {
    let keys = keys(entries);
    let spans = |(key, _): &(&str, &str)| span(&values(entries, key));
    let (key, label) = keys.iter().copied().filter(|k| spans(k) > 1.0).max_by(|a, b| spans(a).total_cmp(&spans(b)))?;
    let other = keys.iter().copied().find(|(k, _)| *k != key);
    let first = &entries.first()?.curve.solver;
    let finest = entries.iter().map(|e| e.size.level).max()?;
    let shown: Vec<&Entry> = entries.iter().filter(|e| e.curve.solver == *first && e.size.level == finest).collect();
    let panel = |y_label: &str, of: fn(&Entry) -> Option<f64>| Panel {
        x_label: if is_ratio(key) { "1 − 2ν".to_owned() } else { label.to_owned() },
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

/// Where a value stands: Poisson's ratio by its distance from one half, which is what the equations feel.
fn abscissa(setting: &Setting) -> Option<f64> {
    let x = setting.number?;
    Some(if is_ratio(&setting.key) { 1.0 - 2.0 * x } else { x })
}

fn is_ratio(key: &str) -> bool {
    key.ends_with(".poisson")
}

/// The largest over the smallest positive number; 1 where there are none.
fn span(settings: &[&Setting]) -> f64 {
    let numbers: Vec<f64> = settings.iter().filter_map(|s| abscissa(s)).filter(|x| *x > 0.0).collect();
    let ends = numbers.iter().copied().reduce(f64::max).zip(numbers.iter().copied().reduce(f64::min));
    ends.map_or(1.0, |(most, least)| most / least)
}

/// A curve for each value of the other key, or one.
fn curves(
    entries: &[Entry],
    shown: &[&Entry],
    key: &str,
    other: Option<(&str, &str)>,
    of: fn(&Entry) -> Option<f64>,
) -> Vec<Series> {
    let point = |e: &&Entry| Some((abscissa(e.value(key)?)?, of(e)?));
    let series = |label: String, k: usize, points: Vec<(f64, f64)>| {
        let (colour, shape) = LOOKS[k];
        Series { label, colour, style: Style::Marks(shape, 0), points }
    };
    let Some((other, name)) = other else {
        return vec![series("every value".to_owned(), 0, shown.iter().filter_map(point).collect())];
    };
    let of_value = |(k, value): (usize, &&Setting)| {
        let own = shown.iter().filter(|e| e.value(other) == Some(*value));
        series(format!("{name} = {}", value.value), k, own.filter_map(point).collect())
    };
    values(entries, other).iter().take(LOOKS.len()).enumerate().map(of_value).collect()
}
