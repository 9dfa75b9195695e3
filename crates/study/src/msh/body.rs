//! The triangles of a physical surface as a body of its own.

use super::error::{MshError, refuse};
use super::read::{Element, Msh};
use crate::nearest::nearest;
use signorini_contact::Point;
use signorini_contact::geometry::twice_area;
use signorini_contact::mesh::Triangulation;
use std::collections::{BTreeMap, BTreeSet};

/// A body out of a file: its triangles, counterclockwise, the nodes that they use, and its boundary.
#[derive(Clone, Debug)]
pub struct BodyMesh {
    /// The physical surface.
    pub name: String,
    /// Nodes and triangles, in the order of their tags and of the file.
    pub mesh: Triangulation,
    /// The file's tag of each node.
    pub tags: Vec<u64>,
    /// The shortest side at each node.
    pub size: Vec<f64>,
    /// The boundary sides by their ends, lower number first; the body lies on the left.
    pub boundary: BTreeMap<[u32; 2], [u32; 2]>,
}

/// `2 |T| / (longest side)²` below which a triangle counts as degenerate.
const FLATTEST: f64 = 1e-10;

impl BodyMesh {
    /// The body that the physical surface `name` consists of. Nodes that no triangle uses are left out, clockwise triangles are turned.
    ///
    /// # Errors
    /// A group that does not exist or is empty; triangles that are degenerate, are there twice or overlap; two boundary nodes at the same
    /// place.
    pub fn new(msh: &Msh, name: &str) -> Result<Self, MshError> {
        let entities = msh.group(2, name)?;
        let own: Vec<&Element<3>> = msh.triangles.iter().filter(|t| entities.contains(&t.entity)).collect();
        if own.is_empty() {
            return refuse(
                format!("the physical surface \"{name}\" has no triangle"),
                "mesh it in dimension 2: gmsh -2 -format msh41",
            );
        }
        let used: BTreeSet<u64> = own.iter().flat_map(|t| t.nodes).collect();
        let tags: Vec<u64> = used.into_iter().collect();
        let points: Vec<Point> = tags.iter().map(|t| msh.nodes[t]).collect();
        let number: BTreeMap<u64, u32> = tags.iter().zip(0..).map(|(t, i)| (*t, i)).collect();
        let mut body = Self {
            name: name.to_string(),
            size: vec![f64::INFINITY; points.len()],
            mesh: Triangulation { points, triangles: Vec::with_capacity(own.len()) },
            tags,
            boundary: BTreeMap::new(),
        };
        for t in &own {
            body.add(t, t.nodes.map(|tag| number[&tag]))?;
        }
        body.find_boundary(&own)?;
        body.refuse_slits()?;
        Ok(body)
    }

    fn add(&mut self, element: &Element<3>, [i, j, k]: [u32; 3]) -> Result<(), MshError> {
        let [a, b, c] = [i, j, k].map(|n| self.mesh.points[n as usize]);
        let sides = [(b - c).norm(), (c - a).norm(), (a - b).norm()];
        let longest = sides.into_iter().fold(0.0, f64::max);
        let area = twice_area(a, b, c);
        if area.is_nan() || area.abs() <= FLATTEST * longest * longest {
            let corners: Vec<String> = [i, j, k].map(|n| self.at(n)).into();
            let message = format!(
                "triangle {} of \"{}\" is degenerate: twice its area is {area:.3e} at the corners {}",
                element.tag,
                self.name,
                corners.join(", ")
            );
            return refuse(message, "correct the geometry there, or move one of its corners, and mesh it again");
        }
        self.mesh.triangles.push(if area > 0.0 { [i, j, k] } else { [i, k, j] });
        for (n, opposite) in [i, j, k].into_iter().zip(0..) {
            let shortest = (0..3).filter(|s| *s != opposite).map(|s| sides[s]).fold(f64::INFINITY, f64::min);
            let size = &mut self.size[n as usize];
            *size = size.min(shortest);
        }
        Ok(())
    }

    /// The sides of one triangle alone. A side of two must run in both directions, and none may belong to three.
    fn find_boundary(&mut self, own: &[&Element<3>]) -> Result<(), MshError> {
        let mut sides: BTreeMap<[u32; 2], Vec<([u32; 2], u64)>> = BTreeMap::new();
        for (triangle, element) in self.mesh.triangles.iter().zip(own) {
            for k in 0..3 {
                let side = [triangle[k], triangle[(k + 1) % 3]];
                sides.entry(lower_first(side)).or_default().push((side, element.tag));
            }
        }
        for (ends, owners) in sides {
            match &owners[..] {
                [(side, _)] => _ = self.boundary.insert(ends, *side),
                [(a, _), (b, _)] if a != b => {}
                _ => {
                    let tags: Vec<String> = owners.iter().map(|(_, tag)| tag.to_string()).collect();
                    let message = format!(
                        "triangles {} of \"{}\" overlap along the side from {} to {}",
                        tags.join(", "),
                        self.name,
                        self.at(ends[0]),
                        self.at(ends[1])
                    );
                    return refuse(message, "remove the one that is there twice");
                }
            }
        }
        Ok(())
    }

