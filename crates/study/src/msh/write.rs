//! A mesh as text that Gmsh and whatever reads its files understand.

use super::kind::{LINE, TRIANGLE};
use signorini_contact::mesh::Mesh;
use signorini_contact::{Body, Point};
use std::fmt::Write;

/// The mesh as a Gmsh file, version 4.1, ASCII. `bodies` are the names of `Ω'` and `Ω''`.
///
/// | entity = physical group | name | elements |
/// | --- | --- | --- |
/// | surface 1, 2 | the body | its triangles, counterclockwise, in the order of the mesh |
/// | curve 1, 2 | `BODY:contact` | the face of `Ω'`, of `Ω''` on the contact zone in the zone's order: side `k` of one faces side `k` of the other |
/// | curve 3, 4, … | `BODY:PART` | the sides of boundary part `0, 1, …` of the mesh, the body on the left |
///
/// Node `i` of the mesh has the tag `i + 1`, triangle `t` the tag `t + 1`; lines follow. Coordinates read back to the last bit.
/// Curved sides appear as their chords, since the format has no arcs: whoever refines the mesh has to know the curves.
pub fn write(mesh: &Mesh, bodies: [&str; 2]) -> String {
    let groups = groups(mesh, bodies);
    // about 60 bytes a node, 25 an element
    let mut text =
        String::with_capacity(60 * mesh.points.len() + 25 * (mesh.triangles.len() + mesh.sides.len()) + 4096);
    text += "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    names(&mut text, &groups);
    entities(&mut text, mesh, &groups);
    nodes(&mut text, mesh);
    elements(&mut text, mesh, &groups);
    text
}

/// A physical group and the entity that it consists of; both have the tag.
struct Group {
    dimension: usize,
    tag: usize,
    name: String,
    body: Body,
    /// The sides of a curve; a surface has all triangles of its body.
    sides: Vec<[u32; 2]>,
}

fn groups(mesh: &Mesh, bodies: [&str; 2]) -> Vec<Group> {
    let curve = |tag: usize, body: Body, part: &str, sides| {
        let name = format!("{}:{part}", bodies[body.index()]);
        Group { dimension: 1, tag, name, body, sides }
    };
    let first = mesh.contact.iter().map(|c| c.first).collect();
    // the zone runs with Ω'' on its right; a side keeps its body on the left
    let second = mesh.contact.iter().map(|c| [c.second[1], c.second[0]]).collect();
    let mut groups = vec![curve(1, Body::First, "contact", first), curve(2, Body::Second, "contact", second)];
    for (k, part) in mesh.parts.iter().enumerate() {
        let own = mesh.sides.iter().filter(|s| usize::from(s.part) == k);
        groups.push(curve(k + 3, part.body, &part.name, own.map(|s| s.nodes).collect()));
    }
    for body in Body::BOTH {
        let name = bodies[body.index()].to_string();
        groups.push(Group { dimension: 2, tag: body.index() + 1, name, body, sides: Vec::new() });
    }
    groups
}

/// Appends a line. Writing to a String cannot fail.
macro_rules! line {
    ($text:expr, $($what:tt)*) => {{ let _ = writeln!($text, $($what)*); }};
}

fn names(text: &mut String, groups: &[Group]) {
    line!(text, "$PhysicalNames\n{}", groups.len());
    for g in groups {
        // a name stands between quotation marks and has no means of holding one
        line!(text, "{} {} \"{}\"", g.dimension, g.tag, g.name.replace(['"', '\n', '\r'], "'"));
    }
    line!(text, "$EndPhysicalNames");
}

fn entities(text: &mut String, mesh: &Mesh, groups: &[Group]) {
    let count = |dimension| groups.iter().filter(|g| g.dimension == dimension).count();
    line!(text, "$Entities\n0 {} {} 0", count(1), count(2));
    for g in groups.iter().filter(|g| g.dimension == 1) {
        let points = g.sides.iter().flatten().map(|&i| mesh.points[i as usize]);
        line!(text, "{} {} 1 {} 0", g.tag, extent(points), g.tag);
    }
    for g in groups.iter().filter(|g| g.dimension == 2) {
        let points = mesh.points.iter().zip(&mesh.node_bodies).filter(|(_, b)| **b == g.body).map(|(p, _)| *p);
        let own: Vec<usize> = groups.iter().filter(|c| c.dimension == 1 && c.body == g.body).map(|c| c.tag).collect();
        let bounding: String = own.iter().map(|tag| format!(" {tag}")).collect();
        line!(text, "{} {} 1 {} {}{bounding}", g.tag, extent(points), g.tag, own.len());
    }
    line!(text, "$EndEntities");
}

