//! What is measured on a level and can be claimed about: keys of records and study files, words, symbols and values.

use crate::record::Level;

/// One error norm, or another measured quantity that a claim judges.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Key in the errors and rates of a record, and in study files.
    pub key: &'static str,
    /// Short words.
    pub words: &'static str,
    /// Symbol, `e = u − uₕ`.
    pub symbol: &'static str,
    value: fn(&Level) -> Option<f64>,
}

impl Quantity {
    /// The value on one level; `None` where there is none.
    pub fn value(&self, level: &Level) -> Option<f64> {
        (self.value)(level)
    }

    /// `strain |u−uₕ|`
    pub fn label(&self) -> String {
        format!("{} {}", self.words, self.symbol)
    }
}

macro_rules! error {
    ($key:literal, $words:literal, $symbol:literal, $field:ident) => {
        Quantity { key: $key, words: $words, symbol: $symbol, value: |level| level.errors.$field }
    };
}

/// Every quantity, in the order of tables and legends.
pub const QUANTITIES: [Quantity; 18] = [
    error!("strain", "strain", "|u−uₕ|", strain),
    error!("energy", "energy", "√A(e,e)", energy),
    error!("h1", "H¹", "‖u−uₕ‖₁", h1),
    error!("l2", "L²", "‖u−uₕ‖₀", l2),
    error!("pressure_l2", "pressure L²", "‖p−pₕ‖₀", pressure_l2),
    error!("pressure_dual", "pressure, dual", "‖p−pₕ‖₋½", pressure_dual),
    error!("penetration_l2", "penetration", "‖([uₕ]ₙ)₊‖₀", penetration_l2),
    error!("contact_set", "contact set", "|C △ Cₕ|", contact_set),
    error!("energy_gap", "energy gap", "L(uₕ)−L(u)", energy_gap),
    error!("interpolation", "interpolation", "√A(u−u_I,u−u_I)", interpolation),
    error!("boundary_l2", "boundary L²", "‖u−u_I‖₀ on ∂Ω", boundary_l2),
    error!("constant", "constant", "c", constant),
    error!("half_width", "half width's difference", "aₕ/a − 1", half_width),
    error!("peak_pressure", "peak pressure's difference", "max pₕ/p₀ − 1", peak_pressure),
    error!("force", "force's difference", "Σλ/P − 1", force),
    Quantity { key: "formula", words: "difference from the formula", symbol: "(largest)", value: of_formula },
    Quantity { key: "solution_h1", words: "size of the solution", symbol: "‖uₕ‖₁", value: |l| l.solution_h1 },
    Quantity { key: "b_over_h2", words: "constant", symbol: "b/h²", value: b_over_h2 },
];

/// The quantity of that key, if there is one.
pub fn quantity(key: &str) -> Option<&'static Quantity> {
    QUANTITIES.iter().find(|q| q.key == key)
}

/// The quantity in a sentence: its short words, of a constant its symbol too; the key itself where nothing has it.
pub fn in_words(key: &str) -> String {
    match quantity(key) {
        Some(q) if q.words == "constant" => q.label(),
        Some(q) => q.words.into(),
        None => key.into(),
    }
}

/// The difference from the formula that is farthest from zero.
fn of_formula(level: &Level) -> Option<f64> {
    level.errors.difference("formula")
}

/// `b/h²`, the constant of the ledger's boundary term.
fn b_over_h2(level: &Level) -> Option<f64> {
    level.ledger.as_ref().map(|l| l.b / (level.h * level.h))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Errors, Ledger};
    use crate::sample;

    #[test]
    fn every_fitted_norm_has_words_and_its_own_value() {
        let mut level = sample::level(0, 0.5);
        for (i, name) in Errors::NORMS.iter().enumerate() {
            let mut errors = serde_json::to_value(Errors::default()).unwrap();
            errors[name] = (i as f64 - 3.5).into();
            level.errors = serde_json::from_value(errors).unwrap();
            let value = quantity(name).unwrap().value(&level);
            assert_eq!(value.map(f64::abs), level.errors.size(name).map(f64::abs), "{name}");
            assert_eq!(value, Some(i as f64 - 3.5), "{name}");
            assert!(!in_words(name).contains('_'), "{name}");
        }
    }

    #[test]
    fn constants_say_which() {
        assert_eq!(in_words("b_over_h2"), "constant b/h²");
        assert_eq!(in_words("penetration_l2"), "penetration");
        assert_eq!(in_words("ledger"), "ledger");
        let mut level = sample::level(0, 0.5);
        let b = -3.0 * level.h * level.h;
        level.ledger = Some(Ledger { lhs: 0.1, a: 0.1, b, c: 0.0, parts: Default::default(), delta: 0.0, holds: None });
        let value = quantity("b_over_h2").unwrap().value(&level).unwrap();
        assert!((value + 3.0).abs() < 1e-12, "{value}");
    }
}
