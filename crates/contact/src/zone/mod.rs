//! The contact zone of a mesh: node pairs, their normals and the length each constraint stands for.
//!
//! ```text
//!        Ω'   (n points out of Ω')        At a corner A_i two segments meet: the pair carries
//!   ──●────────●────────●──  nodes a      two constraints, one for each normal, and each owns
//!     ○────────○────────○    nodes b      the half side on its own segment.
//!        Ω''        │n
//! ```

mod bilateral;
#[cfg(test)]
mod tests;

pub use bilateral::ConstraintKind;

use crate::geometry::{LinePoint, Vec2, cross};
use crate::mesh::Mesh;
use std::collections::BTreeMap;

/// Normals with `|n¹ × n²|` below this are one.
pub const SAME_NORMAL: f64 = 1e-8;

/// Below this the two constraints at a corner are nearly dependent, which deserves a warning.
pub const NEARLY_SAME_NORMAL: f64 = 0.05;

/// `n·(v' − v'') ≤ gap` at a pair, or `=` where it is bilateral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Unit normal, outward from `Ω'`.
    pub normal: Vec2,
    /// Initial gap, zero where the bodies touch before loading, negative where they penetrate.
    pub gap: f64,
    /// Half the measure of the adjacent sides with this normal (length, or width in `η` across a gap): the lumped mass of the
    /// pressure.
    pub mass: f64,
    /// The last contact side (index into `Mesh::contact`) that this constraint belongs to.
    pub side: usize,
    /// Whether the bodies may part.
    pub kind: ConstraintKind,
}

/// A node of `Ω'` and its partner in `Ω''`, at the same point of `Γ_K` or, across a gap, on the same line `η = C_j`.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPair {
    /// Node `a` of `Ω'`.
    pub first: u32,
    /// Node `b` of `Ω''`.
    pub second: u32,
    /// One constraint, or two at a corner of the contact polyline.
    pub constraints: Vec<Constraint>,
}

/// The pairs in the order of the contact polyline.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Zone {
    /// The pairs.
    pub pairs: Vec<ContactPair>,
    /// For each contact side, the `n` of its constraints at the two ends: the unit normal outward from `Ω'`, or `−e_ξ`.
    pub side_normals: Vec<[Vec2; 2]>,
    /// For each contact side, where its two end nodes find their constraint: `(pair, constraint)`.
    pub side_ends: Vec<[(usize, usize); 2]>,
    /// Corners whose two normals are nearly the same, in words.
    pub warnings: Vec<String>,
}

impl Zone {
    /// Collects the pairs of the mesh with the normals of their sides.
    pub fn new(mesh: &Mesh) -> Self {
        let mut zone = Self::default();
        let mut known = BTreeMap::new();
        for side in 0..mesh.contact.len() {
            let view = mesh.contact_view(side);
            let mass = 0.5 * view.measure();
            let points = [view.at(0.0), view.at(1.0)];
            let constraint = |p: &LinePoint| Constraint {
                normal: p.normal,
                gap: p.gap,
                mass,
                side,
                kind: ConstraintKind::Unilateral,
            };
            let ends = [0, 1].map(|end| zone.add(mesh, side, end, constraint(&points[end]), &mut known));
            zone.side_normals.push(points.map(|p| p.normal));
            zone.side_ends.push(ends);
        }
        zone
    }

    /// Number of constraints of all pairs.
    pub fn constraints(&self) -> usize {
        self.pairs.iter().map(|p| p.constraints.len()).sum()
    }

    fn add(
        &mut self,
        mesh: &Mesh,
        side: usize,
        end: usize,
        constraint: Constraint,
        known: &mut BTreeMap<u32, usize>,
    ) -> (usize, usize) {
        let contact = &mesh.contact[side];
        let normal = constraint.normal;
        let (first, second) = (contact.first[end], contact.second[end]);
        let Some(&pair) = known.get(&first) else {
            known.insert(first, self.pairs.len());
            self.pairs.push(ContactPair { first, second, constraints: vec![constraint] });
            return (self.pairs.len() - 1, 0);
        };
        let same = |c: &Constraint| cross(c.normal, normal).abs() < SAME_NORMAL && c.normal.dot(&normal) > 0.0;
        if let Some(k) = self.pairs[pair].constraints.iter().position(same) {
            self.pairs[pair].constraints[k].mass += constraint.mass;
            self.pairs[pair].constraints[k].side = side;
            return (pair, k);
        }
        self.warn_of_nearly_dependent_normals(mesh, pair, normal);
        self.pairs[pair].constraints.push(constraint);
        (pair, self.pairs[pair].constraints.len() - 1)
    }

    fn warn_of_nearly_dependent_normals(&mut self, mesh: &Mesh, pair: usize, normal: Vec2) {
        let pair = &self.pairs[pair];
        let sine = cross(pair.constraints[0].normal, normal).abs();
        if sine < NEARLY_SAME_NORMAL {
            let x = mesh.points[pair.first as usize];
            self.warnings.push(format!(
                "contact corner at ({}, {}): its two normals differ by a sine of {sine:.1e} only (below {NEARLY_SAME_NORMAL}); \
                 the two constraints there are nearly dependent",
                x.x, x.y
            ));
        }
    }
}

/// The measure of contact side `side`: its length, or its width in `η` across a gap.
pub fn side_length(mesh: &Mesh, side: usize) -> f64 {
    mesh.contact_view(side).measure()
}
