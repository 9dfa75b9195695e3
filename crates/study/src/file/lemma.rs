//! The table `[lemma]`: what a case measures where it solves no contact problem.

use super::error::{Fault, refuse};
use super::field::expression_fault;
use super::fixed::Fixed;
use super::layer::Layer;
use super::number::Finite;
use super::raw::{LemmaName, NormsName, RawLemma, SideName};
use super::spanned::Spanned;
use crate::expr::Expression;
use crate::lemma::Lemma;
use crate::lemma::boundary::BoundaryFunction;
use crate::lemma::domain::{Domain, Side};
use crate::lemma::ellipse::Ellipse;
use crate::lemma::inverse::{Intervals, Norms};
use std::collections::BTreeMap;
use std::ops::Range;

/// Longest over shortest semi-axis: beyond it the coarse mesh is no good at the tips.
const LONGEST: f64 = 3.0;

/// The lemma of the table. `place` is the case's name.
pub fn lemma(raw: &Spanned<RawLemma>, parameters: &BTreeMap<String, f64>) -> Result<Lemma, Fault> {
    let (l, place) = (raw.get_ref(), raw.span());
    only_its_own(l)?;
    match l.kind {
        LemmaName::BoundaryInterpolation => {
            let domain = Domain { ellipse: ellipse(l, place.clone())?, side: Side::Inside };
            let text = needed(l.function.as_ref(), "function", "an expression in x, y, r", place)?;
            let expression = Expression::parse(text.get_ref(), &BoundaryFunction::VARIABLES, parameters)
                .map_err(|e| expression_fault(text, &e, &BoundaryFunction::VARIABLES, parameters))?;
            let function = BoundaryFunction::new(expression, &domain);
            Ok(Lemma::BoundaryInterpolation { domain, function })
        }
        LemmaName::InverseInequality => intervals(l, place).map(Lemma::InverseInequality),
        LemmaName::Strip => {
            let ellipse = ellipse(l, place.clone())?;
            let side = match needed(l.side.as_ref(), "side", "\"inside\" or \"outside\"", place)?.get_ref() {
                SideName::Inside => Side::Inside,
                SideName::Outside => Side::Outside,
            };
            Ok(Lemma::Strip(Domain { ellipse, side }))
        }
    }
}

/// Refuses what belongs to a contact problem.
pub fn nothing_else(layer: &Layer<'_>) -> Result<(), Fault> {
    let body = layer.body.unwrap_or_default().first().map(|b| ("[[body]]", b.get_ref().name.span()));
    let boundary = layer.boundary.unwrap_or_default().first().map(|b| ("[[boundary]]", b.name.span()));
    let tables = [
        body,
        boundary,
        layer.mesh.map(|m| ("[mesh]", m.file.span())),
        layer.contact.and_then(|c| c.span()).map(|span| ("[contact]", span)),
        layer.slide.map(|s| ("[slide]", s.span())),
        layer.curve.and_then(|c| c.first()).map(|c| ("[[curve]]", c.span())),
        layer.discretisation.map(|d| ("[discretisation]", d.span())),
        layer.exact.map(|e| ("[exact]", e.span())),
        layer.formula.map(|f| ("[formula]", f.span())),
        layer.family.map(|f| ("[family]", f.span())),
        layer.reference.map(|r| ("[reference]", r.span())),
    ];
    match tables.into_iter().flatten().next() {
        None => Ok(()),
        Some((name, span)) => {
            let message = format!("{name} beside [lemma]: a lemma solves no contact problem");
            refuse(span, message, "keep one of them")
        }
    }
}

/// Every level of a refined mesh halves the coarse sides.
pub fn powers_of_two(levels: &[usize], span: Range<usize>) -> Result<(), Fault> {
    match levels.iter().find(|n| !n.is_power_of_two()) {
        None => Ok(()),
        Some(n) => refuse(
            span,
            format!("level {n}: the coarse sides are halved, never divided by {n}"),
            "let every level be a power of two, e.g. [4, 8, 16, 32, 64, 128]",
        ),
    }
}

/// Fields that say nothing for the kind.
fn only_its_own(l: &RawLemma) -> Result<(), Fault> {
    let (name, own): (_, &[&str]) = match l.kind {
        LemmaName::BoundaryInterpolation => ("boundary-interpolation", &["semi_axes", "function"]),
        LemmaName::InverseInequality => ("inverse-inequality", &["interval", "norms", "seed"]),
        LemmaName::Strip => ("strip", &["semi_axes", "side"]),
    };
    let given = [
        ("semi_axes", l.semi_axes.as_ref().map(Spanned::span)),
        ("function", l.function.as_ref().map(Spanned::span)),
        ("side", l.side.as_ref().map(Spanned::span)),
        ("interval", l.interval.as_ref().map(Spanned::span)),
        ("norms", l.norms.as_ref().map(Spanned::span)),
        ("seed", l.seed.as_ref().map(Spanned::span)),
    ];
    match given.into_iter().find(|(field, span)| span.is_some() && !own.contains(field)) {
        Some((field, Some(span))) => {
            let message = format!("`{field}` says nothing to the lemma `{name}`");
            refuse(span, message, format!("leave it out; it takes {}", own.join(", ")))
        }
        _ => Ok(()),
    }
}

fn needed<'a, T>(
    field: Option<&'a Spanned<T>>,
    name: &str,
    what: &str,
    place: Range<usize>,
) -> Result<&'a Spanned<T>, Fault> {
    field.ok_or_else(|| Fault::new(place, format!("this lemma needs `{name}`"), format!("give `{name}`: {what}")))
}

fn ellipse(l: &RawLemma, place: Range<usize>) -> Result<Ellipse, Fault> {
    let raw: &Spanned<Fixed<Finite, 2>> =
        needed(l.semi_axes.as_ref(), "semi_axes", "[a, b] of the ellipse, a disc if equal", place)?;
    let [a, b] = raw.get_ref().0.map(|x| x.0);
    if b > 0.0 && a >= b && a <= LONGEST * b {
        return Ok(Ellipse { semi_axes: [a, b] });
    }
    let message = format!("semi-axes {a} and {b}, where 0 < b ≤ a ≤ {LONGEST} b must hold");
    refuse(raw.span(), message, "give the longer one first; a very slender ellipse has no good coarse mesh here")
}

fn intervals(l: &RawLemma, place: Range<usize>) -> Result<Intervals, Fault> {
    let raw = needed(l.interval.as_ref(), "interval", "[a, b]", place.clone())?;
    let whole = raw.get_ref().0.map(|x| x.0);
    if whole[0] >= whole[1] {
        let message = format!("the interval from {} to {} has no length", whole[0], whole[1]);
        return refuse(raw.span(), message, "give the smaller end first");
    }
    let norms = match needed(l.norms.as_ref(), "norms", "\"seminorms\", \"full-right\" or \"full\"", place.clone())? {
        n if *n.get_ref() == NormsName::Seminorms => Norms::Seminorms,
        n if *n.get_ref() == NormsName::FullRight => Norms::FullRight,
        _ => Norms::Full,
    };
    let seed = *needed(l.seed.as_ref(), "seed", "a whole number for the irregular division", place)?.get_ref();
    Ok(Intervals { whole, norms, seed })
}
