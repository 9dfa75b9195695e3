//! `mesh`: the set-up on one level: both bodies, their triangles, boundary parts and the contact zone.

use super::body_chart::{Area, BodyChart, Label, Stroke, XY, bounds};
use super::chart::Colour;
use super::outline::outline;
use crate::format;
use crate::summary::name;
use signorini_study::fields::{Condition, Fields};
use signorini_study::record::StudyRecord;
use std::collections::BTreeSet;

/// Above this number triangles are too small to be drawn.
const VISIBLE: usize = 20_000;
/// Above this number parts with the same condition are named together.
const NAMED: usize = 14;

/// Both bodies with the triangles of a level, boundary parts and contact zone named at the sides.
pub fn mesh(record: &StudyRecord, fields: &Fields) -> BodyChart {
    let (stretch, stretched) = whole(fields);
    let (inside, outside) = names(fields, 0.0);
    let mut strokes = Vec::new();
    let shown = fields.triangles.len() <= VISIBLE;
    if shown {
        strokes.extend(edges(fields));
    }
    strokes.extend(part_strokes(fields));
    strokes.extend(zone_strokes(fields, Colour::Blue, 5.0, 0.0));
    let small = format!("Its {} triangles are too small to be drawn.", fields.triangles.len());
    BodyChart {
        title: format!("{}: set-up", name(record)),
        subtitle: vec![record.title.clone(), numbers(record, fields)],
        areas: areas(fields),
        strokes,
        labels: labels(fields).into_iter().chain(outside).collect(),
        names: inside,
        bar: None,
        stretch,
        remarks: stretched.into_iter().chain((!shown).then_some(small)).collect(),
    }
}

/// The magnification of thin bodies.
pub(super) fn whole(fields: &Fields) -> ([f64; 2], Option<String>) {
    let [low, high] = bounds(fields.nodes.iter());
    BodyChart::stretched(low, high)
}

/// `level 3: 1024 triangles, 594 nodes, h = 0.0884, smallest angle 45°, 33 contact pairs`
fn numbers(record: &StudyRecord, fields: &Fields) -> String {
    let sizes = format!("level {}: {} triangles, {} nodes", fields.level, fields.triangles.len(), fields.nodes.len());
    let Some(level) = record.levels.iter().find(|l| l.level == fields.level) else { return sizes };
    let (h, angle) = (format::significant(level.h, 3), format::significant(level.min_angle, 3));
    format!("{sizes}, h = {h}, smallest angle {angle}°, {} contact pairs", level.contact_pairs)
}

/// Each body in its tint: its outline, or where that is not one line its triangles.
fn areas(fields: &Fields) -> Vec<Area> {
    let tinted =
        |outline: Vec<XY>, body: usize| Area { outline, colour: [Colour::Blue, Colour::Orange][body], strength: 0.12 };
    let of = |body: usize| match outline(fields, body) {
        Some(whole) => vec![tinted(whole, body)],
        None => fields.triangles_of(body).map(|t| tinted(fields.outline(t, 0.0), body)).collect(),
    };
    (0..2).flat_map(of).collect()
}

/// Every side once.
fn edges(fields: &Fields) -> Vec<Stroke> {
    let mut seen = BTreeSet::new();
    let mut edges = Vec::new();
    for (t, corners) in fields.triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            if seen.insert((a.min(b), a.max(b))) {
                let points = fields.side(t, [a, b], 0.0);
                edges.push(Stroke { points, colour: Colour::Grey, width: 1.0, strength: 0.7 });
            }
        }
    }
    edges
}

/// The look of a boundary part: colour and width.
fn look(condition: Condition) -> (Colour, f64) {
    match condition {
        Condition::Fixed => (Colour::Vermillion, 6.0),
        Condition::Sliding => (Colour::Purple, 6.0),
        Condition::Traction => (Colour::Green, 6.0),
        Condition::Free => (Colour::Black, 2.0),
    }
}

fn part_strokes(fields: &Fields) -> Vec<Stroke> {
    let condition = |k: usize| fields.parts[fields.side_parts[k] as usize].condition;
    let mut order: Vec<usize> = (0..fields.sides.len()).collect();
    // free parts first, so that what holds a body is not covered at the corners
    order.sort_by_key(|k| std::cmp::Reverse(condition(*k)));
    let stroke = |k: usize| {
        let (colour, width) = look(condition(k));
        let points = fields.side(fields.side_triangles[k] as usize, fields.sides[k], 0.0);
        Stroke { points, colour, width, strength: 1.0 }
    };
    order.into_iter().map(stroke).collect()
}

