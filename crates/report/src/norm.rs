//! The error norms a record may hold: their keys, words, symbols and values.

use signorini_study::rate::is_rounding;
use signorini_study::record::{Level, Rate, StudyRecord};

/// One error norm, or another measured quantity that a claim judges.
#[derive(Clone, Copy, Debug)]
pub struct Norm {
    /// Key in `errors` and `rates`.
    pub key: &'static str,
    /// Short words.
    pub words: &'static str,
    /// Symbol, `e = u − uₕ`.
    pub symbol: &'static str,
    value: fn(&Level) -> Option<f64>,
}

impl Norm {
    /// The value on one level; `None` where there is none.
    pub fn value(&self, level: &Level) -> Option<f64> {
        (self.value)(level)
    }

    /// `strain |u−uₕ|`
    pub fn label(&self) -> String {
        format!("{} {}", self.words, self.symbol)
    }
}

macro_rules! errors_field {
    ($key:literal, $words:literal, $symbol:literal, $field:ident) => {
        Norm { key: $key, words: $words, symbol: $symbol, value: |level| level.errors.$field }
    };
}

/// How far a fitted rate can be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trust {
    /// The pairwise rates of its window have settled.
    Settled,
    /// They still drift: the rate may yet change.
    Drifting,
    /// The errors scatter so much that the slope says nothing.
    Scattered,
}

/// Half a 95 % interval above this leaves no rate to speak of.
const SCATTER: f64 = 0.5;

impl Trust {
    /// Of a fitted rate.
    pub fn of(rate: &Rate) -> Self {
        if rate.high - rate.low > 2.0 * SCATTER {
            Self::Scattered
        } else if rate.asymptotic {
            Self::Settled
        } else {
            Self::Drifting
        }
    }

    /// Why the rate is no firm one.
    pub fn remark(self) -> Option<&'static str> {
        match self {
            Self::Settled => None,
            Self::Drifting => Some("not asymptotic, its pairwise rates still drift"),
            Self::Scattered => Some("the errors scatter, the 95 % interval is wider than ±0.5"),
        }
    }
}

/// Every norm, in the order of tables and legends.
pub const NORMS: [Norm; 17] = [
    errors_field!("strain", "strain", "|u−uₕ|", strain),
    errors_field!("energy", "energy", "√A(e,e)", energy),
    errors_field!("h1", "H¹", "‖u−uₕ‖₁", h1),
    errors_field!("l2", "L²", "‖u−uₕ‖₀", l2),
    errors_field!("pressure_l2", "pressure L²", "‖p−pₕ‖₀", pressure_l2),
    errors_field!("pressure_dual", "pressure, dual", "‖p−pₕ‖₋½", pressure_dual),
    errors_field!("penetration_l2", "penetration", "‖([uₕ]ₙ)₊‖₀", penetration_l2),
    errors_field!("contact_set", "contact set", "|C △ Cₕ|", contact_set),
    errors_field!("energy_gap", "energy gap", "L(uₕ)−L(u)", energy_gap),
    errors_field!("interpolation", "interpolation", "√A(u−u_I,u−u_I)", interpolation),
    errors_field!("boundary_l2", "boundary L²", "‖u−u_I‖₀ on ∂Ω", boundary_l2),
    errors_field!("constant", "constant", "c", constant),
    errors_field!("half_width", "half width", "aₕ/a − 1", half_width),
    errors_field!("peak_pressure", "peak pressure", "max pₕ/p₀ − 1", peak_pressure),
    errors_field!("force", "force", "Σλ/P − 1", force),
    Norm {
        key: "formula",
        words: "difference from the formula",
        symbol: "(largest)",
        value: |level| level.errors.size("formula"),
    },
    Norm { key: "b_over_h2", words: "constant", symbol: "b/h²", value: b_over_h2 },
];

/// The norm of that key, if the catalogue has it.
pub fn norm(key: &str) -> Option<&'static Norm> {
    NORMS.iter().find(|n| n.key == key)
}

/// Words for a key; the key itself where the catalogue does not know it.
pub fn words(key: &str) -> String {
    norm(key).map_or_else(|| key.to_string(), Norm::label)
}

/// Short words for a key, without the symbol.
pub fn short_words(key: &str) -> String {
    norm(key).map_or(key, |n| n.words).to_string()
}

/// The fitted rates with their keys, in the order of [`NORMS`]; then `dofs`, and what the catalogue does not know.
pub fn rates_in_order(record: &StudyRecord) -> Vec<(&str, &Rate)> {
    let place = |key: &str| NORMS.iter().position(|n| n.key == key).unwrap_or(NORMS.len());
    let mut rates: Vec<(&str, &Rate)> = record.rates.iter().map(|(key, rate)| (key.as_str(), rate)).collect();
    rates.sort_by_key(|(key, _)| place(key));
    rates
}

/// The fitted rate in the norm that the claim judges.
pub fn judged_rate(record: &StudyRecord) -> Option<&Rate> {
    record.rates.get(&record.norm)
}

/// Rate between the level at `index` and the usable level before it: the record's own where it has one.
///
/// `log(e_c/e) / log(h_c/h)`; `None` on the first usable level and where an error is missing, zero or rounding.
pub fn pairwise(record: &StudyRecord, norm: &Norm, index: usize) -> Option<f64> {
    let fine = record.levels.get(index)?;
    if let Some(rate) = record.rates.get(norm.key) {
        let stored = rate.pairwise.iter().find(|(level, _)| *level == fine.level);
        return stored.map(|(_, r)| *r);
    }
    let coarse = record.levels[..index].iter().rev().find(|l| usable(l, norm))?;
    if !usable(fine, norm) {
        return None;
    }
    let errors = norm.value(coarse)? / norm.value(fine)?;
    let rate = errors.ln() / (coarse.h / fine.h).ln();
    rate.is_finite().then_some(rate)
}

fn usable(level: &Level, norm: &Norm) -> bool {
    level.excluded.is_none() && norm.value(level).is_some_and(|e| e > 0.0) && !is_rounding(level)
}

/// `b/h²`, the constant of the ledger's boundary term.
fn b_over_h2(level: &Level) -> Option<f64> {
    level.ledger.as_ref().map(|l| l.b / (level.h * level.h))
}
