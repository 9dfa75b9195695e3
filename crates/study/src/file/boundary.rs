//! Boundary parts and the contact zone of a study file.

use super::curve::Curves;
use super::error::{Fault, refuse};
use super::field::{BOUNDARY, INSIDE, vector_field};
use super::fixed::Fixed;
use super::raw::{ConditionName, RawBoundary, RawContact, RawPoint};
use super::shape::{on_sides, path, point};
use super::spanned::Spanned;
use super::words::suggestion;
use crate::study::{Part, PartCondition, Shape};
use signorini_contact::geometry::{LinePoint, tangent_of};
use signorini_contact::{Body, ContactLine, Vec2};
use std::collections::BTreeMap;
use std::ops::Range;

/// The boundary parts in file order.
pub fn parts(
    raw: &[RawBoundary],
    shapes: &[Shape; 2],
    curves: &Curves,
    parameters: &BTreeMap<String, f64>,
) -> Result<Vec<Part>, Fault> {
    let mut parts: Vec<Part> = Vec::with_capacity(raw.len());
    for boundary in raw {
        let part = part(boundary, shapes, curves, parameters)?;
        if parts.iter().any(|p| p.body == part.body && p.name == part.name) {
            let message = format!("body `{}` has two boundary parts `{}`", boundary.body.get_ref(), part.name);
            return refuse(boundary.name.span(), message, "rename one of them");
        }
        parts.push(part);
    }
    Ok(parts)
}

fn part(
    raw: &RawBoundary,
    shapes: &[Shape; 2],
    curves: &Curves,
    parameters: &BTreeMap<String, f64>,
) -> Result<Part, Fault> {
    let body = body_of(&raw.body, shapes.each_ref().map(|s| s.name.as_str()))?;
    if let Some(physical) = &raw.physical {
        return refuse(physical.span(), NO_MESH, "give the path `along` that the part covers, or add [mesh]");
    }
    let Some(along) = &raw.along else {
        let message = format!("boundary `{}` does not say where it is", raw.name.get_ref());
        return refuse(raw.name.span(), message, "add `along = [[x, y], [x, y]]`");
    };
    Ok(Part {
        body,
        name: raw.name.get_ref().clone(),
        along: path(along, &raw.curves, curves, &[&shapes[body.index()]])?,
        condition: condition(raw, parameters)?,
    })
}

/// The body of this name.
pub fn body_of(word: &Spanned<String>, names: [&str; 2]) -> Result<Body, Fault> {
    let found = Body::BOTH.into_iter().find(|b| names[b.index()] == word.get_ref());
    found.ok_or_else(|| {
        let message = format!("there is no body `{}`", word.get_ref());
        Fault::new(word.span(), message, suggestion(word.get_ref(), &names))
    })
}

const NO_MESH: &str = "a physical curve, and there is no [mesh] whose file would have it";

/// The condition of a part.
pub fn condition(raw: &RawBoundary, parameters: &BTreeMap<String, f64>) -> Result<PartCondition, Fault> {
    let name = *raw.condition.get_ref();
    // A displacement has one value at a corner, where the normal has two: it may not depend on the normal.
    let variables: &[&str] = if name == ConditionName::Fixed { &INSIDE } else { &BOUNDARY };
    let value = raw.value.as_ref().map(|v| vector_field(v.get_ref(), variables, parameters)).transpose()?;
    if let (Some(v), ConditionName::Sliding | ConditionName::Free) = (&raw.value, name) {
        let message = format!("`value` on boundary `{}`, where the condition fixes everything", raw.name.get_ref());
        return refuse(v.span(), message, "leave `value` out, or choose `fixed` or `traction`");
    }
    Ok(match name {
        ConditionName::Fixed => PartCondition::Fixed(value),
        ConditionName::Sliding => PartCondition::Sliding,
        ConditionName::Traction => PartCondition::Traction(value),
        ConditionName::Free => PartCondition::Free,
    })
}

/// The contact zone: a path whose corners lie on both bodies, or the gap between two curves, each on its body.
pub fn contact(
    raw: &RawContact,
    shapes: &[Shape; 2],
    curves: &Curves,
    place: Range<usize>,
) -> Result<ContactLine, Fault> {
    if let Some(physical) = &raw.physical {
        return refuse(physical.span(), NO_MESH, "give the path `along` of the zone, or add [mesh]");
    }
    match (&raw.along, &raw.gap) {
        (Some(along), None) => {
            if let Some(d) = &raw.direction {
                return refuse(d.span(), "`direction` belongs to a `gap`", "leave it out");
            }
            path(along, &raw.curves, curves, &[&shapes[0], &shapes[1]]).map(ContactLine::Common)
        }
        (None, Some(names)) => gap(names, raw.direction.as_ref(), shapes, curves),
        _ => {
            let span = raw.gap.as_ref().map_or(place, Spanned::span);
            refuse(span, "[contact] needs either `along` or `gap`", "give the common path, or the two curves of a gap")
        }
    }
}

fn gap(
    names: &Spanned<Fixed<Spanned<String>, 2>>,
    direction: Option<&Spanned<RawPoint>>,
    shapes: &[Shape; 2],
    curves: &Curves,
) -> Result<ContactLine, Fault> {
    let [first, second] = &names.get_ref().0;
    let (Some(f), Some(s)) = (curves.find(first)?, curves.find(second)?) else {
        return refuse(names.span(), "a gap between curves without names", "name a curve of each body");
    };
    let xi = direction.map_or(Vec2::x(), |d| point(d.get_ref()));
    if (xi.norm() - 1.0).abs() > 1e-12 {
        let span = direction.map_or(names.span(), Spanned::span);
        return refuse(span, format!("direction ({}, {}) of length {}", xi.x, xi.y, xi.norm()), "give length 1");
    }
    let eta = tangent_of(xi);
    let heights = [&f, &s].map(|c| {
        let ends = [c.point(0.0).dot(&eta), c.point(1.0).dot(&eta)];
        (ends[0].min(ends[1]), ends[0].max(ends[1]))
    });
    let ((a, b), (c, d)) = (heights[0], heights[1]);
    if (a - c).abs().max((b - d).abs()) > 1e-12 * (b - a) {
        let message = format!("the curves of the gap run over [{a}, {b}] and [{c}, {d}] across the direction");
        return refuse(names.span(), message, "let both run over the same interval");
    }
    for ((curve, shape), name) in [&f, &s].into_iter().zip(shapes).zip([first, second]) {
        on_sides(&[curve.point(0.0), curve.point(1.0)], shape, name.span())?;
    }
    let line = ContactLine::Gap { curves: [f, s], direction: xi };
    let pieces = line.pieces();
    for k in 0..=64 {
        let point = LinePoint::new([&pieces[0][0], &pieces[0][1]], Some(xi), f64::from(k) / 64.0);
        if point.gap < -1e-12 * (b - a) {
            let message = format!("the gap is {} at ({}, {})", point.gap, point.at[0].x, point.at[0].y);
            return refuse(
                names.span(),
                message,
                "the first curve is that of Ω', on the far side of the gap along `direction`",
            );
        }
    }
    Ok(line)
}
