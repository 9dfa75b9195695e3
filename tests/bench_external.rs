//! Other programs in the bench: timed beside our own solvers, and left out with the reason where they fail.

mod common;

use common::{Ended, Folder, relaxation};
use serde_json::Value;

/// The bench on two levels of 297 and 1105 unknowns with the program, twice under one name.
fn bench(folder: &Folder, out: &str) -> Ended {
    let words = format!("bench two-squares --dofs 200..1200 --solvers condensed --repeat 1 --threads 1 --out {out}");
    let mut command = folder.command(&words);
    command.args(["--external", "awk -f solve.awk K.mtx f.mtx upper.mtx", "--external", "awk -f solve.awk f.mtx"]);
    Ended::new(command.output().expect("the program starts"))
}

#[test]
fn another_program_stands_beside_our_own_solvers() {
    let folder = Folder::new("bench-external");
    folder.write("solve.awk", &relaxation(50, 700));
    let ended = bench(&folder, "out");
    ended.expect(2);
    let record: Value = serde_json::from_str(&folder.text("out/bench.json")).expect("JSON");
    let solvers = record["studies"][0]["solvers"].as_array().expect("solvers");
    let names: Vec<&str> = solvers.iter().filter_map(|s| s["solver"].as_str()).collect();
    assert_eq!(names, ["condensed", "solve", "solve-2"]);
    let [own, theirs, without_matrix] = &solvers[..] else { panic!("three solvers") };
    assert_eq!(own["runs"].as_array().map(Vec::len), Some(2));
    // one level solved, with its own times and memory; nothing to compare with
    let run = &theirs["runs"][0];
    assert_eq!((theirs["runs"].as_array().map(Vec::len), &theirs["linear_solver"]), (Some(1), &Value::Null));
    assert_eq!((&run["status"], &run["linear"]), (&"answer of another program".into(), &Value::Null));
    assert!(run["wall"]["solve"]["median"].as_f64() > Some(0.0) && run["peak_bytes"]["median"].as_f64() > Some(1e5));
    assert_eq!(run["wall"]["setup"]["median"].as_f64(), Some(0.0));
    // the other is left out, with the program's own last words
    let reason = theirs["left_out"][0]["reason"].as_str().expect("a reason");
    assert!(reason.contains("solve: it ended with exit status 2") && reason.contains("too large: "), "{reason}");
    let reasons: Vec<_> = without_matrix["left_out"].as_array().expect("left out").iter().collect();
    assert!(
        reasons.len() == 2 && reasons[1]["reason"] == "not tried, since it failed on a coarser mesh",
        "{reasons:?}"
    );
    assert!(folder.text("out/bench.md").contains("- `solve` is left out at "));
    assert!(folder.path("out/.external/solve/two-squares@two-squares").exists(), "what failed stays");
}

#[test]
fn a_program_that_is_not_there_is_refused_before_anything_is_measured() {
    let folder = Folder::new("bench-external-missing");
    let mut command = folder.command("bench two-squares --out out");
    let ended = Ended::new(command.args(["--external", "no-such-solver x"]).output().expect("the program starts"));
    ended.complains(2, &["--external: there is no program `no-such-solver`", "--solvers"]);
    assert!(!folder.path("out").exists(), "nothing was written");
}
