//! Solvers that are other programs, from end to end: a good one is graded like our own, and every other one is found out.

mod common;

use common::{Ended, Folder, LOADED, relaxation};
use signorini_study::record::Outcome;
use std::fs;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// A folder with the loaded study and a program.
fn folder(test: &str, program: &str) -> Folder {
    let study = LOADED.replace("[4, 8, 16, 32]", "[2, 4]").replace("= 128", "= 8");
    let folder = Folder::with_study(test, &study);
    folder.write("solve.awk", program);
    folder
}

/// Runs the study with a command.
fn run(folder: &Folder, out: &str, command: &str) -> Ended {
    let mut run = folder.command(&format!("run loaded --quiet --out {out} --solver-limit 20 --solver"));
    Ended::new(run.arg(command).output().expect("the program starts"))
}

const WITH_AWK: &str = "awk -f solve.awk K.mtx f.mtx upper.mtx";

#[test]
fn a_solver_of_the_quadratic_problem_is_graded_like_our_own() {
    let folder = folder("external", &relaxation(1000, usize::MAX));
    run(&folder, "theirs", WITH_AWK);
    folder.signorini("run loaded --quiet --out ours");
    let (theirs, ours) = (folder.record("theirs/loaded"), folder.record("ours/loaded"));
    assert_eq!(theirs.levels.len(), 2);
    assert_eq!(theirs.verdict.outcome, ours.verdict.outcome, "{:?}", theirs.verdict);
    for (a, b) in theirs.levels.iter().zip(&ours.levels) {
        assert_eq!((a.solver.name.as_str(), a.solver.solved), ("solve", true));
        assert!(a.kkt.stationarity < 1e-12 && a.kkt.penetration < 1e-12, "{:?}", a.kkt);
        let (e, own) = (a.errors.energy.expect("an error"), b.errors.energy.expect("an error"));
        assert!((e / own - 1.0).abs() < 1e-9 && (a.energy - b.energy).abs() < 1e-12 * b.energy.abs(), "{e} {own}");
        assert_eq!(a.active, b.active);
    }
    let timings = folder.text("theirs/loaded/timings.json");
    assert!(timings.contains("\"external\"") && timings.contains("\"processor\""), "{timings}");
    assert!(!folder.path("theirs/.external").exists(), "the exchange is over");
}

#[test]
fn a_solver_that_stops_too_early_is_shown_and_left_out() {
    let folder = folder("external-early", &relaxation(8, usize::MAX));
    run(&folder, "reports", WITH_AWK).expect(2);
    let record = folder.record("reports/loaded");
    assert_eq!(record.verdict.outcome, Outcome::Inconclusive);
    for level in &record.levels {
        assert!(level.budget.algebraic.is_some_and(|share| share > 0.05), "{:?}", level.budget);
        assert!(level.excluded.as_ref().is_some_and(|why| why.contains("algebraic")), "{:?}", level.excluded);
    }
}

#[test]
fn displacements_of_a_wrong_body_are_found_out_by_their_energy() {
    // nothing moves at all: within all bounds, and far from the minimum
    let folder = folder(
        "external-still",
        "NF == 3 && inside { print ++i \",0,0\" > \"displacement.csv\" }\n/Nodes/ { inside = !inside }",
    );
    run(&folder, "reports", "awk -f solve.awk mesh.msh").expect(2);
    let record = folder.record("reports/loaded");
    assert!(
        record.levels.iter().all(|l| l.kkt.stationarity > 1e-3 && l.excluded.is_some()),
        "{:?}",
        record.levels[0].kkt
    );
}

/// The complaint about an answer that is none, which leaves its files where they can be looked at.
fn refused(test: &str, program: &str, words: &[&str]) {
    let folder = folder(test, program);
    let ended = run(&folder, "reports", "awk -f solve.awk K.mtx f.mtx").complains(2, words);
    assert!(ended.err.starts_with("error: ") && ended.err.contains("its files are in"), "{}", ended.err);
    assert!(folder.path("reports/.external/loaded@loaded/level-0/K.mtx").exists());
}

