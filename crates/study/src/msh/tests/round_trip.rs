//! Written and read again, a mesh is the same to the last bit.

use super::*;
use crate::study::Study;
use signorini_contact::Body;
use std::path::PathBuf;

/// A folder with a mesh file and a study of the scene on it, removed at the end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str, text: &str) -> Self {
        let path = std::env::temp_dir().join(format!("signorini-msh-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        std::fs::write(path.join("mesh.msh"), text).unwrap();
        Self(path)
    }

    /// A study that takes bodies, parts and zone from the file, `curve` on the zone.
    fn study(&self, mesh: &Mesh, [first, second]: [&str; 2], curve: &str) -> Case {
        let mut text = format!(
            "id = \"again\"\ntitle = \"t\"\nquestion = \"q\"\nsetup = \"s\"\nrefuted_by = \"r\"\nclaim = \"two-squares\"\n\
             [mesh]\nfile = \"mesh.msh\"\n[levels]\nquick = [1, 2]\nfull = [1, 2]\n[reference]\nkind = \"none\"\n\
             [contact]\nphysical = [[\"{first}:contact\", \"{second}:contact\"]]\ncurves = [\"{curve}\"]\n\
             [[curve]]\nname = \"hole\"\ncircle = {{ centre = [0, 0], radius = 1, from = -90, to = 90 }}\n"
        );
        for name in [first, second] {
            text += &format!(
                "[[body]]\nname = \"{name}\"\nmaterial = {{ young = 1, poisson = 0.3 }}\nphysical = \"{name}\"\n"
            );
        }
        for part in &mesh.parts {
            let body = [first, second][part.body.index()];
            let name = &part.name;
            text += &format!(
                "[[boundary]]\nbody = \"{body}\"\nname = \"{name}\"\nphysical = \"{body}:{name}\"\ncondition = \"fixed\"\n"
            );
        }
        let study = Study::parse(&text, &self.0.join("again.toml")).unwrap_or_else(|e| panic!("{e}"));
        study.cases.into_iter().next().unwrap()
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn bits(mesh: &Mesh) -> Vec<[u64; 2]> {
    mesh.points.iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect()
}

fn sides(mesh: &Mesh) -> Vec<([u32; 2], String)> {
    let mut sides: Vec<_> =
        mesh.sides.iter().map(|s| (s.nodes, mesh.parts[usize::from(s.part)].name.clone())).collect();
    sides.sort();
    sides
}

fn demand_the_same(id: &str, case: &str, n: usize, curve: &str) {
    let original = sample::case(id, case);
    let mesh = meshed(&original, n);
    let names = original.scene().unwrap().bodies.each_ref().map(|b| b.name.as_str());
    let scratch = Scratch::new(id, &super::super::write(&mesh, names));
    let imported = scratch.study(&mesh, names, curve);
    let again = meshed(&imported, 1);
    assert_eq!(bits(&again), bits(&mesh), "{id}");
    assert_eq!((&again.triangles, again.first_triangles), (&mesh.triangles, mesh.first_triangles));
    assert_eq!(sides(&again), sides(&mesh));
    assert!(again.contact.iter().zip(&mesh.contact).all(|(a, b)| (a.first, a.second) == (b.first, b.second)));
    assert_eq!(again.contact.len(), mesh.contact.len());
    let arcs = |m: &Mesh| m.curved.sides.iter().map(|s| (s.triangle, s.apex)).collect::<Vec<_>>();
    assert_eq!(arcs(&again), arcs(&mesh));
    // and the files are the same, too
    assert_eq!(super::super::write(&again, names), super::super::write(&mesh, names));
}

/// Whatever changes in the file, the case is another one: baselines and unfinished runs of the old file do not serve it.
#[test]
fn the_file_is_part_of_what_names_a_case() {
    let mesh = meshed(&sample::case("two-squares", "two-squares"), 2);
    let text = super::super::write(&mesh, ["upper", "lower"]);
    let print = |name: &str, text: &str| Scratch::new(name, text).study(&mesh, ["upper", "lower"], "").fingerprint();
    assert_eq!(print("once", &text), print("twice", &text));
    assert_ne!(print("once", &text), print("other", &format!("{text}$Comments\nmade anew\n$EndComments\n")));
}

#[test]
fn straight_bodies_come_back_bit_by_bit() {
    demand_the_same("two-squares", "two-squares", 5, "");
    demand_the_same("theorem-3-2", "kinked", 2, "");
}

#[test]
fn curved_bodies_come_back_bit_by_bit() {
    demand_the_same("pin-in-hole", "load-1", 3, "hole");
}

/// New nodes of refinements lie on the true curve: the areas are those of the half disc and of its complement on every level.
#[test]
fn refinements_of_an_imported_mesh_follow_the_true_curve() {
    let case = sample::case("pin-imported", "pin-imported");
    let domain = case.scene().unwrap().domain();
    let level = build_level(&case.family, &domain, &[1, 2, 4], 2).unwrap();
    for mesh in level.hierarchy.levels() {
        let area = |body| (mesh.triangles_of(body)).map(|t| mesh.area(t)).sum::<f64>();
        let half = 0.5 * std::f64::consts::PI;
        assert!((area(Body::First) - half).abs() < 1e-13, "{}", area(Body::First) - half);
        assert!((area(Body::Second) - (200.0 - half)).abs() < 1e-11);
    }
    assert_eq!((level.nested, level.hierarchy.levels().len()), (false, 3));
}
