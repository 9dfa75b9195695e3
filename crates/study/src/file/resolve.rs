//! From the tables of a study file to its cases.

use super::canonical;
use super::curve::Curves;
use super::error::{Fault, refuse};
use super::field::{INSIDE, vector_field};
use super::imported::Geometry;
use super::layer::Layer;
use super::raw::{Expect, RawBody, RawStudy};
use super::spanned::Spanned;
use super::{
    bilateral, boundary, discretisation, exact, formula, imported, initial_gap, judge, lemma, material, plan, shape,
    slide, splitting, words,
};
use crate::claim::Claim;
use crate::lemma::Lemma;
use crate::record::Outcome;
use crate::study::{Case, ReferencePlan, Scene, Study, Subject};
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

/// The study of the tables, read from `path`.
pub fn study(raw: &RawStudy, path: &Path) -> Result<Study, Fault> {
    words::folder_name("id", raw.id.get_ref(), raw.id.span())?;
    let id = raw.id.get_ref().clone();
    if path.file_stem().is_some_and(|stem| stem != id.as_str()) {
        let message = format!("id `{id}` in a file named `{}`", path.display());
        return refuse(raw.id.span(), message, "a study is found by its file name: let the two agree");
    }
    let claim = judge::claim(raw)?;
    Ok(Study {
        cases: cases(raw, &claim)?,
        id,
        title: raw.title.clone(),
        question: prose(&raw.question),
        setup: prose(&raw.setup),
        refuted_by: prose(&raw.refuted_by),
        claim,
        source: path.to_path_buf(),
    })
}

