//! `ledger`: the terms of the error estimate against the mesh size.

use super::chart::{Chart, Colour, Curve, Mark, Shape, Slope, Weight};
use super::rates::{STAR, detail, excluded, kind};
use crate::format;
use crate::ledger::term_rate;
use crate::norm::Trust;
use crate::summary::name;
use signorini_study::claim::proof::proven_terms;
use signorini_study::record::{Ledger, Level, Rate, StudyRecord};

/// A term of the ledger and how it is drawn.
struct Term {
    words: &'static str,
    /// Its name in the rates; the sum has none.
    key: Option<&'static str>,
    colour: Colour,
    shape: Shape,
    weight: Weight,
    value: fn(&Ledger) -> f64,
}

/// Curves that nearly coincide show around one another: the sum's rings, then `a`, then the left side; `b` around `c`.
const TERMS: [Term; 5] = [
    Term {
        words: SUM,
        key: None,
        colour: Colour::Black,
        shape: Shape::Square,
        weight: Weight::Halo,
        value: Ledger::sum,
    },
    term("a", "a", Colour::Green, Shape::Triangle, Weight::Strong, |l| l.a),
    term("½A(e,e)", "lhs", Colour::Blue, Shape::Circle, Weight::Thin, |l| l.lhs),
    term("b", "b", Colour::Vermillion, Shape::Diamond, Weight::Strong, |l| l.b),
    term("c", "c", Colour::Purple, Shape::Circle, Weight::Thin, |l| l.c),
];

const SUM: &str = "a + b + c";

const fn term(
    words: &'static str,
    key: &'static str,
    colour: Colour,
    shape: Shape,
    weight: Weight,
    value: fn(&Ledger) -> f64,
) -> Term {
    Term { words, key: Some(key), colour, shape, weight, value }
}

/// `½A(e,e)`, the terms `a`, `b`, `c` by their absolute values, and their sum, against `h`, with the bound's own slope
/// (the square of the claimed rate) beside them.
///
/// `None` if neither side of the inequality has a finite value above rounding.
pub fn ledger(record: &StudyRecord) -> Option<Chart> {
    let polygonal = levels(record).all(|(_, l)| l.c == 0.0);
    let terms = TERMS.iter().filter(|t| !(polygonal && t.words == "c"));
    let curves: Vec<Curve> = terms.filter_map(|t| curve(record, t, polygonal)).collect();
    if !curves.iter().any(|c| c.judged) {
        return None;
    }
    let sloped = curves.iter().any(Curve::has_slope);
    Some(Chart {
        title: format!("{}: ledger", name(record)),
        subtitle: vec![record.title.clone(), inequality(record, polygonal)],
        x_label: "mesh size h (largest side)".into(),
        y_label: "terms, squares of the energy norm".into(),
        curves,
        bands: Vec::new(),
        guides: Vec::new(),
        slopes: if sloped { slopes(record) } else { Vec::new() },
        remarks: remarks(record, polygonal),
    })
}

fn levels(record: &StudyRecord) -> impl Iterator<Item = (&Level, &Ledger)> {
    record.levels.iter().filter_map(|l| l.ledger.as_ref().map(|ledger| (l, ledger)))
}

fn curve(record: &StudyRecord, term: &Term, polygonal: bool) -> Option<Curve> {
    let marks: Vec<Mark> = levels(record).filter_map(|(level, l)| mark(level, (term.value)(l))).collect();
    let negative = levels(record).any(|(level, l)| is_negative(level, (term.value)(l)));
    let words = if polygonal && term.words == SUM { "a + b" } else { term.words };
    (!marks.is_empty()).then(|| Curve {
        label: if negative { format!("|{words}|") } else { words.into() },
        detail: rate_detail(term.key.and_then(|key| term_rate(record, key))),
        colour: term.colour,
        shape: term.shape,
        weight: term.weight,
        judged: term.words == SUM || term.key == Some("lhs"),
        marks,
    })
}

/// The rate of a term under its name; nothing where there is none or it scatters.
pub(super) fn rate_detail(rate: Option<&Rate>) -> String {
    rate.filter(|r| Trust::of(r) != Trust::Scattered).map_or_else(String::new, detail)
}

/// What the star at a rate means, if one is shown.
pub(super) fn star_remark<'a>(mut rates: impl Iterator<Item = &'a Rate>) -> Option<String> {
    let drifting = rates.any(|r| Trust::of(r) == Trust::Drifting);
    drifting.then(|| format!("{STAR} Not asymptotic: the pairwise rates still drift."))
}

