//! Vector fields of a study file: two expressions each.

use super::error::Fault;
use super::raw::RawField;
use crate::expr::Expression;
use crate::study::VectorField;
use signorini_contact::{Point, Vec2};
use std::collections::BTreeMap;
use std::sync::Arc;
use toml::Spanned;

/// Variables inside a body.
pub const INSIDE: [&str; 2] = ["x", "y"];
/// Variables on the boundary: the point and the outward normal of the body.
pub const BOUNDARY: [&str; 4] = ["x", "y", "nx", "ny"];

/// Both components in the given variables.
pub fn components(
    raw: &RawField,
    variables: &[&str],
    parameters: &BTreeMap<String, f64>,
) -> Result<[Expression; 2], Fault> {
    Ok([component(&raw[0], variables, parameters)?, component(&raw[1], variables, parameters)?])
}

/// The field as a function of the point and the normal; variables that it was not parsed with are not seen by it.
pub fn vector_field(
    raw: &RawField,
    variables: &[&str],
    parameters: &BTreeMap<String, f64>,
) -> Result<VectorField, Fault> {
    let [first, second] = components(raw, variables, parameters)?;
    Ok(Arc::new(move |x: Point, n: Vec2| {
        let at = [x.x, x.y, n.x, n.y];
        Vec2::new(first.eval(&at), second.eval(&at))
    }))
}

fn component(
    raw: &Spanned<String>,
    variables: &[&str],
    parameters: &BTreeMap<String, f64>,
) -> Result<Expression, Fault> {
    let text = raw.get_ref();
    Expression::parse(text, variables, parameters).map_err(|e| {
        let names: Vec<&str> = variables.iter().copied().chain(parameters.keys().map(String::as_str)).collect();
        let message = format!("expression: {}", e.message);
        Fault::new(inside(raw, e.column), message, format!("correct it; known here: {}", names.join(", ")))
    })
}

/// The place of the expression's character `column` in the file, if the string is written without escapes; else the whole.
fn inside(raw: &Spanned<String>, column: usize) -> std::ops::Range<usize> {
    let (span, text) = (raw.span(), raw.get_ref());
    if span.len() != text.len() + 2 {
        return span;
    }
    let offset = text.char_indices().nth(column.saturating_sub(1)).map_or(text.len(), |(i, _)| i);
    let start = span.start + 1 + offset;
    start..start + 1
}
