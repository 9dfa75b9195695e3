//! The text that stands for a resolved case: everything that can change a number or the verdict, and nothing else.
//!
//! Titles, questions, names and the layout of the file stay out: rewording a study keeps its baseline. Numbers are printed
//! with the fewest digits that read back the same.

use super::layer::Layer;
use super::number::Finite;
use super::raw::{RawBoundary, RawExact, RawField, RawMesh, RawPoint, RawTraces};
use super::spanned::Spanned;
use crate::claim::Claim;
use crate::study::{Block, Case, Scene, Subject};
use signorini_contact::mesh::blocks::EVEN;
use signorini_contact::mesh::fnv1a;
use signorini_contact::solver::{Accuracy, Settings};
use signorini_contact::{Material, Point};
use std::fmt::Write;

/// One line per fact, in a fixed order.
pub fn text(case: &Case, layer: &Layer<'_>, claim: &Claim) -> String {
    let mut lines = Lines(String::new());
    match &case.subject {
        Subject::Contact(scene) => contact(&mut lines, scene, layer),
        Subject::Lemma(lemma) => lines.put("lemma", lemma.describe()),
    }
    lines.put("parameters", format!("{:?}", layer.parameters));
    lines.put("family", format!("{:?}", case.family));
    lines.put("levels", format!("{:?} {:?}", case.quick, case.full));
    lines.put("reference", format!("{:?}", case.reference));
    if case.projects {
        lines.put("project", "true");
    }
    if case.expected_from_corners {
        lines.put("expected", "from the corners");
    }
    lines.put("solver", solver(&case.solver));
    if let Some(second) = case.second {
        lines.put("second opinion", second.name());
    }
    if case.refused {
        lines.put("refused", "true");
    }
    lines.put("claim", format!("{} {:?} {}", claim.id, claim.kind, claim.norm));
    lines.put("gates", format!("{:?} {:?} {}", case.gates, case.bounds, case.expected_is_asymptotic));
    lines.put("fixed quadrature", case.fixed_quadrature.to_string());
    if let Some(splitting) = &case.splitting {
        lines.put("splitting", format!("{splitting:?}"));
    }
    lines.put("expect", format!("{:?} {}", case.expect, case.inconclusive_at_quick.is_some()));
    lines.0
}

/// A start of the slide other than zero and an accuracy other than the usual are named; without them the text is the same as ever.
fn solver(settings: &Settings) -> String {
    let Settings { method, max_steps, tolerance, crossover, start_slide, accuracy } = settings;
    let start = if *start_slide == 0.0 { String::new() } else { format!(", start_slide: {start_slide:?}") };
    let accuracy = match accuracy {
        Accuracy::Floor => String::new(),
        other => format!(", accuracy: {other:?}"),
    };
    format!(
        "Settings {{ method: {method:?}, max_steps: {max_steps}, tolerance: {tolerance:?}, crossover: {crossover}{start}{accuracy} }}"
    )
}

fn contact(lines: &mut Lines, scene: &Scene, layer: &Layer<'_>) {
    bodies(lines, scene, layer);
    if let Some(mesh) = layer.mesh {
        imported(lines, scene, layer, mesh);
    }
    for (raw, part) in layer.boundary.unwrap_or_default().iter().zip(&scene.parts) {
        if layer.mesh.is_none() {
            lines.put("part", format!("{:?} {} {}", part.body, part.along.describe(), condition(raw)));
        }
    }
    lines.put("contact", scene.contact.describe());
    if !scene.bilateral.is_empty() {
        lines.put("bilateral pieces", format!("{:?}", scene.bilateral));
    }
    if let Some(slide) = &scene.slide {
        lines.put("slide", format!("{slide:?}"));
    }
    if let Some(gap) = layer.contact.and_then(|c| c.initial_gap.as_ref()) {
        lines.put("initial gap", format!("{:?}", gap.get_ref()));
    }
    if scene.symmetric {
        lines.put("symmetric", "true");
    }
    if let (Some(raw), Some(formula)) = (layer.formula, &scene.formula) {
        let pressure = raw.get_ref().pressure.as_ref().map(|p| p.get_ref());
        lines.put("formula", format!("{:?} {pressure:?}", formula.values));
    }
    if scene.discretisation != Default::default() {
        lines.put("discretisation", format!("{:?}", scene.discretisation));
    }
    if let (Some(raw), Some(exact)) = (layer.exact, &scene.exact) {
        lines.put("exact", solution(raw.get_ref()));
        if let Some(given) = &raw.get_ref().traces {
            lines.put("traces", traces(given.get_ref()));
        }
        lines.put("exact materials", format!("{} {}", law(&exact.materials[0]), law(&exact.materials[1])));
    }
}

