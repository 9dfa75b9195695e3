//! What all levels together say: rates, the bounds they are held against, the verdict.

use super::LogAlternative;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A fitted rate, `e ≈ C h^slope`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Rate {
    /// Least-squares slope of `log e` against `log h`.
    pub slope: f64,
    /// Its standard error.
    pub stderr: f64,
    /// Lower end of the 95 % interval (Student t).
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// The levels of the asymptotic window.
    pub levels: Vec<usize>,
    /// `log C`.
    pub intercept: f64,
    /// Coefficient of determination.
    pub r2: f64,
    /// Rates between successive usable levels: `(finer level, rate)`.
    pub pairwise: Vec<(usize, f64)>,
    /// Second difference of the log–log curve: the mean change of the pairwise rate per level in the window.
    pub curvature: f64,
    /// Slope of the same window against `dofs^{-1/2}`.
    pub dofs_slope: f64,
    /// Whether the pairwise rates of the window have settled; if not, the window is the last four levels.
    pub asymptotic: bool,
    /// Fits with a logarithm, where the study calls the regularity borderline.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub log_alternatives: Vec<LogAlternative>,
}

/// What a rate is held against; `None` where there is no such bound.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Bounds {
    /// The paper's.
    pub paper: Option<f64>,
    /// Today's best.
    pub today: Option<f64>,
    /// From the regularity of the solution.
    pub expected: Option<f64>,
}

/// How a claim is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ClaimKind {
    /// The fitted rate against the bound.
    Rate,
    /// An inequality on every level.
    Inequality,
    /// Rounding error on every level.
    Exact,
    /// Errors fall from level to level by a stated factor.
    Convergence,
    /// The largest over the smallest constant of the levels or cases is bounded.
    Bounded,
    /// The difference from a formula is small on the finest level.
    Agreement,
    /// Every solve ends solved, certified, and as another solver ends it.
    Certificate,
}

/// Pass, fail or inconclusive. Ordered from best to worst, so the worst of several is their maximum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// The claim holds as far as the study can see.
    Pass,
    /// The study cannot judge.
    Inconclusive,
    /// The claim is refuted.
    Fail,
}

/// A judgement with its reasons, for the reader.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Verdict {
    /// What came out.
    pub outcome: Outcome,
    /// Why, most important first.
    pub reasons: Vec<String>,
}
