//! Claims that the paper's definitions imply and that sharpen the look at its theorems.

use super::{Entry, Standing};
use crate::record::ClaimKind;

/// In the order of the studies.
pub(super) const ENTRIES: &[Entry] = &[
    Entry {
        id: "corner-patch",
        standing: Standing::Landed,
        statement: "with both constraints at a corner of Γ_K a piecewise linear solution is reproduced, u_h = u",
        hypotheses: &["polygonal bodies, common nodes on Γ_K", "u ∈ V_h ∩ K"],
        kind: ClaimKind::Exact,
        norm: "energy",
        paper: None,
        today: None,
        sources: &[
            "the discrete set (2.3): two normals at a corner. With one normal, or a mean of the two, u ∉ K_h or T_n is wrong, though O(h) remains",
        ],
    },
    Entry {
        id: "certificate",
        standing: Standing::Landed,
        statement: "every solve ends, with a clean KKT certificate, and another solver finds the same energy and the same contact",
        hypotheses: &[
            "a solution exists",
            "bounds on residuals grow with the number of unknowns and with the cancellation in the energy",
        ],
        kind: ClaimKind::Certificate,
        norm: "kkt",
        paper: None,
        today: None,
        sources: &[
            "the discrete problem has exactly one solution wherever f(y) < 0 for every rigid motion y that contact alone stops",
        ],
    },
    Entry {
        id: "many-switches",
        standing: Standing::Landed,
        statement: "b ≤ c h² with c independent of h and of the number N of switch points, while ‖T_n‖_∞ |u_n|_{1,∞} N is fixed",
        hypotheses: &["those of Theorem 3.1", "finitely many switch points, N of them in scaled copies of one cell"],
        kind: ClaimKind::Bounded,
        norm: "b_over_h2",
        paper: None,
        today: None,
        sources: &["Theorem 3.1, (3.17): b lives on the sides that hold a switch point"],
    },
    Entry {
        id: "two-squares",
        standing: Standing::Landed,
        statement: "‖u − u_h‖_A falls from level to level for two squares pressed together; no rate is claimed",
        hypotheses: &["polygonal bodies, regular family", "L coercive on K"],
        kind: ClaimKind::Convergence,
        norm: "energy",
        paper: None,
        today: None,
        sources: &["Theorem 3.2 in spirit: corners and changes of boundary condition limit the regularity"],
    },
];
