//! Named curves of a study file.

use super::error::{Fault, refuse};
use super::field::expression_fault;
use super::raw::{RawCircle, RawCurve, RawGraph};
use super::shape::point;
use super::spanned::Spanned;
use super::words::suggestion;
use crate::expr::{Along, Expression};
use signorini_contact::geometry::{CircularArc, Graph, SharedCurve, Spline};
use signorini_contact::{Point, Vec2};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// The curves of a case by name.
pub struct Curves(BTreeMap<String, SharedCurve>);

impl Curves {
    /// Reads the tables `[[curve]]`.
    pub fn read(raw: &[Spanned<RawCurve>], parameters: &BTreeMap<String, f64>) -> Result<Self, Fault> {
        let mut curves = BTreeMap::new();
        for r in raw {
            let name = r.get_ref().name.get_ref();
            if name.is_empty() || curves.insert(name.clone(), curve(r, parameters)?).is_some() {
                let message = format!("curve name `{name}` is empty or used twice");
                return refuse(r.get_ref().name.span(), message, "give every curve a name of its own");
            }
        }
        Ok(Self(curves))
    }

    /// The curve of this name; none for the empty name, which means straight.
    pub fn find(&self, name: &Spanned<String>) -> Result<Option<SharedCurve>, Fault> {
        let word = name.get_ref().as_str();
        if word.is_empty() {
            return Ok(None);
        }
        match self.0.get(word) {
            Some(curve) => Ok(Some(curve.clone())),
            None => {
                let names: Vec<&str> = self.0.keys().map(String::as_str).collect();
                refuse(name.span(), format!("there is no curve `{word}`"), suggestion(word, &names))
            }
        }
    }

    /// The curve of this name between two corners, which must lie on it.
    pub fn between(&self, name: &Spanned<String>, ends: [Point; 2]) -> Result<Option<SharedCurve>, Fault> {
        let found = self.find(name)?;
        if let Some(curve) = &found {
            on_curve(curve, name, ends)?;
        }
        Ok(found)
    }
}

/// Share of the distance of two corners by which each may miss its curve.
const TOLERANCE: f64 = 1e-9;

fn on_curve(curve: &SharedCurve, name: &Spanned<String>, ends: [Point; 2]) -> Result<(), Fault> {
    for x in ends {
        let (distance, size) = ((curve.point(curve.foot(x)) - x).norm(), (ends[1] - ends[0]).norm());
        if distance > TOLERANCE * size {
            let message =
                format!("the point ({}, {}) is {distance:.3e} away from curve `{}`", x.x, x.y, name.get_ref());
            return refuse(
                name.span(),
                message,
                "move the point onto the curve, with all its digits, or correct the curve",
            );
        }
    }
    Ok(())
}

fn curve(raw: &Spanned<RawCurve>, parameters: &BTreeMap<String, f64>) -> Result<SharedCurve, Fault> {
    let r = raw.get_ref();
    match (&r.circle, &r.graph, &r.through) {
        (Some(circle), None, None) => arc(circle),
        (None, Some(graph), None) => graph_of(graph, parameters),
        (None, None, Some(points)) => {
            let spline = Spline::through(points.get_ref().iter().map(point).collect());
            spline.map(|s| Arc::new(s) as SharedCurve).map_err(|e| {
                Fault::new(points.span(), e.to_string(), "list different points in the order of the curve")
            })
        }
        _ => {
            let message = format!("curve `{}` needs exactly one of `circle`, `graph`, `through`", r.name.get_ref());
            refuse(r.name.span(), message, "say what the curve is, once")
        }
    }
}

fn arc(raw: &Spanned<RawCircle>) -> Result<SharedCurve, Fault> {
    let c = raw.get_ref();
    let (radius, from, to) = (c.radius.0, c.from.0, c.to.0);
    let sound = radius > 0.0 && from != to && (to - from).abs() <= 360.0;
    if !sound {
        let message = format!("a circle of radius {radius} from {from}° to {to}°");
        return refuse(raw.span(), message, "give a positive radius and two different angles, at most 360° apart");
    }
    let centre = point(&c.centre);
    Ok(Arc::new(CircularArc { centre, radius, from: from.to_radians(), to: to.to_radians() }))
}

fn graph_of(raw: &Spanned<RawGraph>, parameters: &BTreeMap<String, f64>) -> Result<SharedCurve, Fault> {
    let g = raw.get_ref();
    let xi = Expression::parse(g.xi.get_ref(), &[ETA], parameters)
        .map_err(|e| expression_fault(&g.xi, &e, &[ETA], parameters))?;
    let direction = g.direction.as_ref().map_or(Vec2::x(), point);
    let (from, to) = (g.from.0, g.to.0);
    if from == to || (direction.norm() - 1.0).abs() > 1e-12 {
        let message = format!("a graph from {from} to {to} along ({}, {})", direction.x, direction.y);
        return refuse(raw.span(), message, "give two different ends and a direction of length 1");
    }
    finite(&xi, from, to, g.xi.span())?;
    let name = format!("{} with {parameters:?}", xi.text());
    Ok(Arc::new(Graph { function: Arc::new(move |eta| jet(&xi, eta)), name, direction, from, to }))
}

/// The variable of a graph.
const ETA: &str = "eta";

/// `f, f', f''`.
fn jet(xi: &Expression, eta: f64) -> [f64; 3] {
    let Along { re, derivatives: [slope, bend] } = xi.eval(&[Along::variable(eta)]);
    [re, slope, bend]
}

fn finite(xi: &Expression, from: f64, to: f64, span: Range<usize>) -> Result<(), Fault> {
    for k in 0..=64 {
        let eta = from + f64::from(k) / 64.0 * (to - from);
        if let Some(bad) = jet(xi, eta).into_iter().find(|v| !v.is_finite()) {
            let message = format!("f, f' or f'' is {bad} at eta = {eta}");
            return refuse(span, message, "choose a function that is twice differentiable on the whole interval");
        }
    }
    Ok(())
}
