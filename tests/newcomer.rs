//! The first five minutes: a study of one's own, the claim behind it, help, completions, man pages, schemas.

mod common;

use common::{Folder, names};
use serde_json::Value;
use signorini_study::claim::catalogue::catalogue;
use signorini_study::record::Outcome;

#[test]
fn a_new_study_runs_as_it_is() {
    let folder = Folder::new("new");
    let said = folder.signorini("new my-press").expect(0).out;
    assert!(said.starts_with("my-press.toml written") && said.contains("signorini run my-press.toml"), "{said}");
    assert_eq!(names(&folder.0), ["my-press.toml", "study.schema.json"]);
    folder.signorini("check my-press.toml").expect(0);
    let ran = folder.signorini("run my-press.toml --quiet").expect(0);
    assert!(ran.err.is_empty(), "{}", ran.err);
    assert_eq!(folder.record("reports/my-press").verdict.outcome, Outcome::Pass);

    // what is there stays
    let text = folder.text("my-press.toml");
    folder.write("my-press.toml", &(text.clone() + "# mine\n"));
    folder.signorini("new my-press").complains(2, &["my-press.toml is there already", "hint: take another name"]);
    assert!(folder.text("my-press.toml").ends_with("# mine\n"));
}

#[test]
fn a_new_study_with_an_exact_solution_runs_as_it_is() {
    let folder = Folder::new("new-exact");
    folder.write("studies/README.md", "a folder of studies");
    let said = folder.signorini("new mine --reference exact").expect(0).out;
    assert!(said.contains("signorini run mine "), "{said}");
    folder.signorini("run mine --quiet").expect(0);
    let record = folder.record("reports/mine");
    assert_eq!((record.verdict.outcome, record.claim.as_str()), (Outcome::Pass, "theorem-3-1"));
    assert!(record.rates["strain"].slope > 0.95, "{:?}", record.rates["strain"]);
}

/// The comment on the first line names a schema that is there, and the study is as it says: its keys are known to it.
#[test]
fn the_schema_of_a_new_study_is_at_hand() {
    let folder = Folder::new("new-schema");
    folder.signorini("new mine").expect(0);
    let text = folder.text("mine.toml");
    let named = text.lines().next().and_then(|l| l.strip_prefix("#:schema ./")).expect("a schema on the first line");
    assert_eq!(folder.text(named), folder.signorini("schema study").expect(0).out);
    let schema: Value = serde_json::from_str(&folder.text(named)).expect("JSON");
    let table: toml::Table = text.parse().expect("TOML");
    for key in table.keys() {
        assert!(schema["properties"].get(key).is_some(), "{key}");
    }
    let record: Value = serde_json::from_str(&folder.signorini("schema record").expect(0).out).expect("JSON");
    assert!(record["properties"]["verdict"].is_object());
    // every key has its comment, once
    for commented in ["id = ", "rectangle = ", "condition = \"sliding\"", "quick = ", "rate = "] {
        assert!(text.lines().any(|l| l.starts_with(commented) && l.contains(" # ")), "{commented}");
    }
}

#[test]
fn a_name_that_cannot_be_one_is_refused_and_nothing_is_written() {
    let folder = Folder::new("new-name");
    for (name, words) in [
        ("My-Press", "cannot name a study"),
        ("../escape", "cannot name a study"),
        (".hidden", "cannot name a study"),
        ("press.toml", "leave the ending out: press"),
        ("hard", "names a group of studies"),
        ("everything", "names a group of studies"),
    ] {
        folder.signorini(&format!("new {name}")).complains(2, &["error: ", words, "hint: "]);
    }
    assert_eq!(names(&folder.0), [""; 0]);
}

#[test]
fn every_claim_is_explained() {
    let folder = Folder::new("explain");
    let theorem = folder.signorini("explain theorem-3-3").expect(0).out;
    for words in
        ["statement   ", "hypotheses  ", "the paper's: O(h^{3/4})", "sources  ", "theorem-3-3: ", "a rate, in "]
    {
        assert!(theorem.contains(words), "no {words:?} in\n{theorem}");
    }
    let nothing = folder.signorini("explain remark-1-2").expect(0).out;
    assert!(nothing.contains("nothing to run: "), "{nothing}");
    for entry in catalogue().iter().step_by(7) {
        let said = folder.signorini(&format!("explain {}", entry.id)).expect(0).out;
        let all =
            [entry.statement].into_iter().chain(entry.hypotheses.iter().copied()).chain(entry.sources.iter().copied());
        all.for_each(|words| assert!(said.contains(words), "no {words:?} in\n{said}"));
    }
    folder.signorini("explain theorem-31").complains(2, &["no claim `theorem-31`", "did you mean `theorem-3-1`?"]);
    folder.signorini("explain hertz").complains(2, &["`hertz` is a study", "hint: "]);
}

#[test]
fn shells_and_man_read_every_command() {
    let folder = Folder::new("pages");
    let commands =
        ["run", "list", "new", "explain", "check", "bless", "bench", "falsify", "coverage", "report", "schema"];
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let text = folder.signorini(&format!("completions {shell}")).expect(0).out;
        commands.iter().for_each(|c| assert!(text.contains(c), "no {c} in the completions of {shell}"));
    }
    let page = folder.signorini("man").expect(0).out;
    assert!(page.contains(".TH signorini 1") && page.contains("signorini\\-explain"), "{page}");
    folder.signorini("man --out pages").expect(0);
    let written = names(&folder.path("pages"));
    for command in commands {
        assert!(written.contains(&format!("signorini-{command}.1")), "{command}: {written:?}");
        assert!(folder.text(&format!("pages/signorini-{command}.1")).contains(".SH OPTIONS"), "{command}");
    }
    assert!(!written.iter().any(|w| w.contains("bench-one")));
}

#[test]
fn help_teaches() {
    let folder = Folder::new("help");
    let top = folder.signorini("--help").expect(0).out;
    for words in ["First steps:", "signorini new my-press", "Exit status: 0 all pass", "Usage: signorini"] {
        assert!(top.contains(words), "no {words:?} in\n{top}");
    }
    let run = folder.signorini("run --help").expect(0).out;
    for heading in ["Sizes:", "Solver:", "Output:", "Keys of the study:", "Gate:", "Machine:", "Examples:"] {
        assert!(run.lines().any(|l| l == heading), "no {heading:?} in\n{run}");
    }
    for command in
        ["run", "list", "new", "explain", "check", "bless", "bench", "falsify", "coverage", "report", "schema", "man"]
    {
        let help = folder.signorini(&format!("{command} --help")).expect(0).out;
        let purpose = help.split("Usage:").next().unwrap_or_default();
        // a line that says what it is, and a paragraph that says what it does
        assert!(purpose.trim().contains("\n\n") && purpose.len() > 120, "{command}: {purpose}");
        assert!(top.contains(&format!("  {command} ")), "{command}");
    }
}

#[test]
fn the_citation_names_this_version_and_the_paper() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../CITATION.cff");
    let text = std::fs::read_to_string(path).expect("the citation");
    for line in
        [concat!("version: ", env!("CARGO_PKG_VERSION")), "cff-version: 1.2.0", "  - type: article", "    year: 1981"]
    {
        assert!(text.lines().any(|l| l == line), "no {line:?}");
    }
    assert!(text.contains("Contact between elastic bodies — II. Finite element analysis"));
}
