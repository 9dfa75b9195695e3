//! Section 3, bounded contact zone, polygonal bodies.

use super::{Entry, Standing};
use crate::record::ClaimKind;

const TODAY: &str = "today: O(h^{s−1}) for u ∈ H^s, 3/2 < s ≤ 2, without a condition on the contact set: \
    Drouet and Hild (2015), one body on a rigid support, carried over to matching meshes";

/// In the paper's order.
pub(super) const ENTRIES: &[Entry] = &[
    Entry {
        id: "theorem-3-1",
        standing: Standing::Landed,
        statement: "|u − u_h| ≤ c h {‖u‖²_2 + Σ_i ‖T_n‖_∞ (|u'_n|_{1,∞} + |u''_n|_{1,∞})}^{1/2}",
        hypotheses: &[
            "polygonal bodies, regular family",
            "u ∈ H², τ ∈ Y",
            "T_n ∈ L^∞ and u'_n, u''_n ∈ W^{1,∞} on each segment of Γ_K",
            "finitely many switch points",
        ],
        kind: ClaimKind::Rate,
        norm: "strain",
        paper: Some(1.0),
        today: Some(1.0),
        sources: &["paper: Theorem 3.1, (3.13), by (3.16) and (3.17); T_n ∈ L^∞ is used there, not printed", TODAY],
    },
    Entry {
        id: "remark-3-1",
        standing: Standing::Landed,
        statement: "(3.13) holds for any solution u and any discrete solution u_h, unique or not",
        hypotheses: &["those of Theorem 3.1", "a solution exists (then a discrete one does, since K_h ⊂ K)"],
        kind: ClaimKind::Rate,
        norm: "strain",
        paper: Some(1.0),
        today: None,
        sources: &["Remark 3.1"],
    },
    Entry {
        id: "remark-3-2a",
        standing: Standing::Landed,
        statement: "|u − u_h| = O(h), whatever the number of switch points",
        hypotheses: &[
            "polygonal bodies, regular family",
            "u ∈ H², τ ∈ Y, T_n ∈ L^∞",
            "u'_n, u''_n ∈ H² on each segment of Γ_K",
        ],
        kind: ClaimKind::Rate,
        norm: "strain",
        paper: Some(1.0),
        today: Some(1.0),
        sources: &["paper: Remark 3.2, first part", TODAY],
    },
    Entry {
        id: "remark-3-2b",
        standing: Standing::Landed,
        statement: "|u − u_h| = O(h^{3/4})",
        hypotheses: &["polygonal bodies, regular family", "u ∈ H², τ ∈ Y, nothing on switch points or traces"],
        kind: ClaimKind::Rate,
        norm: "strain",
        paper: Some(0.75),
        today: Some(1.0),
        sources: &["paper: Remark 3.2, second part: a proven floor", TODAY],
    },
    Entry {
        id: "remark-3-3",
        standing: Standing::Landed,
        statement: "‖u − u_h‖_1 = O(h) with bilateral contact on Γ_K0",
        hypotheses: &["those of Theorem 3.1", "the jump of u_n is zero on Γ_K0, which stops all rigid motion"],
        kind: ClaimKind::Rate,
        norm: "h1",
        paper: Some(1.0),
        today: None,
        sources: &["Remark 3.3"],
    },
    Entry {
        id: "lemma-3-1",
        standing: Standing::Landed,
        statement: "every v ∈ K is the limit in H¹ of some v_h ∈ K_h",
        hypotheses: &["those of Theorem 3.2"],
        kind: ClaimKind::Convergence,
        norm: "h1",
        paper: None,
        today: None,
        sources: &["Lemma 3.1"],
    },
    Entry {
        id: "theorem-3-2",
        standing: Standing::Landed,
        statement: "‖u − u_h‖_1 → 0, with no regularity",
        hypotheses: &[
            "polygonal bodies, regular family",
            "L coercive on K, u unique",
            "Γ_K at a positive distance from Γ_u and Γ_0",
            "finitely many points where boundary parts meet",
        ],
        kind: ClaimKind::Convergence,
        norm: "h1",
        paper: None,
        today: None,
        sources: &["Theorem 3.2, by Lemma 3.1"],
    },
];
