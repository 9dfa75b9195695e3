//! The table of bad inputs, `tests/bad_input.md`: what each prints, read line by line when it changes.
//!
//! `SIGNORINI_TABLE=write cargo test -p signorini --test bad-input-table` writes it anew.

mod common;

use common::{Ended, Folder, LOADED, edit};
use std::fmt::Write;
use std::path::Path;

const DOVETAIL: &str = include_str!("../studies/dovetail.toml");
const MESH: &str = include_str!("../studies/meshes/dovetail.msh");

/// Words behind `signorini`, split at `|` so that an argument may hold blanks.
const COMMAND_LINE: &[&str] = &[
    "chekc",
    "run|two-squars",
    "run|hards",
    "run|no/such.toml",
    "run|loaded|--juint|x.xml",
    "run|loaded|--levels|0",
    "run|loaded|--levels|many",
    "run|loaded|--profile|medium",
    "run|loaded|--threads|0",
    "run|loaded|--fields|finest",
    "run|loaded|--out|taken",
    "run|loaded|--junit|taken/junit.xml",
    "run|loaded|--annotations|gitlab",
    "check|loded",
    "bless|loaded|--levels|2",
    "bless|loaded|--junit|x.xml",
    "bless|loaded|--set|family.name=criss-cross",
    "report|nowhere",
    "report|taken",
    "report|studies",
    "new",
    "new|My-Press",
    "new|press.toml",
    "new|hard",
    "new|mine|--reference|none",
    "explain|theorem-31",
    "explain|loaded",
    "schema|table",
    "completions|tcsh",
    "man|--out|taken",
    "falsify|theorem-9|--budget|1",
    "falsify|theorem-3-1",
    "falsify|theorem-3-1|--budget|0",
    "coverage|--draws|0",
    "bench|--dofs|5",
    "bench|--dofs|9..3",
    "bench|--max-dofs|1.5",
    "bench|--solvers|magic",
    "bench|--repeat|0",
    "bench|loaded/none",
];

const SOLVERS: &[&str] = &[
    "run|loaded|--solver|multgrid",
    "run|loaded|--solver|",
    "run|loaded|--solver|sh 'open",
    "run|loaded|--solver|no-such-program --fast",
    "run|loaded|--solver|sh fails.sh|--levels|1",
    "run|loaded|--solver|sh nothing.sh|--levels|1",
    "run|loaded|--solver|sh part.sh|--levels|1",
    "run|loaded|--solver-limit|0",
    "bless|loaded|--solver|sh nothing.sh",
];

const CHANGES: &[&str] = &[
    "check|loaded|--set|levels.quick",
    "check|loaded|--set|=1",
    "check|loaded|--set|body.uper.force=1",
    "check|loaded|--set|body.upper.material.posson=0.3",
    "check|loaded|--set|body.7.name=x",
    "check|loaded|--set|family.name=structurd",
    "check|loaded|--set|id=other",
    "check|loaded|--sweep|body.upper.material.poisson=0.3,0.5",
    "check|loaded|--sweep|body.upper.material.poisson=",
    "check|loaded|--sweep|body.*.material.poisson=0.3,0.3",
];

