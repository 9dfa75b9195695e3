//! A coarse mesh and its red refinements, with implicit prolongation; on curved bodies also meshes mapped anew.
//!
//! ```text
//!            2              Every side is halved. Triangle t has the children 4t … 4t+3: child i keeps
//!           / \             corner i and the order of the corners; child 3 is the middle one, its
//!          /4t+2\           corner i the midpoint of side i.
//!       m1 ------ m0
//!        / \4t+3/ \         So on level k the macro-triangle of t is t / 4^k, and its path
//!       /4t \  /4t+1\       from there are the k base-4 digits of t mod 4^k.
//!      0 --- m2 ---- 1
//! ```
//!
//! Nodes of a level keep their numbers on the next. The new nodes of level `k+1` follow: first those on the macro-sides, which
//! are numbered by ascending ends `(lower, higher)`, `2^k` on each in order from its lower end; then those inside the
//! macro-triangles, `3·2^k(2^k−1)/2` in each, in the order in which its level-`k` triangles (by path) and their
//! sides 0, 1, 2 meet them.

mod interiors;
mod onto;
mod template;

use super::sides::{Sides, side_nodes};
use super::{BoundarySide, ContactSide, CurvedSide, CurvedSides, Mesh, Shapes};
use crate::Vec2;
use template::{Midpoint, Template};

/// A coarse mesh (level 0) and its red refinements. Every level is kept.
#[derive(Clone, Debug)]
pub struct Hierarchy {
    levels: Vec<Mesh>,
    parents: Vec<Vec<[u32; 2]>>,
    /// Found by the first refinement.
    macro_sides: MacroSides,
}

/// The sides of the coarse mesh.
#[derive(Clone, Debug, Default)]
struct MacroSides {
    count: usize,
    /// Number of each side of a macro-triangle.
    of: Vec<[u32; 3]>,
    /// Numbers of each contact side, in `Ω'` and in `Ω''`.
    contact: Vec<[u32; 2]>,
}

impl MacroSides {
    fn new(coarse: &Mesh) -> Self {
        let sides = Sides::new(&coarse.triangles);
        // A contact side is a side of a triangle in both bodies: `Mesh::build` saw to it.
        let number = |[a, b]: [u32; 2]| sides.find(a, b).expect("a contact side is a side of a triangle in each body");
        let contact = coarse.contact.iter().map(|c| [number(c.first), number(c.second)]);
        Self { count: sides.len(), contact: contact.collect(), of: sides.of }
    }
}

impl Hierarchy {
    /// The hierarchy that consists of `coarse` alone.
    pub fn new(coarse: Mesh) -> Self {
        Self { levels: vec![coarse], parents: vec![Vec::new()], macro_sides: MacroSides::default() }
    }

    /// The meshes, coarsest first.
    pub fn levels(&self) -> &[Mesh] {
        &self.levels
    }

    /// The finest mesh.
    pub fn finest(&self) -> &Mesh {
        &self.levels[self.levels.len() - 1]
    }

    /// The ends of the sides whose midpoints are the new nodes of `level`, lower number first: node `N + i`, where `N` nodes
    /// make up the level below, halves the side `parents(level)[i]`. Empty for level 0.
    pub fn parents(&self, level: usize) -> &[[u32; 2]] {
        &self.parents[level]
    }

    /// Adds a level: every triangle in four, every boundary and contact side in two, new nodes of curved sides on their curves.
    /// Linear time.
    pub fn refine(&mut self) {
        let (fine, parents) = self.refined();
        self.levels.push(fine);
        self.parents.push(parents);
    }

    /// The next level and the parents of its new nodes.
    fn refined(&mut self) -> (Mesh, Vec<[u32; 2]>) {
        if self.levels.len() == 1 {
            self.macro_sides = MacroSides::new(&self.levels[0]);
        }
        Refiner::new(self).refine()
    }

    /// The nodal values on level `to` of the piecewise linear field with the values `nodal` on level `from ≤ to`.
    ///
    /// # Panics
    /// If `from > to`, `to` is no level, or `nodal` does not have one value per node of level `from`.
    pub fn prolong(&self, from: usize, to: usize, nodal: &[Vec2]) -> Vec<Vec2> {
        assert!(from <= to, "prolongation runs from coarse to fine, not from {from} to {to}");
        assert_eq!(nodal.len(), self.levels[from].points.len(), "one value per node of level {from}");
        let mut values = Vec::with_capacity(self.levels[to].points.len());
        values.extend_from_slice(nodal);
        for level in from + 1..=to {
            append_midpoints(&mut values, self.parents(level));
        }
        values
    }

