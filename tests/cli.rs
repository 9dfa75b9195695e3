//! What may be typed, what comes out and with which exit status.

mod common;

use common::{Folder, LOADED, SMOOTH, edit, names, same_tree, tree};
use serde_json::Value;
use signorini_study::claim::catalogue::{Standing, catalogue};
use std::process::Stdio;

/// The smooth study held against a rate that it cannot reach.
fn too_demanding() -> String {
    edit(SMOOTH, "rate = 1\n", "rate = \"none\"\npaper = 1.5\n")
}

/// The smooth study on two families.
fn two_cases() -> String {
    let cases =
        "\n[[case]]\nname = \"structured\"\n\n[[case]]\nname = \"union-jack\"\nfamily = { name = \"union-jack\" }\n";
    edit(SMOOTH, "id = \"smooth\"", "id = \"pair\"") + cases
}

#[test]
fn the_exit_status_tells_pass_fail_and_doubt() {
    let folder = Folder::with_study("status", SMOOTH);
    let passed = folder.signorini("run smooth").expect(0);
    assert!(passed.out.contains("1 case: 1 pass, 0 fail, 0 inconclusive"), "{}", passed.out);
    // `run` is the default command, and no name means every study.
    assert_eq!(folder.signorini("").expect(0).out, passed.out);

    folder.add(&too_demanding());
    let failed = folder.signorini("run smooth").expect(1);
    assert!(failed.out.contains("too slow") && failed.out.contains("1.500"), "{}", failed.out);

    folder.add(SMOOTH);
    let doubtful = folder.signorini("run smooth --levels 3").expect(2);
    assert!(doubtful.out.contains("3 usable levels, 4 are needed"), "{}", doubtful.out);
    assert_eq!(folder.record("reports/smooth").profile, "custom");
}

#[test]
fn a_failure_outweighs_doubt_and_doubt_a_pass() {
    let folder = Folder::with_study("worst", SMOOTH);
    folder.add(&edit(SMOOTH, "id = \"smooth\"", "id = \"short\"").replace("[8, 16, 32, 64]", "[8, 16, 32]"));
    folder.signorini("run").expect(2);
    folder.add(&edit(&too_demanding(), "id = \"smooth\"", "id = \"slow\""));
    let all = folder.signorini("run").expect(1);
    assert!(all.out.contains("3 cases: 1 pass, 1 fail, 1 inconclusive"), "{}", all.out);
}

#[test]
fn what_cannot_be_understood_ends_with_status_2_and_a_suggestion() {
    let folder = Folder::new("typos");
    folder.signorini("run two-squars").complains(2, &["no study `two-squars`", "did you mean `two-squares`?", "hint:"]);
    // Without a command the word is taken for a study; it may have been meant for a command.
    folder.signorini("chekc").complains(2, &["no study `chekc`", "did you mean `signorini check`?", "signorini list"]);
    folder.signorini("rnu two-squares").complains(2, &["did you mean `signorini run`?"]);
    folder.signorini("run --levels 0").complains(2, &["--levels"]);
    folder.signorini("run --solver guess").complains(2, &["condensed", "interior-point"]);
    folder.signorini("run no/such.toml").complains(2, &["no/such.toml", "cannot read the study"]);
    folder.signorini("run hards").complains(2, &["did you mean `hard`?"]);
}

#[test]
fn a_reader_who_leaves_early_changes_neither_the_status_nor_the_results() {
    let folder = Folder::with_study("pipe", SMOOTH);
    folder.add(&too_demanding());
    for (arguments, status) in [("list", 0), ("check smooth", 0), ("run smooth", 1), ("no-such-study", 2)] {
        let mut command = folder.command(arguments);
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts");
        drop((child.stdout.take(), child.stderr.take()));
        assert_eq!(child.wait().expect("a child").code(), Some(status), "{arguments}");
    }
    assert!(folder.path("reports/summary.md").exists());
}

#[test]
fn the_version_names_the_commit() {
    let said = Folder::new("version").signorini("--version").expect(0).out;
    let commit = said.trim().strip_prefix(concat!("signorini ", env!("CARGO_PKG_VERSION"), " (")).expect("the version");
    let commit = commit.strip_suffix(')').expect("a closing parenthesis");
    let hash = commit.len() == 12 && commit.chars().all(|c| c.is_ascii_hexdigit());
    assert!(hash || commit == "unknown commit", "{said}");
}

