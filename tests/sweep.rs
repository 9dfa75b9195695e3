//! `--set` and `--sweep` from the outside: folders, pages, baselines, the table of a bench, refusals.

mod common;

use common::{Folder, LOADED, SMOOTH, edit, names, same_tree, tree};

/// Small levels: nothing here depends on a verdict.
fn small(study: &str, quick: &str) -> String {
    edit(study, quick, "quick = [4, 8, 16]")
}

const STIFFER: &str = "--set body.upper.material.lame=[3.0,2.0]";

#[test]
fn a_changed_study_has_its_own_folder_page_and_no_baseline() {
    let folder = Folder::with_study("change", &small(SMOOTH, "quick = [8, 16, 32, 64]"));
    folder.signorini("bless smooth");
    folder.signorini("run smooth");
    let plain = tree(&folder.path("reports/smooth"), "timings.json");
    let baseline = folder.text("reference/smooth.json");

    let told = folder.signorini(&format!("run smooth --strict {STIFFER}"));
    assert!(!told.out.contains("drift") && told.out.contains("smooth_lame-3.0-2.0_"), "{}", told.out);
    same_tree(&plain, &tree(&folder.path("reports/smooth"), "timings.json"));
    folder.signorini(&format!("bless smooth {STIFFER}")).complains(2, &["as its file has it", "leave --set"]);
    assert_eq!(folder.text("reference/smooth.json"), baseline);

    let records = names(&folder.path("reports"));
    let changed =
        records.iter().find(|n| n.starts_with("smooth_lame") && n.ends_with("record.json")).expect("a record");
    let changed = changed.strip_suffix("/record.json").expect("a folder");
    let page = folder.text(&format!("reports/{changed}/report.md"));
    for words in [
        "- `body.upper.material.lame` = `[3.0,2.0]`",
        "signorini run smooth --set 'body.upper.material.lame=[3.0,2.0]'",
    ] {
        assert!(page.contains(words), "no {words:?} in\n{page}");
    }
    // the same numbers as of a file with that material, which drifts from the baseline
    let record = folder.record(&format!("reports/{changed}"));
    folder.add(&edit(&small(SMOOTH, "quick = [8, 16, 32, 64]"), "lame = [1.5, 1.0]", "lame = [3.0, 2.0]"));
    assert!(folder.signorini("run smooth").out.contains("drift: smooth/smooth: level 0: energy"));
    let edited = folder.record("reports/smooth");
    assert_eq!((&record.levels, &record.rates, record.study == edited.study), (&edited.levels, &edited.rates, false));
    assert!(!folder.path("reports/.partial").exists());
}

#[test]
fn a_sweep_makes_cases_of_every_combination() {
    let folder = Folder::with_study("sweep", &small(LOADED, "quick = [4, 8, 16, 32]"));
    let sweep =
        "--sweep body.*.material.poisson=0.3,0.45 --sweep family.name=structured,criss-cross --set reference.quick=32";
    let checked = folder.signorini(&format!("check loaded {sweep}")).expect(0);
    assert!(checked.out.contains("poisson-0.45-name-criss-cross: criss-cross family"), "{}", checked.out);
    folder.signorini(&format!("run loaded {sweep} --levels 2 --out out"));
    let records: Vec<String> = names(&folder.path("out")).into_iter().filter(|n| n.ends_with("/record.json")).collect();
    let cases: Vec<&str> = records.iter().filter_map(|n| n.split('/').nth(1)).collect();
    let expected = ["0.3-name-criss-cross", "0.3-name-structured", "0.45-name-criss-cross", "0.45-name-structured"];
    assert_eq!(cases, expected.map(|e| format!("poisson-{e}")));
    let of = |k: usize| folder.record(&format!("out/{}", records[k].strip_suffix("/record.json").expect("a folder")));
    let (soft, stiff) = (of(1), of(3));
    assert_eq!((stiff.parameters["poisson"], stiff.family.as_str()), (0.45, "structured"));
    assert!(soft.levels[1].energy != stiff.levels[1].energy && soft.levels[1].mesh_hash == stiff.levels[1].mesh_hash);
    // the plain study, with the one number in its file
    folder.signorini("run loaded --set reference.quick=32 --levels 2 --out plain");
    let plain = names(&folder.path("plain")).into_iter().find(|n| n.ends_with("record.json")).expect("a record");
    let plain = folder.record(&format!("plain/{}", plain.strip_suffix("/record.json").expect("a folder")));
    assert_eq!(plain.levels, soft.levels);
}

#[test]
fn a_bench_has_swept_values_as_columns() {
    let folder = Folder::new("sweep-bench");
    let run = "bench two-squares --dofs 200..1300 --repeat 1 --threads 1 --solvers multigrid --out out \
        --sweep body.*.material.poisson=0.3,0.49 --sweep body.lower.material.young=1e-4,1";
    let ended = folder.signorini(run).expect(0);
    let csv = folder.text("out/bench.csv");
    let rows: Vec<Vec<&str>> = csv.lines().map(|l| l.split(',').collect()).collect();
    assert_eq!(rows.len(), 1 + 2 * 2 * 2, "{csv}");
    let column = |key: &str| rows[0].iter().position(|k| *k == key).expect("a column");
    let (poisson, young) = (column("body.*.material.poisson"), column("body.lower.material.young"));
    assert_eq!((rows[1][poisson], rows[1][young]), ("0.3", "0.0001"));
    assert_eq!((rows[8][poisson], rows[8][young], rows[8][column("study")]), ("0.49", "1", "two-squares"));
    assert!(rows[8][column("closed")].parse::<f64>().is_ok_and(|c| c > 0.0 && c < 1.0), "{csv}");
    let page = folder.text("out/bench.md");
    for words in
        ["## Sweep of two-squares", "| poisson | young | solver |", "### By poisson", "triangles lock", "sweep.png"]
    {
        assert!(page.contains(words), "no {words:?} in\n{page}");
    }
    assert!(ended.out.contains("work over that at 0.3") && folder.path("out/sweep.png").is_file(), "{}", ended.out);
    // without a ratio near one half nothing locks
    folder.signorini("bench two-squares --levels 1 --repeat 1 --solvers condensed --sweep body.*.material.poisson=0.3,0.4 --out mild").expect(0);
    assert!(!folder.text("mild/bench.md").contains("lock"));
}

#[test]
fn an_option_that_cannot_be_carried_out_is_refused_by_name() {
    let folder = Folder::with_study("sweep-refused", LOADED);
    for (arguments, words) in [
        ("run loaded --set body.uper.force=1", vec!["--set body.uper.force=1", "did you mean `body.upper`?", "hint: "]),
        ("check loaded --sweep body.upper.material.poisson=0.3,0.5", vec!["loaded.toml: with --sweep", "−1 < ν < 1/2"]),
        ("bench loaded --set body.upper.material.posson=1", vec!["unknown field `posson`", "did you mean `poisson`?"]),
        ("run --set levels.quick", vec!["--set levels.quick: no `=`", "--set key=value"]),
        ("bench loaded/none --sweep body.upper.material.poisson=0.3,0.4", vec!["no case `none`"]),
    ] {
        folder.signorini(arguments).complains(2, &words);
    }
    assert!(!folder.path("reports").exists());
}