/// Line breaks of the file are not part of the text.
fn prose(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn cases(raw: &RawStudy, claim: &Claim) -> Result<Vec<Case>, Fault> {
    if raw.case.is_empty() {
        return Ok(vec![case(&raw.id, Layer::of_study(raw), claim)?]);
    }
    let mut cases: Vec<Case> = Vec::with_capacity(raw.case.len());
    for own in &raw.case {
        let name = own.name.get_ref();
        words::folder_name("case name", name, own.name.span())?;
        if cases.iter().any(|c| c.name == *name) {
            return refuse(own.name.span(), format!("two cases named `{name}`"), "rename one of them");
        }
        cases.push(case(&own.name, Layer::of_case(own).over(Layer::of_study(raw)), claim)?);
    }
    Ok(cases)
}

fn case(name: &Spanned<String>, layer: Layer<'_>, claim: &Claim) -> Result<Case, Fault> {
    let place = name.span();
    let refused = matches!(layer.expect, Some(Expect::Refused));
    let control = layer.expect.is_some() && !refused;
    let subject = subject(&layer, &place, control)?;
    let lemma = match &subject {
        Subject::Lemma(lemma) => Some(lemma),
        Subject::Contact(_) => None,
    };
    judge::is_measured(claim, &subject, place.clone())?;
    let family = match (layer.mesh, &subject) {
        (Some(_), Subject::Contact(_)) => {
            imported::check_levels(layer.levels, layer.reference, place.clone())?;
            imported::family(layer.family)?
        }
        _ => plan::family(layer.family)?,
    };
    let reference = match &subject {
        Subject::Contact(scene) => plan::reference(layer.reference, scene.exact.is_some(), place.clone())?,
        // A function is known exactly; a constant is measured against nothing.
        Subject::Lemma(Lemma::BoundaryInterpolation { .. }) => ReferencePlan::Exact,
        Subject::Lemma(_) => ReferencePlan::None,
    };
    let (is_curved, is_located) = match &subject {
        Subject::Contact(scene) => (scene.domain().is_curved(), !scene.domain().nests(&family)),
        Subject::Lemma(_) => (false, false),
    };
    let [quick, full] = plan::levels(layer.levels, &family, is_curved, &reference, control, place.clone())?;
    if lemma.is_some_and(Lemma::halves) {
        lemma::powers_of_two(&[&quick[..], &full[..]].concat(), plan::levels_place(layer.levels, place.clone()))?;
    }
    let (mut gates, fixed_quadrature) = judge::gates(layer.gates, control)?;
    judge::has_bound(claim, &gates, layer.gates.map_or(place.clone(), Spanned::span))?;
    if lemma.is_some() {
        // the ceiling holds the error of a discrete solution against that of an interpolant; here there is no solution
        gates.ceiling = None;
    }
    let (bounds, expected_is_asymptotic) = judge::bounds(&claim.bounds, layer.expected)?;
    let splitting = splitting::splitting(layer.splitting, claim, &subject, &reference, is_located, place.clone())?;
    let expected_from_corners = judge::expects_corners(layer.expected, &subject)?;
    let projects = plan::projects(layer.reference, is_located)?;
    let mut case = Case {
        name: name.get_ref().clone(),
        notes: notes(&layer, &subject, &reference, is_located),
        subject,
        family,
        quick,
        full,
        reference,
        solver: plan::solver(layer.solver)?,
        second: plan::second(layer.solver)?,
        gates,
        bounds,
        expected_is_asymptotic,
        expected_from_corners,
        projects,
        borderline: judge::is_borderline(layer.expected, layer.exact, &layer.parameters),
        expect: layer.expect.and_then(outcome),
        refused,
        inconclusive_at_quick: layer.inconclusive_at_quick.cloned(),
        splitting,
        fixed_quadrature,
        canonical: String::new(),
        changed: None,
        parameters: BTreeMap::new(),
    };
    case.canonical = canonical::text(&case, &layer, claim);
    case.parameters = layer.parameters;
    Ok(case)
}

/// A refusal is no verdict on what was measured: see [`Case::refused`].
fn outcome(expect: Expect) -> Option<Outcome> {
    match expect {
        Expect::Fail => Some(Outcome::Fail),
        Expect::Inconclusive => Some(Outcome::Inconclusive),
        Expect::Refused => None,
    }
}

/// Remarks of the exact solution, and the reasons given for gates and expectations.
fn notes(layer: &Layer<'_>, subject: &Subject, reference: &ReferencePlan, is_located: bool) -> Vec<String> {
    let exact = match subject {
        Subject::Contact(scene) => scene.exact.as_ref(),
        Subject::Lemma(_) => None,
    };
    let mut notes = exact.map_or_else(Vec::new, |e| e.solution.notes());
    if let (Some(_), ReferencePlan::Overkill { .. }) = (exact, reference) {
        notes.push("loads come from the exact solution, errors are measured against the overkill reference".into());
    }
    if let (true, ReferencePlan::Overkill { .. }) = (is_located, reference) {
        notes.push(
            "the reference's mesh is not nested: errors by point location in the true geometry; no identity of energies, no ledger"
                .into(),
        );
    }
    if layer.slide.is_some() {
        notes.push(
            "p(u_I) need not vanish: ceiling and ledger hold energies and normal jumps, which a slide does not change"
                .into(),
        );
    }
    if let Subject::Contact(scene) = subject {
        notes.extend(scene.bodies.iter().filter_map(|b| b.imported.as_ref()).flat_map(|i| i.notes.clone()));
    }
    let gates = layer.gates.and_then(|g| g.get_ref().reason.as_ref()).map(|r| format!("gates: {r}"));
    let expected = layer.expected.and_then(|e| e.get_ref().reason.as_ref()).map(|r| format!("expected rate: {r}"));
    notes.extend(gates.into_iter().chain(expected));
    notes
}

fn subject(layer: &Layer<'_>, place: &Range<usize>, control: bool) -> Result<Subject, Fault> {
    let Some(raw) = layer.lemma else {
        return Ok(Subject::Contact(Box::new(scene(layer, place, control)?)));
    };
    lemma::nothing_else(layer)?;
    lemma::lemma(raw, &layer.parameters).map(Subject::Lemma)
}

fn scene(layer: &Layer<'_>, place: &Range<usize>, control: bool) -> Result<Scene, Fault> {
    let [first, second] = two_bodies(layer, place)?;
    let (a, b) = (first.get_ref(), second.get_ref());
    if a.name.get_ref() == b.name.get_ref() {
        return refuse(b.name.span(), format!("two bodies named `{}`", b.name.get_ref()), "rename one of them");
    }
    let p = &layer.parameters;
    let curves = Curves::read(layer.curve.unwrap_or_default(), p)?;
    let materials = [material::material(&a.material)?, material::material(&b.material)?];
    let Some(raw_contact) = layer.contact else {
        let message = "no [contact]: the two bodies never meet";
        return refuse(place.clone(), message, "add [contact] with `along = [[x, y], …]`, the first body on its left");
    };
    let force = |body: &RawBody| body.force.as_ref().map(|f| vector_field(f, &INSIDE, p)).transpose();
    let Geometry { bodies, parts, contact: line } = match layer.mesh {
        Some(mesh) => imported::geometry(mesh, layer, &curves, place.clone())?,
        None => {
            let bodies = [shape::shape(first, &curves)?, shape::shape(second, &curves)?];
            let contact = boundary::contact(raw_contact, &bodies, &curves, place.clone())?;
            Geometry {
                parts: boundary::parts(layer.boundary.unwrap_or_default(), &bodies, &curves, p)?,
                contact,
                bodies,
            }
        }
    };
    let (contact, bilateral) = bilateral::split(line, &raw_contact.bilateral)?;
    Ok(Scene {
        formula: layer.formula.map(|f| formula::formula(f, &contact, p)).transpose()?,
        symmetric: raw_contact.symmetric,
        parts,
        discretisation: discretisation::discretisation(layer.discretisation, &contact)?,
        initial_gap: initial_gap::initial_gap(raw_contact, &contact, layer.exact.map(Spanned::get_ref), p)?,
        contact,
        bilateral,
        slide: layer.slide.map(|s| slide::slide(s.get_ref(), &bodies)).transpose()?,
        body_force: [force(a)?, force(b)?],
        exact: layer
            .exact
            .filter(|e| !exact::is_none(e.get_ref()))
            .map(|e| exact::exact(e, &bodies, &materials, p, control))
            .transpose()?,
        bodies,
        materials,
    })
}

fn two_bodies<'a>(layer: &Layer<'a>, place: &Range<usize>) -> Result<&'a [Spanned<RawBody>; 2], Fault> {
    let bodies = layer.body.unwrap_or_default();
    bodies.try_into().map_err(|_| {
        let span = bodies.get(2).map_or(place.clone(), |b| b.get_ref().name.span());
        let message = format!("{} bodies, where contact has exactly 2", bodies.len());
        Fault::new(
            span,
            message,
            "give two tables [[body]]; the first is Ω', whose outward normal points to the second",
        )
    })
}
