//! The boundary of both bodies node by node: which way it leaves and on which conditions.

use super::{Nodes, Pair, Ray};
use crate::study::{PartCondition, Scene};
use signorini_contact::corner::Face;
use signorini_contact::geometry::tangent_of;
use signorini_contact::mesh::Mesh;
use signorini_contact::{Body, Vec2};
use std::f64::consts::{PI, TAU};

/// Directions closer than this, in radians, are one; gaps below this share of a side are closed.
const SAME: f64 = 1e-6;

/// A node of the boundary. The body lies to the left of the side that leaves it.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub body: Body,
    /// Unit directions away from the node along the side that leaves and along the side that arrives.
    pub rays: [Vec2; 2],
    /// The conditions on these two sides.
    pub faces: [Face; 2],
}

impl Node {
    fn new(body: Body) -> Self {
        Self { body, rays: [Vec2::zeros(); 2], faces: [Face::Free; 2] }
    }

    /// The angles of the two faces; the body lies between them, counterclockwise.
    pub fn angles(&self) -> [f64; 2] {
        let [from, to] = self.rays.map(|d| d.y.atan2(d.x));
        let turn = (to - from).rem_euclid(TAU);
        // a slit has a full turn, not none
        let angle = if turn < SAME { TAU } else { turn };
        [from, from + angle]
    }

    /// Whether neither the tangent nor the condition changes.
    pub fn is_smooth(&self) -> bool {
        let [from, to] = self.angles();
        (to - from - PI).abs() < SAME && self.faces[0] == self.faces[1]
    }
}

/// The boundary nodes of both bodies and the pairs of the contact zone in its order.
pub(super) struct Outline {
    pub nodes: Nodes,
    pub pairs: Vec<Pair>,
}

impl Outline {
    pub fn new(scene: &Scene, mesh: &Mesh) -> Self {
        let mut outline = Self { nodes: Nodes::new(), pairs: Vec::new() };
        for side in &mesh.sides {
            let part = &scene.parts[side.part as usize];
            let piece = mesh.boundary_view(side).piece;
            outline.side(part.body, side.nodes, [piece.velocity(0.0), piece.velocity(1.0)], face(&part.condition));
        }
        for (number, side) in mesh.contact.iter().enumerate() {
            let view = mesh.contact_view(number);
            let [first, second] = [0, 1].map(|k| [0.0, 1.0].map(|t| view.sides[k].piece.velocity(t)));
            outline.side(Body::First, side.first, first, Face::Contact);
            // the zone runs with Ω'' on its right
            let [a, b] = side.second;
            outline.side(Body::Second, [b, a], [-second[1], -second[0]], Face::Contact);
            for end in 0..2 {
                let point = view.at(end as f64);
                let width = view.measure();
                // across a gap contact is along e_ξ, which has to be the normal for the local problem to be that of contact
                let aligned =
                    mesh.direction.is_none_or(|xi| tangent_of(xi).dot(&first[end].normalize()).abs() > 1.0 - SAME);
                let may_close = point.gap.abs() < SAME * width && aligned;
                let ray = Ray { face: end, forward: end == 0 };
                outline.pair([side.first[end], side.second[end]], ray, may_close);
            }
        }
        outline
    }

    /// Adds a side from `a` to `b`, the body on its left, with its velocities at both ends.
    fn side(&mut self, body: Body, [a, b]: [u32; 2], velocities: [Vec2; 2], face: Face) {
        let leaves = self.nodes.entry(a).or_insert_with(|| Node::new(body));
        (leaves.rays[0], leaves.faces[0]) = (velocities[0].normalize(), face);
        let arrives = self.nodes.entry(b).or_insert_with(|| Node::new(body));
        (arrives.rays[1], arrives.faces[1]) = (-velocities[1].normalize(), face);
    }

    fn pair(&mut self, nodes: [u32; 2], ray: Ray, may_close: bool) {
        match self.pairs.iter_mut().find(|p| p.nodes == nodes) {
            Some(pair) => {
                pair.rays.push(ray);
                pair.may_close &= may_close;
            }
            None => self.pairs.push(Pair { nodes, rays: vec![ray], may_close }),
        }
    }
}

fn face(condition: &PartCondition) -> Face {
    match condition {
        PartCondition::Fixed(_) => Face::Clamped,
        PartCondition::Sliding => Face::Sliding,
        PartCondition::Traction(_) | PartCondition::Free => Face::Free,
    }
}
