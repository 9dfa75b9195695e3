//! The exact solution of a study file: built in by name, by expressions, or by traces on the contact line.

use super::error::{Fault, refuse};
use super::field::{INSIDE, expression_fault};
use super::fixed::Fixed;
use super::raw::{RawExact, RawField, RawLame};
use super::shape::point;
use super::spanned::Spanned;
use super::traces::{reach, traces};
use super::words::suggestion;
use crate::exact::{self, Exact, Expressions};
use crate::study::{ExactScene, Shape};
use signorini_contact::Material;
use signorini_contact::geometry::Segment;
use signorini_contact::material::Lame;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// The exact solution, with the materials of the scene unless the study plants others.
pub fn exact(
    raw: &Spanned<RawExact>,
    bodies: &[Shape; 2],
    scene: &[Material; 2],
    parameters: &BTreeMap<String, f64>,
    control: bool,
) -> Result<ExactScene, Fault> {
    let e = raw.get_ref();
    let materials = match &e.materials {
        None => *scene,
        Some(m) if !control => {
            let next = "leave it to studies with `expect`";
            return refuse(
                m.span(),
                "`materials` of an exact solution other than the bodies' are a planted defect",
                next,
            );
        }
        Some(m) => planted(m)?,
    };
    let solution: Arc<dyn Exact> = match (&e.builtin, &e.first, &e.second, &e.traces) {
        (Some(name), None, None, None) => built_in(name, e, &materials, parameters)?,
        (None, Some(first), Some(second), None) => Arc::new(expressions(e, [first, second], parameters)?),
        (None, None, None, Some(given)) => {
            no_points_beside(e, given.span(), "[exact.traces]", "give them there, as parameters of the contact line")?;
            let lame = isotropic(&materials, given.get_ref().lemma.span(), "a lemma")?;
            Arc::new(traces(given.get_ref(), lame, reach(bodies), parameters)?)
        }
        _ => {
            let message = "[exact] needs either `builtin`, or `first` and `second`, or `traces`";
            let next = "name a built-in solution, or give the displacement of both bodies, or its traces";
            return refuse(raw.span(), message, next);
        }
    };
    Ok(ExactScene { solution, materials })
}

/// Whether a case takes the study's exact solution back: `builtin = "none"`.
pub fn is_none(raw: &RawExact) -> bool {
    raw.builtin.as_ref().is_some_and(|name| name.get_ref() == "none")
}

fn planted(raw: &Spanned<Fixed<RawLame, 2>>) -> Result<[Material; 2], Fault> {
    let law = |l: &RawLame| {
        Material::lame(l.lame[0].0, l.lame[1].0)
            .map_err(|e| Fault::new(raw.span(), e.to_string(), "choose μ > 0 and λ + μ > 0"))
    };
    let [first, second] = &raw.get_ref().0;
    Ok([law(first)?, law(second)?])
}

fn expressions(
    raw: &RawExact,
    displacement: [&RawField; 2],
    parameters: &BTreeMap<String, f64>,
) -> Result<Expressions, Fault> {
    let texts = displacement.map(|u| u.each_ref().map(|component| component.get_ref().as_str()));
    let mut solution = Expressions::parse(texts, parameters).map_err(|e| {
        let culprit = &displacement[e.body.index()][e.component];
        expression_fault(culprit, &e.source, &INSIDE, parameters)
    })?;
    solution.singular_points = raw.singular.iter().map(point).collect();
    solution.break_lines = raw.breaks.iter().map(|s| Segment { a: point(&s[0]), b: point(&s[1]) }).collect();
    solution.switch_points = raw.switches.iter().map(point).collect();
    Ok(solution)
}

fn built_in(
    name: &Spanned<String>,
    raw: &RawExact,
    materials: &[Material; 2],
    parameters: &BTreeMap<String, f64>,
) -> Result<Arc<dyn Exact>, Fault> {
    let word = name.get_ref();
    let names: Vec<&str> = exact::BUILT_INS.iter().map(|b| b.name).collect();
    if !names.contains(&word.as_str()) {
        let message = format!("no built-in exact solution `{word}`");
        return refuse(name.span(), message, suggestion(word, &names));
    }
    no_points_beside(raw, name.span(), &format!("`{word}`"), "leave `singular`, `breaks` and `switches` out")?;
    let lame = isotropic(materials, name.span(), &format!("`{word}`"))?;
    exact::built_in(word, parameters, lame)
        .map_err(|e| Fault::new(name.span(), e, "give its numbers in [parameters], or in `parameters` of the case"))
}

/// Refuses `singular`, `breaks` and `switches` of [exact] where the solution has its own.
fn no_points_beside(raw: &RawExact, place: Range<usize>, owner: &str, next: &str) -> Result<(), Fault> {
    if raw.singular.is_empty() && raw.breaks.is_empty() && raw.switches.is_empty() {
        return Ok(());
    }
    refuse(place, format!("{owner} knows its own singular points, break lines and switch points"), next)
}

fn isotropic(materials: &[Material; 2], place: Range<usize>, solver: &str) -> Result<[Lame; 2], Fault> {
    let [Some(first), Some(second)] = [materials[0].lame_constants(), materials[1].lame_constants()] else {
        let message = format!("{solver} solves for isotropic bodies only");
        return refuse(place, message, "give both materials by `lame`, or by `young` and `poisson`");
    };
    Ok([first, second])
}