#[test]
fn answers_that_are_none_are_refused_by_name() {
    let print = |text: &str, file: &str| format!("END {{ printf \"{text}\" > \"{file}\" }}");
    refused("external-none", "END { }", &["solve: it ended well but left no answer", "displacement.csv", "x.mtx"]);
    refused("external-nan", &print("1,nan,0\\n", "displacement.csv"), &["displacement.csv: node 1 moves by (NaN, 0)"]);
    refused("external-part", &print("1,0,0\\n", "displacement.csv"), &["it is partial: 17 of 18 nodes are missing"]);
    refused(
        "external-size",
        &print("%%%%MatrixMarket matrix array real general\\n2 1\\n0\\n0\\n", "x.mtx"),
        &["x.mtx: its size"],
    );
    refused(
        "external-held",
        "END { for (i = 1; i <= 18; i++) print i \",1,1\" > \"displacement.csv\" }",
        &["displacement.csv: node", "moves by (1e0, 1e0), but its support"],
    );
    let both = "END { print 1 > \"x.mtx\"; print 1 > \"displacement.csv\" }";
    refused("external-both", both, &["it left both displacement.csv and x.mtx"]);
    let endless = "END { for (i = 0; i < 20000; i++) print \"1,0,0\" > \"displacement.csv\" }";
    refused("external-long", endless, &["displacement.csv: it has 120000 bytes; 18 rows need no more than"]);
    let fails = "BEGIN { print \"the matrix is singular\" | \"cat 1>&2\"; close(\"cat 1>&2\"); exit 7 }";
    refused("external-fails", fails, &["solve: it ended with exit status 7; it said", "| the matrix is singular"]);
}

#[test]
fn the_answer_of_an_earlier_run_is_not_taken_again() {
    let folder = folder("external-stale", &relaxation(1000, usize::MAX));
    let again = |out: &str| {
        let mut run = folder.command(&format!("run loaded --quiet --keep-exchange --out {out} --solver"));
        Ended::new(run.arg(WITH_AWK).output().expect("the program starts"))
    };
    again("reports");
    assert!(folder.path("reports/.external/loaded@loaded/level-1/x.mtx").exists());
    folder.write("solve.awk", "END { }");
    again("reports").complains(2, &["it ended well but left no answer"]);
}

/// Whether something comes true within ten seconds or so.
#[cfg(unix)]
fn patiently(mut is_so: impl FnMut() -> bool) -> bool {
    let mut later = || {
        sleep(Duration::from_millis(10));
        is_so()
    };
    (0..1000).any(|_| later())
}

#[cfg(unix)]
#[test]
fn who_quits_takes_the_programs_along() {
    let folder = folder("external-quit", "");
    let mut run = folder.command("run loaded --quiet --levels 1 --solver");
    let mut run = run.arg("sh -c 'echo $$ > pid; sleep 60 & wait'").spawn().expect("the program starts");
    let pid = folder.path("reports/.external/loaded@loaded/level-0/pid");
    assert!(patiently(|| fs::read_to_string(&pid).is_ok_and(|text| text.ends_with('\n'))), "the solver never began");
    let solver = folder.text("reports/.external/loaded@loaded/level-0/pid").trim().to_owned();
    let kill =
        |words: &[&str]| Command::new("kill").args(words).stderr(Stdio::null()).status().expect("kill").success();
    let is_there = || kill(&["-0", "--", &format!("-{solver}")]);
    assert!(is_there());
    // once asks, twice quits
    let program = run.id().to_string();
    assert!(
        patiently(|| {
            kill(&["-INT", &program]);
            run.try_wait().is_ok_and(|ended| ended.is_some())
        }),
        "it goes on"
    );
    assert!(patiently(|| !is_there()), "its solver goes on");
}

#[test]
fn an_endless_solver_is_stopped() {
    let folder = folder("external-endless", "BEGIN { while (1) { } }");
    let mut run = folder.command("run loaded --levels 1 --solver-limit 0.3 --solver");
    let ended = Ended::new(run.arg("awk -f solve.awk").output().expect("the program starts"));
    ended.complains(2, &["it took longer than 0.3 s and was stopped; --solver-limit gives it more"]);
}

#[test]
fn commands_that_cannot_run_are_refused_before_anything_else() {
    let folder = folder("external-words", "");
    run(&folder, "reports", "multgrid").complains(2, &["there is no program `multgrid`", "did you mean multigrid?"]);
    run(&folder, "reports", "awk 'open").complains(2, &["open quotation"]);
    run(&folder, "reports", "").complains(2, &["the command is empty"]);
    let mut bless = folder.command("bless loaded --solver");
    let ended = Ended::new(bless.arg("awk -f solve.awk").output().expect("the program starts"));
    ended.complains(2, &["a baseline is what this program computes"]);
    assert!(fs::read_dir(folder.path("reports")).is_err(), "nothing was written");
}