    /// The transpose of [`prolong`](Self::prolong): nodal forces on level `from` as they act on the fields of level `to ≤ from`,
    /// `f·(P v) = (Pᵀ f)·v`.
    ///
    /// # Panics
    /// If `to > from`, `from` is no level, or `forces` does not have one value per node of level `from`.
    pub fn restrict(&self, from: usize, to: usize, forces: &[Vec2]) -> Vec<Vec2> {
        assert!(to <= from, "restriction runs from fine to coarse, not from {from} to {to}");
        assert_eq!(forces.len(), self.levels[from].points.len(), "one force per node of level {from}");
        let mut forces = forces.to_vec();
        for level in (to + 1..=from).rev() {
            let old = self.levels[level - 1].points.len();
            for (i, &[a, b]) in self.parents(level).iter().enumerate() {
                let half = 0.5 * forces[old + i];
                forces[a as usize] += half;
                forces[b as usize] += half;
            }
            forces.truncate(old);
        }
        forces
    }
}

/// Appends `½ (v_a + v_b)` for each pair of parents.
fn append_midpoints(values: &mut Vec<Vec2>, parents: &[[u32; 2]]) {
    for &[a, b] in parents {
        let middle = 0.5 * (values[a as usize] + values[b as usize]);
        values.push(middle);
    }
}

/// One refinement step of a hierarchy.
struct Refiner<'a> {
    hierarchy: &'a Hierarchy,
    mesh: &'a Mesh,
    /// `2^k`: how many pieces a macro-side has.
    pieces: usize,
    template: Template,
}

impl<'a> Refiner<'a> {
    fn new(hierarchy: &'a Hierarchy) -> Self {
        let mesh = hierarchy.finest();
        let pieces = 1 << (hierarchy.levels.len() - 1);
        Self { hierarchy, mesh, pieces, template: Template::new(pieces) }
    }

    fn refine(&self) -> (Mesh, Vec<[u32; 2]>) {
        let mesh = self.mesh;
        let (triangles, parents) = self.triangles();
        let mut points = Vec::with_capacity(mesh.points.len() + parents.len());
        points.extend_from_slice(&mesh.points);
        append_midpoints(&mut points, &parents);
        for side in &mesh.curved.sides {
            let curve = &mesh.curved.curves[usize::from(side.curve)];
            let middle = self.midpoint(side.triangle as usize, usize::from(side.apex));
            points[middle as usize] = curve.point(0.5 * (side.span[0] + side.span[1]));
        }
        let mut node_bodies = mesh.node_bodies.clone();
        node_bodies.extend(parents.iter().map(|&[a, _]| mesh.node_bodies[a as usize]));
        let fine = Mesh {
            points,
            node_bodies,
            triangles,
            first_triangles: 4 * mesh.first_triangles,
            sides: mesh.sides.iter().flat_map(|s| self.halves(s)).collect(),
            parts: mesh.parts.clone(),
            contact: (0..mesh.contact.len()).flat_map(|c| self.contact_halves(c)).collect(),
            curved: self.curved_halves(),
            direction: mesh.direction,
            initial_gap: mesh.initial_gap.clone(),
            shapes: Some(mesh.shapes.as_ref().map_or_else(|| Shapes::of_coarse(mesh).refined(), Shapes::refined)),
        };
        (fine, parents)
    }

    /// The children of every triangle and the parents of every new node.
    fn triangles(&self) -> (Vec<[u32; 3]>, Vec<[u32; 2]>) {
        let old = self.mesh.points.len();
        let count = self.new_nodes();
        assert!(old + count <= u32::MAX as usize, "node numbers of 32 bits end here");
        let mut parents = vec![[0; 2]; count];
        let mut triangles = Vec::with_capacity(4 * self.mesh.triangles.len());
        for (t, &corners) in self.mesh.triangles.iter().enumerate() {
            let middle = [0, 1, 2].map(|i| self.midpoint(t, i));
            for i in 0..3 {
                let [a, b] = side_nodes(corners, i);
                parents[middle[i] as usize - old] = [a.min(b), a.max(b)];
            }
            triangles.extend(children(corners, middle));
        }
        (triangles, parents)
    }