#[test]
fn the_list_shows_every_claim_and_every_study() {
    let folder = Folder::new("list");
    let shipped = folder.signorini("list").expect(0).out;
    assert!(shipped.starts_with("studies shipped with the program"), "{shipped}");
    let claims: Vec<&str> = shipped.split("claims:").nth(1).expect("a list of claims").lines().collect();
    for entry in catalogue() {
        let at = claims.iter().position(|l| l.split_whitespace().next() == Some(entry.id)).expect(entry.id);
        let (row, judged) = (claims[at], claims[at + 1]);
        assert!(row.ends_with(entry.statement), "{row}");
        match entry.standing {
            Standing::Landed => assert!(judged.contains("judged by"), "{row}: {judged}"),
            Standing::Nothing(why) => assert!(judged.ends_with(why), "{row}: {judged}"),
        }
    }
    assert!(shipped.contains("  theorem-3-1-smooth ") && shipped.contains("[controls]"), "{shipped}");

    folder.add(SMOOTH);
    let own = folder.signorini("list").expect(0).out;
    assert!(own.starts_with("studies in ") && own.contains("  smooth "), "{own}");
    assert!(!own.contains("theorem-3-1-smooth"), "{own}");
}

#[test]
fn check_does_everything_but_the_solve() {
    let folder = Folder::with_study("check", SMOOTH);
    let said = folder.signorini("check smooth").expect(0).out;
    for part in ["n = 8 ", "n = 64 ", "288 dofs", "16640 dofs", "9 pairs", "nested", "45.0°", "needs: "] {
        assert!(said.contains(part), "no {part:?} in\n{said}");
    }
    assert_eq!(names(&folder.0), ["studies/smooth.toml"], "nothing is written");
    folder.add(&edit(LOADED, "-0.1*(1 - 1.75*x)", "0.1"));
    folder.signorini("check loaded").complains(2, &["loaded.toml", "translation of Ω' along (0, 1)"]);
}

const OF_A_CASE: [&str; 19] = [
    "deformed.png",
    "deformed.svg",
    "fields/level-1-zone.vtu",
    "fields/level-1.json",
    "fields/level-1.vtu",
    "ledger.png",
    "ledger.svg",
    "mesh.png",
    "mesh.svg",
    "pressure.png",
    "pressure.svg",
    "rates.png",
    "rates.svg",
    "record.json",
    "report.md",
    "table.csv",
    "table.json",
    "table.tex",
    "timings.json",
];

#[test]
fn one_case_has_no_folder_of_its_own_and_several_have() {
    let folder = Folder::with_study("layout", SMOOTH);
    folder.add(&two_cases());
    folder.signorini("run --out deep/er").expect(0);
    let mut expected: Vec<String> = OF_A_CASE.iter().map(|f| format!("smooth/{f}")).collect();
    for case in ["structured", "union-jack"] {
        let files = OF_A_CASE.iter().filter(|f| **f != "timings.json");
        expected.extend(files.map(|f| format!("pair/{case}/{f}")));
    }
    expected.extend(
        ["pair/timings.json", "index.html", "statements.md", "summary.json", "summary.md", "summary.tex"]
            .map(String::from),
    );
    expected.sort();
    assert_eq!(names(&folder.path("deep/er")), expected);
    assert!(!folder.path("reports").exists() && !folder.path("deep/er/.partial").exists());

    let summary: Value = serde_json::from_str(&folder.text("deep/er/summary.json")).expect("JSON");
    let cases: Vec<_> = summary.as_array().expect("rows").iter().map(|row| row["case"].clone()).collect();
    assert_eq!(cases, ["structured", "union-jack", "smooth"], "by study, then in the order of the file");
    let page = folder.text("deep/er/summary.md");
    assert!(page.contains("(pair/union-jack/report.md)") && page.contains("(smooth/report.md)"), "{page}");
    let timings: Value = serde_json::from_str(&folder.text("deep/er/pair/timings.json")).expect("JSON");
    assert_eq!(timings["cases"][1]["levels"].as_array().map(Vec::len), Some(4));
    assert!(timings["cases"][1]["levels"][0]["solve"].is_f64());
}

#[test]
fn report_renders_the_same_bytes_again_from_the_records_alone() {
    let folder = Folder::with_study("report", SMOOTH);
    folder.add(&two_cases());
    let run = folder.signorini("run --quiet").expect(0);
    let written = tree(&folder.path("reports"), "");
    let is_source =
        |path: &str| path.contains("/fields/") || ["record.json", "timings.json"].iter().any(|f| path.ends_with(f));
    for (path, _) in written.iter().filter(|(path, _)| !is_source(path)) {
        folder.write(&format!("reports/{path}"), "spoilt");
    }
    assert_eq!(folder.signorini("report").expect(0).out, run.out);
    same_tree(&tree(&folder.path("reports"), ""), &written);

    // The pages say what the records say: a changed verdict changes the exit status.
    let record = folder.text("reports/smooth/record.json");
    folder.write("reports/smooth/record.json", &edit(&record, "\"outcome\": \"pass\"", "\"outcome\": \"fail\""));
    folder.signorini("report reports").expect(1);
    folder.write("reports/smooth/record.json", "{ \"schema\": 99 }");
    folder.signorini("report reports").complains(2, &["smooth/record.json", "schema 99", "hint:"]);
}

#[test]
fn a_report_of_nothing_is_an_error() {
    let folder = Folder::new("nothing");
    folder.write("empty/unrelated.txt", "");
    folder.signorini("report empty").complains(2, &["empty holds no record", "hint: run some studies first"]);
    folder.signorini("report nowhere").complains(2, &["nowhere"]);
}

