//! `[exact.traces]`: displacement and stress on the contact line, continued into the bodies by a lemma.

use super::error::{Fault, refuse};
use super::field::expression_fault;
use super::number::Finite;
use super::raw::{RawField, RawTraces, TraceLemma};
use super::shape::point;
use super::spanned::Spanned;
use crate::exact::{LineText, TraceError, TraceName, TraceTexts, Traces};
use crate::study::Shape;
use signorini_contact::{Body, Point, material::Lame};
use std::collections::BTreeMap;
use std::ops::Range;

/// The solution of the traces. `reach` is how far breaks run into the bodies.
pub fn traces(
    raw: &RawTraces,
    lame: [Lame; 2],
    reach: f64,
    parameters: &BTreeMap<String, f64>,
) -> Result<Traces, Fault> {
    only_its_own(raw)?;
    let texts = TraceTexts {
        line: line(raw)?,
        w: pair(&raw.w),
        a: pair(&raw.a),
        p: raw.p.get_ref(),
        cutoff: raw.cutoff.as_ref().map(pair),
    };
    let mut solution = Traces::parse(&texts, parameters, lame).map_err(|e| fault(raw, &texts, &e, parameters))?;
    let numbers = |list: &[Finite]| list.iter().map(|s| s.0).collect();
    solution.switches = numbers(&raw.switches);
    solution.singular = numbers(&raw.singular);
    solution.breaks = numbers(&raw.breaks);
    solution.reach = reach;
    Ok(solution)
}

/// Twice the diagonal of the box around the corners of both bodies: farther than any two points of a body are apart, also
/// where a side bulges out of the box.
pub fn reach(bodies: &[Shape; 2]) -> f64 {
    let nodes = || bodies.iter().filter_map(|s| s.imported.as_ref()).flat_map(|i| i.mesh.points.iter().copied());
    let corners = || bodies.iter().flat_map(|s| &s.blocks).flat_map(|b| b.corners).chain(nodes());
    let start = Point::repeat(f64::INFINITY);
    let low = corners().fold(start, |low, p| low.inf(&p));
    let high = corners().fold(-start, |high, p| high.sup(&p));
    2.0 * (high - low).norm()
}

fn pair(raw: &RawField) -> [&str; 2] {
    raw.each_ref().map(|text| text.get_ref().as_str())
}

/// Refuses what belongs to the line of another lemma.
fn only_its_own(raw: &RawTraces) -> Result<(), Fault> {
    let lemma = *raw.lemma.get_ref();
    let places: [(&str, Option<Range<usize>>, TraceLemma); 4] = [
        ("centre", raw.centre.as_ref().map(Spanned::span), TraceLemma::Arc),
        ("radius", raw.radius.as_ref().map(Spanned::span), TraceLemma::Arc),
        ("middle", raw.middle.as_ref().map(Spanned::span), TraceLemma::Arc),
        ("f", raw.f.as_ref().map(Spanned::span), TraceLemma::Graph),
    ];
    for (key, span, owner) in places {
        if let Some(span) = span.filter(|_| owner != lemma) {
            let message = format!("`{key}` belongs to the {} lemma, not to the {} lemma", owner.word(), lemma.word());
            return refuse(span, message, format!("leave it out, or write `lemma = \"{}\"`", owner.word()));
        }
    }
    Ok(())
}

fn line(raw: &RawTraces) -> Result<LineText<'_>, Fault> {
    let missing = |what: &str, example: &str| {
        let message = format!("the {} lemma needs {what}", raw.lemma.get_ref().word());
        refuse(raw.lemma.span(), message, format!("add {example}"))
    };
    match (raw.lemma.get_ref(), &raw.centre, &raw.radius, &raw.f) {
        (TraceLemma::Line, ..) => Ok(LineText::Straight),
        (TraceLemma::Arc, Some(centre), Some(radius), _) => Ok(LineText::Arc {
            centre: point(centre.get_ref()),
            radius: radius.get_ref().0,
            middle: raw.middle.as_ref().map_or(0.0, |angle| angle.get_ref().0),
        }),
        (TraceLemma::Arc, ..) => missing("`centre` and `radius`", "for example `centre = [0, 0]` and `radius = 1`"),
        (TraceLemma::Graph, _, _, Some(f)) => Ok(LineText::Graph { f: pair(f.get_ref()) }),
        (TraceLemma::Graph, ..) => {
            missing("`f`", "for example `f = [\"eta^2/4\", \"-eta^2/8\"]`, first body on the right")
        }
    }
}

/// The error at its place in the file.
fn fault(raw: &RawTraces, texts: &TraceTexts<'_>, error: &TraceError, parameters: &BTreeMap<String, f64>) -> Fault {
    match error {
        TraceError::Expression { name, body, source } => {
            let culprit = expression(raw, *name, body.unwrap_or(Body::First));
            expression_fault(culprit, source, &texts.variables(*name), parameters)
        }
        TraceError::Radius(_) => {
            let place = raw.radius.as_ref().map_or(raw.lemma.span(), Spanned::span);
            Fault::new(place, error.to_string(), "give the radius of the common arc")
        }
    }
}

fn expression(raw: &RawTraces, name: TraceName, body: Body) -> &Spanned<String> {
    let list = match name {
        TraceName::P => None,
        TraceName::W => Some(&raw.w),
        TraceName::A => Some(&raw.a),
        TraceName::F => raw.f.as_ref().map(Spanned::get_ref),
        TraceName::Cutoff => raw.cutoff.as_ref(),
    };
    list.map_or(&raw.p, |pair| &pair[body.index()])
}