    fn new_nodes(&self) -> usize {
        let sides = &self.hierarchy.macro_sides;
        sides.count * self.pieces + sides.of.len() * interiors::inside(self.pieces)
    }

    /// The number of the new node on side `i` of triangle `t`.
    fn midpoint(&self, t: usize, i: usize) -> u32 {
        let paths = self.template.paths();
        let (macro_triangle, path) = (t / paths, t % paths);
        match self.template.midpoint(path, i) {
            Midpoint::OnSide { side, piece } => {
                let number = self.hierarchy.macro_sides.of[macro_triangle][side as usize];
                let corners = self.hierarchy.levels[0].triangles[macro_triangle];
                self.on_macro_side(number, side_nodes(corners, side as usize), piece as usize)
            }
            Midpoint::Inside(place) => {
                let sides = self.hierarchy.macro_sides.count * self.pieces;
                let before = sides + macro_triangle * interiors::inside(self.pieces);
                (self.mesh.points.len() + before) as u32 + place
            }
        }
    }

    /// The new node on piece `piece` of macro-side `number`, counted from the first of the macro-nodes `ends`.
    fn on_macro_side(&self, number: u32, ends: [u32; 2], piece: usize) -> u32 {
        let from_lower = if ends[0] < ends[1] { piece } else { self.pieces - 1 - piece };
        (self.mesh.points.len() + number as usize * self.pieces + from_lower) as u32
    }

    fn halves(&self, side: &BoundarySide) -> [BoundarySide; 2] {
        let (t, [a, b]) = (side.triangle, side.nodes);
        let corner = |node| position(self.mesh.triangles[t as usize], node);
        let middle = self.midpoint(t as usize, 3 - corner(a) - corner(b));
        let half = |nodes, corner| BoundarySide { nodes, triangle: 4 * t + corner as u32, part: side.part };
        [half([a, middle], corner(a)), half([middle, b], corner(b))]
    }

    fn contact_halves(&self, c: usize) -> [ContactSide; 2] {
        let side = self.mesh.contact[c];
        let (macro_side, piece) = (c / self.pieces, c % self.pieces);
        let [n, m] = self.hierarchy.macro_sides.contact[macro_side];
        let coarse = self.hierarchy.levels[0].contact[macro_side];
        let first = self.on_macro_side(n, coarse.first, piece);
        let second = self.on_macro_side(m, coarse.second, piece);
        // The half at a node belongs to the child at the triangle's corner there.
        let child = |t: u32, node| 4 * t + position(self.mesh.triangles[t as usize], node) as u32;
        let half = |f, s, end: usize| ContactSide {
            first: f,
            second: s,
            triangles: [child(side.triangles[0], side.first[end]), child(side.triangles[1], side.second[end])],
            segment: side.segment,
        };
        [
            half([side.first[0], first], [side.second[0], second], 0),
            half([first, side.first[1]], [second, side.second[1]], 1),
        ]
    }

    /// Children keep the order of the corners, so the halves lie opposite the same corner as their parent.
    fn curved_halves(&self) -> CurvedSides {
        let mut fine = CurvedSides { sides: Vec::new(), ..self.mesh.curved.clone() };
        for side in &self.mesh.curved.sides {
            let ([from, to], apex) = (side.span, u32::from(side.apex));
            let middle = 0.5 * (from + to);
            let half = |corner, span| CurvedSide { triangle: 4 * side.triangle + (apex + corner) % 3, span, ..*side };
            let mut halves = [half(1, [from, middle]), half(2, [middle, to])];
            halves.sort_by_key(|h| h.triangle);
            fine.sides.extend(halves);
        }
        fine
    }
}

/// The four children of a triangle with corners `c` and side midpoints `m`.
fn children(c: [u32; 3], m: [u32; 3]) -> [[u32; 3]; 4] {
    [[c[0], m[2], m[1]], [m[2], c[1], m[0]], [m[1], m[0], c[2]], m]
}

/// Which corner of the triangle a node is.
fn position(triangle: [u32; 3], node: u32) -> usize {
    let found = triangle.iter().position(|&i| i == node);
    found.expect("a boundary side is a side of its triangle")
}
