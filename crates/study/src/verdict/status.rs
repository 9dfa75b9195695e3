//! From the verdicts of cases to that of a study and to the exit status of a run.

use crate::record::{Outcome, StudyRecord};

/// Exit status for input that cannot be read or makes no sense.
pub const BAD_INPUT: u8 = 2;

/// What a case counts as. A control passes when it gets what it expects; a control that could not be judged, though it
/// should have been, stays inconclusive; one with any other outcome fails.
pub fn effective(outcome: Outcome, expect: Option<Outcome>) -> Outcome {
    match (outcome, expect) {
        (outcome, None) => outcome,
        (outcome, Some(expected)) if outcome == expected => Outcome::Pass,
        (Outcome::Inconclusive, Some(_)) => Outcome::Inconclusive,
        _ => Outcome::Fail,
    }
}

/// The worst of several outcomes; inconclusive if there are none.
pub fn worst(outcomes: impl IntoIterator<Item = Outcome>) -> Outcome {
    outcomes.into_iter().max().unwrap_or(Outcome::Inconclusive)
}

/// Exit status of a run: 1 if any case fails, else 2 if any is inconclusive where that was not to be expected at these
/// sizes, or if there are no cases; else 0.
pub fn exit_status(records: &[StudyRecord]) -> u8 {
    match worst(records.iter().map(counted)) {
        Outcome::Pass => 0,
        Outcome::Fail => 1,
        Outcome::Inconclusive => 2,
    }
}

fn counted(record: &StudyRecord) -> Outcome {
    match effective(record.verdict.outcome, record.expect) {
        Outcome::Inconclusive if excused(record) => Outcome::Pass,
        outcome => outcome,
    }
}

/// Too small sizes excuse doubt about a rate, not an unfinished solve.
fn excused(record: &StudyRecord) -> bool {
    record.expected_inconclusive.is_some() && record.levels.iter().all(|l| l.solver.solved)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;
    use Outcome::{Fail, Inconclusive, Pass};

    #[test]
    fn a_control_passes_only_with_what_it_expects() {
        let table = [
            (Pass, None, Pass),
            (Fail, None, Fail),
            (Inconclusive, None, Inconclusive),
            (Fail, Some(Fail), Pass),
            (Pass, Some(Fail), Fail),
            (Inconclusive, Some(Fail), Inconclusive),
            (Inconclusive, Some(Inconclusive), Pass),
            (Pass, Some(Inconclusive), Fail),
            (Fail, Some(Inconclusive), Fail),
        ];
        for (outcome, expect, counts_as) in table {
            assert_eq!(effective(outcome, expect), counts_as, "{outcome:?} {expect:?}");
        }
    }

    #[test]
    fn the_worst_case_decides() {
        assert_eq!(worst([Pass, Inconclusive, Pass]), Inconclusive);
        assert_eq!(worst([Pass, Fail, Inconclusive]), Fail);
        assert_eq!(worst([Pass]), Pass);
        assert_eq!(worst([]), Inconclusive);
    }

    fn case(outcome: Outcome, expect: Option<Outcome>, excused: bool) -> StudyRecord {
        let mut record = sample::record("s", "s", Vec::new());
        record.verdict.outcome = outcome;
        record.expect = expect;
        record.expected_inconclusive = excused.then(|| "too coarse".into());
        record
    }

    #[test]
    fn exit_status_by_the_contract() {
        assert_eq!(exit_status(&[]), 2);
        assert_eq!(exit_status(&[case(Pass, None, false), case(Fail, Some(Fail), false)]), 0);
        assert_eq!(exit_status(&[case(Inconclusive, None, false), case(Pass, None, false)]), 2);
        assert_eq!(exit_status(&[case(Inconclusive, None, false), case(Fail, None, false)]), 1);
        assert_eq!(exit_status(&[case(Inconclusive, None, true)]), 0);
        // the excuse covers doubt, never failure
        assert_eq!(exit_status(&[case(Fail, None, true)]), 1);
        let mut unfinished = case(Inconclusive, None, true);
        unfinished.levels = sample::levels(4, |h| h);
        assert_eq!(exit_status(std::slice::from_ref(&unfinished)), 0);
        unfinished.levels[3].solver.solved = false;
        assert_eq!(exit_status(&[unfinished]), 2);
    }
}
