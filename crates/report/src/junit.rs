//! A run as JUnit XML, as services of continuous integration read it: a suite per study, a test case per case.

use crate::drift::CaseDrift;
use crate::error::ReportError;
use crate::summary::name;
use crate::verdict::{self, Standing};
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};
use signorini_study::record::{Outcome, StudyRecord};
use std::time::Duration;

/// A case of a run, as a gate sees it.
#[derive(Clone, Debug)]
pub struct Judged<'a> {
    /// The record.
    pub record: &'a StudyRecord,
    /// Its seconds, the sum over all phases of its levels and its reference.
    pub seconds: f64,
    /// What drifted from the baseline.
    pub drift: &'a CaseDrift,
}

/// The report of a run. A gate that failed is a `failure`; what could not be judged an `error`; inconclusive as announced at
/// this size is `skipped`; drift is a `failure` with `strict` and a line of output without.
///
/// # Errors
/// [`ReportError::Junit`] if the XML cannot be written.
pub fn junit(cases: &[Judged<'_>], strict: bool) -> Result<String, ReportError> {
    let mut report = Report::new("signorini");
    for study in cases.chunk_by(|a, b| a.record.study == b.record.study) {
        let mut suite = TestSuite::new(study[0].record.study.as_str());
        suite.set_time(seconds(study));
        suite.add_test_cases(study.iter().map(|case| test_case(case, strict)));
        report.add_test_suite(suite);
    }
    report.set_time(seconds(cases));
    written(&report)
}

/// The report of a run that bad input stopped: one `error`.
///
/// # Errors
/// [`ReportError::Junit`] if the XML cannot be written.
pub fn junit_of_bad_input(message: &str) -> Result<String, ReportError> {
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
    status.set_type("bad input").set_message(message.lines().next().unwrap_or_default()).set_description(message);
    let mut suite = TestSuite::new("signorini");
    suite.add_test_case(TestCase::new("input", status));
    let mut report = Report::new("signorini");
    report.add_test_suite(suite);
    written(&report)
}

fn written(report: &Report) -> Result<String, ReportError> {
    report.to_string().map_err(|e| ReportError::Junit(e.to_string()))
}

fn seconds(cases: &[Judged<'_>]) -> Duration {
    cases.iter().map(|c| duration(c.seconds)).sum()
}

/// No seconds where they are none.
fn duration(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or_default()
}

fn test_case(judged: &Judged<'_>, strict: bool) -> TestCase {
    let record = judged.record;
    let lines: Vec<String> = judged.drift.1.iter().map(|d| format!("drift from the baseline: {d}")).collect();
    let mut case = TestCase::new(record.case.as_str(), status(record, if strict { &lines } else { &[] }));
    case.set_classname(record.study.as_str()).set_time(duration(judged.seconds));
    let words = format!("{}: {}: {}", name(record), verdict::words(record), record.verdict.reasons.join("; "));
    case.set_system_out([vec![words], lines].concat().join("\n"));
    case
}

/// The status by the verdict, read against what a control expects; `drift` turns a pass.
fn status(record: &StudyRecord, drift: &[String]) -> TestCaseStatus {
    let (kind, ty) = match verdict::standing(record) {
        Standing::Plain(Outcome::Fail) => (NonSuccessKind::Failure, "fail"),
        Standing::ControlMissed => (NonSuccessKind::Failure, "control missed"),
        Standing::Plain(Outcome::Inconclusive) => (NonSuccessKind::Error, "inconclusive"),
        Standing::Plain(Outcome::Pass) | Standing::ControlMet | Standing::ExpectedInconclusive if !drift.is_empty() => {
            return non_success(NonSuccessKind::Failure, "drift", &drift[0], &drift.join("\n"));
        }
        Standing::Plain(Outcome::Pass) | Standing::ControlMet => return TestCaseStatus::success(),
        Standing::ExpectedInconclusive => {
            let mut skipped = TestCaseStatus::skipped();
            skipped.set_message(verdict::why(record));
            return skipped;
        }
    };
    let why = verdict::why(record);
    let description = [vec![why.clone()], drift.to_vec()].concat().join("\n");
    non_success(kind, ty, &format!("{}: {why}", verdict::words(record)), &description)
}

fn non_success(kind: NonSuccessKind, ty: &str, message: &str, description: &str) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(kind);
    status.set_type(ty).set_message(message).set_description(description);
    status
}
