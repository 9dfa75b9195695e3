//! Meshes out of files, from end to end: the shipped dovetail, a mesh of the user's own, what is refused.

mod common;

use common::{Folder, edit};
use signorini_study::record::{Outcome, StudyRecord};

const DOVETAIL: &str = include_str!("../studies/dovetail.toml");
const MESH: &str = include_str!("../studies/meshes/dovetail.msh");

/// The dovetail in a folder of its own, study and mesh, with a coarse reference.
fn folder(test: &str, old: &str, new: &str) -> Folder {
    let coarse = edit(DOVETAIL, "quick = 64", "quick = 16");
    let folder = Folder::with_study(test, &edit(&coarse, old, new));
    folder.write("studies/meshes/dovetail.msh", MESH);
    folder
}

fn energies(record: &StudyRecord) -> Vec<f64> {
    record.levels.iter().map(|l| l.energy).collect()
}

/// What is checked is the whole way: file, zone with its two corners, refinement, solution, corners of the scene, verdict.
#[test]
fn the_dovetail_converges_at_the_rate_of_its_corners() {
    let folder = folder("dovetail", "[levels]", "[levels]");
    folder.signorini("run dovetail --levels 3 --quiet");
    let record = folder.record("reports/dovetail");
    assert_eq!(record.family, "refined");
    // a notch of 297° whose one flank slides and whose other is free
    assert!(record.bounds.expected.is_some_and(|rate| (rate - 0.5).abs() < 1e-9), "{:?}", record.bounds);
    let counts: Vec<_> = record.levels.iter().map(|l| (l.contact_pairs, l.constraints, l.nested)).collect();
    // every corner inside the zone has two constraints
    assert_eq!(counts, [(12, 14, false), (23, 25, true), (45, 47, true)]);
    let errors: Vec<f64> = record.levels.iter().map(|l| l.errors.energy.unwrap()).collect();
    assert!(errors.windows(2).all(|w| w[1] < 0.8 * w[0]), "{errors:?}");
    assert!(energies(&record).windows(2).all(|w| w[1] < w[0]));
    assert!(record.levels.iter().all(|l| l.ledger.as_ref().is_some_and(|ledger| ledger.holds == Some(true))));
}

/// Without a folder of studies the program uses the ones, and the meshes, that were built into it.
#[test]
fn shipped_meshes_need_no_checkout() {
    let folder = Folder::new("embedded");
    let ended = folder.signorini("check dovetail pin-imported").expect(0);
    assert!(ended.out.contains("n = 8") && ended.out.contains("pin 90° contact–sliding"), "{}", ended.out);
}

#[test]
fn a_mesh_that_changes_is_another_case() {
    let plain = folder("plain", "[levels]", "[levels]");
    plain.signorini("run dovetail --levels 1 --quiet");
    let moved = folder("moved", "[levels]", "[levels]");
    // the wall of the groove stands farther out
    moved.write("studies/meshes/dovetail.msh", &MESH.replace("\n2.5 -2.5 0\n", "\n2.6 -2.5 0\n"));
    moved.signorini("run dovetail --levels 1 --quiet");
    let records = [&plain, &moved].map(|f| f.record("reports/dovetail"));
    assert_ne!(records[0].levels[0].mesh_hash, records[1].levels[0].mesh_hash);
    assert_ne!(energies(&records[0]), energies(&records[1]));
}

