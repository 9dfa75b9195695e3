//! `studies/README.md` tells the truth: its example parses, and it names every field that the reader knows.

use crate::record::ClaimKind;
use crate::study::{PartCondition, Study};
use std::path::Path;

const README: &str = include_str!("../../../../../studies/README.md");

fn example() -> &'static str {
    README.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).expect("an example in TOML")
}

#[test]
fn the_example_parses() {
    let study = Study::parse(example(), Path::new("pressed-block.toml")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(study.claim.kind, ClaimKind::Rate);
    assert_eq!(study.cases.len(), 2);
    let fixed = |c: &crate::study::Case| matches!(c.scene().unwrap().parts[0].condition, PartCondition::Fixed(_));
    assert!(study.cases.iter().all(fixed));
}

/// A field that does not exist makes the parser list those that do.
#[test]
fn every_field_is_documented() {
    let tables = [
        "",
        "[own_claim]",
        "[mesh]",
        "[[body]]",
        "[body.material]",
        "[body.material.orthotropic]",
        "[[boundary]]",
        "[contact]",
        "[slide]",
        "[[curve]]",
        "[curve.circle]",
        "[curve.graph]",
        "[discretisation]",
        "[formula]",
        "[exact]",
        "[exact.traces]",
        "[lemma]",
        "[family]",
        "[levels]",
        "[reference]",
        "[solver]",
        "[splitting]",
        "[gates]",
        "[expected]",
        "[[case]]",
    ];
    for table in tables {
        let head = match table {
            t if t.starts_with("[body.") => "[[body]]\n",
            t if t.starts_with("[curve.") => "[[curve]]\n",
            _ => "",
        };
        let text = format!("{head}{table}\nno_such_field = 1\n");
        let e = Study::parse(&text, Path::new("x.toml")).err().unwrap();
        let fields: Vec<&str> = e.message.split('`').skip(3).step_by(2).collect();
        assert!(e.message.starts_with("unknown field `no_such_field`") && !fields.is_empty(), "{table}: {}", e.message);
        for field in fields {
            let named = README.contains(&format!("`{field}`")) || README.contains(&format!("[{field}]"));
            assert!(named, "{table}: `{field}` is not documented");
        }
    }
}
