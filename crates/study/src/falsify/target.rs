//! What is searched: a claim, the scenes that meet its hypotheses, and what its constant is divided by.

/// A claim under attack.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Theorem 3.1.
    Theorem31,
    /// Remark 3.2, smooth traces and many switch points.
    Remark32a,
    /// Remark 3.2, `u ∈ H²` alone.
    Remark32b,
    /// Theorem 3.3.
    Theorem33,
    /// Theorem 3.4.
    Theorem34,
    /// Lemma 2.1.
    Lemma21,
    /// The term `b` of Theorem 3.1 and the number of switch points.
    ManySwitches,
    /// The ledger's inequality, on the scenes of all three theorems.
    Falk,
    /// Theorem 3.1 on scenes that break its hypotheses: what the search has to find.
    Bent,
}

/// What stands in the summary of a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct About {
    /// The name on the command line.
    pub id: &'static str,
    /// The claim of the catalogue that the drawn studies make; `None`: their own, about the ledger.
    pub claim: Option<&'static str>,
    /// The scenes that are drawn, in words.
    pub scenes: &'static str,
    /// The constant that is measured, as a formula.
    pub constant: &'static str,
    /// The power of `h` of the bound; `None` where no rate is claimed.
    pub power: Option<f64>,
    /// The bound that is proven for the constant, where there is one.
    pub constant_bound: Option<f64>,
}

const RATE_31: &str = "|u−u_h| / (h {‖u‖²_2 + ‖T_n‖_∞ (|u'_n|_{1,∞} + |u''_n|_{1,∞})}^{1/2})";

impl Target {
    /// What `all` stands for: every claim, without the bent one.
    pub const CLAIMS: [Self; 8] = [
        Self::Theorem31,
        Self::Remark32a,
        Self::Remark32b,
        Self::Theorem33,
        Self::Theorem34,
        Self::Lemma21,
        Self::ManySwitches,
        Self::Falk,
    ];

    /// The target of that name.
    pub fn find(id: &str) -> Option<Self> {
        Self::CLAIMS.into_iter().chain([Self::Bent]).find(|t| t.about().id == id)
    }

    /// Name, scenes, constant.
    pub fn about(self) -> About {
        let rate = |id, power, scenes, constant| About {
            id,
            claim: Some(id),
            scenes,
            constant,
            power: Some(power),
            constant_bound: None,
        };
        match self {
            Self::Theorem31 => rate(
                "theorem-3-1",
                1.0,
                "straight zones: traces with up to four switch points, P(k, m), W, R(α) with 1.1 ≤ α < 2",
                RATE_31,
            ),
            Self::Remark32a => rate(
                "remark-3-2a",
                1.0,
                "straight zones: traces with up to six switch points, periodic cells, R(α) with 1.55 ≤ α < 2",
                "|u−u_h| / (h {‖u‖²_2 + ‖T_n‖_0 (|u'_n|_{2,Γ} + |u''_n|_{2,Γ})}^{1/2})",
            ),
            Self::Remark32b => rate(
                "remark-3-2b",
                0.75,
                "straight zones: W, R(α) with 1.1 ≤ α < 2, shrinking tiles, traces",
                "|u−u_h| / (h^{3/4} {‖u‖²_2 + ‖T_n‖_0 ‖u‖_2}^{1/2})",
            ),
            Self::Theorem33 => rate(
                "theorem-3-3",
                0.75,
                "a quarter of the unit circle, strongly regular families: traces with up to two switch points, arcR(α)",
                "|u−u_h| / (h^{3/4} {‖u‖²_2 + ‖T_n‖_0 (‖u‖_2 + ‖u_h‖_1)}^{1/2})",
            ),
            Self::Theorem34 => rate(
                "theorem-3-4",
                1.0,
                "two graphs with a gap, cubic polynomials: traces with up to two switch points, graphR(α)",
                "|u−u_h| / (h {‖u‖²_2 + ‖T_ξ‖_∞ (|u'_ξ|_{1,∞} + |u''_ξ|_{1,∞} + |ε|_{1,∞} + |ε|_{2,∞})}^{1/2})",
            ),
            Self::Lemma21 => About {
                id: "lemma-2-1",
                claim: Some("lemma-2-1"),
                scenes: "polygonal zones with up to two corners, random loads, no exact solution",
                constant: "‖([u_h]_n)_+‖_0 / (max|u_h| |Γ_K|^{1/2})",
                power: None,
                constant_bound: Some(crate::rate::ROUNDING),
            },
            Self::ManySwitches => About {
                id: "many-switches",
                claim: Some("many-switches"),
                scenes: "straight zones: traces with one to six switch points",
                constant: "b / (h² N ‖T_n‖_∞ |[u]_n|_{1,∞}), N switch points",
                power: None,
                constant_bound: Some(1.0),
            },
            Self::Falk => About {
                id: "falk",
                claim: None,
                scenes: "those of Theorems 3.1, 3.3 and 3.4 in turn",
                constant: "½A(e,e) / (a + b + c)",
                power: None,
                constant_bound: Some(1.0),
            },
            Self::Bent => About {
                id: "bent-theorem-3-1",
                claim: Some("theorem-3-1"),
                scenes: "hypotheses broken on purpose: R(α) with 0.4 ≤ α ≤ 0.8, u ∉ H²; must be found out",
                constant: RATE_31,
                power: Some(1.0),
                constant_bound: None,
            },
        }
    }
}
