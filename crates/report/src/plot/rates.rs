//! `rates`: the errors of a case against its measured mesh size.

use super::chart::{Band, Chart, Colour, Curve, Mark, MarkKind, Shape, Slope, Weight};
use crate::format;
use crate::levels;
use crate::markdown;
use crate::norm::{self, NORMS, Norm, Trust, judged_rate};
use crate::summary::name;
use crate::verdict;
use signorini_study::rate;
use signorini_study::record::{Level, Rate, Reference, StudyRecord};

/// Errors against `h`: the strain seminorm, the energy norm and the norm that the claim judges drawn strong, `H¹` and
/// `L²` thin; the fitted line of the judged norm with its 95 % band; the bounds as slope triangles.
///
/// `None` if no error is positive and finite.
pub fn rates(record: &StudyRecord) -> Option<Chart> {
    let curves: Vec<Curve> = NORMS.iter().filter_map(|norm| curve(record, norm)).collect();
    if curves.is_empty() {
        return None;
    }
    let judged = NORMS.iter().position(|n| n.key == record.norm);
    let judged_curve = judged.and_then(|i| curve(record, &NORMS[i]));
    Some(Chart {
        title: name(record),
        subtitle: vec![record.title.clone(), outcome(record)],
        x_label: "mesh size h (largest side)".into(),
        y_label: y_label(record),
        bands: judged_curve.iter().filter_map(|c| band(record, c.colour)).collect(),
        guides: Vec::new(),
        slopes: if judged_curve.is_some_and(|c| c.has_slope()) { slopes(record) } else { Vec::new() },
        curves,
        remarks: remarks(record),
    })
}

fn y_label(record: &StudyRecord) -> String {
    if !levels::has_solution(record) {
        return norm::words(&record.norm);
    }
    match record.reference {
        Reference::Exact => "error norms, e = u − uₕ".into(),
        Reference::Overkill { .. } => "error norms, e = u − uₕ, u the reference solution".into(),
        Reference::None => norm::words(&record.norm),
    }
}

/// The curve of one norm, if the picture shows it and it has a value.
fn curve(record: &StudyRecord, norm: &Norm) -> Option<Curve> {
    let judged = norm.key == record.norm;
    let (colour, shape) = match norm.key {
        "strain" => (Colour::Blue, Shape::Circle),
        "energy" => (Colour::Vermillion, Shape::Square),
        "h1" => (Colour::Green, Shape::Triangle),
        "l2" => (Colour::Purple, Shape::Diamond),
        _ if judged => (Colour::Black, Shape::Circle),
        _ => return None,
    };
    let marks: Vec<Mark> = record.levels.iter().filter_map(|level| mark(level, norm)).collect();
    let rate = record.rates.get(norm.key);
    (!marks.is_empty()).then(|| Curve {
        label: norm.label(),
        detail: rate.map_or_else(String::new, detail),
        colour,
        shape,
        weight: if judged || matches!(norm.key, "strain" | "energy") { Weight::Strong } else { Weight::Thin },
        judged,
        marks,
    })
}

/// The rate under a curve's name, starred where it is not asymptotic.
pub(super) fn detail(rate: &Rate) -> String {
    match Trust::of(rate) {
        Trust::Settled => format::interval(rate.slope, rate.low, rate.high),
        Trust::Drifting => format!("{}{STAR}", format::interval(rate.slope, rate.low, rate.high)),
        Trust::Scattered => "no rate".into(),
    }
}

/// Marks a rate that is not asymptotic.
pub(super) const STAR: &str = "*";

fn mark(level: &Level, norm: &Norm) -> Option<Mark> {
    let kind = kind(level, norm.value(level)?);
    let value = norm.value(level)?.abs();
    let drawable = value > 0.0 && value.is_finite() && level.h > 0.0 && level.h.is_finite();
    drawable.then_some(Mark { h: level.h, value, kind })
}

