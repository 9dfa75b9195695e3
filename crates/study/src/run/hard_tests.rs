//! Second opinions, refusals and initial gaps, end to end on meshes of a few cells.

use super::*;
use crate::record::Outcome;
use std::path::Path;

/// Two blocks of height 1 between sliding walls: uniaxial strain, `M = λ + 2μ = 3.5` in both. The top is pressed by `top`, the
/// bottom clamped.
const COLUMN: &str = r#"id = "column"
title = "t"
question = "q"
setup = "s"
refuted_by = "r"
claim = "certificate"

[levels]
quick = [2, 4]
full = [2, 4]

[reference]
kind = "none"

[solver]
second = "interior-point"

[[body]]
name = "upper"
material = { lame = [1.5, 1.0] }
rectangle = [[0, 0], [1, 1]]

[[body]]
name = "lower"
material = { lame = [1.5, 1.0] }
rectangle = [[0, -1], [1, 0]]

[[boundary]]
body = "upper"
name = "top"
along = [[0, 1], [1, 1]]
condition = "fixed"
value = ["0", "TOP"]

[[boundary]]
body = "upper"
name = "walls-left"
along = [[0, 0], [0, 1]]
condition = "sliding"

[[boundary]]
body = "upper"
name = "walls-right"
along = [[1, 0], [1, 1]]
condition = "sliding"

[[boundary]]
body = "lower"
name = "bottom"
along = [[0, -1], [1, -1]]
condition = "fixed"

[[boundary]]
body = "lower"
name = "left"
along = [[0, -1], [0, 0]]
condition = "sliding"

[[boundary]]
body = "lower"
name = "right"
along = [[1, -1], [1, 0]]
condition = "sliding"

[contact]
along = [[0, 0], [1, 0]]
initial_gap = "GAP"
"#;

fn run_text(text: &str) -> Result<StudyRecord, RunError> {
    let study = Study::parse(text, Path::new("column.toml")).unwrap_or_else(|e| panic!("{e}"));
    let settings =
        RunSettings { profile: Profile::Quick, levels: None, solver: None, partial: None, keep: Default::default() };
    run_case(&study, &study.cases[0], &settings, &Unwatched).map(|run| run.record)
}

fn column(top: &str, gap: &str) -> String {
    COLUMN.replace("TOP", top).replace("GAP", gap)
}

/// Both blocks shorten by half of what the walls leave: `p = M (−top − g)/2`, none where the gap stays open.
#[test]
fn initial_gaps_shorten_two_columns() {
    for (top, gap) in [("0", "-0.01"), ("-0.03", "0.01"), ("-0.03", "-0.02"), ("-0.01", "0.02"), ("0", "0")] {
        let record = run_text(&column(top, gap)).unwrap();
        assert_eq!(record.verdict.outcome, Outcome::Pass, "{top} {gap}: {:?}", record.verdict);
        let closing = -top.parse::<f64>().unwrap() - gap.parse::<f64>().unwrap();
        let pressure = 1.75 * closing.max(0.0);
        let zone = record.zone.unwrap();
        for (p, g) in zone.pressure.iter().zip(&zone.gap) {
            assert!((p - pressure).abs() < 1e-14, "{top} {gap}: {p} {pressure}");
            assert!((g - (-closing).max(0.0)).abs() < 1e-15, "{top} {gap}: {g}");
        }
        for level in &record.levels {
            // L = ½A = p²/M, no loads
            assert!((level.energy - pressure * pressure / 3.5).abs() < 1e-15, "{top} {gap}: {}", level.energy);
            assert_eq!(level.errors.penetration_l2.unwrap().max(1e-15), 1e-15);
        }
    }
}

#[test]
fn between_the_nodes_a_curved_gap_is_penetrated_and_nothing_is_said_of_energies() {
    let pressed = |gap: &str| {
        let record = run_text(&column("-0.05", gap)).unwrap();
        assert_eq!(record.verdict.outcome, Outcome::Pass, "{:?}", record.verdict);
        let level = record.levels[0].clone();
        assert_eq!(level.active, level.constraints);
        (level.inside == Some(true), level.errors.penetration_l2.unwrap())
    };
    assert!(pressed("0.01*x").0);
    // closed throughout, the jump is I_h g: below a concave gap, above a convex one by g'' s(h − s)/2, ‖·‖ = g'' h²/√120
    assert_eq!(pressed("0.04*x*(1 - x)"), (true, 0.0));
    let (falls, penetration) = pressed("-0.04*x*(1 - x)");
    let expected = 0.08 * 0.25 / 120.0_f64.sqrt();
    assert!(!falls && (penetration / expected - 1.0).abs() < 1e-9, "{penetration} {expected}");
}

