//! Boundary parts and the contact zone of a study file.

use super::error::{Fault, refuse};
use super::field::{BOUNDARY, INSIDE, vector_field};
use super::raw::{ConditionName, RawBoundary, RawContact};
use super::shape::polyline;
use super::words::suggestion;
use crate::study::{Part, PartCondition, Shape};
use signorini_contact::{Body, Point};
use std::collections::BTreeMap;

/// The boundary parts in file order.
pub fn parts(raw: &[RawBoundary], shapes: &[Shape; 2], parameters: &BTreeMap<String, f64>) -> Result<Vec<Part>, Fault> {
    let mut parts: Vec<Part> = Vec::with_capacity(raw.len());
    for boundary in raw {
        let part = part(boundary, shapes, parameters)?;
        if parts.iter().any(|p| p.body == part.body && p.name == part.name) {
            let message = format!("body `{}` has two boundary parts `{}`", boundary.body.get_ref(), part.name);
            return refuse(boundary.name.span(), message, "rename one of them");
        }
        parts.push(part);
    }
    Ok(parts)
}

fn part(raw: &RawBoundary, shapes: &[Shape; 2], parameters: &BTreeMap<String, f64>) -> Result<Part, Fault> {
    let word = raw.body.get_ref();
    let Some(body) = Body::BOTH.into_iter().find(|b| shapes[b.index()].name == *word) else {
        let names = shapes.each_ref().map(|s| s.name.as_str());
        return refuse(raw.body.span(), format!("there is no body `{word}`"), suggestion(word, &names));
    };
    Ok(Part {
        body,
        name: raw.name.get_ref().clone(),
        along: polyline(&raw.along, &[&shapes[body.index()]])?,
        condition: condition(raw, parameters)?,
    })
}

fn condition(raw: &RawBoundary, parameters: &BTreeMap<String, f64>) -> Result<PartCondition, Fault> {
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

/// The contact polyline; its corners lie on both bodies.
pub fn contact(raw: &RawContact, shapes: &[Shape; 2]) -> Result<Vec<Point>, Fault> {
    polyline(&raw.along, &[&shapes[0], &shapes[1]])
}
