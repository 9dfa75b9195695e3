//! Random input: scenes are solved and certified or refused with a reason, texts are read or refused; nothing panics.
//!
//! `SIGNORINI_FUZZ_CASES` says how many cases each test tries (default: what takes a few seconds), `SIGNORINI_FUZZ_SEED` which (default
//! 1). A failing case prints its number and its text; `SIGNORINI_FUZZ_FIRST` starts from that number.

#[path = "fuzz/expressions.rs"]
mod expressions;
#[path = "fuzz/mangle.rs"]
mod mangle;
#[path = "fuzz/random.rs"]
mod random;
#[path = "fuzz/scene.rs"]
mod scene;

use random::{Random, cases};
use signorini_study::error::RunError;
use signorini_study::expr::Expression;
use signorini_study::family::Family;
use signorini_study::record::{Outcome, StudyRecord};
use signorini_study::run::{Profile, RunSettings, Unwatched, check_case, run_case};
use signorini_study::study::{Case, Study};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// Runs `one` and names the input if it panics.
fn survives<T>(number: u64, input: &str, one: impl FnOnce() -> T) -> T {
    catch_unwind(AssertUnwindSafe(one)).unwrap_or_else(|_| panic!("case {number} panics on\n{input}"))
}

/// How many of the random scenes ended in which way.
#[derive(Debug, Default)]
struct Ends {
    solved: usize,
    refused: usize,
}

#[test]
fn random_scenes_are_certified_or_refused() {
    let mut ends = Ends::default();
    let mut unsound = Vec::new();
    for number in cases(1200) {
        let scene = scene::random(&mut Random::new(number));
        match survives(number, &scene.text, || run(&scene.text)) {
            Ok(record) => {
                unsound.extend(fault(&scene, &record).map(|why| format!("case {number}: {why}\n{}", scene.text)));
                ends.solved += 1;
            }
            Err(error) => {
                assert!(
                    matches!(error, RunError::Contact(_)) && !error.to_string().is_empty(),
                    "case {number}: {error}"
                );
                ends.refused += 1;
            }
        }
    }
    assert!(
        unsound.is_empty(),
        "{} unsound answers, among them\n{}",
        unsound.len(),
        unsound[..unsound.len().min(5)].join("\n")
    );
    // the generator makes both sorts, and more of those that have a solution
    assert!(ends.refused > 0 && ends.solved > ends.refused, "{ends:?}");
}

fn run(text: &str) -> Result<StudyRecord, RunError> {
    let study = Study::parse(text, Path::new("random.toml")).unwrap_or_else(|e| panic!("the generator: {e}"));
    let settings =
        RunSettings { profile: Profile::Quick, levels: None, solver: None, partial: None, keep: Default::default() };
    run_case(&study, &study.cases[0], &settings, &Unwatched).map(|run| run.record)
}

/// What is wrong with an answer that ought to be certified, confirmed, without broken numbers, and no worse than the zero displacement
/// where that is admissible.
fn fault(scene: &scene::Scene, record: &StudyRecord) -> Option<String> {
    let above_zero = |energy: f64| scene.zero_is_admissible && energy > 0.0;
    if record.verdict.outcome != Outcome::Pass {
        return Some(format!("{:?}", record.verdict));
    }
    if let Err(error) = record.to_json() {
        return Some(error.to_string());
    }
    let energy = record.levels.iter().map(|l| l.energy).find(|e| above_zero(*e))?;
    Some(format!("L(u_h) = {energy} exceeds L(0) = 0"))
}

#[test]
fn mangled_studies_are_read_or_refused() {
    let originals = mangle::shipped_texts();
    let mut read = 0;
    for number in cases(2500) {
        let random = &mut Random::new(number);
        let (id, original) = &originals[random.below(originals.len())];
        let text = mangle::mangled(original, random);
        let path = format!("{id}.toml");
        let Ok(study) = survives(number, &text, || Study::parse(&text, Path::new(&path))) else { continue };
        read += 1;
        for case in study.cases.iter().filter_map(small) {
            let checked = survives(number, &text, || check_case(&case, Profile::Quick));
            if let Err(error) = checked {
                assert!(!error.to_string().is_empty(), "case {number}: an error without words\n{text}");
            }
        }
    }
    assert!(read > 0, "every mangled study is refused: the mutations are too rough");
}

/// The case on its coarsest possible mesh, if that is small and quickly made.
fn small(case: &Case) -> Option<Case> {
    let scene = case.scene()?;
    let quick =
        !matches!(case.family, Family::Delaunay { .. } | Family::RefinedDelaunay { .. } | Family::Graded { .. });
    let cells: usize = scene.bodies.iter().flat_map(|b| &b.blocks).map(|b| b.divisions[0] * b.divisions[1]).sum();
    // curved scenes with an exact solution are verified pointwise, which takes longest
    (quick && cells <= 500 && scene.exact.is_none()).then(|| Case { quick: vec![1], full: vec![1], ..case.clone() })
}

#[test]
fn random_bytes_are_no_study() {
    for number in cases(2000) {
        let random = &mut Random::new(number);
        let bytes: Vec<u8> = (0..random.below(200)).map(|_| random.below(256) as u8).collect();
        let text = String::from_utf8_lossy(&bytes);
        let refused = survives(number, &text, || Study::parse(&text, Path::new("x.toml")).err());
        assert!(refused.is_some_and(|e| !e.message.is_empty()), "case {number}: read as a study\n{text}");
    }
}

#[test]
fn expressions_have_values_or_are_refused() {
    let parameters = BTreeMap::from([("s".to_string(), 0.25)]);
    let mut parsed = 0;
    for number in cases(20_000) {
        let random = &mut Random::new(number);
        let text = expressions::random(random);
        survives(number, &text, || match Expression::parse(&text, &["x", "y"], &parameters) {
            Ok(expression) => {
                let at = [random.between(-2.0, 2.0), random.between(-2.0, 2.0)];
                let (first, second): (f64, f64) = (expression.eval(&at), expression.eval(&at));
                assert_eq!(first.to_bits(), second.to_bits());
                let _: f64 = expression.derivative(random.below(2)).eval(&at);
                parsed += 1;
            }
            Err(error) => {
                assert!(!error.message.is_empty() && error.column >= 1, "{error:?}");
                assert!(error.column <= text.chars().count() + 1, "{error:?}");
            }
        });
    }
    assert!(parsed > 0, "no expression is one");
}
