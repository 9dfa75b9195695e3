//! A verdict in words, read against what a control expects.

use signorini_study::record::{Outcome, StudyRecord};

/// How a case stands once its own expectation is taken into account.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// No expectation: the verdict itself.
    Plain(Outcome),
    /// A control that got the verdict it was built for.
    ControlMet,
    /// A control that got another one.
    ControlMissed,
    /// Inconclusive, and announced as such at this profile's sizes.
    ExpectedInconclusive,
}

/// How the case stands.
pub fn standing(record: &StudyRecord) -> Standing {
    let outcome = record.verdict.outcome;
    match record.expect {
        Some(expect) if expect == outcome => Standing::ControlMet,
        Some(_) => Standing::ControlMissed,
        None if outcome == Outcome::Inconclusive && record.expected_inconclusive.is_some() => {
            Standing::ExpectedInconclusive
        }
        None => Standing::Plain(outcome),
    }
}

/// `pass`, `fail`, `inconclusive`.
pub fn outcome_word(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Pass => "pass",
        Outcome::Fail => "fail",
        Outcome::Inconclusive => "inconclusive",
    }
}

/// The verdict with its expectation: `fail (wanted)` of a control, `inconclusive (ok)` where announced.
pub fn words(record: &StudyRecord) -> String {
    let outcome = outcome_word(record.verdict.outcome);
    match (standing(record), record.expect) {
        (Standing::ControlMet, _) => format!("{outcome} (wanted)"),
        (Standing::ControlMissed, Some(expect)) => {
            format!("{outcome} (wanted {})", outcome_word(expect))
        }
        (Standing::ExpectedInconclusive, _) => format!("{outcome} (ok)"),
        _ => outcome.into(),
    }
}

/// Whether a reader of the summary is owed the reasons.
pub fn needs_reason(record: &StudyRecord) -> bool {
    !matches!(standing(record), Standing::Plain(Outcome::Pass) | Standing::ControlMet)
}

/// The reasons in one line.
pub fn why(record: &StudyRecord) -> String {
    let mut reasons = record.verdict.reasons.clone();
    if standing(record) == Standing::ExpectedInconclusive {
        let announced = record.expected_inconclusive.iter();
        reasons.extend(announced.map(|why| format!("expected at this size: {why}")));
    }
    if reasons.is_empty() { "no reason recorded".into() } else { reasons.join("; ") }
}

/// `14 cases: 12 pass, 1 fail, 1 inconclusive; 3 of 3 controls met`
pub fn counts(records: &[StudyRecord]) -> String {
    let count = |wanted: Standing| records.iter().filter(|r| standing(r) == wanted).count();
    let plain = |outcome| count(Standing::Plain(outcome));
    let expected = count(Standing::ExpectedInconclusive);
    let mut out = format!(
        "{} case{}: {} pass, {} fail, {} inconclusive",
        records.len(),
        if records.len() == 1 { "" } else { "s" },
        plain(Outcome::Pass),
        plain(Outcome::Fail),
        plain(Outcome::Inconclusive) + expected,
    );
    if expected > 0 {
        out += &format!(" ({expected} expected at this size)");
    }
    let (met, missed) = (count(Standing::ControlMet), count(Standing::ControlMissed));
    if met + missed > 0 {
        out += &format!("; {met} of {} control{} met", met + missed, if met + missed == 1 { "" } else { "s" });
    }
    out
}
