//! Every claim of the paper by id, in its order, and the laboratory's own.
//!
//! J. Haslinger, I. Hlaváček, *Contact between elastic bodies — II. Finite element analysis*. The bounds are the paper's
//! and today's best; the rate to expect of a solution comes from its regularity and is the study's to state.

mod basics;
mod curved;
mod enlarging;
mod laboratory;
mod polygon;

use crate::claim::Claim;
use crate::nearest::edits;
use crate::record::{Bounds, ClaimKind};
use std::sync::LazyLock;

/// Whether a claim can be put to the test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// A study can judge it.
    Landed,
    /// There is nothing to run of its own: why, and where its content is seen.
    Nothing(&'static str),
}

/// A claim of the catalogue.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Id, e.g. `theorem-3-1`.
    pub id: &'static str,
    /// Whether it can be put to the test.
    pub standing: Standing,
    /// One line.
    pub statement: &'static str,
    /// What must hold for the claim to apply.
    pub hypotheses: &'static [&'static str],
    /// How it is judged.
    pub kind: ClaimKind,
    /// What it judges: a field of [`Errors`](crate::record::Errors), `b_over_h2`, or `ledger`.
    pub norm: &'static str,
    /// The paper's bound on the rate, as a power of `h`.
    pub paper: Option<f64>,
    /// Today's best bound.
    pub today: Option<f64>,
    /// Where statement and bounds come from.
    pub sources: &'static [&'static str],
}

impl Entry {
    /// The claim as a study holds it, without an expected rate.
    pub fn claim(&self) -> Claim {
        Claim {
            id: self.id.into(),
            statement: self.statement.into(),
            hypotheses: self.hypotheses.iter().map(|h| h.to_string()).collect(),
            kind: self.kind,
            norm: self.norm.into(),
            bounds: Bounds { paper: self.paper, today: self.today, expected: None },
            sources: self.sources.iter().map(|s| s.to_string()).collect(),
        }
    }
}

/// An id that the catalogue does not have.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no claim '{id}' in the catalogue; the nearest is '{nearest}'")]
pub struct UnknownClaim {
    /// What was asked for.
    pub id: String,
    /// The id that differs least.
    pub nearest: &'static str,
}

/// All claims: the paper's in its order, then the laboratory's own.
pub fn catalogue() -> &'static [Entry] {
    static ENTRIES: LazyLock<Vec<Entry>> = LazyLock::new(|| {
        [basics::ENTRIES, polygon::ENTRIES, curved::ENTRIES, enlarging::ENTRIES, laboratory::ENTRIES].concat()
    });
    &ENTRIES
}

/// The claim of this id.
///
/// # Errors
/// [`UnknownClaim`] with the nearest id.
pub fn find(id: &str) -> Result<&'static Entry, UnknownClaim> {
    let entries = catalogue();
    entries.iter().find(|e| e.id == id).ok_or_else(|| UnknownClaim {
        id: id.into(),
        nearest: entries.iter().min_by_key(|e| edits(id, e.id)).map_or("", |e| e.id),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Errors;
    use std::collections::BTreeSet;

    #[test]
    fn every_statement_of_the_paper_is_listed_once_and_in_order() {
        let ids: Vec<&str> = catalogue().iter().map(|e| e.id).collect();
        let paper = [
            "lemma-1-1",
            "remark-1-1",
            "remark-1-2",
            "remark-1-3",
            "theorem-1-1",
            "theorem-1-2",
            "remark-1-4",
            "remark-1-5",
            "remark-1-6",
            "lemma-2-1",
            "theorem-3-1",
            "remark-3-1",
            "remark-3-2a",
            "remark-3-2b",
            "remark-3-3",
            "lemma-3-1",
            "theorem-3-2",
            "lemma-3-2",
            "lemma-3-3",
            "lemma-3-4",
            "theorem-3-3",
            "remark-3-4",
            "remark-3-5",
            "remark-3-6",
            "remark-3-7",
            "theorem-3-4",
            "lemma-3-5",
            "lemma-3-6",
            "theorem-3-5",
        ];
        assert_eq!(ids[..paper.len()], paper);
        assert_eq!(ids[paper.len()..], ["corner-patch", "certificate", "many-switches", "two-squares"]);
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
    }

    #[test]
    fn what_can_be_tested_today() {
        let landed: Vec<&str> = catalogue().iter().filter(|e| e.standing == Standing::Landed).map(|e| e.id).collect();
        let expected = [
            "lemma-1-1",
            "remark-1-1",
            "remark-1-3",
            "theorem-1-2",
            "remark-1-6",
            "lemma-2-1",
            "theorem-3-1",
            "remark-3-1",
            "remark-3-2a",
            "remark-3-2b",
            "remark-3-3",
            "lemma-3-1",
            "theorem-3-2",
            "lemma-3-2",
            "lemma-3-3",
            "lemma-3-4",
            "theorem-3-3",
            "remark-3-4",
            "remark-3-5",
            "remark-3-6",
            "remark-3-7",
            "theorem-3-4",
            "lemma-3-5",
            "lemma-3-6",
            "theorem-3-5",
            "corner-patch",
            "certificate",
            "many-switches",
            "two-squares",
        ];
        assert_eq!(landed, expected);
    }

    #[test]
    fn entries_are_complete_and_name_a_quantity_that_exists() {
        for e in catalogue() {
            assert!(!e.statement.is_empty() && !e.sources.is_empty(), "{}", e.id);
            let known = Errors::NORMS.contains(&e.norm)
                || ["b_over_h2", "ledger", "splitting", "constant", "solution_h1", "kkt"].contains(&e.norm);
            assert!(known, "{}: {}", e.id, e.norm);
            let gated = e.paper.or(e.today).is_some();
            assert!(e.kind == ClaimKind::Rate || !gated, "{}: a bound that no rule reads", e.id);
        }
    }

    #[test]
    fn the_bounds_of_the_paper() {
        let paper = |id: &str| find(id).map(|e| e.paper);
        assert_eq!(paper("theorem-3-1"), Ok(Some(1.0)));
        assert_eq!(paper("remark-3-2b"), Ok(Some(0.75)));
        assert_eq!(find("remark-3-2b").unwrap().claim().bounds.today, Some(1.0));
        assert_eq!(paper("theorem-3-3"), Ok(Some(0.75)));
        assert_eq!(paper("theorem-3-2"), Ok(None));
    }

    #[test]
    fn a_misspelt_id_gets_the_nearest() {
        assert_eq!(find("theorem-31").unwrap_err().nearest, "theorem-3-1");
        assert_eq!(find("corner_patch").unwrap_err().nearest, "corner-patch");
    }
}
