//! `summary.json`: one row per case.

use super::{StoreError, read_json, write_json};
use crate::record::{Outcome, StudyRecord};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A case in one row. Rates and bounds are those of the norm that the claim judges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SummaryRow {
    /// Study id.
    pub study: String,
    /// Case name.
    pub case: String,
    /// Claim id.
    pub claim: String,
    /// Family of triangulations.
    pub family: String,
    /// `exact`, `overkill` or `none`.
    pub reference: String,
    /// The norm that the claim judges.
    pub norm: String,
    /// Observed rate.
    pub rate: Option<f64>,
    /// Lower end of its interval.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
    /// The paper's bound.
    pub paper: Option<f64>,
    /// Today's bound.
    pub today: Option<f64>,
    /// The rate expected from the regularity.
    pub expected: Option<f64>,
    /// What came out.
    pub outcome: Outcome,
    /// What a control expects.
    pub expect: Option<Outcome>,
    /// Why an inconclusive verdict is expected at this profile's sizes.
    pub expected_inconclusive: Option<String>,
    /// Why, most important first.
    pub reasons: Vec<String>,
}

impl From<&StudyRecord> for SummaryRow {
    fn from(r: &StudyRecord) -> Self {
        let rate = r.rates.get(&r.norm);
        Self {
            study: r.study.clone(),
            case: r.case.clone(),
            claim: r.claim.clone(),
            family: r.family.clone(),
            reference: r.reference.name().into(),
            norm: r.norm.clone(),
            rate: rate.map(|f| f.slope),
            low: rate.map(|f| f.low),
            high: rate.map(|f| f.high),
            paper: r.bounds.paper,
            today: r.bounds.today,
            expected: r.bounds.expected,
            outcome: r.verdict.outcome,
            expect: r.expect,
            expected_inconclusive: r.expected_inconclusive.clone(),
            reasons: r.verdict.reasons.clone(),
        }
    }
}

/// Writes `summary.json` in `folder`, a row per record in the order given, and returns the file.
///
/// # Errors
/// [`StoreError`] where a number is not finite or the file cannot be written.
pub fn write_summary(folder: &Path, records: &[StudyRecord]) -> Result<PathBuf, StoreError> {
    let rows: Vec<SummaryRow> = records.iter().map(SummaryRow::from).collect();
    let path = folder.join("summary.json");
    write_json(&path, &rows)?;
    Ok(path)
}

/// Reads `summary.json` of `folder`.
///
/// # Errors
/// [`StoreError`] where there is none or it is malformed.
pub fn read_summary(folder: &Path) -> Result<Vec<SummaryRow>, StoreError> {
    read_json(&folder.join("summary.json"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;
    use crate::store::scratch::Scratch;

    #[test]
    fn one_row_per_case_with_the_judged_rate() {
        let scratch = Scratch::new("summary");
        let fitted = sample::record("a", "a", sample::levels(5, |h| h));
        let mut unfitted = sample::record("b", "structured", sample::levels(2, |h| h));
        unfitted.verdict.outcome = Outcome::Inconclusive;
        unfitted.expect = Some(Outcome::Inconclusive);
        unfitted.expected_inconclusive = Some("two levels".into());
        write_summary(&scratch.0, &[fitted.clone(), unfitted]).unwrap();
        let rows = read_summary(&scratch.0).unwrap();
        assert_eq!(rows.len(), 2);
        assert_eq!(rows[0].rate, Some(fitted.rates["strain"].slope));
        assert_eq!((rows[0].reference.as_str(), rows[0].paper), ("exact", Some(1.0)));
        assert_eq!((rows[1].case.as_str(), rows[1].rate, rows[1].low), ("structured", None, None));
        assert_eq!((rows[1].outcome, rows[1].expect), (Outcome::Inconclusive, Some(Outcome::Inconclusive)));
        assert_eq!(rows[1].expected_inconclusive.as_deref(), Some("two levels"));
    }
}
