//! The same bytes on every run, for any number of threads, and after an interruption.

mod common;

use common::{Folder, LOADED, SMOOTH, edit, files, names, same_tree, tree};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};

/// Everything but the times.
fn results(folder: &Folder, out: &str) -> Vec<(String, Vec<u8>)> {
    tree(&folder.path(out), "timings.json")
}

/// Random meshes, several cases, an exact and a finer reference.
fn varied() -> [String; 2] {
    let families = "\n[[case]]\nname = \"perturbed\"\nfamily = { name = \"perturbed\", seed = 3, amount = 0.2 }\n\n\
        [[case]]\nname = \"refined\"\nfamily = { name = \"refined\", seed = 3, amount = 0.2 }\n";
    [SMOOTH.to_owned() + families, LOADED.to_owned()]
}

#[test]
fn records_tables_and_pictures_are_the_same_bytes_for_any_number_of_threads() {
    let folder = Folder::new("threads");
    varied().iter().for_each(|study| folder.add(study));
    let runs = ["--threads 1 --out one", "--threads 2 --out two", "--threads 3 --out three", "--threads 2 --out two"];
    let said: Vec<(i32, String)> = runs
        .iter()
        .map(|arguments| folder.signorini(&format!("run --quiet {arguments}")))
        .map(|ended| (ended.status, ended.out))
        .collect();
    assert!(said.iter().all(|s| *s == said[0] && s.0 != 1), "{said:?}");
    let one = results(&folder, "one");
    assert!(one.iter().any(|(path, _)| path == "smooth/refined/rates.png"), "{:?}", names(&folder.path("one")));
    same_tree(&one, &results(&folder, "two"));
    same_tree(&one, &results(&folder, "three"));
}

#[test]
fn another_seed_gives_other_numbers() {
    let folder = Folder::new("seed");
    let [study, _] = varied();
    let errors = |study: &str| {
        folder.add(study);
        folder.signorini("run --levels 2");
        folder.record("reports/smooth/perturbed").levels.into_iter().map(|l| l.mesh_hash).collect::<Vec<_>>()
    };
    assert_ne!(errors(&study), errors(&study.replace("seed = 3", "seed = 4")));
}

#[test]
fn a_record_tells_no_time() {
    let folder = Folder::with_study("time", SMOOTH);
    folder.signorini("run --threads 1 --levels 2");
    let record = folder.text("reports/smooth/record.json");
    for word in ["second", "elapsed", "time", "date", "bytes", "threads", "memory"] {
        assert!(!record.lines().any(|l| l.split("\":").next().is_some_and(|key| key.contains(word))), "{word}");
    }
    assert!(folder.text("reports/smooth/timings.json").contains("peak_bytes"), "the times are elsewhere");
}

/// Many quick levels and a slow one at the end, during which the run is killed.
fn long() -> String {
    edit(SMOOTH, "quick = [8, 16, 32, 64]", "quick = [4, 8, 16, 32, 128]")
}

/// Files of unfinished cases below `reports/.partial`.
fn kept(folder: &Folder) -> Vec<PathBuf> {
    files(&folder.path("reports/.partial"))
}

/// A folder with a run that was killed after its first levels and before its last.
fn interrupted(test: &str) -> Folder {
    // Should the machine pause this test for so long that the run ends first, it is tried again.
    (0..5).find_map(|_| killed_midway(test)).expect("a run that can be interrupted")
}