/// One edit of the loaded study: old, new.
const STUDIES: &[(&str, &str)] = &[
    ("title = \"Loaded\"", "title = \"Loaded"),
    ("title = \"Loaded\"", "titel = \"Loaded\""),
    ("title = \"Loaded\"\n", ""),
    ("title = \"Loaded\"", "title = 7"),
    ("id = \"loaded\"", "id = \"Loaded\""),
    ("id = \"loaded\"", "id = \"other\""),
    ("claim = \"two-squares\"", "claim = \"two-square\""),
    ("claim = \"two-squares\"\n", ""),
    ("[levels]\nquick = [4, 8]", "[levels]\nquick = []"),
    ("[levels]\nquick = [4, 8]", "[levels]\nquick = [8, 4]"),
    ("[levels]\nquick = [4, 8]", "[levels]\nquick = [0, 4]"),
    ("[levels]\nquick = [4, 8]", "[levels]\nquick = [4.5, 8]"),
    ("quick = 32", "quick = 30"),
    ("quick = 32", "quick = 8"),
    ("kind = \"overkill\"", "kind = \"exact\""),
    ("kind = \"overkill\"", "kind = \"finer\""),
    (
        "young = 1.0, poisson = 0.3, plane = \"strain\" }\nrectangle = [[0, 0], [1, 1]]",
        "young = 1.0 }\nrectangle = [[0, 0], [1, 1]]",
    ),
    (
        "young = 1.0, poisson = 0.3, plane = \"strain\" }\nrectangle = [[0, 0], [1, 1]]",
        "young = -1, poisson = 0.3 }\nrectangle = [[0, 0], [1, 1]]",
    ),
    (
        "young = 1.0, poisson = 0.3, plane = \"strain\" }\nrectangle = [[0, 0], [1, 1]]",
        "young = 1, poisson = 0.5 }\nrectangle = [[0, 0], [1, 1]]",
    ),
    (
        "young = 1.0, poisson = 0.3, plane = \"strain\" }\nrectangle = [[0, 0], [1, 1]]",
        "young = nan, poisson = 0.3 }\nrectangle = [[0, 0], [1, 1]]",
    ),
    (
        "young = 1.0, poisson = 0.3, plane = \"strain\" }\nrectangle = [[0, 0], [1, 1]]",
        "lame = [1, 1], young = 1 }\nrectangle = [[0, 0], [1, 1]]",
    ),
    ("rectangle = [[0, 0], [1, 1]]", "rectangle = [[1, 1], [0, 0]]"),
    ("rectangle = [[0, 0], [1, 1]]", "rectangle = [[0, 0, 0], [1, 1]]"),
    ("rectangle = [[0, 0], [1, 1]]", "rectangle = [[0, 0.5], [1, 1]]"),
    ("rectangle = [[0, 0], [1, 1]]\n", ""),
    ("rectangle = [[0, 0], [1, 1]]", "divisions = [3, 1]\nrectangle = [[0, 0], [1, 1]]"),
    ("name = \"lower\"\nmaterial", "name = \"upper\"\nmaterial"),
    ("condition = \"sliding\"", "condition = \"slidng\""),
    ("condition = \"sliding\"", "condition = \"free\""),
    ("\"-0.1*(1 - 1.75*x)\"", "\"-0.1*(1 - 1.75*x\""),
    ("\"-0.1*(1 - 1.75*x)\"", "\"-0.1*coss(x)\""),
    ("\"-0.1*(1 - 1.75*x)\"", "\"-0.1*z\""),
    ("\"-0.1*(1 - 1.75*x)\"", "\"0.1\""),
    ("\"-0.1*(1 - 1.75*x)\"", "\"0\""),
    ("\"-0.1*(1 - 1.75*x)\"", "\"1/(x - x)\""),
    ("value = [\"0\", \"-0.1*(1 - 1.75*x)\"]", "value = [\"0\"]"),
    ("body = \"lower\"\nname = \"bottom\"", "body = \"lowr\"\nname = \"bottom\""),
    ("along = [[0, 1], [1, 1]]", "along = [[0, 1], [1, 2]]"),
    ("along = [[0, 1], [1, 1]]", "along = [[0, 1], [0.5, 1]]"),
    ("along = [[0, 1], [1, 1]]", "along = [[0, 1], [0, 0]]"),
    ("along = [[0, 0], [0, 1]]\ncondition", "curves = [\"arc\"]\nalong = [[0, 0], [0, 1]]\ncondition"),
    ("[contact]\nalong = [[0, 0], [1, 0]]\n", ""),
    ("[contact]\nalong = [[0, 0], [1, 0]]", "[contact]\nalong = [[1, 0], [0, 0]]"),
    ("[contact]\nalong = [[0, 0], [1, 0]]", "[contact]\nalong = [[0, 0.5], [1, 0.5]]"),
    ("[contact]", "[contakt]"),
    ("reason = \"the corner between clamped and free sides governs large sizes only\"\n", ""),
    ("[expected]", "[gates]\nrate_tolerance = 0.2\n\n[expected]"),
    ("[expected]", "[gates]\nrate_tolerance = -1\nreason = \"x\"\n\n[expected]"),
    ("[expected]", "[solver]\nname = \"magic\"\n\n[expected]"),
    ("[expected]", "[family]\nname = \"perturbed\"\n\n[expected]"),
    ("[expected]", "[family]\nname = \"perturbed\"\nseed = 1\namount = 0.7\n\n[expected]"),
    ("[expected]", "[exact]\nbuiltin = \"Q\"\n\n[expected]"),
    ("[expected]", "[[case]]\nname = \"a\"\n\n[[case]]\nname = \"a\"\n\n[expected]"),
];

/// One edit of the mesh file of the dovetail.
const MESHES: &[(&str, &str)] =
    &[("$MeshFormat", "hello"), ("4.1 0 8", "2.2 0 8"), ("$EndNodes\n", ""), ("\"tongue-top\"", "\"tongue-tip\"")];

