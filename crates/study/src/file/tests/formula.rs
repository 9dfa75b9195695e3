//! The table `[formula]`: hand numbers of Hertz's line contact, and what is refused.

use super::malformed::GOOD;
use crate::study::{Formula, Study};
use signorini_contact::Point;
use std::path::Path;

fn formula_of(table: &str) -> Result<Formula, String> {
    let text = GOOD.replacen("[levels]", &format!("[parameters]\nP = 2\nR = 0.5\nE = 4\n{table}\n[levels]"), 1);
    let study = Study::parse(&text, Path::new("small.toml")).map_err(|e| e.to_string())?;
    Ok(study.cases[0].scene().unwrap().formula.clone().unwrap())
}

/// `P = 2`, `R = ½`, `E* = 4`: `a² = 4·2·½/(4π) = 1/π`, `p0 = 2·2/(π a) = 4/√π`; at `x = a/2` it is `p0 √3/2`.
#[test]
fn hertz_by_hand() {
    let table = "[formula]\nforce = \"P\"\nhalf_width = \"sqrt(4*P*R/(pi*E))\"\npeak_pressure = \"2*P/(pi*half_width)\"\n\
                 pressure = \"peak_pressure*sqrt(pos(1 - (x/half_width)^2))\"";
    let Formula { values, pressure } = formula_of(table).unwrap();
    let (a, p0) = (0.564_189_583_547_756_3, 2.256_758_334_191_025);
    assert_eq!(values.force, Some(2.0));
    assert!((values.half_width.unwrap() - a).abs() < 1e-15 && (values.peak_pressure.unwrap() - p0).abs() < 1e-14);
    let p = pressure.unwrap();
    assert!((p(Point::new(0.5 * a, 0.0)) - 0.8660254037844386 * p0).abs() < 1e-14);
    assert_eq!(p(Point::new(0.6, 0.0)), 0.0);
    // half an ellipse of half axes a and p0 holds the load
    let n = 20_000;
    let sum: f64 = (0..n).map(|i| p(Point::new(a * (f64::from(i) + 0.5) / f64::from(n), 0.0))).sum();
    assert!((2.0 * a * sum / f64::from(n) - 2.0).abs() < 1e-5);
}

#[test]
fn numbers_may_stand_without_an_expression() {
    assert_eq!(formula_of("[formula]\nhalf_width = 1").unwrap().values.half_width, Some(1.0));
}

#[test]
fn nonsense_is_refused_at_its_place() {
    let refused = [
        ("[formula]", "[formula] says nothing"),
        ("[formula]\nhalf_width = -1", "half_width = -1 must be positive"),
        ("[formula]\nhalf_width = nan", "NaN is not a finite number"),
        ("[formula]\nhalf_width = \"sqrt(P - 3)\"", "half_width = NaN must be positive"),
        ("[formula]\nhalf_width = \"sqrt(Q)\"", "expression `sqrt(Q)`"),
        ("[formula]\nhalf_width = \"x\"", "expression `x`"),
        ("[formula]\nhalf_width = true", "expected a number or an expression"),
        ("[formula]\nforce = \"peak_pressure\"\npeak_pressure = 1", "expression `peak_pressure`"),
        ("[formula]\npressure = \"sqrt(0.5 - x)\"", "the pressure is NaN at (0.515625, 0)"),
        ("[formula]\npressure = \"0.5 - x\"", "the pressure is -0.015625 at (0.515625, 0)"),
        ("[formula]\nwidth = 1", "unknown field `width`"),
        ("half_width = 3\n[formula]\nhalf_width = 1", "`half_width` is a parameter and a field of [formula]"),
    ];
    for (table, message) in refused {
        let error = formula_of(table).err().unwrap_or_else(|| panic!("{table} is accepted"));
        assert!(error.contains(message), "{table}: {error}");
    }
}

#[test]
fn a_claim_on_a_formula_needs_one_and_a_bound() {
    let own =
        |kind: &str, norm: &str| format!("[own_claim]\nstatement = \"s\"\nkind = \"{kind}\"\nnorm = \"{norm}\"\n");
    let judged = |kind: &str, norm: &str, tables: &str| {
        let text = GOOD.replacen("claim = \"theorem-3-1\"\n", "", 1);
        let text = text.replacen("[levels]", &format!("{}{tables}[levels]", own(kind, norm)), 1);
        Study::parse(&text, Path::new("small.toml")).map(|_| ()).map_err(|e| e.to_string())
    };
    let (formula, gates) = ("[formula]\nhalf_width = 1\n", "[gates]\nconstant = 0.1\nreason = \"r\"\n");
    let both = format!("{formula}{gates}");
    assert_eq!(judged("agreement", "half_width", &both), Ok(()));
    assert_eq!(judged("agreement", "formula", &both), Ok(()));
    let refused = [
        (judged("agreement", "peak_pressure", &both), "no formula gives it"),
        (judged("agreement", "half_width", gates), "no formula gives it"),
        (judged("agreement", "half_width", formula), "`agreement` without a bound"),
        (judged("agreement", "energy", &both), "`energy` does not"),
        (judged("rate", "half_width", &both), "falls to no rate"),
    ];
    for (answer, message) in refused {
        let error = answer.err().unwrap_or_else(|| panic!("accepted, not refused with: {message}"));
        assert!(error.contains(message), "{error}");
    }
}
