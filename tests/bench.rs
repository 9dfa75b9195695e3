//! Speed against error from the outside: files, keys and refusals. No time is judged.

mod common;

use common::Folder;
use serde_json::Value;

const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

fn json(folder: &Folder, path: &str) -> Value {
    serde_json::from_str(&folder.text(path)).expect("JSON")
}

#[test]
fn a_small_measurement_leaves_record_tables_and_pictures() {
    let folder = Folder::new("bench");
    let run = "bench theorem-3-1-smooth two-squares --dofs 200..1300 --repeat 2 --threads 1 --out out";
    let ended = folder.signorini(run).expect(0);
    assert!(ended.out.contains("theorem-3-1-smooth/structured") && ended.out.contains("bench.md"), "{}", ended.out);
    let record = json(&folder, "out/bench.json");
    assert_eq!((&record["schema"], &record["threads"], &record["repeat"]), (&1.into(), &1.into(), &2.into()));
    assert!(record["bandwidth"]["one_thread"]["median"].as_f64() > Some(0.0));
    let studies = record["studies"].as_array().expect("studies");
    for (study, dofs) in studies.iter().zip([[288, 1088], [297, 1105]]) {
        for (size, n) in study["sizes"].as_array().expect("sizes").iter().zip(dofs) {
            assert_eq!(size["dofs"], n);
            assert!(size["product"]["runs"] == 2 && size["matrix_bytes"].as_u64() > Some(36 * n as u64 / 2), "{size}");
        }
        for solver in study["solvers"].as_array().expect("solvers") {
            assert_eq!(solver["runs"].as_array().map(Vec::len), Some(2), "{solver}");
            for run in solver["runs"].as_array().expect("runs") {
                for phase in ["mesh", "assembly", "setup", "solve", "error", "system", "solution", "total"] {
                    assert_eq!(run["wall"][phase]["runs"], 2, "{phase} {run}");
                }
                assert!(run["linear"]["ratio"].as_f64() > Some(0.0) && run["iterations"].as_u64() > Some(0), "{run}");
            }
        }
    }
    // the error is that of a run; two levels are too few to extrapolate energies
    folder.signorini("run theorem-3-1-smooth --levels 2 --quiet");
    let level = &folder.record("reports/theorem-3-1-smooth/structured").levels[1];
    assert_eq!(studies[0]["solvers"][0]["runs"][1]["error"].as_f64(), level.errors.energy);
    assert_eq!((&studies[1]["error"], &studies[1]["solvers"][0]["runs"][1]["error"]), (&"none".into(), &Value::Null));
    // a line for each of two studies, two levels and three solvers
    assert_eq!(folder.text("out/bench.csv").lines().count(), 1 + 2 * 2 * 3);
    assert!(folder.text("out/bench.md").contains("| solver | unknowns | error (%) |"));
    for name in ["work-precision", "scaling", "work-precision-two-squares", "scaling-two-squares"] {
        let bytes = std::fs::read(folder.path(&format!("out/{name}.png"))).expect("a picture");
        assert!(bytes.starts_with(PNG), "{name}");
    }
}

#[test]
fn a_case_and_a_solver_can_be_chosen_and_threads_change_no_answer() {
    let folder = Folder::new("bench-case");
    let errors = [1, 2].map(|threads| {
        let run = "bench theorem-3-1-smooth/refined --levels 1 --dofs ..2000 --repeat 1 --solvers condensed --quiet";
        folder.signorini(&format!("{run} --threads {threads} --out {threads}")).expect(0);
        let study = &json(&folder, &format!("{threads}/bench.json"))["studies"][0];
        assert_eq!((&study["case"], study["sizes"].as_array().map(Vec::len)), (&"refined".into(), Some(1)));
        assert_eq!(study["solvers"].as_array().map(Vec::len), Some(1));
        study["solvers"][0]["runs"][0]["error"].clone()
    });
    assert!(errors[0].as_f64() > Some(0.0) && errors[0] == errors[1], "{errors:?}");
}

#[test]
fn what_cannot_be_measured_is_refused_with_the_way_out() {
    let folder = Folder::new("bench-refused");
    for (arguments, words) in [
        ("theorem-3-1-smoth", vec!["no study `theorem-3-1-smoth`", "theorem-3-1-smooth"]),
        ("theorem-3-1-smooth/rough", vec!["no case `rough`", "use one of: structured"]),
        ("lemma-3-2", vec!["no contact problem to solve"]),
        ("hard", vec!["`hard` is a group", "name studies by their ids"]),
        ("two-squares --dofs 310..320", vec!["no level of 'two-squares' has between 310 and 320 unknowns: it has 297"]),
        ("--dofs 1e5", vec!["--dofs", "two numbers with .. between them"]),
        ("--dofs 1e5..1e3", vec!["--dofs", "swap the two"]),
        ("--max-dofs many", vec!["--max-dofs", "`many` is no whole number from 1 to 2e9"]),
        ("--solvers condensed,magic", vec!["--solvers", "magic", "interior-point"]),
        ("--repeat 0", vec!["--repeat"]),
    ] {
        folder.signorini(&format!("bench {arguments}")).complains(2, &words);
    }
    folder.write("taken", "a file");
    folder.signorini("bench --out taken/inside").complains(2, &["taken/inside", "--out"]);
    folder.signorini("bench-one").complains(2, &["no job", "`bench-one` is for `bench` alone"]);
    folder.signorini("benhc").complains(2, &["did you mean `signorini bench`?"]);
}