/// What is changed in the study, and what the program says.
const REFUSED: &[(&str, &str, &[&str])] = &[
    (
        "meshes/dovetail.msh\"",
        "meshes/dovetale.msh\"",
        &["cannot read the mesh file", "dovetale.msh", "path from the folder of the study"],
    ),
    (
        "physical = \"tongue\"",
        "physical = \"tonge\"",
        &["dovetail.msh: the file has no physical surface \"tonge\"", "did you mean \"tongue\"?"],
    ),
    (
        "physical = \"tongue\"",
        "rectangle = [[0, 0], [1, 1]]",
        &["a body beside [mesh] is made of the file's triangles"],
    ),
    (
        "physical = \"groove-bottom\"",
        "physical = \"tongue-top\"",
        &["is no boundary side of the body \"groove\"", "curves of its own"],
    ),
    ("\"groove-face\"", "\"groove-free\"", &["the zone of \"groove\" has 2 separate pieces"]),
    (
        "[[\"tongue-face\", \"groove-face\"]]",
        "[[\"tongue-top\", \"groove-face\"]]",
        &["has no partner on the zone of \"groove\"", "Transfinite"],
    ),
    ("physical = \"tongue-sides\"", "physical = \"tongue-top\"", &["belongs to top and to sides"]),
    ("quick = [1, 2, 4, 8]", "quick = [2, 4, 8]", &["do not begin with 1, the mesh of the file"]),
    (
        "[levels]",
        "[family]\nname = \"delaunay\"\nseed = 1\n\n[levels]",
        &["the family of a mesh file is its own refinement"],
    ),
    (
        "condition = \"free\"\n\n[[boundary]]",
        "condition = \"free\"\ncurves = [\"hole\"]\n\n[[boundary]]",
        &["there is no curve `hole`"],
    ),
    ("[mesh]\nfile = \"meshes/dovetail.msh\"\n", "", &["is said to be a physical surface, and there is no [mesh]"]),
];

#[test]
fn names_that_do_not_fit_the_file_are_refused() {
    for (number, (old, new, words)) in REFUSED.iter().enumerate() {
        let folder = folder(&format!("refused-{number}"), old, new);
        let ended = folder.signorini("check dovetail").complains(2, words);
        assert!(ended.err.starts_with("error: ") && ended.err.contains("dovetail.toml:"), "{}", ended.err);
    }
}

#[test]
fn a_mesh_that_makes_no_sense_is_refused_by_its_line() {
    let folder = folder("line", "[levels]", "[levels]");
    folder.write("studies/meshes/dovetail.msh", &MESH.replacen("4.1 0 8", "2.2 0 8", 1));
    folder.signorini("check dovetail").complains(2, &["dovetail.msh: line 2: version `2.2`", "gmsh -2 -format msh41"]);
}

/// Uniform pressure on flanks and bottom, both constraints active at the corners between: a displacement linear in x, y is found again to rounding.
#[test]
fn a_linear_displacement_is_reproduced_on_an_imported_mesh() {
    const PATCH: &str = r#"[own_claim]
statement = "a linear displacement is reproduced"
kind = "exact"
norm = "energy"
sources = ["patch test"]

[exact]
first = ["-0.01*x", "-0.01*y"]
second = ["-0.01*x", "-0.01*y"]

[levels]
quick = [1, 2, 4]
full = [1, 2, 4]

[mesh]"#;
    let study = edit(DOVETAIL, "claim = \"theorem-3-2\"\n", "");
    let study = edit(&study, "value = [\"0.01\", \"0.05\"]\n", "").replace("\"free\"\n", "\"traction\"\n");
    let scene = edit(&study, "[mesh]", PATCH);
    let folder = Folder::with_study("patch", &scene[..scene.rfind("[levels]").expect("the levels")]);
    folder.write("studies/meshes/dovetail.msh", MESH);
    folder.signorini("run dovetail --quiet").expect(0);
    let record = folder.record("reports/dovetail");
    assert_eq!(record.verdict.outcome, Outcome::Pass, "{:?}", record.verdict);
    assert!(record.levels.iter().all(|l| l.active == l.constraints), "{:?}", record.levels[0].active);
}

/// The same scene on mapped grids: half width, peak pressure and force of the two meet.
#[test]
fn the_imported_pin_presses_like_the_mapped_one() {
    let folder = Folder::new("pins");
    folder.signorini("run pin-imported pin-in-hole --levels 3 --quiet");
    let contact = |case: &str| folder.record(case).levels.pop().and_then(|l| l.contact).expect("a contact zone");
    let (own, mapped) = (contact("reports/pin-imported"), contact("reports/pin-in-hole/load-1"));
    let near = |a: f64, b: f64, share: f64| assert!((a / b - 1.0).abs() < share, "{a} {b}");
    near(own.half_width, mapped.half_width, 1e-3);
    near(own.peak_pressure, mapped.peak_pressure, 0.02);
    near(own.force, mapped.force, 1e-3);
}
