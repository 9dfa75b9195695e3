//! The error norms of a record, and how far their rates can be trusted.

pub use signorini_study::claim::quantity::{QUANTITIES as NORMS, Quantity as Norm};
use signorini_study::rate::{self, is_rounding};
use signorini_study::record::{Level, Rate, StudyRecord};

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

/// The fitted rates of error norms with their keys, in the order of [`NORMS`]; then `dofs`, and what the catalogue does
/// not know. Those of the ledger's terms are not among them.
pub fn rates_in_order(record: &StudyRecord) -> Vec<(&str, &Rate)> {
    let place = |key: &str| NORMS.iter().position(|n| n.key == key).unwrap_or(NORMS.len());
    let mut rates: Vec<(&str, &Rate)> = record.rates.iter().map(|(key, rate)| (key.as_str(), rate)).collect();
    rates.retain(|(key, _)| !key.starts_with(rate::LEDGER));
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