/// How a value of that level is drawn.
pub(super) fn kind(level: &Level, value: f64) -> MarkKind {
    match level.excluded {
        Some(_) => MarkKind::Greyed,
        None if value < 0.0 => MarkKind::Negative,
        None => MarkKind::Used,
    }
}

fn band(record: &StudyRecord, colour: Colour) -> Option<Band> {
    let rate = judged_rate(record)?;
    let inside = |level: &&Level| rate.levels.contains(&level.level) && level.h > 0.0;
    Some(Band {
        colour,
        slope: rate.slope,
        intercept: rate.intercept,
        window: record.levels.iter().filter(inside).map(|l| l.h).collect(),
        half_width: 0.5 * (rate.high - rate.low),
    })
}

/// The paper's bound, today's and the expected rate, equal ones together.
fn slopes(record: &StudyRecord) -> Vec<Slope> {
    let bounds = &record.bounds;
    let mut slopes: Vec<Slope> = Vec::new();
    for (value, source) in [(bounds.paper, "paper"), (bounds.today, "today"), (bounds.expected, "expected")] {
        let Some(exponent) = value.filter(|x| x.is_finite()) else {
            continue;
        };
        match slopes.iter_mut().find(|s| s.exponent == exponent) {
            Some(same) => same.source += &format!(", {source}"),
            None => slopes.push(Slope { exponent, label: format::order(exponent), source: source.into() }),
        }
    }
    slopes
}

/// `observed 0.998 [0.994, 1.002] on levels 2–6 · paper 1 · today 1 · expected 1 · pass`; bounds that there are.
fn outcome(record: &StudyRecord) -> String {
    let observed = judged_rate(record).map_or_else(
        || markdown::kind_words(record.kind).into(),
        |r| format!("observed {} on {}", detail(r), format::level_words(&r.levels)),
    );
    let bounds = &record.bounds;
    let bounds = [("paper", bounds.paper), ("today", bounds.today), ("expected", bounds.expected)];
    let shown = bounds.iter().filter_map(|(words, value)| value.map(|b| format!("{words} {}", format::bound(b))));
    let verdict = [verdict::words(record)];
    [observed].into_iter().chain(shown).chain(verdict).collect::<Vec<_>>().join(" · ")
}

/// What the picture leaves out or greys, in words.
fn remarks(record: &StudyRecord) -> Vec<String> {
    let mut remarks = excluded(record);
    let shown = NORMS.iter().filter(|n| curve(record, n).is_some()).filter_map(|n| record.rates.get(n.key));
    if shown.map(Trust::of).any(|t| t == Trust::Drifting) {
        remarks.push(format!("{STAR} Not asymptotic: the pairwise rates still drift."));
    }
    if record.levels.iter().any(rate::is_rounding) {
        remarks.push("Rounding: the energy error is below 1e-11 of the solution's energy norm.".into());
    }
    let Some(norm) = NORMS.iter().find(|n| n.key == record.norm) else {
        return remarks;
    };
    let missing = record.levels.iter().filter(|l| mark(l, norm).is_none());
    let missing: Vec<usize> = missing.map(|l| l.level).collect();
    if !missing.is_empty() {
        let levels = format::level_words(&missing);
        remarks.push(format!("Not drawn, zero or without a value: {} on {levels}.", norm.label()));
    }
    remarks
}

/// The levels left out of the fit, together where the reason is the same.
pub(super) fn excluded(record: &StudyRecord) -> Vec<String> {
    let mut groups: Vec<(&str, Vec<usize>)> = Vec::new();
    for level in &record.levels {
        let Some(why) = level.excluded.as_deref() else {
            continue;
        };
        match groups.iter_mut().find(|(reason, _)| *reason == why) {
            Some((_, levels)) => levels.push(level.level),
            None => groups.push((why, vec![level.level])),
        }
    }
    let words = |(why, levels): (&str, Vec<usize>)| {
        format!("Grey, left out of the fit: {}: {why}.", format::level_words(&levels))
    };
    groups.into_iter().map(words).collect()
}