/// `xmin ymin 0 xmax ymax 0` of the box around the points.
fn extent(points: impl Iterator<Item = Point> + Clone) -> String {
    let low = points.clone().reduce(|a, b| a.inf(&b)).unwrap_or_default();
    let high = points.reduce(|a, b| a.sup(&b)).unwrap_or_default();
    format!("{:?} {:?} 0 {:?} {:?} 0", low.x, low.y, high.x, high.y)
}

fn nodes(text: &mut String, mesh: &Mesh) {
    let total = mesh.points.len();
    let first = mesh.node_bodies.partition_point(|&b| b == Body::First);
    line!(text, "$Nodes\n2 {total} 1 {total}");
    for (tag, range) in [(1, 0..first), (2, first..total)] {
        line!(text, "2 {tag} 0 {}", range.len());
        range.clone().for_each(|i| line!(text, "{}", i + 1));
        // the fewest digits that read back as the same number
        mesh.points[range].iter().for_each(|p| line!(text, "{:?} {:?} 0", p.x, p.y));
    }
    line!(text, "$EndNodes");
}

fn elements(text: &mut String, mesh: &Mesh, groups: &[Group]) {
    let total = mesh.triangles.len() + groups.iter().map(|g| g.sides.len()).sum::<usize>();
    line!(text, "$Elements\n{} {total} 1 {total}", groups.len());
    for body in Body::BOTH {
        let own = mesh.triangles_of(body);
        line!(text, "2 {} {TRIANGLE} {}", body.index() + 1, own.len());
        for t in own {
            let [a, b, c] = mesh.triangles[t].map(|i| i + 1);
            line!(text, "{} {a} {b} {c}", t + 1);
        }
    }
    let mut tag = mesh.triangles.len();
    for g in groups.iter().filter(|g| g.dimension == 1) {
        line!(text, "1 {} {LINE} {}", g.tag, g.sides.len());
        for [a, b] in g.sides.iter().map(|s| s.map(|i| i + 1)) {
            tag += 1;
            line!(text, "{tag} {a} {b}");
        }
    }
    line!(text, "$EndElements");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::family::build_level;
    use crate::sample;

    fn written(id: &str, case: &str, n: usize) -> (Mesh, String) {
        let case = sample::case(id, case);
        let scene = case.scene().unwrap();
        let level = build_level(&case.family, &scene.domain(), &[n], 0).unwrap();
        let mesh = level.hierarchy.finest().clone();
        let text = write(&mesh, [&scene.bodies[0].name, &scene.bodies[1].name]);
        (mesh, text)
    }

    #[test]
    fn groups_carry_the_names_of_bodies_parts_and_faces() {
        let (mesh, text) = written("two-squares", "two-squares", 2);
        let names: Vec<&str> = text.lines().skip(5).take(mesh.parts.len() + 4).collect();
        assert_eq!(names[0], "1 1 \"upper:contact\"");
        assert_eq!(names[1], "1 2 \"lower:contact\"");
        assert_eq!(names[2], format!("1 3 \"upper:{}\"", mesh.parts[0].name));
        assert_eq!(names[names.len() - 2..], ["2 1 \"upper\"", "2 2 \"lower\""]);
        assert!(text.contains(&format!("$Nodes\n2 {0} 1 {0}\n2 1 0 9\n1\n2\n", mesh.points.len())));
    }

    /// Every triangle and every side is there once, and sides have their body on the left: the two faces run against each other.
    #[test]
    fn elements_are_those_of_the_mesh() {
        let (mesh, text) = written("pin-in-hole", "load-1", 8);
        let elements = text.split("$Elements\n").nth(1).unwrap();
        let total = mesh.triangles.len() + mesh.sides.len() + 2 * mesh.contact.len();
        assert!(elements.starts_with(&format!("{} {total} 1 {total}\n", mesh.parts.len() + 4)));
        let blocks = mesh.parts.len() + 4;
        assert_eq!(elements.lines().count(), 1 + blocks + total + 1);
        let face = |tag: usize| elements.split(&format!("\n1 {tag} 1 ")).nth(1).unwrap().lines().nth(1).unwrap();
        let ends = |line: &str| line.split(' ').skip(1).map(|i| i.parse::<u32>().unwrap() - 1).collect::<Vec<u32>>();
        assert_eq!(ends(face(1)), mesh.contact[0].first);
        let [a, b] = mesh.contact[0].second;
        assert_eq!(ends(face(2)), [b, a]);
    }
}