/// The zone as the boundary of both bodies, moved by `factor · u_h`.
pub(super) fn zone_strokes(fields: &Fields, colour: Colour, width: f64, factor: f64) -> Vec<Stroke> {
    let zone = &fields.zone;
    let mut strokes = Vec::new();
    for body in 0..2 {
        for (side, triangles) in zone.sides.iter().zip(&zone.side_triangles) {
            let ends = side.map(|i| zone.nodes[i as usize][body]);
            let points = fields.side(triangles[body] as usize, ends, factor);
            strokes.push(Stroke { points, colour, width, strength: 1.0 });
        }
    }
    strokes
}

/// A body less wide than this share of both has its name at the side.
const NARROW: f64 = 0.15;

/// The names of the two bodies: in the middle of each, or at the side of the picture where that would cover the body.
pub(super) fn names(fields: &Fields, factor: f64) -> (Vec<(String, XY)>, Vec<Label>) {
    let [low, high] = bounds(fields.nodes.iter());
    let narrow = |body: usize| {
        let triangles = fields.triangles_of(body);
        let nodes = triangles.flat_map(|t| fields.triangles[t]).map(|i| &fields.nodes[i as usize]);
        let [a, b] = bounds(nodes);
        b[0] - a[0] < NARROW * (high[0] - low[0])
    };
    let named = both_names(fields, factor).into_iter().enumerate();
    let (outside, inside): (Vec<_>, Vec<_>) = named.partition(|(body, _)| narrow(*body));
    let label = |(_, (text, at)): (usize, (String, XY))| Label {
        text,
        detail: String::new(),
        colour: Colour::Black,
        anchors: vec![at],
    };
    (inside.into_iter().map(|(_, name)| name).collect(), outside.into_iter().map(label).collect())
}

fn both_names(fields: &Fields, factor: f64) -> Vec<(String, XY)> {
    let name = |body: usize, range: std::ops::Range<usize>| {
        let symbol = ["Ω′", "Ω″"][body];
        let text =
            if fields.bodies[body].is_empty() { symbol.into() } else { format!("{symbol} {}", fields.bodies[body]) };
        (text, middle(fields, range, factor))
    };
    (0..2).map(|body| name(body, fields.triangles_of(body))).collect()
}

/// The centroid of the triangle that is nearest to the centre of area of these.
fn middle(fields: &Fields, range: std::ops::Range<usize>, factor: f64) -> XY {
    let centroid = |t: usize| {
        let at = |axis: usize, i: u32| fields.nodes[i as usize][axis] + factor * fields.displacement[i as usize][axis];
        [0, 1].map(|axis| fields.triangles[t].iter().map(|i| at(axis, *i)).sum::<f64>() / 3.0)
    };
    let total: f64 = range.clone().map(|t| fields.areas[t]).sum();
    let mean = [0, 1].map(|axis| range.clone().map(|t| fields.areas[t] * centroid(t)[axis]).sum::<f64>() / total);
    let far = |p: &XY| (p[0] - mean[0]).hypot(p[1] - mean[1]);
    range.map(centroid).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(mean)
}

fn labels(fields: &Fields) -> Vec<Label> {
    let together = fields.parts.len() > NAMED;
    let mut labels: Vec<Label> = Vec::new();
    for (number, part) in fields.parts.iter().enumerate() {
        let sides = (0..fields.sides.len()).filter(|k| fields.side_parts[*k] as usize == number);
        let anchors: Vec<XY> =
            sides.map(|k| centre(&fields.side(fields.side_triangles[k] as usize, fields.sides[k], 0.0))).collect();
        let (symbol, words) = words(part.condition);
        let (colour, _) = look(part.condition);
        let text = if together { symbol.to_owned() } else { format!("{symbol} {}", part.name) };
        match labels.iter_mut().find(|l| together && l.text == text && l.detail == words) {
            Some(same) => same.anchors.extend(anchors),
            None => labels.push(Label { text, detail: words.into(), colour, anchors }),
        }
    }
    labels.extend(zone_label(fields));
    labels
}

fn zone_label(fields: &Fields) -> Option<Label> {
    let zone = zone_strokes(fields, Colour::Blue, 0.0, 0.0);
    let first = &zone[..zone.len() / 2];
    let anchors: Vec<XY> = first.iter().map(|s| centre(&s.points)).collect();
    let detail = if fields.zone.across_gap { "zone, across a gap" } else { "contact zone" };
    (!anchors.is_empty()).then(|| Label { text: "Γ_{K}".into(), detail: detail.into(), colour: Colour::Blue, anchors })
}

/// The middle of a line of points.
fn centre(points: &[XY]) -> XY {
    let half = points.len() / 2;
    if points.len() % 2 == 1 {
        return points[half];
    }
    [0, 1].map(|axis| 0.5 * (points[half - 1][axis] + points[half][axis]))
}

fn words(condition: Condition) -> (&'static str, &'static str) {
    match condition {
        Condition::Fixed => ("Γ_{u}", "fixed"),
        Condition::Sliding => ("Γ_{0}", "sliding"),
        Condition::Traction => ("Γ_{τ}", "traction"),
        Condition::Free => ("Γ_{τ}", "free"),
    }
}
