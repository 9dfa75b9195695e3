//! The initial distance of the bodies along a straight common zone.

use super::error::{Fault, refuse};
use super::exact::is_none;
use super::field::{INSIDE, expression_fault};
use super::raw::{RawContact, RawExact};
use crate::expr::Expression;
use signorini_contact::geometry::InitialGap;
use signorini_contact::{ContactLine, Point};
use std::collections::BTreeMap;

/// `g(x, y)` of a zone that is straight, or has straight pieces.
pub fn initial_gap(
    raw: &RawContact,
    zone: &ContactLine,
    exact: Option<&RawExact>,
    parameters: &BTreeMap<String, f64>,
) -> Result<Option<InitialGap>, Fault> {
    let Some(text) = &raw.initial_gap else { return Ok(None) };
    match zone {
        ContactLine::Gap { .. } => {
            let message = "`initial_gap` beside `gap`: the two curves say how far apart the bodies are";
            return refuse(text.span(), message, "leave `initial_gap` out, or give the zone by `along`");
        }
        ContactLine::Common(path) if path.curves.iter().any(Option::is_some) => {
            let message = "`initial_gap` on a curved zone, where the estimates have no such term";
            return refuse(text.span(), message, "give it on a straight zone, or give two curves with a `gap`");
        }
        ContactLine::Common(_) => {}
    }
    if exact.is_some_and(|e| !is_none(e)) {
        let message = "`initial_gap` beside an exact solution, whose own gap begins at zero";
        return refuse(text.span(), message, "leave one of them out; an overkill reference serves any initial gap");
    }
    let expression = Expression::parse(text.get_ref(), &INSIDE, parameters)
        .map_err(|e| expression_fault(text, &e, &INSIDE, parameters))?;
    Ok(Some(InitialGap::new(move |x: Point| expression.eval(&[x.x, x.y]))))
}
