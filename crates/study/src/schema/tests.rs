use super::validate::complaint;
use super::*;
use crate::file::library::{Group, shipped};
use crate::file::shipped::SHIPPED;
use crate::sample;
use std::path::Path;

/// A study file as the JSON of the same shape.
fn json_of(toml: &str) -> Value {
    let table: toml::Table = toml.parse().expect("TOML");
    serde_json::to_value(table).expect("JSON")
}

#[test]
fn every_shipped_study_is_as_its_schema_says() {
    assert!(shipped().sources.len() > 50 && Group::ALL.len() == 3);
    let schema = study();
    for (_, id, text) in SHIPPED {
        assert_eq!(complaint(&schema, &json_of(text)), None, "{id}");
    }
}

#[test]
fn a_broken_study_is_not() {
    let schema = study();
    let (_, _, good) = SHIPPED.iter().find(|(_, id, _)| *id == "theorem-3-1-smooth").expect("the study");
    let body = "[[body]]\nname = \"x\"\nmaterial = { young = 1, poisson = 0.3 }\n";
    for (what, old, new, told) in [
        ("a misspelt key", "question =", "qestion =", "unknown"),
        ("a missing key", "title =", "# title =", "no \"title\""),
        (
            "a text for a number",
            "[[body]]",
            &format!("{}rectangle = [[0, 0], [1, \"1\"]]\n[[body]]", body) as &str,
            "/rectangle/1/1",
        ),
        ("three coordinates", "[[body]]", &format!("{}rectangle = [[0, 0, 0], [1, 1]]\n[[body]]", body), "maxItems"),
        ("a misspelt material", "[[body]]", &format!("{}\n[[body]]", body.replace("young", "yung")), "/material"),
        ("no such family", "[[body]]", "[family]\nname = \"structurd\"\n[[body]]", "/family/name"),
        ("half a cell", "[[body]]", "[reference]\nkind = \"overkill\"\nquick = 1.5\n[[body]]", "/reference/quick"),
        ("a word for a rate", "[[body]]", "[gates]\nceiling = \"no\"\n[[body]]", "/gates/ceiling"),
        ("cells below zero", "[[body]]", "[levels]\nquick = [-1]\n[[body]]", "/levels/quick/0"),
    ] {
        // the entry goes in front of the first of its kind
        let broken = good.replacen(old, new, 1);
        assert_ne!(&broken, good, "{what}");
        let found = complaint(&schema, &json_of(&broken));
        assert!(found.as_ref().is_some_and(|f| f.contains(told)), "{what}: {found:?}");
    }
}

#[test]
fn records_are_as_their_schema_says_and_broken_ones_are_not() {
    let schema = record();
    let good = sample::record("s", "structured", sample::levels(5, |h| 0.3 * h));
    let good = serde_json::to_value(good).expect("JSON");
    assert_eq!(complaint(&schema, &good), None);
    let broken = |change: &dyn Fn(&mut Value)| {
        let mut value = good.clone();
        change(&mut value);
        complaint(&schema, &value).unwrap_or_default()
    };
    assert!(broken(&|v| v["levels"][2]["dofs"] = json!("many")).contains("/levels/2/dofs"));
    assert!(broken(&|v| v["verdict"]["outcome"] = json!("passed")).contains("/verdict/outcome"));
    assert!(broken(&|v| v["kind"] = json!("rates")).contains("/kind"));
    assert!(broken(&|v| drop(v.as_object_mut().unwrap().remove("levels"))).contains("no \"levels\""));
    assert!(broken(&|v| v["levels"][0]["h"] = Value::Null).contains("/levels/0/h"));
}

#[test]
fn published_records_are_as_the_schema_says() {
    let schema = record();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reports/published");
    for study in ["hertz", "lemma-3-2", "lemma-1-1", "remark-3-3"] {
        let record = find_record(&folder.join(study)).expect(study);
        let value = serde_json::from_str(&std::fs::read_to_string(record).expect("a record")).expect("JSON");
        assert_eq!(complaint(&schema, &value), None, "{study}");
    }
}

fn find_record(folder: &Path) -> Option<std::path::PathBuf> {
    let mut below: Vec<_> = std::fs::read_dir(folder).ok()?.flatten().map(|e| e.path()).collect();
    below.sort();
    below.iter().find(|p| p.ends_with("record.json")).cloned().or_else(|| below.iter().find_map(|p| find_record(p)))
}

#[test]
fn everything_is_described() {
    for (name, schema) in [("study", study()), ("record", record())] {
        let tables = schema["$defs"].as_object().expect("tables").iter().map(|(k, v)| (k.as_str(), v));
        for (table, of) in tables.chain([(name, &schema)]) {
            for (key, property) in of["properties"].as_object().into_iter().flatten() {
                assert!(property["description"].is_string(), "{table}.{key} of a {name}");
            }
        }
    }
}

/// `SIGNORINI_SCHEMAS=write cargo test -p signorini-study schema` writes them anew.
#[test]
fn the_files_are_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/schemas");
    for (name, schema) in [("study", study()), ("record", record())] {
        let path = folder.join(format!("{name}.schema.json"));
        if std::env::var("SIGNORINI_SCHEMAS").is_ok_and(|word| word == "write") {
            crate::store::write_atomic(&path, text(&schema)).expect("the schema");
        }
        let stored = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(stored == text(&schema), "{} is out of date: `signorini schema {name} > {0}`", path.display());
    }
}