    /// Two boundary nodes at one place are a slit that nobody sees.
    fn refuse_slits(&self) -> Result<(), MshError> {
        let mut nodes: Vec<u32> = self.boundary.values().map(|side| side[0]).collect();
        let place = |n: &u32| self.mesh.points[*n as usize];
        nodes.sort_by(|a, b| place(a).x.total_cmp(&place(b).x).then(place(a).y.total_cmp(&place(b).y)));
        let near = |a: u32, b: u32| {
            let bound = self.tolerance(a).min(self.tolerance(b));
            (place(&a) - place(&b)).norm() <= bound
        };
        for (k, &a) in nodes.iter().enumerate() {
            let candidates = nodes[k + 1..].iter().take_while(|b| place(b).x - place(&a).x <= self.tolerance(a));
            if let Some(&b) = candidates.into_iter().find(|b| **b != a && near(a, **b)) {
                return refuse(
                    format!("{} and {} of \"{}\" are two nodes at one place", self.at(a), self.at(b), self.name),
                    "let the surfaces of a body share their curves, or merge the nodes: Coherence Mesh;",
                );
            }
        }
        Ok(())
    }

    /// The sides of the body in the physical curve `name`, the body on the left, in the order of the file.
    ///
    /// # Errors
    /// A group that does not exist or is empty, a line that is no boundary side of the body.
    pub fn sides(&self, msh: &Msh, name: &str) -> Result<Vec<[u32; 2]>, MshError> {
        let entities = msh.group(1, name)?;
        let number = |tag: &u64| self.tags.binary_search(tag).ok().map(|i| i as u32);
        let (mut sides, mut seen) = (Vec::new(), BTreeSet::new());
        for line in msh.lines.iter().filter(|l| entities.contains(&l.entity)) {
            let [a, b] = line.nodes.each_ref().map(number);
            let found = a.zip(b).and_then(|(a, b)| self.boundary.get(&lower_first([a, b])));
            let Some(side) = found else {
                let message = format!(
                    "line {} (nodes {} and {}) of \"{name}\" is no boundary side of the body \"{}\"",
                    line.tag, line.nodes[0], line.nodes[1], self.name
                );
                return refuse(message, "give each body physical curves of its own, made of its boundary alone");
            };
            if seen.insert(*side) {
                sides.push(*side);
            }
        }
        if sides.is_empty() {
            return refuse(
                format!("the physical curve \"{name}\" has no line"),
                "mesh the curve, and let Mesh.SaveAll be 0 so that groups are saved with their lines",
            );
        }
        Ok(sides)
    }

    /// A node with its tag and place, for messages.
    pub fn at(&self, n: u32) -> String {
        let p = self.mesh.points[n as usize];
        format!("node {} at ({}, {})", self.tags[n as usize], p.x, p.y)
    }

    /// The place of a node.
    pub fn point(&self, n: u32) -> Point {
        self.mesh.points[n as usize]
    }

    /// How far a node may be from where it belongs: [`SAME`] of the shortest side there.
    pub fn tolerance(&self, n: u32) -> f64 {
        SAME * self.size[n as usize]
    }
}

/// Share of the shortest side at a node within which the node lies on a line, on a curve, at its partner.
pub const SAME: f64 = 1e-4;

/// The ends of a side as a key.
pub fn lower_first([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

impl Msh {
    /// The entities of the physical group of this name.
    fn group(&self, dimension: i32, name: &str) -> Result<BTreeSet<i32>, MshError> {
        let groups = || self.names.iter().filter(|((d, _), _)| *d == dimension);
        let tags: BTreeSet<i32> = groups().filter(|(_, n)| *n == name).map(|((_, tag), _)| *tag).collect();
        if tags.is_empty() {
            let what = ["point", "curve", "surface"][dimension as usize];
            let known: Vec<&str> = groups().map(|(_, n)| n.as_str()).collect();
            let next = match nearest(name, known.iter().copied()) {
                Some(meant) => format!("did you mean \"{meant}\"?"),
                None if known.is_empty() => "name groups of that dimension in the .geo and mesh it again".into(),
                None => format!("the file has \"{}\"", known.join("\", \"")),
            };
            return refuse(format!("the file has no physical {what} \"{name}\""), next);
        }
        let own = self
            .entities
            .iter()
            .filter(|((d, _), physical)| *d == dimension && physical.iter().any(|t| tags.contains(t)));
        Ok(own.map(|((_, entity), _)| *entity).collect())
    }
}
