//! A run as a gate of continuous integration: JUnit XML, annotations, the table of what drifted.

mod common;

use common::{Folder, SMOOTH, edit};

/// The smooth study on small meshes, held against a rate that it cannot reach in the second of three cases; the third has too
/// few levels.
fn mixed() -> String {
    SMOOTH.to_owned()
        + "\n[[case]]\nname = \"good\"\n\n[[case]]\nname = \"slow\"\nexpected = { paper = 1.5 }\n\n\
        [[case]]\nname = \"short\"\nlevels = { quick = [4, 8], full = [4, 8] }\n"
}

/// The element of a test case.
fn element<'a>(xml: &'a str, case: &str) -> &'a str {
    let from = xml.find(&format!("<testcase name=\"{case}\"")).unwrap_or_else(|| panic!("no case {case} in\n{xml}"));
    let end = xml[from..].find("</testcase>").expect("the end of the case");
    &xml[from..from + end]
}

#[test]
fn every_case_is_told_with_its_reasons_and_its_time() {
    let folder = Folder::with_study("gate", &mixed());
    let ended = folder.signorini("run --quiet --junit ci/junit.xml --annotations github").expect(1);
    let xml = folder.text("ci/junit.xml");
    for element in ["<testsuites name=\"signorini\"", "<testsuite name=\"smooth\""] {
        let head = xml.lines().find(|l| l.trim_start().starts_with(element)).unwrap_or_else(|| panic!("{xml}"));
        assert!(["tests=\"3\"", "failures=\"1\"", "errors=\"1\""].iter().all(|count| head.contains(count)), "{head}");
    }
    assert!(!element(&xml, "good").contains("<failure") && !element(&xml, "good").contains("time=\"0.000\""), "{xml}");
    let slow = element(&xml, "slow");
    assert!(slow.contains("<failure") && slow.contains("type=\"fail\"") && slow.contains("too slow"), "{slow}");
    let short = element(&xml, "short");
    assert!(
        short.contains("<error") && short.contains("type=\"inconclusive\"") && short.contains("2 usable levels"),
        "{short}"
    );

    let line = |case: &str| 1 + mixed().lines().position(|l| l == format!("name = \"{case}\"")).expect("the case");
    let lines: Vec<&str> = ended.out.lines().filter(|l| l.starts_with("::")).collect();
    assert_eq!(lines.len(), 2, "{}", ended.out);
    let error = format!("::error file=studies/smooth.toml,line={},title=smooth · slow%3A fail::", line("slow"));
    let warning =
        format!("::warning file=studies/smooth.toml,line={},title=smooth · short%3A inconclusive::", line("short"));
    assert!(lines[0].starts_with(&error) && lines[0].contains("too slow"), "{}", lines[0]);
    assert!(lines[1].starts_with(&warning), "{}", lines[1]);
    // without being asked nothing is written
    folder.signorini("run --quiet --out plain").expect(1);
    assert!(!folder.path("plain/junit.xml").exists());
}

#[test]
fn bad_input_is_an_error_of_its_own() {
    let folder = Folder::with_study("gate-bad", &edit(SMOOTH, "[contact]", "[contakt]"));
    let ended = folder.signorini("run --junit junit.xml --annotations github").expect(2);
    let xml = folder.text("junit.xml");
    assert!(xml.contains("errors=\"1\"") && xml.contains("bad input") && xml.contains("contakt"), "{xml}");
    assert!(ended.out.starts_with("::error title=signorini: bad input::error: "), "{}", ended.out);
    assert!(ended.out.contains("%0A") && ended.err.contains("contakt"), "{}", ended.out);
    folder.signorini("bless --junit junit.xml").complains(2, &["belong to `run`"]);
}

#[test]
fn what_drifted_is_a_table_where_it_decides() {
    let folder = Folder::with_study("gate-drift", SMOOTH);
    folder.signorini("bless smooth").expect(0);
    let same = folder.signorini("run smooth --strict --junit same.xml").expect(0);
    assert!(!same.out.contains("baseline") && !folder.text("same.xml").contains("drift"), "{}", same.out);

    let energy = folder.record("reports/smooth").levels[2].energy;
    let baseline =
        edit(&folder.text("reference/smooth.json"), &format!("{energy}"), &format!("{}", energy * (1.0 + 1e-7)));
    folder.write("reference/smooth.json", &baseline);
    let strict = folder.signorini("run smooth --strict --junit strict.xml --annotations github").expect(1);
    let table: Vec<&str> = strict.out.lines().skip_while(|l| !l.starts_with("drift from the baselines")).collect();
    let columns = ["case", "quantity", "baseline", "now", "change", "allowed"];
    assert_eq!(table[1].split_whitespace().collect::<Vec<_>>(), columns, "{}", strict.out);
    for words in ["smooth/smooth", "level 2: energy", "1.0e-7", "1.0e-8"] {
        assert!(table[3].contains(words), "no {words:?} in {}", table[3]);
    }
    assert!(
        strict.out.contains("::error file=studies/smooth.toml,line=1,title=smooth%3A drift::level 2: energy"),
        "{}",
        strict.out
    );
    let xml = folder.text("strict.xml");
    assert!(element(&xml, "smooth").contains("type=\"drift\"") && xml.contains("failures=\"1\""), "{xml}");

    // without --strict drift is told and decides nothing
    let plain = folder.signorini("run smooth --junit plain.xml --annotations github").expect(0);
    assert!(
        plain.out.contains("drift: smooth/smooth: level 2: energy") && plain.out.contains("::warning file="),
        "{}",
        plain.out
    );
    let xml = folder.text("plain.xml");
    assert!(xml.contains("failures=\"0\"") && element(&xml, "smooth").contains("drift from the baseline"), "{xml}");
}