/// What the program said, with a row for the table.
fn row(table: &mut String, input: &str, folder: &Folder, ended: &Ended) {
    assert_eq!(ended.status, 2, "{input}\n{}\n{}", ended.out, ended.err);
    assert!(!ended.err.contains("panicked"), "{input}\n{}", ended.err);
    let said = ended.err.replace(&format!("{}/", folder.0.display()), "");
    let first = said.lines().next().unwrap_or_default();
    // ours is `hint:`, that of the reader of arguments `tip:` or the pointer to --help
    let starts = ["hint: ", "tip: ", "For more information, try "];
    let hint = starts.iter().find_map(|start| said.lines().map(str::trim).find(|l| l.starts_with(start)));
    let hint = hint.unwrap_or_else(|| panic!("no hint for {input}\n{said}"));
    assert!(first.starts_with("error: "), "{input}\n{said}");
    let cell = |text: &str| text.replace('|', "\\|").replace('\n', " ⏎ ");
    let _ = writeln!(table, "| `{}` | {} | {} |", cell(input), cell(&first["error: ".len()..]), cell(hint));
}

fn heading(table: &mut String, words: &str) {
    let _ = write!(table, "\n## {words}\n\n| input | error | what to do |\n| --- | --- | --- |\n");
}

/// The loaded study with few and small levels.
fn study() -> String {
    edit(LOADED, "quick = [4, 8, 16, 32]", "quick = [4, 8]").replace("quick = 128", "quick = 32")
}

fn folder() -> Folder {
    let folder = Folder::with_study("table", &study());
    folder.write("taken", "a file");
    folder.write("fails.sh", "echo the matrix is singular >&2; exit 7\n");
    folder.write("nothing.sh", "exit 0\n");
    folder.write("part.sh", "echo 1,0,0 > displacement.csv\n");
    folder
}

fn of_arguments(table: &mut String, inputs: &[&str]) {
    let folder = folder();
    for input in inputs {
        let mut command = folder.command("");
        let ended = Ended::new(command.args(input.split('|')).output().expect("the program starts"));
        row(table, &input.replace('|', " "), &folder, &ended);
    }
}

fn of_studies(table: &mut String) {
    let folder = folder();
    for (old, new) in STUDIES {
        folder.write("studies/loaded.toml", &edit(&study(), old, new));
        let input = if new.is_empty() { format!("without {}", old.trim_end()) } else { changed_lines(old, new) };
        row(table, &input, &folder, &folder.signorini("check loaded"));
    }
}

/// The lines of `new` that `old` does not have.
fn changed_lines(old: &str, new: &str) -> String {
    let lines = new.lines().filter(|l| !l.is_empty() && !old.lines().any(|o| o == *l));
    lines.collect::<Vec<_>>().join("\n")
}

fn of_meshes(table: &mut String) {
    let folder = Folder::with_study("table-mesh", DOVETAIL);
    row(table, "[mesh] file that is not there", &folder, &folder.signorini("check dovetail"));
    for (old, new) in MESHES {
        folder.write("studies/meshes/dovetail.msh", &MESH.replacen(old, new, 1));
        let input = if new.is_empty() { format!("without {}", old.trim_end()) } else { format!("{new} for {old}") };
        row(table, &input, &folder, &folder.signorini("check dovetail"));
    }
}

#[cfg(unix)]
#[test]
fn every_bad_input_prints_what_the_table_says() {
    let mut table = String::from(
        "# Bad input\n\nWhat the program says; the exit status is 2. Written by `tests/bad_input_table.rs`.\n",
    );
    heading(&mut table, "Command line");
    of_arguments(&mut table, COMMAND_LINE);
    heading(&mut table, "Solvers of one's own");
    of_arguments(&mut table, SOLVERS);
    heading(&mut table, "Keys that options change");
    of_arguments(&mut table, CHANGES);
    heading(&mut table, "Study files");
    of_studies(&mut table);
    heading(&mut table, "Mesh files");
    of_meshes(&mut table);

    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/bad_input.md");
    if std::env::var("SIGNORINI_TABLE").is_ok_and(|word| word == "write") {
        std::fs::write(&path, &table).expect("the table");
    }
    let stored = std::fs::read_to_string(&path).unwrap_or_default();
    for (now, was) in table.lines().zip(stored.lines()) {
        assert_eq!(now, was, "SIGNORINI_TABLE=write cargo test --test bad-input-table, then read the difference");
    }
    assert_eq!(table, stored);
}
