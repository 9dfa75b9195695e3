//! From a solved level to its fields.

use super::{Arc, Condition, ContactStatus, FieldPart, Fields, ZoneFields};
use crate::run::contact::ContactState;
use crate::study::{PartCondition, Scene};
use signorini_contact::Vec2;
use signorini_contact::element::{gradients, linear_strain};
use signorini_contact::material::strain;
use signorini_contact::mesh::Mesh;
use signorini_contact::problem::{Discrete, Solution};
use signorini_contact::zone::ConstraintKind;
use std::collections::{BTreeMap, BTreeSet};

/// Points between the ends of a curved side.
const BETWEEN: usize = 7;

/// The fields of a solved level; none where the solve left numbers that are none.
pub fn collect(
    level: usize,
    scene: &Scene,
    mesh: &Mesh,
    discrete: &Discrete,
    solution: &Solution,
    state: &ContactState,
) -> Option<Fields> {
    let u = &solution.displacement;
    let strain: Vec<[f64; 3]> = (0..mesh.triangles.len()).map(|t| strain_of(mesh, t, u)).collect();
    let material = |t: usize| &scene.materials[mesh.body(t).index()];
    let stress: Vec<[f64; 3]> = strain.iter().enumerate().map(|(t, e)| material(t).stress(*e)).collect();
    let fields = Fields {
        level,
        asked: false,
        bodies: [0, 1].map(|b| scene.bodies[b].name.clone()),
        nodes: mesh.points.iter().map(components).collect(),
        triangles: mesh.triangles.clone(),
        first_triangles: mesh.first_triangles,
        areas: (0..mesh.triangles.len()).map(|t| mesh.area(t)).collect(),
        arcs: arcs(mesh, u),
        displacement: u.iter().map(components).collect(),
        von_mises: stress.iter().enumerate().map(|(t, s)| material(t).von_mises(*s)).collect(),
        strain,
        stress,
        parts: parts(scene),
        sides: mesh.sides.iter().map(|s| s.nodes).collect(),
        side_triangles: mesh.sides.iter().map(|s| s.triangle).collect(),
        side_parts: mesh.sides.iter().map(|s| u32::from(s.part)).collect(),
        zone: zone(mesh, discrete, solution, state),
    };
    fields.is_finite().then_some(fields)
}

fn components(v: &Vec2) -> [f64; 2] {
    [v.x, v.y]
}

/// `ε(u_h)`: constant where displacements are linear, at the centroid of an isoparametric triangle.
fn strain_of(mesh: &Mesh, t: usize, u: &[Vec2]) -> [f64; 3] {
    let values = mesh.triangles[t].map(|i| u[i as usize]);
    match mesh.curved_triangle(t) {
        None => linear_strain(&gradients(mesh.corners(t)).0, values),
        // (ρ, τ) = (2/3, 1/2) is the centroid of the reference triangle
        Some(curved) => strain(curved.at(2.0 / 3.0, 0.5).gradient(&values)),
    }
}

fn arcs(mesh: &Mesh, u: &[Vec2]) -> Vec<Arc> {
    let shares = || (1..=BETWEEN).map(|k| k as f64 / (BETWEEN + 1) as f64);
    let arc = |(t, curved): (usize, signorini_contact::element::CurvedTriangle)| {
        let values = mesh.triangles[t].map(|i| u[i as usize]);
        let value = |s: f64| -> Vec2 { curved.trace(s).iter().zip(&values).map(|(hat, u)| *hat * u).sum() };
        Arc {
            triangle: t as u32,
            apex: curved.apex as u8,
            points: shares().map(|s| components(&curved.arc(s).0)).collect(),
            displacement: shares().map(|s| components(&value(s))).collect(),
        }
    };
    mesh.curved_triangles().map(arc).collect()
}

fn parts(scene: &Scene) -> Vec<FieldPart> {
    let condition = |c: &PartCondition| match c {
        PartCondition::Fixed(_) => Condition::Fixed,
        PartCondition::Sliding => Condition::Sliding,
        PartCondition::Traction(_) => Condition::Traction,
        PartCondition::Free => Condition::Free,
    };
    let part = |p: &crate::study::Part| FieldPart {
        body: p.body.index() as u8,
        name: p.name.clone(),
        condition: condition(&p.condition),
    };
    scene.parts.iter().map(part).collect()
}

/// Walks along the zone; an end of one side is the start of the next, unless the zone turns a corner there.
fn zone(mesh: &Mesh, discrete: &Discrete, solution: &Solution, state: &ContactState) -> ZoneFields {
    let tied = discrete.basis.held.iter().map(|h| &h.origin);
    let kept: BTreeSet<(usize, usize)> = discrete.origins.iter().chain(tied).map(|o| (o.pair, o.constraint)).collect();
    let mut zone = ZoneFields { across_gap: mesh.direction.is_some(), ..Default::default() };
    let mut known: BTreeMap<(usize, usize), u32> = BTreeMap::new();
    let mut start = 0.0;
    for (side, ends) in discrete.zone.side_ends.iter().enumerate() {
        let view = mesh.contact_view(side);
        let contact = &mesh.contact[side];
        let length = view.measure();
        let numbers = [0, 1].map(|end| {
            let (key, t) = (ends[end], end as f64);
            *known.entry(key).or_insert_with(|| {
                let point = view.at(t);
                let constraint = &discrete.zone.pairs[key.0].constraints[key.1];
                let status = match (kept.contains(&key), constraint.kind, state.active[side][end]) {
                    (false, ..) => ContactStatus::Held,
                    (_, ConstraintKind::Bilateral, _) => ContactStatus::Bilateral,
                    (_, _, true) => ContactStatus::Contact,
                    _ => ContactStatus::Open,
                };
                zone.s.push(start + t * length);
                zone.nodes.push([contact.first[end], contact.second[end]]);
                zone.normal.push(components(&point.normal));
                zone.pressure.push(state.pressure[side][end]);
                zone.gap.push(point.gap - view.jump(t, &point, &solution.displacement));
                zone.status.push(status as u8);
                zone.s.len() as u32 - 1
            })
        });
        zone.sides.push(numbers);
        zone.side_triangles.push(contact.triangles);
        start += length;
    }
    zone
}
