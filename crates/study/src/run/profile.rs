//! The contact zone of a solved level as an engineer sees it: force, width, peak pressure, pressure and gap node by node.

use super::contact::ContactState;
use super::contact_width::Sides;
use crate::record::{ContactMeasure, Errors, PressureSource, ReferencePressure, ZoneProfile};
use crate::study::Scene;
use signorini_contact::geometry::LinePoint;
use signorini_contact::mesh::Mesh;
use signorini_contact::problem::{Discrete, Solution};
use std::collections::BTreeSet;

/// A constraint that the solver decided, at its place in the zone.
struct Node {
    /// Distance from the start of the zone.
    coordinate: f64,
    point: LinePoint,
    pressure: f64,
    gap: f64,
}

/// Measures the zone; `with_profile` keeps every node of it.
pub fn measure(
    scene: &Scene,
    mesh: &Mesh,
    discrete: &Discrete,
    solution: &Solution,
    state: &ContactState,
    with_profile: bool,
) -> ContactMeasure {
    let sides = Sides {
        zone: &discrete.zone,
        length: (0..mesh.contact.len()).map(|side| mesh.contact_view(side).measure()).collect(),
        active: &state.active,
        gap: (0..mesh.contact.len()).map(|side| gaps(mesh, side, solution)).collect(),
    };
    let nodes = nodes(mesh, discrete, &sides, state);
    let whole = if scene.symmetric { 2.0 } else { 1.0 };
    ContactMeasure {
        force: whole * solution.contact_forces.iter().flatten().sum::<f64>(),
        half_width: 0.5 * whole * sides.contact(),
        peak_pressure: nodes.iter().map(|n| n.pressure).fold(0.0, f64::max),
        formula: scene.formula.as_ref().map(|f| f.values.clone()),
        profile: with_profile.then(|| profile(scene, mesh, &nodes)),
    }
}

/// Relative differences from the formula.
pub fn compare(contact: &ContactMeasure, errors: &mut Errors) {
    let Some(formula) = &contact.formula else { return };
    let difference = |measured: f64, value: Option<f64>| value.map(|v| measured / v - 1.0);
    errors.force = difference(contact.force, formula.force);
    errors.half_width = difference(contact.half_width, formula.half_width);
    errors.peak_pressure = difference(contact.peak_pressure, formula.peak_pressure);
}

/// The constraints in the order of the zone, each once.
fn nodes(mesh: &Mesh, discrete: &Discrete, sides: &Sides, state: &ContactState) -> Vec<Node> {
    let tied = discrete.basis.held.iter().map(|h| &h.origin);
    let kept: BTreeSet<(usize, usize)> = discrete.origins.iter().chain(tied).map(|o| (o.pair, o.constraint)).collect();
    let mut nodes = Vec::with_capacity(kept.len());
    let (mut start, mut last) = (0.0, None);
    for (side, ends) in discrete.zone.side_ends.iter().enumerate() {
        let view = mesh.contact_view(side);
        let length = sides.length[side];
        for (end, key) in ends.iter().enumerate() {
            // an end of one side is the start of the next, unless the zone turns a corner there
            if last == Some(*key) || !kept.contains(key) {
                continue;
            }
            last = Some(*key);
            let t = end as f64;
            nodes.push(Node {
                coordinate: start + t * length,
                point: view.at(t),
                pressure: state.pressure[side][end],
                gap: sides.gap[side][end],
            });
        }
        start += length;
    }
    nodes
}

fn gaps(mesh: &Mesh, side: usize, solution: &Solution) -> [f64; 2] {
    let view = mesh.contact_view(side);
    [0.0, 1.0].map(|t| {
        let point = view.at(t);
        point.gap - view.jump(t, &point, &solution.displacement)
    })
}

fn profile(scene: &Scene, mesh: &Mesh, nodes: &[Node]) -> ZoneProfile {
    ZoneProfile {
        across_gap: mesh.direction.is_some(),
        symmetric: scene.symmetric,
        coordinate: nodes.iter().map(|n| n.coordinate).collect(),
        points: nodes.iter().map(|n| [n.point.at[0].x, n.point.at[0].y]).collect(),
        pressure: nodes.iter().map(|n| n.pressure).collect(),
        gap: nodes.iter().map(|n| n.gap).collect(),
        reference: reference(scene, nodes),
    }
}

fn finite(pressure: f64) -> Option<f64> {
    pressure.is_finite().then_some(pressure)
}

/// The formula's pressure, or else that of the exact solution.
fn reference(scene: &Scene, nodes: &[Node]) -> Option<ReferencePressure> {
    if let Some(pressure) = scene.formula.as_ref().and_then(|f| f.pressure.as_ref()) {
        let pressure = nodes.iter().map(|n| finite(pressure(n.point.at[0]))).collect();
        return Some(ReferencePressure { source: PressureSource::Formula, pressure });
    }
    let exact = scene.exact.as_ref()?;
    let pressure = nodes.iter().map(|n| finite(-exact.contact_stress(&n.point))).collect();
    Some(ReferencePressure { source: PressureSource::Exact, pressure })
}
