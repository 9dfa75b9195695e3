//! Falk's splitting on one level, as a record holds it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which form of the estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Estimate {
    /// Lemma 1.1, (1.1), for every `v ∈ K`.
    #[serde(rename = "lemma-1-1")]
    General,
    /// Remark 1.1, (1.2), with `v = u_h`, where `K_h ⊂ K`.
    #[serde(rename = "remark-1-1")]
    Contained,
    /// Remark 1.3, with halves of squares in place of the mixed term.
    #[serde(rename = "remark-1-3")]
    Halved,
}

impl Estimate {
    /// The estimate in letters.
    pub fn formula(self) -> &'static str {
        match self {
            Self::General => "A(u−uₕ,u−uₕ) ≤ f(u−vₕ) + f(uₕ−v) + A(uₕ−u,vₕ−u) + A(u,v−uₕ) + A(u,vₕ−u)",
            Self::Contained => "A(u−uₕ,u−uₕ) ≤ f(u−vₕ) + A(uₕ−u,vₕ−u) + A(u,vₕ−u)",
            Self::Halved => "½A(u−uₕ,u−uₕ) ≤ f(u−vₕ) + f(uₕ−v) + ½A(vₕ−u,vₕ−u) + A(u,v−uₕ) + A(u,vₕ−u)",
        }
    }
}

/// The estimate for one kind of `v ∈ K` and one of `v_h ∈ K_h`; of several random fields the pair with the least slack.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Splitting {
    /// Which form.
    pub estimate: Estimate,
    /// What `v` is.
    pub v: String,
    /// What `v_h` is.
    pub v_h: String,
    /// How many pairs were tried.
    pub tried: usize,
    /// `f(u − v_h)`.
    pub load_u: f64,
    /// `f(u_h − v)`, zero in (1.2).
    pub load_v: f64,
    /// `A(u_h − u, v_h − u)`, or `½A(v_h − u, v_h − u)` in Remark 1.3.
    pub energy: f64,
    /// `A(u, v − u_h)`, zero in (1.2).
    pub stress_v: f64,
    /// `A(u, v_h − u)`.
    pub stress_u: f64,
    /// The left side.
    pub left: f64,
    /// The sum of the five terms.
    pub right: f64,
    /// What quadrature, the algebraic error and rounding may make of `right − left`.
    pub delta: f64,
    /// `true`: holds; `false`: broken beyond `10 δ`; `None`: within `10 δ`.
    pub holds: Option<bool>,
}

impl Splitting {
    /// `right − left`, not negative where the estimate holds.
    pub fn slack(&self) -> f64 {
        self.right - self.left
    }
}
