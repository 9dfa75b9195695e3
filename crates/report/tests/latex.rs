//! Tables in LaTeX: commands and braces in balance, as many cells as columns, nothing that LaTeX would choke on.

mod common;

use common::{arc, gap, healthy, record};
use signorini_report::latex;
use signorini_report::table::tex;
use signorini_study::record::StudyRecord;
use signorini_study::store::read_records;
use std::path::Path;

/// What is wrong with a table of ours, if anything: the grammar that its writer promises, and no more of LaTeX.
fn complaint(text: &str) -> Option<String> {
    let mut open: Vec<&str> = Vec::new();
    let mut columns = 0;
    for (number, line) in text.lines().enumerate().filter(|(_, l)| !l.starts_with('%')) {
        let wrong = |what: &str| Some(format!("line {}: {what}: {line}", number + 1));
        if let Some(what) = unbalanced(line) {
            return wrong(what);
        }
        if let Some(name) = line.trim().strip_prefix("\\begin{").and_then(|r| r.split('}').next()) {
            open.push(name);
            if name != "table" {
                columns = line.rsplit('{').next().map_or(0, |c| c.trim_end_matches('}').len());
            }
        } else if let Some(name) = line.trim().strip_prefix("\\end{").and_then(|r| r.strip_suffix('}')) {
            if open.pop() != Some(name) {
                return wrong("ends what is not open");
            }
        } else if line.ends_with("\\\\") && !line.contains("\\caption") {
            let cells = 1 + line.replace("\\&", "").matches('&').count();
            if cells != columns {
                return wrong(&format!("{cells} cells in {columns} columns"));
            }
        } else if line.replace("\\&", "").contains('&') {
            return wrong("`&` outside a row");
        }
    }
    open.pop().map(|name| format!("{name} is never ended"))
}

/// Braces, dollars, and characters that are commands or missing in a plain font.
fn unbalanced(line: &str) -> Option<&'static str> {
    let mut depth = 0_i32;
    let mut mathematics = false;
    let mut characters = line.chars().peekable();
    while let Some(c) = characters.next() {
        match c {
            '\\' => drop(characters.next()),
            '{' => depth += 1,
            '}' if depth == 0 => return Some("`}` without `{`"),
            '}' => depth -= 1,
            '$' => mathematics = !mathematics,
            '^' | '_' if !mathematics => return Some("an index outside mathematics"),
            '|' | '<' | '>' if !mathematics => return Some("a sign that is another one in text"),
            '#' | '%' | '~' => return Some("a character that is a command"),
            c if !c.is_ascii() && !c.is_alphabetic() => return Some("a character that no font has"),
            c if mathematics && !c.is_ascii() => return Some("a letter that mathematics does not know"),
            _ => {}
        }
    }
    if depth != 0 {
        Some("`{` without `}`")
    } else if mathematics {
        Some("`$` without `$`")
    } else {
        None
    }
}

fn published() -> Vec<StudyRecord> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reports/published");
    read_records(&folder).expect("the published records")
}

#[test]
fn tables_of_every_published_record_are_well_formed_and_translate_every_character() {
    let records = published();
    assert!(records.len() > 50, "{}", records.len());
    for record in &records {
        let text = latex::case(record).unwrap_or_default();
        assert_eq!(complaint(&text), None, "{}/{}", record.study, record.case);
        let words = [&record.title, &record.statement, &record.question, &record.setup, &record.refuted_by];
        let reasons = record.verdict.reasons.iter().chain(&record.notes).chain(&record.hypotheses);
        for words in words.into_iter().chain(reasons) {
            assert!(!tex(words).contains("[U+"), "{}", tex(words));
            assert_eq!(unbalanced(&tex(words)), None, "{words}\n{}", tex(words));
        }
    }
    let summary = latex::summary(&records);
    assert_eq!(complaint(&summary), None);
    assert_eq!(
        summary.lines().filter(|l| l.ends_with("\\\\")).count(),
        records.len() + 3,
        "rows, caption, two headings"
    );
}

#[test]
fn orders_stand_beside_their_errors() {
    let text = latex::case(&record(5, (0.21, 1.0), (0.44, 1.0), (0.235, 1.0), (0.09, 2.0))).expect("a table");
    let heading = text.lines().find(|l| l.contains("EOC")).expect("a heading");
    assert!(heading.contains(r"$\sqrt{A(e,e)}$ & EOC & $|u-u_h|$ & EOC & $\|u-u_h\|_0$ & EOC"), "{heading}");
    assert!(!heading.contains(r"\|_1$"), "{heading}");
    let rows: Vec<&str> = text.lines().filter(|l| l.contains("e-0")).collect();
    assert_eq!(rows.len(), 5);
    assert!(rows[0].contains("& -- &") && rows[1].contains("& 1.000 &") && rows[4].ends_with("2.000 \\\\"), "{text}");
    for record in [healthy(), arc(), gap()] {
        assert_eq!(latex::case(&record).as_deref().and_then(complaint), None);
    }
}

#[test]
fn no_levels_no_table() {
    let mut none = healthy();
    none.levels.clear();
    assert_eq!(latex::case(&none), None);
}

/// The grammar can say no: each of these has one defect.
#[test]
fn a_malformed_table_is_told() {
    let good = "\\begin{table}\n  \\begin{tabular}{ll}\n a & $b$ \\\\\n  \\end{tabular}\n\\end{table}\n";
    assert_eq!(complaint(good), None);
    for (old, new, told) in [
        ("a &", "a & c &", "3 cells in 2 columns"),
        ("$b$", "$b", "`$` without `$`"),
        ("a &", "{a &", "`{` without `}`"),
        ("a &", "x_h &", "an index outside mathematics"),
        ("a &", "50 % &", "a character that is a command"),
        ("a &", "√a &", "no font has"),
        ("  \\end{tabular}\n", "", "ends what is not open"),
        ("\\end{table}\n", "", "table is never ended"),
    ] {
        let found = complaint(&good.replacen(old, new, 1)).unwrap_or_default();
        assert!(found.contains(told), "{new}: {found}");
    }
}
