//! Falk's splitting of the error, as an inequality that runs (Lemma 1.1, Remarks 1.1 and 1.3).
//!
//! For the solution `u ∈ K` and the discrete solution `u_h ∈ K_h`, for every `v ∈ K` and every `v_h ∈ K_h`,
//!
//! ```text
//! A(u−u_h, u−u_h) ≤ f(u−v_h) + f(u_h−v) + A(u_h−u, v_h−u) + A(u, v−u_h) + A(u, v_h−u)      (1.1)
//! ```
//!
//! The slack is the sum of the residuals of the two variational inequalities,
//! `A(u, v−u) − f(v−u) ≥ 0` and `A(u_h, v_h−u_h) − f(v_h−u_h) ≥ 0`, so it is zero for `v = u`, `v_h = u_h`, and any field
//! outside its set may turn its sign.

mod fields;
mod forms;
#[cfg(test)]
mod tests;

pub use fields::{Random, opened};
pub use forms::{Forms, dot};

use crate::record::{Estimate, Splitting};
use signorini_contact::Vec2;

/// Whether a study measures the splitting, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SplittingPlan {
    /// Which form of it.
    pub estimate: Estimate,
    /// Seed of the random fields.
    pub seed: u64,
}

/// A field and what it is, in words.
pub struct Named {
    /// E.g. `interpolant`.
    pub kind: &'static str,
    /// Its nodal values; none for the solution `u` itself.
    pub values: Option<Vec<Vec2>>,
}

impl Named {
    /// A field with nodal values.
    pub fn nodal(kind: &'static str, values: Vec<Vec2>) -> Self {
        Self { kind, values: Some(values) }
    }
}

/// The five terms of the right side, in the order of (1.1), and the left side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// `f(u−v_h)`, `f(u_h−v)`, the energy term, `A(u, v−u_h)`, `A(u, v_h−u)`.
    pub terms: [f64; 5],
    /// `A(u−u_h, u−u_h)`, or half of it.
    pub left: f64,
}

impl Sides {
    /// The terms for the nodal fields `u_h`, `v_h`, and `v`, which is `u` itself where there is none. `square` is
    /// `A(u−u_h, u−u_h)`.
    pub fn new(estimate: Estimate, forms: &Forms, u_h: &[Vec2], v: Option<&[Vec2]>, v_h: &[Vec2], square: f64) -> Self {
        let load_u = forms.work - forms.load(v_h);
        let stress_u = forms.stress(v_h) - forms.energy;
        let load_v = forms.load(u_h) - v.map_or(forms.work, |v| forms.load(v));
        let stress_v = v.map_or(forms.energy, |v| forms.stress(v)) - forms.stress(u_h);
        // A(u_h−u, v_h−u) = A(u_h, v_h) − A(u, u_h) − A(u, v_h) + A(u, u)
        let mixed = |a: &[Vec2], b: &[Vec2]| forms.product(a, b) - forms.stress(a) - forms.stress(b) + forms.energy;
        match estimate {
            Estimate::General => Self { terms: [load_u, load_v, mixed(u_h, v_h), stress_v, stress_u], left: square },
            Estimate::Contained => Self { terms: [load_u, 0.0, mixed(u_h, v_h), 0.0, stress_u], left: square },
            Estimate::Halved => {
                Self { terms: [load_u, load_v, 0.5 * mixed(v_h, v_h), stress_v, stress_u], left: 0.5 * square }
            }
        }
    }

    /// The sum of the terms.
    pub fn right(&self) -> f64 {
        self.terms.iter().sum()
    }

    /// `right − left`.
    pub fn slack(&self) -> f64 {
        self.right() - self.left
    }

    /// The entry of a record. `delta` is what the numbers may be off by.
    pub fn record(&self, estimate: Estimate, [v, v_h]: [&str; 2], delta: f64) -> Splitting {
        let [load_u, load_v, energy, stress_v, stress_u] = self.terms;
        let holds = match -self.slack() {
            excess if excess <= delta => Some(true),
            excess if excess <= 10.0 * delta => None,
            // beyond, and NaN
            _ => Some(false),
        };
        let (left, right) = (self.left, self.right());
        let (v, v_h) = (v.into(), v_h.into());
        Splitting { estimate, v, v_h, tried: 1, load_u, load_v, energy, stress_v, stress_u, left, right, delta, holds }
    }
}

/// Of the entries with the same kinds of `v` and `v_h` the one with the least slack, in the order in which the kinds first
/// occur. One that is broken or open goes before one that holds.
pub fn worst_of_each_kind(entries: Vec<Splitting>) -> Vec<Splitting> {
    let mut worst: Vec<Splitting> = Vec::new();
    for entry in entries {
        let Some(known) = worst.iter_mut().find(|w| (&w.v, &w.v_h) == (&entry.v, &entry.v_h)) else {
            worst.push(entry);
            continue;
        };
        let tried = known.tried + entry.tried;
        if rank(&entry) < rank(known) || (rank(&entry) == rank(known) && entry.slack() < known.slack()) {
            *known = entry;
        }
        known.tried = tried;
    }
    worst
}

/// Broken, open, holds.
fn rank(entry: &Splitting) -> u8 {
    match entry.holds {
        Some(false) => 0,
        None => 1,
        Some(true) => 2,
    }
}
