//! Options on small studies and on the shipped ones.

use super::Changes;
use crate::file::StudyError;
use crate::file::library::shipped;
use crate::record::Setting;
use crate::study::{Case, Study};
use std::path::Path;

/// Two cases, one with a family and a parameter of its own.
const STUDY: &str = r#"id = "small"
title = "t"
question = "q"
setup = "s"
refuted_by = "r"
claim = "theorem-3-1"

[parameters]
p = 0.1

[[body]]
name = "upper"
material = { young = 1.0, poisson = 0.3 }
rectangle = [[0, 0], [1, 1]]
force = ["0", "p*sin(x)"]

[[body]]
name = "lower"
material = { young = 10, poisson = 0.3, plane = "strain" }
rectangle = [[0, -1], [1, 0]]

[[boundary]]
body = "lower"
name = "end"
along = [[0, -1], [1, -1]]
condition = "fixed"

[[boundary]]
body = "upper"
name = "end"
along = [[0, 1], [1, 1]]
condition = "traction"
value = ["0", "-0.1*nx"]

[contact]
along = [[0, 0], [1, 0]]

[levels]
quick = [8, 16, 32, 64]

[[case]]
name = "one"

[[case]]
name = "two.5"
family = { name = "refined", seed = 1, amount = 0.2 }

[case.parameters]
p = 0.2
"#;

fn changes(set: &[&str], sweep: &[&str]) -> Changes {
    let owned = |list: &[&str]| list.iter().map(|s| (*s).to_owned()).collect::<Vec<_>>();
    Changes::read(&owned(set), &owned(sweep)).unwrap_or_else(|e| panic!("{e}"))
}

fn apply(set: &[&str], sweep: &[&str]) -> Result<Study, StudyError> {
    changes(set, sweep).apply(STUDY, Path::new("small.toml"))
}

fn study(set: &[&str], sweep: &[&str]) -> Study {
    apply(set, sweep).unwrap_or_else(|e| panic!("{e}"))
}

