//! Vector fields of a study file: two expressions each.

use super::error::Fault;
use super::raw::RawField;
use super::spanned::Spanned;
use crate::expr::{ExprError, Expression};
use crate::study::VectorField;
use signorini_contact::{Point, Vec2};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Variables inside a body.
pub const INSIDE: [&str; 2] = ["x", "y"];
/// Variables on the boundary: the point and the outward normal of the body.
pub const BOUNDARY: [&str; 4] = ["x", "y", "nx", "ny"];

/// The field as a function of the point and the normal; variables that it was not parsed with are not seen by it.
pub fn vector_field(
    raw: &RawField,
    variables: &[&str],
    parameters: &BTreeMap<String, f64>,
) -> Result<VectorField, Fault> {
    let first = component(&raw[0], variables, parameters)?;
    let second = component(&raw[1], variables, parameters)?;
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
    Expression::parse(raw.get_ref(), variables, parameters)
        .map_err(|e| expression_fault(raw, &e, variables, parameters))
}

/// The error of an expression, at its place in the file.
pub fn expression_fault(
    raw: &Spanned<String>,
    error: &ExprError,
    variables: &[&str],
    parameters: &BTreeMap<String, f64>,
) -> Fault {
    let names: Vec<&str> = variables.iter().copied().chain(parameters.keys().map(String::as_str)).collect();
    let next = format!("correct it; names known here: {}", names.join(", "));
    Fault::new(inside(raw, error.column), format!("expression `{}`: {}", error.text, error.message), next)
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