/// A wall that a node is pushed along the normal of lets the side next to it follow; a node in the middle may not.
#[test]
fn data_that_push_against_a_slide_end_the_chain_of_energies() {
    let inside = |top: &str| {
        let text = column("-0.05", "0").replace("value = [\"0\", \"-0.05\"]", &format!("value = {top}"));
        run_text(&text).unwrap().levels[0].inside
    };
    assert_eq!(inside("[\"0\", \"-0.04\"]"), Some(true));
    assert_eq!(inside("[\"0.01\", \"-0.04\"]"), Some(false));
}

#[test]
fn a_gap_that_is_no_number_is_refused_with_its_place() {
    let error = run_text(&column("0", "1/x")).unwrap_err().to_string();
    assert!(error.contains("initial gap at (0, 0)"), "{error}");
}

/// The upper block without its top: the walls let it rise.
fn loose(load: &str) -> String {
    column("0", "0").replacen(
        "condition = \"fixed\"\nvalue = [\"0\", \"0\"]",
        &format!("condition = \"traction\"\nvalue = [\"0\", \"{load}\"]"),
        1,
    )
}

#[test]
fn a_case_passes_by_being_refused_and_by_nothing_else() {
    let refused = |load: &str| run_text(&loose(load).replacen("claim =", "expect = \"refused\"\nclaim =", 1));
    let record = refused("0.1").unwrap();
    assert_eq!((record.verdict.outcome, record.expect), (Outcome::Pass, None));
    assert!(record.levels.is_empty() && record.rates.is_empty());
    let refusal = record.refusal.as_ref().unwrap();
    assert_eq!((refusal.refused, refusal.levels), (2, 2));
    assert!(refusal.message.as_ref().unwrap().contains("pushes a body away"), "{refusal:?}");
    let read = StudyRecord::from_json(&record.to_json().unwrap()).unwrap();
    assert_eq!(read, record);
    // what can be solved is not refused, and a load that is no number is not refused for want of equilibrium
    let solvable = refused("-0.1").unwrap();
    assert_eq!(solvable.verdict.outcome, Outcome::Fail);
    assert!(solvable.verdict.reasons[0].contains("2 of 2 levels were accepted"), "{:?}", solvable.verdict);
    assert!(matches!(refused("1/0"), Err(RunError::Contact(_))));
    // without the word the same scene is bad input
    assert!(run_text(&loose("0.1")).is_err());
}

/// An interior point that stops early gives another energy than the second solver.
#[test]
fn a_loose_solver_is_contradicted() {
    let sound = column("-0.03 + 0.05*x", "0")
        .replace("second = \"interior-point\"", "second = \"condensed\"\nname = \"interior-point\"");
    let loose =
        sound.replace("name = \"interior-point\"", "name = \"interior-point\"\ntolerance = 1e-2\ncrossover = false");
    assert_eq!(run_text(&sound).unwrap().verdict.outcome, Outcome::Pass);
    let verdict = run_text(&loose).unwrap().verdict;
    assert_eq!(verdict.outcome, Outcome::Fail);
    assert!(verdict.reasons.iter().any(|r| r.contains("the energy of condensed differs")), "{verdict:?}");
}

#[test]
fn the_monotone_method_confirms_too() {
    let text = column("-0.03 + 0.05*x", "0.001*x").replace("second = \"interior-point\"", "second = \"monotone\"");
    let record = run_text(&text).unwrap();
    assert_eq!(record.verdict.outcome, Outcome::Pass, "{:?}", record.verdict);
    assert_eq!(record.levels[1].second.as_ref().unwrap().name, "monotone");
}

/// Every hard study on its coarsest mesh.
#[test]
fn hard_cases_are_solved_or_refused() {
    use crate::file::Group;
    let settings =
        RunSettings { profile: Profile::Quick, levels: Some(1), solver: None, partial: None, keep: Default::default() };
    let studies: Vec<Study> = crate::file::library::shipped().group(Group::Hard).map(|s| s.load().unwrap()).collect();
    let cheap = |study: &&Study| !["hard-million", "hard-gaps"].contains(&study.id.as_str());
    let mut cases = 0;
    for study in studies.iter().filter(cheap) {
        for case in &study.cases {
            let record =
                run_case(study, case, &settings, &Unwatched).unwrap_or_else(|e| panic!("{}: {e}", case.name)).record;
            assert_eq!(record.verdict.outcome, Outcome::Pass, "{} {}: {:?}", study.id, case.name, record.verdict);
            cases += 1;
        }
    }
    assert!(cases > 40, "{cases}");
}