fn edited(old: &str, new: &str) -> Study {
    assert_eq!(STUDY.matches(old).count(), 1, "{old}");
    Study::parse(&STUDY.replace(old, new), Path::new("small.toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// What the cases are, all names aside.
fn canonical(study: &Study) -> Vec<&str> {
    study.cases.iter().map(|c| c.canonical.as_str()).collect()
}

fn refused(set: &[&str], sweep: &[&str]) -> String {
    apply(set, sweep).err().unwrap_or_else(|| panic!("{set:?} {sweep:?} is accepted")).to_string()
}

#[test]
fn a_key_set_is_the_file_edited() {
    let upper = "material = { young = 1.0, poisson = 0.3 }";
    for (set, old, new) in [
        // a number, in a table of a list by name and by number
        ("body.upper.material.poisson=0.49", upper, "material = { young = 1.0, poisson = 0.49 }"),
        ("body.0.material.young=1e-4", upper, "material = { young = 1e-4, poisson = 0.3 }"),
        // a whole table, a field that was not there, a word
        ("body.upper.material={ lame = [1.5, 1] }", upper, "material = { lame = [1.5, 1] }"),
        ("body.upper.material.plane=stress", upper, "material = { young = 1.0, poisson = 0.3, plane = \"stress\" }"),
        // a list, an entry of a list in a list, an expression with a comma
        ("levels.quick=[8, 16, 32]", "quick = [8, 16, 32, 64]", "quick = [8, 16, 32]"),
        ("levels.quick.0=4", "quick = [8, 16, 32, 64]", "quick = [4, 16, 32, 64]"),
        ("body.lower.rectangle.0.1=-2", "rectangle = [[0, -1], [1, 0]]", "rectangle = [[0, -2], [1, 0]]"),
        ("boundary.1.value.1=max(x, y)", "\"-0.1*nx\"", "\"max(x, y)\""),
        ("boundary.1.value=[\"0\", 'x']", "[\"0\", \"-0.1*nx\"]", "[\"0\", \"x\"]"),
        // a table that was not there
        ("solver.name=interior-point", "[levels]", "[solver]\nname = \"interior-point\"\n\n[levels]"),
        // a flag, and a field of the study itself
        ("contact.symmetric=true", "along = [[0, 0], [1, 0]]", "along = [[0, 0], [1, 0]]\nsymmetric = true"),
        ("claim=lemma-2-1", "claim = \"theorem-3-1\"", "claim = \"lemma-2-1\""),
        // one case alone: the other keeps what it has, and the rest of the table stays
        ("case.\"two.5\".family.seed=7", "seed = 1", "seed = 7"),
        ("case.one.levels.quick=[8, 16]", "name = \"one\"", "name = \"one\"\nlevels = { quick = [8, 16] }"),
        ("case.0.parameters.p=3", "name = \"one\"", "name = \"one\"\nparameters = { p = 3 }"),
    ] {
        let (changed, expected) = (study(&[set], &[]), edited(old, new));
        assert_eq!(canonical(&changed), canonical(&expected), "{set}");
        assert_eq!(changed.claim.id, expected.claim.id);
        let plain = study(&[], &[]);
        assert!(canonical(&changed) != canonical(&plain), "{set} changes nothing");
        let names: Vec<&str> = changed.cases.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, ["one", "two.5"], "{set}");
    }
}

#[test]
fn a_star_is_every_entry_and_a_key_reaches_the_cases_own_tables() {
    let both = study(&["body.*.material.poisson=0.45"], &[]);
    assert_eq!(
        canonical(&both),
        canonical(&study(&["body.upper.material.poisson=0.45", "body.lower.material.poisson=0.45"], &[]))
    );
    // case two.5 has a family and a parameter of its own
    let seeded = study(&["family={ name = 'perturbed', seed = 9, amount = 0.1 }", "parameters.p=0.5"], &[]);
    for case in &seeded.cases {
        assert_eq!((case.family.name(), case.seed(), case.parameters["p"]), ("perturbed", 9, 0.5), "{}", case.name);
    }
}

#[test]
fn every_shipped_study_survives_the_way_through_tables() {
    for source in shipped().sources {
        let plain = source.load().unwrap();
        let retitled = source.load_changed(&changes(&["title=Another"], &[])).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(canonical(&plain), canonical(&retitled), "{}", plain.id);
        assert_eq!(retitled.title, "Another");
        let facts = |s: &Study| format!("{} {} {} {}", s.question, s.setup, s.refuted_by, s.claim.statement);
        assert_eq!(facts(&plain), facts(&retitled));
    }
}

#[test]
fn a_sweep_makes_a_case_of_each_combination() {
    let swept =
        study(&["levels.quick=[8, 16]"], &["body.*.material.poisson=0.3,0.49", "body.lower.material.young=1e-4, 1"]);
    let names: Vec<&str> = swept.cases.iter().map(|c| c.name.as_str()).collect();
    let expected = ["poisson-0.3-young-1e-4", "poisson-0.3-young-1", "poisson-0.49-young-1e-4", "poisson-0.49-young-1"];
    let expected: Vec<String> = ["one", "two.5"].iter().flat_map(|c| expected.map(|e| format!("{c}-{e}"))).collect();
    assert_eq!(names, expected);
    let last = &swept.cases[7];
    assert_eq!((last.quick.as_slice(), last.family.name()), (&[8, 16][..], "refined"));
    assert_eq!((last.parameters["poisson"], last.parameters["young"], last.parameters["p"]), (0.49, 1.0, 0.2));
    let alone = study(&["levels.quick=[8, 16]", "body.*.material.poisson=0.49", "body.lower.material.young=1"], &[]);
    assert_eq!(last.canonical, alone.cases[1].canonical);
    let changed = last.changed.as_ref().unwrap();
    assert_eq!((changed.study.as_str(), changed.case.as_str()), ("small", "two.5"));
    assert_eq!(changed.options[1], "--sweep 'body.*.material.poisson=0.3,0.49'");
    let poisson = Setting {
        key: "body.*.material.poisson".into(),
        name: "poisson".into(),
        value: "0.49".into(),
        number: Some(0.49),
        swept: true,
    };
    assert_eq!((changed.settings.len(), &changed.settings[1]), (3, &poisson));
    assert!(!changed.settings[0].swept && changed.swept().count() == 2);
}

#[test]
fn names_tell_keys_and_values_apart() {
    let names = |sweep: &[&str]| -> Vec<String> {
        let study = study(&[], sweep);
        study.cases[..study.cases.len() / 2].iter().map(|c: &Case| c.name.clone()).collect()
    };
    let two = names(&["body.upper.material.young=1", "body.lower.material.young=2"]);
    assert_eq!(two, ["one-upper-material-young-1-lower-material-young-2"]);
    assert_eq!(names(&["levels.quick=[8, 16],[8, 16, 32]"]), ["one-quick-8-16", "one-quick-8-16-32"]);
    assert_eq!(names(&["parameters.p=-1,1"]), ["one-p--1", "one-p-1"]);
    let long = "sin(x) + cos(y) + sin(2*x) + cos(2*y)";
    let numbered = names(&[&format!("body.0.force.1={long} + 1,{long} + 2")]);
    assert_eq!(numbered, ["one-force-1-1", "one-force-1-2"]);
}

#[test]
fn a_changed_study_never_bears_the_name_of_the_plain_one_or_of_another_change() {
    let plain = study(&[], &[]);
    let ids: Vec<String> = [
        study(&["body.0.material.poisson=0.4"], &[]),
        study(&["body.1.material.poisson=0.4"], &[]),
        study(&[], &["body.0.material.poisson=0.4"]),
        study(&[], &["body.0.material.poisson=0.4,0.41"]),
    ]
    .map(|s| s.id)
    .to_vec();
    for (k, id) in ids.iter().enumerate() {
        assert!(id.starts_with("small_poisson") && *id != plain.id && !ids[..k].contains(id), "{ids:?}");
    }
    assert_eq!(study(&["body.0.material.poisson=0.4"], &[]).id_of_file(), "small");
    assert!(plain.id == "small" && plain.cases[0].changed.is_none());
    // one case, named like its study
    let single = STUDY.split("[[case]]").next().unwrap();
    let alone = changes(&["levels.quick=[8, 16]"], &[]).apply(single, Path::new("small.toml")).unwrap();
    assert_eq!((alone.cases.len(), &alone.cases[0].name), (1, &alone.id));
    let one = changes(&[], &["levels.quick=[8, 16]"]).apply(single, Path::new("small.toml")).unwrap();
    assert_eq!(one.cases[0].name, "quick-8-16");
}

#[test]
fn options_survive_the_way_to_another_process() {
    let options = changes(&["title=a, 'b'", "levels.quick=[8, 16]"], &["body.*.material.poisson=0.3,0.4"]);
    let text = serde_json::to_string(&options).unwrap();
    assert_eq!(serde_json::from_str::<Changes>(&text).unwrap(), options);
    assert!(serde_json::from_str::<Changes>(r#"{"set":["x"],"sweep":[]}"#).is_err());
    assert!(changes(&[], &[]).is_none() && !options.is_none() && options.sweeps());
}

#[test]
fn what_makes_no_sense_is_refused_with_option_key_and_what_there_is() {
    type Row<'a> = (&'a [&'a str], &'a [&'a str], &'a [&'a str]);
    let rows: [Row; 18] = [
        // mistyped fields
        (
            &["body.upper.material.posson=0.4"],
            &[],
            &[
                "--set body.upper.material.posson=0.4",
                "unknown field `posson`",
                "`young`, `poisson`",
                "did you mean `poisson`?",
            ],
        ),
        (&["bdy.upper.force=1"], &[], &["--set bdy.upper.force=1", "unknown field `bdy`", "did you mean `body`?"]),
        (&["solver.nam=condensed"], &[], &["unknown field `nam`", "did you mean `name`?"]),
        (&["titel=x"], &[], &["unknown field `titel`", "`exact`"]),
        // entries of lists
        (
            &["body.uper.force=1"],
            &[],
            &["`body` has no entry `uper`", "0 (`upper`), 1 (`lower`)", "did you mean `body.upper`?"],
        ),
        (&["body.2.force=1"], &[], &["`body` has no entry `2`", "`*` for all"]),
        (
            &["boundary.end.condition=free"],
            &[],
            &["`boundary` has 2 entries named `end`: numbers 0, 1", "`boundary.0`"],
        ),
        (&["levels.*=1"], &[], &["`levels.*`", "`*` stands for all entries of a list", "quick"]),
        // through a number, and values of the wrong type or out of bounds
        (&["body.upper.material.poisson.x=1"], &[], &["`body.upper.material.poisson` is 0.3", "nothing named `x`"]),
        (
            &["body.upper.material.poisson=soft"],
            &[],
            &["--set body.upper.material.poisson=soft", "\"soft\"", "expected a number", "in `"],
        ),
        (&["body.upper.material.poisson=0.6"], &[], &["--set body.upper.material.poisson=0.6", "−1 < ν < 1/2"]),
        (&["levels.quick=8"], &[], &["--set levels.quick=8", "invalid type: integer `8`"]),
        // parameters are known by the study alone
        (&["parameters.q=1"], &[], &["the study has no parameter `q`", "use one of: p"]),
        // cases
        (&["case.on.levels.quick=[8]"], &[], &["--set 'case.on.levels.quick=[8]'", "did you mean `case.one`?"]),
        (&["case.one=1"], &[], &["write `case.NAME.KEY`; the cases are one, two.5"]),
        (&[], &["case.one.family.seed=1,2"], &["a sweep goes over all cases", "`--set` changes this one"]),
        (&[], &["claim=theorem-3-1,theorem-3-3"], &["--sweep claim=theorem-3-1,theorem-3-3", "no key of them"]),
        (&["id=other"], &[], &["--set id=other", "id `other` in a file named"]),
    ];
    for (set, sweep, words) in rows {
        let said = refused(set, sweep);
        assert!(said.starts_with("small.toml: ") && said.contains("\nnext: "), "{said}");
        words.iter().for_each(|w| assert!(said.contains(w), "no {w:?} in\n{said}"));
    }
}

#[test]
fn what_is_no_option_is_refused_before_any_study_is_read() {
    for (set, sweep, words) in [
        (&["poisson"][..], &[][..], ["--set poisson: no `=`", "--set key=value"]),
        (&["a..b=1"], &[], ["is empty", "--set key=value"]),
        (&["a="], &[], ["a value is missing", "--set key=value"]),
        (&[], &["a=1,,2"], ["a value is missing", "--sweep key=a,b,c"]),
        (&[], &["a=1,2,1"], ["the value 1 stands there twice", "--sweep"]),
        (&["a.b=1"], &["a.b=2,3"], ["`a.b` is given twice", "once"]),
    ] {
        let owned = |list: &[&str]| list.iter().map(|s| (*s).to_owned()).collect::<Vec<_>>();
        let refused = Changes::read(&owned(set), &owned(sweep)).unwrap_err();
        let said = format!("{refused}\n{}", refused.next);
        words.iter().for_each(|w| assert!(said.contains(w), "no {w:?} in\n{said}"));
    }
}

#[test]
fn a_file_that_is_wrong_by_itself_is_blamed_with_its_place() {
    let text = STUDY.replace("poisson = 0.3 }", "poisson = 0.7 }");
    let said = changes(&["levels.quick=[8, 16]"], &[]).apply(&text, Path::new("small.toml")).err().unwrap().to_string();
    assert!(said.starts_with("small.toml:13:") && !said.contains("--set"), "{said}");
}
