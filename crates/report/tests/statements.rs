//! The page that goes through the paper statement by statement.

mod common;

use common::healthy;
use signorini_report::statements_markdown;
use signorini_study::claim::catalogue::{Standing, catalogue};
use signorini_study::record::{Outcome, StudyRecord};

/// A case of `study` that judges `claim`, its strain rate moved to `slope`.
fn case(claim: &str, study: &str, case: &str, slope: f64) -> StudyRecord {
    let mut record =
        StudyRecord { claim: claim.into(), study: study.into(), case: case.into(), several: true, ..healthy() };
    let rate = record.rates.get_mut("strain").expect("a strain rate");
    (rate.slope, rate.low, rate.high) = (slope, slope - 0.01, slope + 0.01);
    record
}

fn row<'a>(page: &'a str, id: &str) -> &'a str {
    page.lines().find(|l| l.starts_with(&format!("| {id} |"))).unwrap_or_else(|| panic!("no {id} in\n{page}"))
}

#[test]
fn every_statement_has_its_row_even_without_a_record() {
    let page = statements_markdown(&[]);
    for entry in catalogue() {
        let row = row(&page, entry.id);
        match entry.standing {
            Standing::Landed => assert!(row.contains("not in this run"), "{row}"),
            Standing::Nothing(why) => assert!(row.contains(&why.replace('|', "\\|")), "{row}"),
        }
    }
    assert!(!page.contains("themselves"), "{page}");
}

#[test]
fn the_cases_of_a_study_stand_in_one_row() {
    let mut doubtful = case("theorem-3-1", "waves", "b", 1.05);
    doubtful.verdict.outcome = Outcome::Inconclusive;
    let page = statements_markdown(&[case("theorem-3-1", "waves", "a", 0.98), doubtful]);
    let row = row(&page, "theorem-3-1");
    assert!(row.contains("[waves](summary.md), 2 cases"), "{row}");
    assert!(row.contains("0.980–1.050 [0.970, 1.060]"), "{row}");
    assert!(row.contains("1 pass, 1 inconclusive"), "{row}");
}

#[test]
fn two_studies_of_one_statement_have_two_rows() {
    let page = statements_markdown(&[case("theorem-3-1", "waves", "a", 0.98), case("theorem-3-1", "edges", "a", 1.0)]);
    assert_eq!(page.lines().filter(|l| l.starts_with("| theorem-3-1 |")).count(), 2, "{page}");
}

#[test]
fn controls_judge_no_statement_and_own_claims_stand_apart() {
    let control = StudyRecord { expect: Some(Outcome::Fail), ..case("theorem-3-1", "wrong", "a", 0.3) };
    let page = statements_markdown(&[control, case("own", "mine", "a", 0.99)]);
    assert!(row(&page, "theorem-3-1").contains("not in this run"), "{page}");
    let own = page.split("## Claims that studies state themselves").nth(1).expect("a second table");
    assert!(row(own, "own").contains("mine"), "{own}");
    assert!(!page.contains("wrong"), "{page}");
}
