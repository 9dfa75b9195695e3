//! What a formula of engineering says of the contact, from a study file: numbers, and the pressure along the zone.

use super::error::{Fault, refuse};
use super::field::{INSIDE, expression_fault};
use super::number::NumberOrText;
use super::raw::RawFormula;
use super::spanned::Spanned;
use crate::expr::Expression;
use crate::record::FormulaValues;
use crate::study::Formula;
use signorini_contact::{ContactLine, Point};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Points at which the pressure is tried on each piece of the zone.
const TRIALS: u32 = 64;

/// The formula. Later fields may use the earlier ones by name: `force`, `half_width`, `peak_pressure`, `pressure`.
pub fn formula(
    raw: &Spanned<RawFormula>,
    contact: &ContactLine,
    parameters: &BTreeMap<String, f64>,
) -> Result<Formula, Fault> {
    let f = raw.get_ref();
    let mut known = parameters.clone();
    let mut next = |name: &str, given: &Option<Spanned<NumberOrText>>| -> Result<Option<f64>, Fault> {
        let Some(given) = given else { return Ok(None) };
        let value = positive(name, given, &known)?;
        if known.insert(name.to_string(), value).is_some() {
            let message = format!("`{name}` is a parameter and a field of [formula]");
            return refuse(given.span(), message, "rename the parameter");
        }
        Ok(Some(value))
    };
    let values = FormulaValues {
        force: next("force", &f.force)?,
        half_width: next("half_width", &f.half_width)?,
        peak_pressure: next("peak_pressure", &f.peak_pressure)?,
    };
    let pressure = f.pressure.as_ref().map(|text| pressure(text, contact, &known)).transpose()?;
    if values == FormulaValues::default() && pressure.is_none() {
        let next = "give `force`, `half_width`, `peak_pressure` or `pressure`";
        return refuse(raw.span(), "[formula] says nothing", next);
    }
    Ok(Formula { values, pressure })
}

fn positive(name: &str, raw: &Spanned<NumberOrText>, known: &BTreeMap<String, f64>) -> Result<f64, Fault> {
    let value = match raw.get_ref() {
        NumberOrText::Number(x) => *x,
        NumberOrText::Text(text) => {
            let text = Spanned::new(raw.span(), text.clone());
            Expression::parse(text.get_ref(), &[], known)
                .map_err(|e| expression_fault(&text, &e, &[], known))?
                .eval(&[])
        }
    };
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    refuse(raw.span(), format!("{name} = {value} must be positive"), "correct the formula, or its parameters")
}

type Pressure = Arc<dyn Fn(Point) -> f64 + Send + Sync>;

fn pressure(raw: &Spanned<String>, contact: &ContactLine, known: &BTreeMap<String, f64>) -> Result<Pressure, Fault> {
    let expression =
        Expression::parse(raw.get_ref(), &INSIDE, known).map_err(|e| expression_fault(raw, &e, &INSIDE, known))?;
    let at = move |x: Point| expression.eval(&[x.x, x.y]);
    for [piece, _] in contact.pieces() {
        for x in (0..=TRIALS).map(|k| piece.point(f64::from(k) / f64::from(TRIALS))) {
            let p = at(x);
            if !(p.is_finite() && p >= 0.0) {
                let message = format!("the pressure is {p} at ({}, {})", x.x, x.y);
                let next = "let it be zero where nothing touches, e.g. sqrt(pos(1 - (x/half_width)^2))";
                return refuse(raw.span(), message, next);
            }
        }
    }
    Ok(Arc::new(at))
}