#[test]
fn the_solver_can_be_chosen_and_silence_be_asked_for() {
    let folder = Folder::with_study("solver", SMOOTH);
    let run = folder.signorini("run smooth --solver interior-point --quiet --out ip").expect(0);
    assert_eq!(run.err, "");
    assert!(!run.out.contains("tables and plots") && run.out.contains("1 case: 1 pass"), "{}", run.out);
    folder.signorini("run smooth").expect(0);
    for (out, name) in [("ip", "interior-point"), ("reports", "condensed")] {
        let levels = folder.record(&format!("{out}/smooth")).levels;
        assert!(levels.iter().all(|l| l.solver.name == name && l.solver.solved), "{out}");
    }
}

/// Every documented key, as paths into a record; `[]` stands for every entry of a list.
const KEYS: &str = "
    schema study case parameters claim kind family profile seed
    levels[].level levels[].h levels[].min_angle levels[].side_ratio levels[].nested levels[].dofs
    levels[].contact_pairs levels[].constraints levels[].switch_sides levels[].energy levels[].two_way levels[].mesh_hash
    levels[].errors.strain levels[].errors.energy levels[].errors.h1 levels[].errors.l2 levels[].errors.pressure_l2
    levels[].errors.penetration_l2 levels[].errors.contact_set levels[].errors.switch_position
    levels[].ledger.lhs levels[].ledger.a levels[].ledger.b levels[].ledger.c levels[].ledger.holds
    levels[].kkt.stationarity levels[].kkt.penetration levels[].kkt.tension levels[].kkt.complementarity
    levels[].kkt.weakly_active
    levels[].budget.algebraic levels[].budget.quadrature levels[].budget.geometry levels[].budget.reference
    levels[].solver.name levels[].solver.status levels[].solver.iterations levels[].solver.factorizations
    rates.strain.slope rates.strain.stderr rates.strain.low rates.strain.high rates.strain.levels
    rates.energy.slope rates.h1.slope rates.l2.slope
    bounds.paper bounds.today bounds.expected verdict.outcome verdict.reasons";

/// The values at a path; a missing key is an error with the path so far.
fn at<'a>(value: &'a Value, path: &str) -> Vec<&'a Value> {
    path.split('.').fold(vec![value], |values, key| {
        let (name, each) = (key.trim_end_matches("[]"), key.ends_with("[]"));
        let step = |v: &'a Value| v.get(name).unwrap_or_else(|| panic!("no {name} for {path}"));
        let found = values.into_iter().map(step);
        if each { found.flat_map(|v| v.as_array().expect("a list")).collect() } else { found.collect() }
    })
}

#[test]
fn a_record_holds_every_documented_key() {
    let folder = Folder::with_study("keys", SMOOTH);
    folder.add(LOADED);
    folder.signorini("run").expect(0);
    for study in ["smooth", "loaded"] {
        let record: Value = serde_json::from_str(&folder.text(&format!("reports/{study}/record.json"))).expect("JSON");
        for path in KEYS.split_whitespace() {
            let values = at(&record, path);
            assert_eq!(values.len(), if path.contains("[]") { 4 } else { 1 }, "{study}: {path}");
            // Only bounds may be unknown where everything was measured.
            assert!(path.starts_with("bounds.") || values.iter().all(|v| !v.is_null()), "{study}: {path} is null");
        }
        let words = ["pass", "rate", "structured", "quick"];
        let told = ["verdict.outcome", "kind", "family", "profile"].map(|p| at(&record, p)[0].clone());
        assert!(study == "loaded" || told == words, "{told:?}");
    }
    let smooth: Value = serde_json::from_str(&folder.text("reports/smooth/record.json")).expect("JSON");
    assert_eq!(smooth["parameters"], serde_json::json!({ "k": 3.0, "m": 2.0 }));
    let hashes = at(&smooth, "levels[].mesh_hash");
    assert!(hashes.iter().all(|h| h.as_str().is_some_and(|h| h.len() == 16)), "{hashes:?}");
}

#[test]
fn a_table_has_a_row_for_each_level_and_pictures_are_pictures() {
    let folder = Folder::with_study("tables", SMOOTH);
    folder.signorini("run").expect(0);
    let table = folder.text("reports/smooth/table.csv");
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows.len(), 1 + 4, "{table}");
    let dofs = rows[0].split(',').position(|c| c == "dofs").expect("a column of dofs");
    let column: Vec<&str> = rows[1..].iter().map(|r| r.split(',').nth(dofs).expect("a cell")).collect();
    assert_eq!(column, ["288", "1088", "4224", "16640"]);
    for picture in ["rates", "ledger", "mesh", "deformed"] {
        let png = std::fs::read(folder.path(&format!("reports/smooth/{picture}.png"))).expect("a picture");
        assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
        assert!(folder.text(&format!("reports/smooth/{picture}.svg")).starts_with("<svg"));
    }
}