/// The file by its hash, what is taken from it by name, and the paths that came of it.
fn imported(lines: &mut Lines, scene: &Scene, layer: &Layer<'_>, mesh: &RawMesh) {
    lines.put("mesh file", format!("{:016x}", fnv1a(&mesh.content)));
    for body in layer.body.unwrap_or_default() {
        lines.put("physical surface", format!("{:?}", body.get_ref().physical.as_ref().map(Spanned::get_ref)));
    }
    for raw in layer.boundary.unwrap_or_default() {
        let physical = raw.physical.as_ref().map(Spanned::get_ref);
        let name = raw.body.get_ref();
        let body = scene.bodies.iter().position(|b| b.name == *name);
        lines.put("physical curve", format!("{body:?} {physical:?} {}", condition(raw)));
    }
    for part in &scene.parts {
        lines.put("part", format!("{:?} {}", part.body, part.along.describe()));
    }
}

struct Lines(String);

impl Lines {
    fn put(&mut self, key: &str, value: impl AsRef<str>) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.0, "{key}: {}", value.as_ref());
    }
}

fn bodies(lines: &mut Lines, scene: &Scene, layer: &Layer<'_>) {
    for (i, raw) in layer.body.unwrap_or_default().iter().enumerate() {
        for Block { corners, divisions, curves, grading } in &scene.bodies[i].blocks {
            lines.put("block", format!("{} {divisions:?}", points(corners)));
            if *grading != EVEN {
                lines.put("grading", format!("{grading:?}"));
            }
            for (k, curve) in curves.iter().enumerate() {
                if let Some(curve) = curve {
                    lines.put("curved side", format!("{k} {}", curve.describe()));
                }
            }
        }
        lines.put("material", law(&scene.materials[i]));
        lines.put("force", raw.get_ref().force.as_ref().map_or("from the exact solution, or none".into(), field));
    }
}

fn condition(raw: &RawBoundary) -> String {
    let value = raw.value.as_ref().map_or("-".into(), |v| field(v.get_ref()));
    format!("{:?} {value}", raw.condition.get_ref())
}

fn solution(raw: &RawExact) -> String {
    let text = |f: &Option<RawField>| f.as_ref().map_or("-".into(), field);
    let name = raw.builtin.as_ref().map_or("-", |n| n.get_ref().as_str());
    let (first, second) = (text(&raw.first), text(&raw.second));
    let list = |points: &[RawPoint]| points.iter().map(|p| format!("({:?}, {:?})", p[0].0, p[1].0)).collect::<String>();
    let breaks: String = raw.breaks.iter().map(|s| list(&s.0)).collect();
    format!("{name} {first} {second} [{}] [{breaks}] [{}]", list(&raw.singular), list(&raw.switches))
}

fn traces(raw: &RawTraces) -> String {
    let pair = |f: Option<&RawField>| f.map_or("-".into(), field);
    let number = |x: &Option<Spanned<Finite>>| x.as_ref().map_or("-".into(), |x| format!("{:?}", x.get_ref().0));
    let list = |numbers: &[Finite]| format!("{:?}", numbers.iter().map(|x| x.0).collect::<Vec<f64>>());
    let centre =
        raw.centre.as_ref().map_or("-".into(), |c| format!("({:?}, {:?})", c.get_ref()[0].0, c.get_ref()[1].0));
    [
        format!(
            "{} {} {centre} {}",
            raw.lemma.get_ref().word(),
            pair(raw.f.as_ref().map(Spanned::get_ref)),
            number(&raw.radius)
        ),
        format!("{} w {} a {} p {:?}", number(&raw.middle), field(&raw.w), field(&raw.a), raw.p.get_ref()),
        format!(
            "cutoff {} {} {} {}",
            pair(raw.cutoff.as_ref()),
            list(&raw.switches),
            list(&raw.singular),
            list(&raw.breaks)
        ),
    ]
    .join(" ")
}

fn field(raw: &RawField) -> String {
    format!("{:?} {:?}", raw[0].get_ref(), raw[1].get_ref())
}

fn points(points: &[Point]) -> String {
    points.iter().map(|p| format!("({:?}, {:?})", p.x, p.y)).collect()
}

fn law(material: &Material) -> String {
    format!("{:?}", material.matrix())
}
