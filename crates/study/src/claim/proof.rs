//! What the proofs claim of each term of their ledger: an exponent of `h`, and where it is shown.
//!
//! The theorem's rate is half the smallest exponent of a square. Which proof a ledger belongs to is read off its parts:
//! an arc and a gap have their own ([`Ledger::PARTS`]), a polygon has none.

use crate::record::{Ledger, StudyRecord};

/// A term of a ledger and what is proven of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proven {
    /// `lhs`, `a`, `b`, `c`, or one of [`Ledger::PARTS`].
    pub term: &'static str,
    /// The term is `O(h^exponent)`.
    pub exponent: f64,
    /// Where that is shown.
    pub source: &'static str,
}

const fn proven(term: &'static str, exponent: f64, source: &'static str) -> Proven {
    Proven { term, exponent, source }
}

/// The rate of `u ∈ H²`, less rounding.
const FULL_RATE: f64 = 1.0 - 1e-9;

/// Theorem 3.1.
const POLYGON: &[Proven] =
    &[proven("lhs", 2.0, "Theorem 3.1, (3.13)"), proven("a", 2.0, "(3.16)"), proven("b", 2.0, "(3.17), switch sides")];

/// Remark 3.2 (b): nothing is known of the switch points.
const POLYGON_WEAK: &[Proven] = &[
    proven("lhs", 1.5, "Remark 3.2 (b)"),
    proven("a", 2.0, "(3.16)"),
    proven("b", 1.5, "Remark 3.2 (b), traces in H^{3/2}"),
];

/// Theorem 3.3.
const ARC: &[Proven] = &[
    proven("lhs", 1.5, "Theorem 3.3, (3.30)"),
    proven("a", 2.0, "(3.16)"),
    proven("b", 1.5, "(3.31), by Lemma 3.2"),
    proven("c", 1.5, "(3.39), by (3.38)"),
    proven("trace_interpolation", 1.5, "Lemma 3.2, (3.28)"),
    proven("jump_minus_chord", 1.5, "(3.34)"),
    proven("nodal_minus_chord", 1.5, "(3.37)"),
    proven("nodal_minus_jump", 1.5, "(3.38), from (3.34) and (3.37)"),
];

/// Theorem 3.4.
const GAP: &[Proven] = &[
    proven("lhs", 2.0, "Theorem 3.4"),
    proven("a", 2.0, "(3.40)"),
    proven("b", 2.0, "(3.41) and (3.43)"),
    proven("c", 2.0, "(3.45)"),
    proven("b_gap", 2.0, "(3.41)"),
    proven("b_switch", 2.0, "(3.43)"),
    proven("gap_interpolation", 2.0, "(3.45), c h² |ε|_2"),
];

/// What the proof behind a record's ledger claims, term by term; empty where there is no ledger, or one that belongs to
/// no proof of the paper (a curved zone against a discrete reference, a solution that is known not to be in `H²`).
pub fn proven_terms(record: &StudyRecord) -> &'static [Proven] {
    let Some((level, ledger)) = record.levels.iter().find_map(|l| Some((l, l.ledger.as_ref()?))) else {
        return &[];
    };
    if record.bounds.expected.is_some_and(|rate| rate < FULL_RATE) {
        // the solution is rougher than any of the proofs asks for
        &[]
    } else if ledger.parts.contains_key("gap_interpolation") {
        GAP
    } else if ledger.parts.contains_key("jump_minus_chord") {
        ARC
    } else if level.straight_over_chord.is_some() {
        &[]
    } else if record.claim == "remark-3-2b" {
        POLYGON_WEAK
    } else {
        POLYGON
    }
}

/// What is proven of one term of a record's ledger.
pub fn proven_term(record: &StudyRecord, term: &str) -> Option<&'static Proven> {
    proven_terms(record).iter().find(|p| p.term == term)
}

/// Words for a term of the ledger: `½A(e,e)`, the letter of the estimate, or the symbol of a part.
pub fn term_words(term: &str) -> &str {
    match Ledger::PARTS.iter().find(|(name, _)| *name == term) {
        Some((_, symbol)) => symbol,
        None if term == "lhs" => "½A(e,e)",
        None => term,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::catalogue::find;
    use crate::sample;

    /// A record of this claim whose levels have these parts.
    fn record(claim: &str, parts: &[&str]) -> StudyRecord {
        let mut levels = sample::levels(4, |h| h);
        let parts: std::collections::BTreeMap<String, f64> = parts.iter().map(|p| (p.to_string(), 0.1)).collect();
        for level in &mut levels {
            level.ledger =
                Some(Ledger { lhs: 0.1, a: 0.1, b: 0.1, c: 0.0, parts: parts.clone(), delta: 0.0, holds: None });
        }
        StudyRecord { claim: claim.into(), ..sample::record("s", "s", levels) }
    }

    #[test]
    fn the_terms_of_a_proof_give_the_rate_of_its_theorem() {
        for (claim, parts) in [
            ("theorem-3-1", &[][..]),
            ("remark-3-2b", &[]),
            ("theorem-3-3", &["jump_minus_chord"]),
            ("theorem-3-4", &["gap_interpolation"]),
        ] {
            let record = record(claim, parts);
            let squares = ["a", "b", "c"].iter().filter_map(|t| proven_term(&record, t));
            let smallest = squares.map(|p| p.exponent).fold(f64::INFINITY, f64::min);
            assert_eq!(proven_term(&record, "lhs").map(|p| p.exponent), Some(smallest), "{claim}");
            assert_eq!(find(claim).unwrap().paper, Some(0.5 * smallest), "{claim}");
        }
    }

    #[test]
    fn every_part_is_proven_once() {
        for (name, symbol) in Ledger::PARTS {
            let found = [ARC, GAP].concat().iter().filter(|p| p.term == name).count();
            assert_eq!((found, term_words(name)), (1, symbol), "{name}");
        }
        assert_eq!((term_words("lhs"), term_words("b")), ("½A(e,e)", "b"));
    }

    #[test]
    fn no_ledger_and_no_proof_claim_nothing() {
        assert!(proven_terms(&sample::record("s", "s", sample::levels(4, |h| h))).is_empty());
        let mut rough = record("own", &[]);
        rough.bounds.expected = Some(0.711);
        assert!(proven_terms(&rough).is_empty());
        let mut curved = record("own", &[]);
        assert_eq!(proven_terms(&curved), POLYGON);
        curved.levels.iter_mut().for_each(|l| l.straight_over_chord = Some(0.9));
        assert!(proven_terms(&curved).is_empty());
    }
}
