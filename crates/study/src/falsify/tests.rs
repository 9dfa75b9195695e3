//! Small searches: every draw is a study, the same for any number of threads, resumed, reproduced; bent hypotheses are found out.

use super::draw::{Mesh, Place, Solution, simpler};
use super::measure::measure;
use super::shrink::shrink;
use super::*;
use crate::exact::verify;
use crate::store::scratch::Scratch;
use crate::study::Study;
use std::path::Path;

fn study_of(draw: &Draw) -> Study {
    let text = draw.text("draw", &["a remark".into()]);
    Study::parse(&text, Path::new("draw.toml")).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// Whatever is drawn is a study whose exact solution meets the contact conditions.
#[test]
fn every_draw_is_a_sound_study() {
    for target in Target::CLAIMS.into_iter().chain([Target::Bent]) {
        for index in 0..24 {
            let drawn = draw(target, 7, index);
            assert_eq!(drawn, draw(target, 7, index));
            let study = study_of(&drawn);
            let scene = study.cases[0].scene().unwrap();
            let Some(exact) = &scene.exact else { continue };
            verify::verify(exact.solution.as_ref(), &exact.materials, &scene.contact)
                .unwrap_or_else(|e| panic!("{target:?} {index}: {e}\n{}", drawn.text("draw", &[])));
        }
        assert_ne!(draw(target, 7, 0), draw(target, 8, 0));
    }
}

#[test]
fn simpler_scenes_are_sound_studies_too() {
    for target in [Target::Theorem31, Target::Theorem33, Target::Theorem34, Target::Lemma21] {
        for simple in (0..4).flat_map(|index| simpler(&draw(target, 3, index))) {
            let study = study_of(&simple);
            let scene = study.cases[0].scene().unwrap();
            if let Some(exact) = &scene.exact {
                let verified = verify::verify(exact.solution.as_ref(), &exact.materials, &scene.contact);
                assert!(verified.is_ok(), "{verified:?}\n{}", simple.text("draw", &[]));
            }
            if let Solution::Traces(t) = &simple.solution {
                assert_eq!(t.pieces.len(), t.switches.len() + 1);
            }
        }
    }
}

/// `u = (0, −y/4)` in both bodies of height 1: `‖u‖²_2 = 2 (1/48 + 1/16)`; `p = (λ + 2μ)(−1/4)`, and nothing moves on the zone.
#[test]
fn sizes_of_a_linear_solution_by_hand() {
    let drawn = draw(Target::ManySwitches, 1, 0);
    let plain = Draw {
        laws: [draw::Law { young: 2.6, poisson: 0.3 }; 2],
        place: Place::Line { width: 1.0, heights: [1.0, 1.0], split: None },
        mesh: Mesh::Structured,
        ..drawn
    };
    let text = plain.text("draw", &[]);
    let traces = text.find("\n[exact.traces]").unwrap();
    let after = traces + text[traces..].find("\n[family]").unwrap();
    let exact = "\n[exact]\nfirst = [\"0\", \"-y/4\"]\nsecond = [\"0\", \"-y/4\"]\n";
    let study = Study::parse(&(text[..traces].to_owned() + exact + &text[after..]), Path::new("draw.toml")).unwrap();
    let scene = study.cases[0].scene().unwrap();
    let found = size(scene, scene.exact.as_ref().unwrap(), &study.cases[0]).unwrap();
    assert!((found.h2_squared - 2.0 * (1.0 / 48.0 + 1.0 / 16.0)).abs() < 1e-12, "{found:?}");
    // λ = 1.5, μ = 1
    assert!((found.stress_max - 3.5 / 4.0).abs() < 1e-12 && (found.stress_l2 - 3.5 / 4.0).abs() < 1e-12);
    assert!(found.slopes < 1e-9 && found.curvatures < 1e-12 && found.jump_slope < 1e-9 && found.unit == 1.0);
}

/// The sup norms of traces against their closed forms: two programs for one number.
#[test]
fn sizes_of_traces_agree_with_closed_forms() {
    for index in 0..4 {
        let drawn = draw(Target::ManySwitches, 11, index);
        let (Solution::Traces(traces), Place::Line { width, .. }) = (&drawn.solution, &drawn.place) else {
            panic!("{drawn:?}")
        };
        let [stress, slope] = traces.bounds(drawn.unit(), *width);
        let study = study_of(&drawn);
        let scene = study.cases[0].scene().unwrap();
        let found = size(scene, scene.exact.as_ref().unwrap(), &study.cases[0]).unwrap();
        // amplitudes are printed with three digits, maxima are sampled
        let close = |a: f64, b: f64| (a - b).abs() < 0.01 * b;
        assert!(close(found.stress_max * found.unit, stress), "{} {stress}", found.stress_max * found.unit);
        assert!(slope == 0.0 || close(found.jump_slope, slope), "{} {slope}", found.jump_slope);
        assert_eq!(found.switches, traces.switches.len());
    }
}

#[test]
fn bent_hypotheses_are_found_out_and_shrunk() {
    let drawn = Draw { levels: vec![2, 4, 8, 16], ..draw(Target::Bent, 1, 0) };
    let (tried, found) = measure(0, &drawn);
    assert!(found.is_candidate() && found.sound && found.finer > 0, "{found:?}");
    assert!(found.rate.unwrap() < 0.9 && found.constant.is_some());
    let simple = shrink(Aim::Rate, &drawn, &found);
    assert!(simple.steps > 0 && simple.measured.is_candidate(), "{simple:?}");
    assert!(simple.measured.rate.unwrap() <= found.rate.unwrap() + RATE_KEPT);
    assert_eq!(tried.levels.len(), 4 + found.finer);
    // the twin: the same scene within the hypotheses is no candidate
    let within = Draw { solution: Solution::BuiltIn("R", vec![("alpha", 1.6)]), ..drawn };
    assert!(!measure(0, &within).1.is_candidate());
}

fn found_with(threads: usize, budget: usize, state: Option<&Path>) -> Found {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let plan = Plan { budget, seed: 5, state, version: "test" };
    pool.install(|| search(Target::Lemma21, &plan, &|| {})).unwrap()
}

#[test]
fn a_search_resumes_and_does_not_depend_on_threads() {
    let (one, two) = (Scratch::new("falsify-one"), Scratch::new("falsify-two"));
    let whole = found_with(1, 4, Some(&one.0));
    let file = |s: &Scratch| std::fs::read_to_string(s.0.join("draws.jsonl")).unwrap();
    found_with(2, 2, Some(&two.0));
    // as if it had been killed in the middle of a line
    let cut = file(&two);
    std::fs::write(two.0.join("draws.jsonl"), &cut[..cut.len() - 20]).unwrap();
    assert_eq!(found_with(3, 4, Some(&two.0)), whole);
    assert_eq!(file(&one), file(&two));
    assert_eq!(found_with(2, 4, None), whole);
    // what was found by another search is not used: a marked result is gone
    let marked = file(&one).replace("\"test\"", "\"other\"").replacen("loads", "marked", 1);
    std::fs::write(one.0.join("draws.jsonl"), marked).unwrap();
    assert_eq!(found_with(1, 4, Some(&one.0)), whole);
    // the twin: a result of the same search is
    let marked = file(&one).replacen("loads", "marked", 1);
    std::fs::write(one.0.join("draws.jsonl"), marked).unwrap();
    assert!(found_with(1, 4, Some(&one.0)).draws[0].scene.starts_with("marked"));
}

#[test]
fn the_saved_study_reproduces_its_figure() {
    let scratch = Scratch::new("falsify-saved");
    let found = found_with(1, 3, None);
    let summary = Summary::write(&scratch.0, std::slice::from_ref(&found)).unwrap();
    let row = &summary.rows[0];
    assert!(row.draws == 3 && row.judged == 3 && row.candidates.is_empty() && !summary.has_candidates(), "{row:?}");
    let saved = row.worst_constant.as_ref().unwrap();
    assert!(saved.saved_figure <= row.constant_bound.unwrap());
    let study = Study::load(&scratch.0.join(&saved.file)).unwrap();
    assert_eq!(study.id, "worst-constant");
    let again = &found.worst_constant.as_ref().unwrap().shrunk;
    assert_eq!(measure(again.measured.index, &again.draw).1.constant, Some(saved.saved_figure));
}
