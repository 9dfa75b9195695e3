//! Sections 1 and 2: Falk's splitting and the discrete set of polygons.

use super::{Entry, Standing};
use crate::record::ClaimKind;

/// In the paper's order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry {
        id: "lemma-1-1",
        standing: Standing::NotYet,
        statement: "A(u−u_h, u−u_h) ≤ f(u−v_h) + f(u_h−v) + A(u_h−u, v_h−u) + A(u, v−u_h) + A(u, v_h−u) for all v ∈ K, v_h ∈ K_h",
        hypotheses: &["K and K_h closed and convex"],
        kind: ClaimKind::Inequality,
        norm: "ledger",
        paper: None,
        today: None,
        sources: &["Lemma 1.1, (1.1): Falk's splitting of the error"],
    },
    Entry {
        id: "remark-1-1",
        standing: Standing::NotYet,
        statement: "with v = u_h the terms f(u_h−v) and A(u, v−u_h) of the splitting vanish",
        hypotheses: &["K_h ⊂ K"],
        kind: ClaimKind::Inequality,
        norm: "ledger",
        paper: None,
        today: None,
        sources: &["Remark 1.1, (1.2)"],
    },
    Entry {
        id: "remark-1-3",
        standing: Standing::NotYet,
        statement: "½A(u−u_h, u−u_h) ≤ f(u−v_h) + f(u_h−v) + ½A(v_h−u, v_h−u) + A(u, v−u_h) + A(u, v_h−u) for all v ∈ K, v_h ∈ K_h",
        hypotheses: &["K and K_h closed and convex"],
        kind: ClaimKind::Inequality,
        norm: "ledger",
        paper: None,
        today: None,
        sources: &["Remark 1.3, with A(u,v) ≤ ½A(u,u) + ½A(v,v) in place of the printed equality"],
    },
    Entry {
        id: "lemma-2-1",
        standing: Standing::Landed,
        statement: "K_h ⊂ K: no penetration between the contact nodes",
        hypotheses: &["polygonal bodies", "common nodes on Γ_K", "both constraints at every interior corner of Γ_K"],
        kind: ClaimKind::Inequality,
        norm: "penetration_l2",
        paper: None,
        today: None,
        sources: &["Lemma 2.1, for the discrete set (2.3)"],
    },
];
