//! `parts`: what the proof bounds the terms of the contact zone by, against the mesh size.

use super::chart::{Chart, Colour, Curve, Guide, Mark, MarkKind, Shape, Slope, Weight};
use super::ledger::{rate_detail, star_remark};
use super::rates::{excluded, kind};
use crate::format;
use crate::ledger::{present_parts, term_rate};
use crate::summary::name;
use signorini_study::claim::proof::{proven_term, term_words};
use signorini_study::rate;
use signorini_study::record::{Ledger, Level, StudyRecord};

/// Colours and shapes of the parts, in the order of [`Ledger::PARTS`]; an arc has at most four, a gap three.
const STYLES: [(Colour, Shape); 7] = [
    (Colour::Blue, Shape::Circle),
    (Colour::Green, Shape::Triangle),
    (Colour::Purple, Shape::Diamond),
    (Colour::Vermillion, Shape::Square),
    (Colour::Blue, Shape::Circle),
    (Colour::Vermillion, Shape::Square),
    (Colour::Green, Shape::Triangle),
];

/// Each part of the ledger against `h`, with the observed rate at its name and, dashed, its own proven slope above it.
///
/// `None` if no part has a finite value above rounding.
pub fn parts(record: &StudyRecord) -> Option<Chart> {
    let curves: Vec<(&str, Curve)> =
        present_parts(record).filter_map(|(part, _)| Some((part, curve(record, part)?))).collect();
    if curves.is_empty() {
        return None;
    }
    let guides: Vec<Guide> = curves.iter().filter_map(|(part, curve)| guide(record, part, curve)).collect();
    let slopes = slopes(&guides);
    let remarks = remarks(record, &curves);
    let norms_alone = curves.iter().all(|(part, _)| !Ledger::is_square(part));
    Some(Chart {
        title: format!("{}: parts of the ledger", name(record)),
        subtitle: vec![record.title.clone(), bounded(norms_alone).into()],
        x_label: "mesh size h (largest side)".into(),
        y_label: if norms_alone { "norms in L²(Γ_K)" } else { "parts of b; norm in L²(Γ_K)" }.into(),
        curves: curves.into_iter().map(|(_, curve)| curve).collect(),
        bands: Vec::new(),
        guides,
        slopes,
        remarks,
    })
}

fn bounded(norms_alone: bool) -> &'static str {
    if norms_alone {
        "b is bounded by ‖[u_I−u]ₙ‖₀, c by ‖Φ−Uₕ‖₀ ≤ ‖Φ−Ũₕ‖₀ + ‖Uₕ−Ũₕ‖₀"
    } else {
        "b is the sum of its two parts, c is bounded by ‖ε_I−ε‖₀"
    }
}

fn curve(record: &StudyRecord, part: &str) -> Option<Curve> {
    let value = |level: &Level| level.ledger.as_ref().and_then(|l| l.term(part));
    let marks: Vec<Mark> = record.levels.iter().filter_map(|level| mark(level, part, value(level)?)).collect();
    let (colour, shape) = STYLES[Ledger::PARTS.iter().position(|(name, _)| *name == part)?];
    let negative = marks.iter().any(|m| m.kind == MarkKind::Negative);
    let words = term_words(part);
    (!marks.is_empty()).then(|| Curve {
        label: if negative { format!("|{words}|") } else { words.into() },
        detail: rate_detail(term_rate(record, part)),
        colour,
        shape,
        weight: Weight::Strong,
        judged: true,
        marks,
    })
}

/// A square within `1e-14 A(u,u)`, or a norm within `1e-11` of the solution's trace, is rounding.
fn mark(level: &Level, part: &str, value: f64) -> Option<Mark> {
    let floor = if Ledger::is_square(part) {
        1e-14 * level.solution_energy.unwrap_or(0.0).powi(2)
    } else {
        rate::ROUNDING * level.solution_trace.unwrap_or(0.0)
    };
    let drawable = value.abs() > floor && value.is_finite() && level.h > 0.0 && level.h.is_finite();
    drawable.then(|| Mark { h: level.h, value: value.abs(), kind: kind(level, value) })
}

/// `c h^p` with the proven `p` and the least `c` that holds on every level that counts.
fn guide(record: &StudyRecord, part: &str, curve: &Curve) -> Option<Guide> {
    let exponent = proven_term(record, part)?.exponent;
    let used = || curve.marks.iter().filter(|m| m.kind != MarkKind::Greyed);
    let from = used().map(|m| m.h).reduce(f64::max)?;
    let to = used().map(|m| m.h).reduce(f64::min).filter(|h| *h < from)?;
    let value = used().map(|m| m.value * (from / m.h).powf(exponent)).reduce(f64::max)?;
    Some(Guide { colour: curve.colour, exponent, from: (from, value), to })
}

/// One triangle for each exponent.
fn slopes(guides: &[Guide]) -> Vec<Slope> {
    let mut exponents: Vec<f64> = guides.iter().map(|g| g.exponent).collect();
    exponents.sort_by(f64::total_cmp);
    exponents.dedup();
    let slope = |exponent| Slope { exponent, label: format::order(exponent), source: "proven".into() };
    exponents.into_iter().map(slope).collect()
}

fn remarks(record: &StudyRecord, curves: &[(&str, Curve)]) -> Vec<String> {
    let mut remarks = excluded(record);
    remarks.push("Dashed: C h^{p} with the proven p and the least C that holds on every level that counts.".into());
    if curves.iter().any(|(_, c)| c.marks.iter().any(|m| m.kind == MarkKind::Negative)) {
        remarks.push("Hollow marks: the absolute value of a negative part.".into());
    }
    remarks.extend(star_remark(curves.iter().filter_map(|(part, _)| term_rate(record, part))));
    remarks
}