/// Whether a term is zero or no more than `1e-14 A(u,u)`, the rounding that the inequality itself allows for.
fn is_rounding(level: &Level, value: f64) -> bool {
    let solution = level.solution_energy.unwrap_or(0.0);
    value.abs() <= 1e-14 * solution * solution
}

fn mark(level: &Level, value: f64) -> Option<Mark> {
    let drawable = !is_rounding(level, value) && value.is_finite() && level.h > 0.0 && level.h.is_finite();
    drawable.then(|| Mark { h: level.h, value: value.abs(), kind: kind(level, value) })
}

/// Negative beyond rounding.
fn is_negative(level: &Level, value: f64) -> bool {
    value < 0.0 && !is_rounding(level, value)
}

/// `½A(e,e) ≤ a + b holds on levels 0–4, is broken on level 5`
fn inequality(record: &StudyRecord, polygonal: bool) -> String {
    let sum = if polygonal { "a + b" } else { "a + b + c" };
    let verdicts = [(Some(true), "holds"), (None, "within its tolerance"), (Some(false), "BROKEN")];
    let parts = verdicts.iter().filter_map(|(wanted, words)| {
        let found: Vec<usize> = levels(record).filter(|(_, l)| l.holds == *wanted).map(|(l, _)| l.level).collect();
        (!found.is_empty()).then(|| format!("{words} on {}", format::level_words(&found)))
    });
    format!("½A(e,e) ≤ {sum}: {}{}", parts.collect::<Vec<_>>().join(", "), shares(record))
}

/// `; left over right side 0.927 to 0.9995`, over the levels where the right side is positive.
fn shares(record: &StudyRecord) -> String {
    let known = levels(record).filter(|(level, l)| l.sum() > 0.0 && !is_rounding(level, l.sum()));
    let ratios: Vec<f64> = known.map(|(_, l)| l.lhs / l.sum()).filter(|r| r.is_finite()).collect();
    let (Some(low), Some(high)) = (ratios.iter().copied().reduce(f64::min), ratios.iter().copied().reduce(f64::max))
    else {
        return String::new();
    };
    let [low, high] = [low, high].map(|ratio| format::significant(ratio, 4));
    let range = if low == high { low } else { format!("{low} to {high}") };
    format!("; left over right side {range}")
}

/// The bound of the claim, and what is proven of single terms where that is another slope.
fn slopes(record: &StudyRecord) -> Vec<Slope> {
    let mut slopes: Vec<Slope> = vec![slope(record)];
    for proven in proven_terms(record).iter().filter(|p| Ledger::TERMS.contains(&p.term)) {
        match slopes.iter().position(|s| s.exponent == proven.exponent) {
            Some(0) => {}
            Some(same) => slopes[same].source += &format!(", {}", proven.term),
            None => slopes.push(Slope {
                exponent: proven.exponent,
                label: format::order(proven.exponent),
                source: format!("proven of {}", proven.term),
            }),
        }
    }
    slopes
}

/// Squares fall twice as fast as norms: `h²` for `O(h)`, `h³ᐟ²` for `O(h³ᐟ⁴)`.
fn slope(record: &StudyRecord) -> Slope {
    let energy_like = matches!(record.norm.as_str(), "strain" | "energy" | "h1");
    let proven = record.bounds.paper.or(record.bounds.today);
    let source = if proven.is_some() { "claimed" } else { "expected" };
    match proven.or(record.bounds.expected).filter(|b| energy_like && b.is_finite()) {
        Some(rate) => Slope { exponent: 2.0 * rate, label: format::order(2.0 * rate), source: source.into() },
        None => Slope { exponent: 2.0, label: "O(h²)".into(), source: "to compare".into() },
    }
}

fn remarks(record: &StudyRecord, polygonal: bool) -> Vec<String> {
    let mut remarks = excluded(record);
    if levels(record).any(|(level, l)| TERMS.iter().any(|t| is_negative(level, (t.value)(l)))) {
        remarks.push("Hollow marks: the absolute value of a negative term.".into());
    }
    remarks.extend(star_remark(TERMS.iter().filter_map(|t| term_rate(record, t.key?))));
    for term in TERMS.iter().filter(|t| !(polygonal && t.words == "c")) {
        let zero: Vec<usize> =
            levels(record).filter(|(level, l)| is_rounding(level, (term.value)(l))).map(|(l, _)| l.level).collect();
        if !zero.is_empty() {
            remarks.push(format!("Not drawn, zero or rounding: {} on {}.", term.words, format::level_words(&zero)));
        }
    }
    remarks
}
