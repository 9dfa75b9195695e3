//! `pressure`: the contact pressure and the gap of the finest level along the zone.

use super::chart::Colour;
use super::zone_chart::{Trace, ZoneChart};
use crate::format;
use crate::summary::name;
use signorini_study::fields::{ContactStatus, Fields};
use signorini_study::record::{ContactMeasure, Level, PressureSource, StudyRecord, ZoneProfile};

/// A node counts as in contact when its pressure exceeds this share of the largest.
const ACTIVE: f64 = 1e-8;
/// Share of the contact's extent that is shown beside it.
const BESIDE: f64 = 0.6;

/// The discrete pressure as marks, that of the formula or of the exact solution as a line, and the gap.
///
/// `None` if the record has no profile, or fewer than two nodes in it.
pub fn pressure(record: &StudyRecord) -> Option<ZoneChart> {
    chart(record, record.zone.as_ref()?, record.levels.last()?)
}

/// The same of any level whose fields are kept, without formula or exact solution.
pub fn pressure_of_level(record: &StudyRecord, fields: &Fields) -> Option<ZoneChart> {
    let level = record.levels.iter().find(|l| l.level == fields.level)?;
    let zone = &fields.zone;
    // where the supports decide the distance no pressure is known
    let known: Vec<usize> = (0..zone.s.len()).filter(|k| zone.status[*k] != ContactStatus::Held as u8).collect();
    let of = |list: &[f64]| known.iter().map(|k| list[*k]).collect();
    let profile = ZoneProfile {
        across_gap: zone.across_gap,
        symmetric: record.zone.as_ref().is_some_and(|z| z.symmetric),
        coordinate: of(&zone.s),
        points: known.iter().map(|k| fields.nodes[zone.nodes[*k][0] as usize]).collect(),
        pressure: of(&zone.pressure),
        gap: of(&zone.gap),
        reference: None,
    };
    chart(record, &profile, level)
}

fn chart(record: &StudyRecord, zone: &ZoneProfile, level: &Level) -> Option<ZoneChart> {
    if zone.coordinate.len() < 2 {
        return None;
    }
    let trace = |label: &str, colour, marks, values: &[f64]| Trace {
        label: label.into(),
        colour,
        marks,
        points: zone.coordinate.iter().copied().zip(values.iter().copied()).collect(),
    };
    let mut pressure = vec![trace("discrete pressure λᵢ/mᵢ", Colour::Blue, true, &zone.pressure)];
    if let Some(reference) = &zone.reference {
        // the line first, so that the marks lie on it
        let known = zone.coordinate.iter().zip(&reference.pressure).filter_map(|(x, p)| Some((*x, (*p)?)));
        pressure.insert(
            0,
            Trace {
                label: source_words(reference.source).into(),
                colour: Colour::Vermillion,
                marks: false,
                points: known.collect(),
            },
        );
    }
    let edge = level.contact.as_ref().and_then(|c| c.formula.as_ref()?.half_width).filter(|_| zone.symmetric);
    let window = window(zone, edge);
    Some(ZoneChart {
        title: format!("{}: contact pressure", name(record)),
        subtitle: [record.title.clone()].into_iter().chain(level.contact.as_ref().map(numbers)).collect(),
        x_label: coordinate_words(zone).into(),
        window,
        pressure,
        gap: trace("discrete gap", Colour::Green, true, &zone.gap),
        edge,
        remarks: vec![remark(zone, level, window)],
    })
}

fn source_words(source: PressureSource) -> &'static str {
    match source {
        PressureSource::Formula => "formula",
        PressureSource::Exact => "exact solution",
    }
}

fn coordinate_words(zone: &ZoneProfile) -> &'static str {
    match (zone.across_gap, zone.symmetric) {
        (true, true) => "distance from the axis of symmetry, across ξ",
        (true, false) => "distance from the start of the zone, across ξ",
        (false, true) => "length along the zone from the axis of symmetry",
        (false, false) => "length along the zone from its start",
    }
}

/// `half width 0.0997 (formula 0.1000, −0.27 %) · peak pressure …`
fn numbers(contact: &ContactMeasure) -> String {
    let formula = contact.formula.clone().unwrap_or_default();
    let width = number("half width", contact.half_width, formula.half_width);
    format!("{width} · {}", number("peak pressure", contact.peak_pressure, formula.peak_pressure))
}

fn number(words: &str, measured: f64, formula: Option<f64>) -> String {
    let shown = format::significant(measured, 4);
    match formula {
        None => format!("{words} {shown}"),
        Some(f) => {
            format!("{words} {shown} (formula {}, {})", format::significant(f, 4), percent(measured / f - 1.0))
        }
    }
}

/// `+0.31 %`, `−2.0 %`; the sign of zero is lost.
pub fn percent(x: f64) -> String {
    let text = format!("{:+.2} %", 100.0 * x).replace('-', "−");
    if text == "−0.00 %" || text == "+0.00 %" { "0.00 %".into() } else { text }
}

/// The contact with something of what lies beside it; the whole zone where that is not much more.
fn window(zone: &ZoneProfile, edge: Option<f64>) -> (f64, f64) {
    let (first, last) = (zone.coordinate[0], zone.coordinate[zone.coordinate.len() - 1]);
    let touching = zone.coordinate.iter().zip(touches(zone)).filter(|(_, touches)| *touches).map(|(x, _)| *x);
    let touching = touching.chain(edge);
    let (low, high) = touching.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    if low >= high {
        return (first, last);
    }
    let beside = BESIDE * (high - low);
    ((low - beside).max(first), (high + beside).min(last))
}

/// Whether each node presses or, on a bilateral part, pulls.
fn touches(zone: &ZoneProfile) -> impl Iterator<Item = bool> {
    let largest = zone.pressure.iter().fold(0.0, |m: f64, p| m.max(p.abs()));
    zone.pressure.iter().map(move |p| p.abs() > ACTIVE * largest)
}

fn remark(zone: &ZoneProfile, level: &Level, window: (f64, f64)) -> String {
    let (count, last) = (zone.coordinate.len(), zone.coordinate[zone.coordinate.len() - 1]);
    let touching = touches(zone).filter(|touches| *touches).count();
    let beyond =
        if window.1 < last { format!("; the zone goes on to {}", format::significant(last, 3)) } else { String::new() };
    format!("Level {}: {touching} of {count} nodes of the zone are in contact{beyond}.", level.level)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentages_have_a_sign_and_no_negative_zero() {
        assert_eq!(percent(0.0123), "+1.23 %");
        assert_eq!(percent(-0.5), "−50.00 %");
        assert_eq!(percent(-1e-9), "0.00 %");
    }
}
