//! The contact zone of two bodies out of a file: faces side by side, nodes matched.

use super::body::BodyMesh;
use super::chain::{along, rows, straight};
use super::error::{MshError, refuse};
use super::read::Msh;
use signorini_contact::Point;
use signorini_contact::geometry::{Path, SharedCurve};
use std::collections::BTreeMap;

/// A part of the zone: the physical curve of `Ω'`, that of `Ω''`, and the curve of the study that they follow.
#[derive(Clone, Debug)]
pub struct Faces {
    /// Names of the physical curves.
    pub groups: [String; 2],
    /// The curve with its name; none where the faces are straight from corner to corner.
    pub curve: Option<(String, SharedCurve)>,
}

/// The zone as a path with `Ω'` on its left. Nodes of `Ω''` take the places of their partners.
///
/// # Errors
/// Groups that are no boundary of their body, a zone in several pieces or closed, a node without partner, faces that are not those of
/// their partners, nodes off their curve.
pub fn zone(msh: &Msh, bodies: &mut [BodyMesh; 2], faces: &[Faces]) -> Result<Path, MshError> {
    let first = row_of(msh, &bodies[0], faces, 0)?;
    let mut second = row_of(msh, &bodies[1], faces, 1)?;
    second.nodes.reverse();
    second.faces.reverse();
    check_partners(bodies, &first.nodes, &second.nodes)?;
    if let Some(k) = (0..first.faces.len()).find(|&k| first.faces[k] != second.faces[k]) {
        let name = |b: usize, face: usize| faces[face].groups[b].as_str();
        let message = format!(
            "the side of \"{}\" from {} faces a side of \"{}\"",
            name(0, first.faces[k]),
            bodies[0].at(first.nodes[k]),
            name(1, second.faces[k])
        );
        return refuse(message, "let each pair of physical curves cover the same piece of the zone");
    }
    let path = follow(bodies, &first, faces)?;
    for (&a, &b) in first.nodes.iter().zip(&second.nodes) {
        bodies[1].mesh.points[b as usize] = bodies[0].point(a);
    }
    Ok(path)
}

/// The sides of a body on the zone in a row: nodes, and the number of the pair of faces for each side.
struct Row {
    nodes: Vec<u32>,
    faces: Vec<usize>,
}

fn row_of(msh: &Msh, body: &BodyMesh, faces: &[Faces], b: usize) -> Result<Row, MshError> {
    let mut owner: BTreeMap<[u32; 2], usize> = BTreeMap::new();
    for (k, pair) in faces.iter().enumerate() {
        for side in body.sides(msh, &pair.groups[b])? {
            owner.insert(side, k);
        }
    }
    let sides: Vec<[u32; 2]> = owner.keys().copied().collect();
    let mut found = rows(&sides);
    if found.len() > 1 {
        let starts: Vec<String> = found.iter().map(|row| body.at(row[0])).collect();
        let message = format!(
            "the zone of \"{}\" has {} separate pieces, from {}",
            body.name,
            found.len(),
            starts.join(" and from ")
        );
        return refuse(message, "the zone is one row of sides: join the pieces, or name one of them");
    }
    let nodes = found.remove(0);
    if nodes[0] == nodes[nodes.len() - 1] {
        let message = format!("the zone of \"{}\" is closed: it comes back to {}", body.name, body.at(nodes[0]));
        return refuse(message, "the zone needs two ends: use the symmetry of the scene");
    }
    let of_side = nodes.windows(2).map(|w| owner[&[w[0], w[1]]]).collect();
    Ok(Row { nodes, faces: of_side })
}

/// Each node of one face has its partner on the other, in the same order.
fn check_partners(bodies: &[BodyMesh; 2], first: &[u32], second: &[u32]) -> Result<(), MshError> {
    let bound = |a: u32, b: u32| bodies[0].tolerance(a).min(bodies[1].tolerance(b));
    let apart = |a: u32, b: u32| (bodies[0].point(a) - bodies[1].point(b)).norm();
    if first.len() == second.len() && first.iter().zip(second).all(|(&a, &b)| apart(a, b) <= bound(a, b)) {
        return Ok(());
    }
    for (own, b, others) in [(first, 0, second), (second, 1, first)] {
        let (body, other) = (&bodies[b], &bodies[1 - b]);
        for &n in own {
            let far = |m: &u32| (other.point(*m) - body.point(n)).norm();
            let Some(m) = others.iter().min_by(|a, b| far(a).total_cmp(&far(b))) else { continue };
            let allowed = body.tolerance(n).min(other.tolerance(*m));
            if far(m) > allowed {
                let message = format!(
                    "{} of \"{}\" has no partner on the zone of \"{}\": the nearest is {}, {:.3e} away, where at most {allowed:.1e} is allowed, 1e-4 of the shortest side there",
                    body.at(n),
                    body.name,
                    other.name,
                    other.at(*m),
                    far(m)
                );
                return refuse(
                    message,
                    "both faces need the same nodes: give their curves in the .geo the same Transfinite Curve count, or let both surfaces share the curves",
                );
            }
        }
    }
    refuse(
        format!(
            "the zone has {} nodes on \"{}\" and {} on \"{}\"",
            first.len(),
            bodies[0].name,
            second.len(),
            bodies[1].name
        ),
        "both faces need the same nodes, each once",
    )
}

/// The path through the nodes of `Ω'`: along the named curves, straight elsewhere. Curves come first, since their ends move.
fn follow(bodies: &mut [BodyMesh; 2], row: &Row, faces: &[Faces]) -> Result<Path, MshError> {
    let mut runs: Vec<(usize, Vec<u32>)> = Vec::new();
    for (k, &face) in row.faces.iter().enumerate() {
        match runs.last_mut() {
            // straight faces in a row have their corners in common
            Some((last, nodes)) if *last == face || faces[*last].curve.is_none() && faces[face].curve.is_none() => {
                nodes.push(row.nodes[k + 1]);
            }
            _ => runs.push((face, vec![row.nodes[k], row.nodes[k + 1]])),
        }
    }
    let mut paths: Vec<Option<Path>> = Vec::new();
    for (face, nodes) in &runs {
        let curved = faces[*face].curve.as_ref().map(|(name, curve)| along(&mut bodies[0], nodes, name, curve));
        paths.push(curved.transpose()?);
    }
    let mut whole = Path { corners: vec![bodies[0].point(row.nodes[0])], curves: Vec::new() };
    for ((_, nodes), path) in runs.iter().zip(paths) {
        let Path { corners, mut curves } = path.unwrap_or_else(|| straight(&mut bodies[0], nodes));
        curves.resize(corners.len() - 1, None);
        whole.corners.extend::<Vec<Point>>(corners[1..].to_vec());
        whole.curves.extend(curves);
    }
    Ok(whole)
}
