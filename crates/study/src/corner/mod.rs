//! Every corner of a scene, on both bodies, with the exponents that the local problems have there.
//!
//! ```text
//!          Ω'                Corners are read off a mesh: nodes of the boundary where the tangent turns, the condition
//!       free│                changes or the zone ends. At a node of the zone both bodies meet, and every ray of Γ_K that
//!   ────────x════════        starts there may be closed (frictionless contact) or open (both faces free).
//!     free     Γ_K
//!          Ω''
//! ```
//!
//! A mode that would pull on a closed ray while it presses on another cannot lead there and is passed over.
//!
//! Which state governs is read off the contact pressure of the finest discrete solution along the ray: [`NEAR`] nodes that all press, or
//! none of which does. Loads, jumps of tractions and given displacements are taken for smooth enough not to matter. Where the
//! bodies are apart before loading the zone is open at its ends.

mod outline;
mod state;
#[cfg(test)]
mod tests;

use crate::record::{Corner, CornerState, CornerWedge, RayState, ZoneProfile};
use crate::study::Scene;
use outline::{Node, Outline};
use signorini_contact::Error;
use signorini_contact::corner::{Face, Singularity, Wedge, singularity};
use signorini_contact::mesh::Mesh;
pub use state::NEAR;
use state::governing;
use std::collections::BTreeMap;

/// The corners in the order of the boundary nodes of the mesh, those of the contact zone first; `zone` is the solved zone, if
/// there is one.
///
/// # Errors
/// What [`singularity`] refuses.
pub fn corners(scene: &Scene, mesh: &Mesh, zone: Option<&ZoneProfile>) -> Result<Vec<Corner>, Error> {
    let outline = Outline::new(scene, mesh);
    let mut finder = Finder { scene, known: Vec::new() };
    let mut found = Vec::new();
    for pair in &outline.pairs {
        let nodes = [&outline.nodes[&pair.nodes[0]], &outline.nodes[&pair.nodes[1]]];
        if pair.rays.len() == 2 && nodes.iter().all(|n| n.is_smooth()) {
            continue;
        }
        let states =
            if pair.may_close { all_states(pair.rays.len()) } else { vec![vec![RayState::Open; pair.rays.len()]] };
        let states: Result<Vec<_>, Error> =
            states.into_iter().map(|rays| finder.state(&nodes, &pair.rays, rays)).collect();
        let states = states?;
        let at = mesh.points[pair.nodes[0] as usize];
        let governing = zone.and_then(|zone| governing(zone, at, &pair.rays, &states));
        found.push(Corner {
            point: [at.x, at.y],
            wedges: nodes.map(|n| finder.describe(n)).to_vec(),
            states,
            governing,
        });
    }
    for (number, node) in &outline.nodes {
        if node.is_smooth() || outline.pairs.iter().any(|p| p.nodes.contains(number)) {
            continue;
        }
        let at = mesh.points[*number as usize];
        let state = finder.state(&[node], &[], Vec::new())?;
        let wedges = vec![finder.describe(node)];
        found.push(Corner { point: [at.x, at.y], wedges, states: vec![state], governing: Some(0) });
    }
    Ok(found)
}

/// Every ray open or closed, all open first.
fn all_states(rays: usize) -> Vec<Vec<RayState>> {
    let state = |closed: bool| if closed { RayState::Closed } else { RayState::Open };
    (0..1usize << rays).map(|mask| (0..rays).map(|k| state(mask >> k & 1 == 1)).collect()).collect()
}

/// A ray of the contact zone from one of its nodes: the face of `Ω'` that it is (0 the first one counterclockwise), and whether
/// the zone runs away from the node along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Ray {
    face: usize,
    forward: bool,
}

/// Solves the local problems, equal ones once.
struct Finder<'a> {
    scene: &'a Scene,
    known: Vec<(Vec<Wedge>, Singularity)>,
}

impl Finder<'_> {
    fn state(&mut self, nodes: &[&Node], rays: &[Ray], states: Vec<RayState>) -> Result<CornerState, Error> {
        let mut wedges: Vec<Wedge> = nodes.iter().map(|n| self.wedge(n)).collect();
        for (ray, state) in rays.iter().zip(&states) {
            if *state == RayState::Open {
                wedges[0].faces[ray.face] = Face::Free;
                // what is to the left of the ray in one body is to its right in the other
                wedges[1].faces[1 - ray.face] = Face::Free;
            }
        }
        let Singularity { exponent, pulling } = self.singularity(wedges)?;
        Ok(CornerState {
            rays: states,
            exponent: exponent.map(|l| l.re),
            oscillation: exponent.map(|l| l.im).filter(|im| *im != 0.0),
            pulling: pulling.map(|l| l.re),
        })
    }

    fn singularity(&mut self, wedges: Vec<Wedge>) -> Result<Singularity, Error> {
        if let Some((_, known)) = self.known.iter().find(|(w, _)| *w == wedges) {
            return Ok(*known);
        }
        let found = singularity(&wedges)?;
        self.known.push((wedges, found));
        Ok(found)
    }

    fn wedge(&self, node: &Node) -> Wedge {
        let [from, to] = node.angles();
        Wedge { material: self.scene.materials[node.body.index()], from, to, faces: node.faces }
    }

    fn describe(&self, node: &Node) -> CornerWedge {
        let [from, to] = node.angles();
        CornerWedge {
            body: self.scene.bodies[node.body.index()].name.clone(),
            angle: (to - from).to_degrees(),
            faces: node.faces.map(|face| word(face).to_owned()),
        }
    }
}

fn word(face: Face) -> &'static str {
    match face {
        Face::Clamped => "clamped",
        Face::Sliding => "sliding",
        Face::Free => "free",
        Face::Contact => "contact",
    }
}

/// The nodes of both bodies by number.
type Nodes = BTreeMap<u32, Node>;

/// Both bodies meet in two nodes of the zone.
struct Pair {
    nodes: [u32; 2],
    rays: Vec<Ray>,
    /// Whether the bodies touch there without a gap and press along their common normal.
    may_close: bool,
}
