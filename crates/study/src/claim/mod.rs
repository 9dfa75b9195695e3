//! The catalogue of claims: statement, hypotheses, the paper's bound, today's bound, sources.

pub mod catalogue;
pub mod hypothesis;
pub mod proof;
pub mod quantity;

use crate::record::{Bounds, ClaimKind};

/// A claim that a study judges.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// Catalogue id, or `own`.
    pub id: String,
    /// One line, e.g. `|u − u_h| ≤ c h`.
    pub statement: String,
    /// What must hold for the claim to apply.
    pub hypotheses: Vec<String>,
    /// How it is judged.
    pub kind: ClaimKind,
    /// The error norm it judges: a field name of [`Errors`](crate::record::Errors), `b_over_h2` for the ledger constant.
    pub norm: String,
    /// The three bounds.
    pub bounds: Bounds,
    /// Where each bound comes from.
    pub sources: Vec<String>,
}
