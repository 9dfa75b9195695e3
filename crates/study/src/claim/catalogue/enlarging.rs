//! Section 3, enlarging contact zone.

use super::{Entry, Standing};
use crate::record::ClaimKind;

/// In the paper's order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry {
        id: "theorem-3-4",
        standing: Standing::Landed,
        statement: "|u − u_h| ≤ c(u) h with isoparametric elements along both graphs",
        hypotheses: &[
            "f', f'' ∈ C²",
            "u ∈ H² ∩ K_ε, τ ∈ Y, T ∈ L^∞",
            "u', u'' ∈ W^{1,∞} on the contact zone",
            "finitely many switch points",
        ],
        kind: ClaimKind::Rate,
        norm: "strain",
        paper: Some(1.0),
        today: None,
        sources: &["Theorem 3.4, by (3.40), (3.41), (3.43) and (3.45), the last with c h² |ε|_2"],
    },
    Entry {
        id: "lemma-3-5",
        standing: Standing::Landed,
        statement: "every v ∈ K_ε is the limit in H¹ of some v_h ∈ K_εh",
        hypotheses: &["those of Theorem 3.5"],
        kind: ClaimKind::Convergence,
        norm: "h1",
        paper: None,
        today: None,
        sources: &["Lemma 3.5"],
    },
    Entry {
        id: "lemma-3-6",
        standing: Standing::Landed,
        statement: "if nodal constraints hold and the traces converge almost everywhere, the limit satisfies the constraint",
        hypotheses: &["those of Theorem 3.5"],
        kind: ClaimKind::Convergence,
        norm: "penetration_l2",
        paper: None,
        today: None,
        sources: &["Lemma 3.6"],
    },
    Entry {
        id: "theorem-3-5",
        standing: Standing::Landed,
        statement: "‖u − u_h‖_1 → 0, with no regularity",
        hypotheses: &[
            "f', f'' ∈ C³",
            "u unique, ‖u_h‖ bounded",
            "Γ_K away from Γ_u and Γ_0",
            "u''_ξ − u'_ξ < ε near the ends of the zone",
        ],
        kind: ClaimKind::Convergence,
        norm: "h1",
        paper: None,
        today: None,
        sources: &["Theorem 3.5, by Lemmas 3.5 and 3.6"],
    },
];
