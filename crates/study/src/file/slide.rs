//! The condition that picks one solution where a body may slide.

use super::error::{Fault, refuse};
use super::raw::RawSlide;
use super::shape::{on_sides, point};
use super::words::suggestion;
use crate::study::Shape;
use signorini_contact::Body;
use signorini_contact::geometry::Segment;
use signorini_contact::problem::SlideCondition;

/// `p(v) = ∫ v_t ds = 0` on a straight part of a body's boundary.
pub fn slide(raw: &RawSlide, shapes: &[Shape; 2]) -> Result<SlideCondition, Fault> {
    let word = raw.body.get_ref();
    let Some(body) = Body::BOTH.into_iter().find(|b| shapes[b.index()].name == *word) else {
        let names = shapes.each_ref().map(|s| s.name.as_str());
        return refuse(raw.body.span(), format!("there is no body `{word}`"), suggestion(word, &names));
    };
    let [a, b] = raw.along.get_ref().0.each_ref().map(point);
    if a == b {
        let message = format!("the part from ({}, {}) to itself has no length", a.x, a.y);
        return refuse(raw.along.span(), message, "give the two ends of a straight part of the boundary");
    }
    on_sides(&[a, b], &shapes[body.index()], raw.along.span())?;
    Ok(SlideCondition { body, along: Segment { a, b } })
}
