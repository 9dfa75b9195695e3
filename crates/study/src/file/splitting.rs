//! The table that asks for Falk's splitting.

use super::error::{Fault, refuse};
use super::spanned::Spanned;
use crate::claim::Claim;
use crate::record::Estimate;
use crate::splitting::SplittingPlan;
use crate::study::{ReferencePlan, Subject};
use schemars::JsonSchema;
use serde::Deserialize;
use std::ops::Range;

/// `[splitting]`.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RawSplitting {
    /// Which form of the estimate.
    pub estimate: Estimate,
    /// Of the random fields.
    pub seed: u64,
}

/// The norm of claims that judge the splitting.
pub const NORM: &str = "splitting";

/// What is measured. A claim on the splitting needs the table, and the table a contact problem with a reference that the forms
/// can be evaluated for: an exact solution, or a discrete one on a nested mesh.
pub fn splitting(
    raw: Option<&Spanned<RawSplitting>>,
    claim: &Claim,
    subject: &Subject,
    reference: &ReferencePlan,
    is_located: bool,
    place: Range<usize>,
) -> Result<Option<SplittingPlan>, Fault> {
    let Some(raw) = raw else {
        return if claim.norm == NORM {
            let next = "add a table [splitting] with `estimate` and `seed`";
            refuse(place, "the claim judges Falk's splitting, and the case does not measure it", next)
        } else {
            Ok(None)
        };
    };
    let overkill = matches!(reference, ReferencePlan::Overkill { .. });
    let why = match subject {
        Subject::Lemma(_) => "a lemma has no discrete solution to split the error of",
        _ if *reference == ReferencePlan::None => {
            "the splitting speaks of the solution u, and there is no reference for it"
        }
        _ if overkill && is_located => "the reference's mesh is not nested, so its set does not hold the discrete one",
        _ => {
            let RawSplitting { estimate, seed } = *raw.get_ref();
            return Ok(Some(SplittingPlan { estimate, seed }));
        }
    };
    refuse(raw.span(), why, "leave [splitting] out, or give an exact solution or a nested reference")
}