/// A run of which `level` was just kept.
fn begun(folder: &Folder, level: &str) -> Option<Child> {
    let mut command = folder.command("run --quiet --threads 1");
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the program starts");
    while !kept(folder).iter().any(|p| p.ends_with(level)) {
        if child.try_wait().expect("a child").is_some() {
            return None;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    Some(child)
}

fn killed_midway(test: &str) -> Option<Folder> {
    let folder = Folder::with_study(test, &long());
    let mut child = begun(&folder, "level-3.json")?;
    child.kill().expect("a child");
    child.wait().expect("a child");
    let unfinished = !folder.path("reports/smooth").exists() && !kept(&folder).is_empty();
    unfinished.then_some(folder)
}

/// Changes a number of a kept level, so that whoever uses it can be told.
fn mark(folder: &Folder, name: &str) {
    let level = kept(folder).into_iter().find(|p| p.ends_with(name)).expect("a kept level");
    let text = fs::read_to_string(&level).expect("a kept level");
    fs::write(&level, edit(&text, "\"status\": \"converged", "\"status\": \"marked, converged")).expect("a kept level");
}

fn is_marked(folder: &Folder) -> bool {
    folder.record("reports/smooth").levels[1].solver.status.starts_with("marked")
}

fn finish(folder: &Folder, arguments: &str) {
    let ended = folder.signorini(&format!("run --quiet {arguments}"));
    assert!(ended.status != 1 && ended.err.is_empty(), "{ended:?}");
    let hidden = |path: &String| Path::new(path).components().any(|c| c.as_os_str().to_string_lossy().starts_with('.'));
    let left: Vec<String> = names(&folder.path("reports")).into_iter().filter(hidden).collect();
    assert!(left.is_empty() && !folder.path("reports/.partial").exists(), "{left:?}");
}

#[test]
fn an_interrupted_run_resumes_to_the_same_bytes() {
    let whole = Folder::with_study("whole", &long());
    finish(&whole, "");
    let expected = results(&whole, "reports");

    let resumed = interrupted("resumed");
    // A temporary file of the killed process and a level that was cut short must not matter.
    let first = kept(&resumed).into_iter().find(|p| p.ends_with("level-0.json")).expect("a kept level");
    fs::write(first.with_file_name(".level-4.json.1.tmp"), "{ \"lev").expect("a file");
    fs::write(&first, "{ \"lev").expect("a file");
    finish(&resumed, "");
    same_tree(&expected, &results(&resumed, "reports"));
}

/// Ctrl-C while one of the first levels runs: what it said. `None` if the run was faster.
#[cfg(unix)]
fn stopped(folder: &Folder) -> Option<String> {
    let child = begun(folder, "level-0.json")?;
    let signal = format!("kill -INT {}", child.id());
    std::process::Command::new("sh").args(["-c", &signal]).status().expect("a signal");
    let ended = child.wait_with_output().expect("a child");
    let said = String::from_utf8(ended.stderr).expect("UTF-8");
    (ended.status.code() == Some(130)).then_some(said)
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_finished_levels_and_says_how_to_go_on() {
    let whole = Folder::with_study("unbroken", &long());
    finish(&whole, "");
    let expected = results(&whole, "reports");
    // Should the machine pause this test for so long that the run ends first, it is tried again.
    let (folder, said) = (0..5)
        .find_map(|_| {
            let folder = Folder::with_study("stopped", &long());
            stopped(&folder).map(|said| (folder, said))
        })
        .expect("a run that can be stopped");
    assert!(said.contains("stopping: levels that run come to their end"), "{said}");
    let kept = kept(&folder).len();
    assert!((1..5).contains(&kept) && !folder.path("reports/smooth").exists(), "{kept} levels");
    let levels = if kept == 1 { "1 level".to_owned() } else { format!("{kept} levels") };
    assert!(
        said.contains(&format!("error: interrupted; {levels} of unfinished cases kept in reports/.partial")),
        "{said}"
    );
    assert!(said.contains("hint: the same command goes on from there: signorini run --quiet --threads 1"), "{said}");
    mark(&folder, "level-0.json");
    finish(&folder, "--threads 1");
    let marked = folder.record("reports/smooth").levels[0].solver.status.clone();
    assert!(marked.starts_with("marked"), "the kept level was not used: {marked}");
    // unmarked again, the bytes are those of a run that was never stopped
    let record = folder.text("reports/smooth/record.json").replace("marked, converged", "converged");
    assert!(expected.iter().any(|(path, bytes)| path == "smooth/record.json" && *bytes == record.as_bytes()));
}

#[test]
fn a_kept_level_is_used_once_and_never_for_another_run() {
    let folder = interrupted("kept");
    mark(&folder, "level-1.json");
    finish(&folder, "");
    assert!(is_marked(&folder), "the kept level was not used");
    // A finished run is computed anew.
    finish(&folder, "");
    assert!(!is_marked(&folder));

    // Other settings are another problem: what was kept is discarded.
    let folder = interrupted("stale");
    mark(&folder, "level-1.json");
    finish(&folder, "--levels 4");
    assert!(!is_marked(&folder));
}
