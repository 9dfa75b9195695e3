//! Studies that a user writes: the README's example, materials of every kind, a claim and an exact solution of one's own.

mod common;

use common::Folder;
use signorini_study::record::{Outcome, StudyRecord};

/// The first TOML block of the README.
fn readme_study() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../README.md");
    let text = std::fs::read_to_string(path).expect("the README");
    let block = text.split("```toml\n").nth(1).expect("a study in the README");
    block.split("```").next().expect("the end of the block").to_owned()
}

#[test]
fn the_example_of_the_readme_runs_and_passes() {
    let folder = Folder::with_study("readme", &readme_study());
    let ended = folder.signorini("run press --levels 3 --quiet");
    assert_eq!(ended.status, 0, "{ended:?}");
    let record = folder.record("reports/press");
    assert!(record.levels.iter().all(|l| l.ledger.as_ref().is_some_and(|ledger| ledger.holds == Some(true))));
}

/// Two blocks between sliding walls under uniaxial strain, `u_2'' = −0.1 (1 + y)` and `u_2' = −0.1 − slope · y`. The stress
/// `τ_22 = −0.1 · C_22''` is the same in both only if `slope = 0.1 · C_22''/C_22'`.
fn uniaxial(upper: &str, lower: &str, slope: f64) -> String {
    let head = format!(
        r#"id = "uniaxial"
title = "Uniaxial strain of two blocks"
question = "Is a linear displacement reproduced?"
setup = "Blocks of different materials between sliding walls."
refuted_by = "Any error beyond rounding."

[own_claim]
statement = "a linear displacement is reproduced"
kind = "exact"
norm = "energy"
sources = ["patch test"]

[parameters]
slope = {slope:?}

[exact]
first = ["0", "-0.1 - slope * y"]
second = ["0", "-0.1 * (1 + y)"]

[levels]
quick = [2, 4, 8]
full = [2, 4, 8]

[contact]
along = [[0, 0], [1, 0]]

[[body]]
name = "upper"
material = {upper}
rectangle = [[0, 0], [1, 1]]

[[body]]
name = "lower"
material = {lower}
rectangle = [[0, -1], [1, 0]]
"#
    );
    let side = |body: &str, name: &str, ends: [[i32; 2]; 2], condition: &str| {
        format!("\n[[boundary]]\nbody = \"{body}\"\nname = \"{name}\"\nalong = {ends:?}\ncondition = \"{condition}\"\n")
    };
    head + &side("upper", "top", [[0, 1], [1, 1]], "traction")
        + &side("upper", "left", [[0, 0], [0, 1]], "sliding")
        + &side("upper", "right", [[1, 0], [1, 1]], "sliding")
        + &side("lower", "bottom", [[0, -1], [1, -1]], "fixed")
        + &side("lower", "left", [[0, -1], [0, 0]], "sliding")
        + &side("lower", "right", [[1, -1], [1, 0]], "sliding")
}

/// `C_22` in plane strain of an orthotropic law, from its compliance with the third direction eliminated.
fn orthotropic_modulus([e1, e2, e3]: [f64; 3], [n12, n13, n23]: [f64; 3]) -> f64 {
    let s11 = 1.0 / e1 - n13 * n13 / (e1 * e1) * e3;
    let s22 = 1.0 / e2 - n23 * n23 / (e2 * e2) * e3;
    let s12 = -n12 / e1 - n13 / e1 * (n23 / e2) * e3;
    s11 / (s11 * s22 - s12 * s12)
}

#[test]
fn every_kind_of_material_passes_its_patch_test() {
    let orthotropic =
        "{ orthotropic = { moduli = [2.0, 1.0, 1.5], ratios = [0.2, 0.1, 0.15], shear = 0.7 }, plane = \"strain\" }";
    let matrix = "{ matrix = [[3.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 0.9]] }";
    let strain = "{ young = 2.6, poisson = 0.3, plane = \"strain\" }";
    let stress = "{ young = 2.6, poisson = 0.3, plane = \"stress\" }";
    let lame = "{ lame = [1.5, 1.0] }";
    // C_22 = λ + 2μ in plane strain, E/(1 − ν²) in plane stress.
    let modulus = [
        (orthotropic, orthotropic_modulus([2.0, 1.0, 1.5], [0.2, 0.1, 0.15])),
        (matrix, 2.0),
        (strain, 3.5),
        (stress, 2.6 / (1.0 - 0.09)),
        (lame, 3.5),
    ];
    for (i, (upper, c_upper)) in modulus.iter().enumerate() {
        let (lower, c_lower) = modulus[(i + 1) % modulus.len()];
        let folder = Folder::with_study(&format!("material-{i}"), &uniaxial(upper, lower, 0.1 * c_lower / c_upper));
        let ended = folder.signorini("run uniaxial --quiet");
        assert_eq!(ended.status, 0, "{upper} on {lower}: {ended:?}");
        let record: StudyRecord = folder.record("reports/uniaxial");
        assert_eq!(record.verdict.outcome, Outcome::Pass);
        assert!(record.levels.iter().all(|l| l.errors.energy.is_some_and(|e| e < 1e-13)));
        // A stress that is not the same in both bodies is refused before anything is solved.
        folder.add(&uniaxial(upper, lower, 0.11 * c_lower / c_upper));
        let refused = folder.signorini("run uniaxial --quiet");
        assert!(refused.status == 2 && refused.err.contains("T'_n − T''_n"), "{refused:?}");
    }
}
