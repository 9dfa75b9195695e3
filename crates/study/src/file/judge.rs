//! What a case is judged by: the claim, its bounds, the gates.

use super::error::{Fault, refuse};
use super::expected::ExpectedRate;
use super::number::{Finite, OrNone};
use super::raw::{RawClaim, RawExact, RawExpected, RawGates, RawStudy};
use super::spanned::Spanned;
use super::words::suggestion;
use crate::claim::Claim;
use crate::claim::catalogue::{Standing, catalogue, find};
use crate::exact::sobolev_order;
use crate::record::{Bounds, ClaimKind, Errors, FormulaValues};
use crate::study::{Gates, Scene, Subject};
use std::collections::BTreeMap;
use std::ops::Range;

/// What else than an error norm a claim of a study's own may judge.
const CONSTANTS: [&str; 6] = ["b_over_h2", "ledger", "splitting", "constant", "solution_h1", CERTIFICATE];

/// What a claim of the kind `certificate` judges, and no other.
const CERTIFICATE: &str = "kkt";

/// The study's claim: one of the catalogue or its own.
pub fn claim(raw: &RawStudy) -> Result<Claim, Fault> {
    match (&raw.claim, &raw.own_claim) {
        (Some(id), None) => catalogued(id),
        (None, Some(own)) => own_claim(own.get_ref()),
        (Some(id), Some(_)) => refuse(id.span(), "both `claim` and `own_claim`", "keep one of them"),
        (None, None) => {
            refuse(raw.id.span(), "the study claims nothing", "give `claim = \"…\"` or a table [own_claim]")
        }
    }
}

fn catalogued(id: &Spanned<String>) -> Result<Claim, Fault> {
    let word = id.get_ref();
    let landed: Vec<&str> = catalogue().iter().filter(|e| e.standing == Standing::Landed).map(|e| e.id).collect();
    match find(word) {
        Ok(entry) => {
            let Standing::Nothing(why) = entry.standing else { return Ok(entry.claim()) };
            let message = format!("claim `{word}` has nothing to run: {why}");
            refuse(id.span(), message, format!("use one of: {}; or state it as [own_claim]", landed.join(", ")))
        }
        Err(_) => refuse(id.span(), format!("no claim `{word}` in the catalogue"), suggestion(word, &landed)),
    }
}

fn own_claim(raw: &RawClaim) -> Result<Claim, Fault> {
    let norm = raw.norm.get_ref();
    let known: Vec<&str> = Errors::NORMS.into_iter().chain(CONSTANTS).chain(Errors::OF_FORMULA).collect();
    if !known.contains(&norm.as_str()) {
        return refuse(raw.norm.span(), format!("no error norm `{norm}`"), suggestion(norm, &known));
    }
    if (raw.kind == ClaimKind::Certificate) != (norm == CERTIFICATE) {
        let message = format!("kind `certificate` judges `{CERTIFICATE}`, and no other kind does");
        return refuse(raw.norm.span(), message, "let kind and norm belong together");
    }
    let of_formula = Errors::OF_FORMULA.contains(&norm.as_str());
    if raw.kind == ClaimKind::Agreement && !of_formula {
        let message = format!("kind `agreement` compares with a formula, and `{norm}` does not");
        return refuse(raw.norm.span(), message, format!("choose one of: {}", Errors::OF_FORMULA.join(", ")));
    }
    if of_formula && matches!(raw.kind, ClaimKind::Rate | ClaimKind::Exact | ClaimKind::Inequality) {
        let message = format!("`{norm}` contains what the formula neglects and falls to no rate");
        return refuse(raw.norm.span(), message, "judge it by kind `agreement`, `bounded` or `convergence`");
    }
    let number = |x: Option<Finite>| x.map(|x| x.0);
    Ok(Claim {
        id: "own".into(),
        statement: raw.statement.clone(),
        hypotheses: raw.hypotheses.clone(),
        kind: raw.kind,
        norm: norm.clone(),
        bounds: Bounds { paper: number(raw.paper), today: number(raw.today), expected: number(raw.expected) },
        sources: raw.sources.clone(),
    })
}

/// The three bounds of a case, and whether the expected rate is only an asymptotic one.
pub fn bounds(claim: &Bounds, raw: Option<&Spanned<RawExpected>>) -> Result<(Bounds, bool), Fault> {
    let Some(raw) = raw else { return Ok((claim.clone(), false)) };
    let e = raw.get_ref();
    if e.asymptotic_only && e.reason.is_none() {
        let message = "`asymptotic_only` takes a gate away, so it needs a `reason`";
        return refuse(raw.span(), message, "say in `reason` why the rate comes late");
    }
    let own = |given: Option<OrNone>, claimed: Option<f64>| given.map_or(claimed, |g| g.0);
    let bounds = Bounds {
        paper: own(e.paper, claim.paper),
        today: own(e.today, claim.today),
        expected: match e.rate {
            Some(ExpectedRate::Given(rate)) => rate,
            // the run fills it in
            Some(ExpectedRate::Corners) => None,
            None => claim.expected,
        },
    };
    Ok((bounds, e.asymptotic_only))
}

/// Whether the expected rate is that of the scene's corners, which the program computes itself.
pub fn expects_corners(raw: Option<&Spanned<RawExpected>>, subject: &Subject) -> Result<bool, Fault> {
    let Some(raw) = raw.filter(|e| e.get_ref().rate == Some(ExpectedRate::Corners)) else { return Ok(false) };
    let next = "give the rate as a number";
    match subject {
        Subject::Contact(scene) if scene.exact.is_none() => Ok(true),
        Subject::Contact(_) => {
            let message = "rate = \"corners\" beside an exact solution, which decides its regularity itself";
            refuse(raw.span(), message, next)
        }
        Subject::Lemma(_) => refuse(raw.span(), "rate = \"corners\" of a lemma, which has no corners", next),
    }
}

/// Whether the regularity is borderline, `u ∈ H^s` with `s = 2` where the rate `min(1, s − 1)` has its kink: what the study says, else
/// what is known of its built-in solution.
pub fn is_borderline(
    expected: Option<&Spanned<RawExpected>>,
    exact: Option<&Spanned<RawExact>>,
    parameters: &BTreeMap<String, f64>,
) -> bool {
    let known = || {
        let name = exact?.get_ref().builtin.as_ref()?;
        sobolev_order(name.get_ref(), parameters).ok().flatten()
    };
    expected.and_then(|e| e.get_ref().borderline).unwrap_or_else(|| known() == Some(2.0))
}

/// The gates, and whether quadrature is fixed. Whatever moves a gate needs a reason; only a control plants a defect.
pub fn gates(raw: Option<&Spanned<RawGates>>, control: bool) -> Result<(Gates, bool), Fault> {
    let d = Gates::default();
    let Some(raw) = raw else { return Ok((d, false)) };
    let g = raw.get_ref();
    if g.reason.is_none() {
        return refuse(raw.span(), "[gates] moves a gate and gives no `reason`", "say why in `reason`");
    }
    let fixed = g.fixed_quadrature.as_ref().is_some_and(|f| *f.get_ref());
    if let (Some(f), false) = (&g.fixed_quadrature, control) {
        return refuse(f.span(), "`fixed_quadrature` is a planted defect", "leave it to studies with `expect`");
    }
    let ceiling = match &g.ceiling {
        Some(c) => c.get_ref().0.map(|x| between("ceiling", x, c, 0.0, f64::INFINITY)).transpose()?,
        None => d.ceiling,
    };
    let gates = Gates {
        rate_tolerance: number("rate_tolerance", &g.rate_tolerance, d.rate_tolerance, 0.0, 1.0)?,
        ceiling,
        exact_tolerance: number("exact_tolerance", &g.exact_tolerance, d.exact_tolerance, 0.0, 1.0)?,
        fall: number("fall", &g.fall, d.fall, 0.0, 1.0)?,
        spread: number("spread", &g.spread, d.spread, 1.0, f64::INFINITY)?,
        constant: match &g.constant {
            Some(c) => Some(between("constant", c.get_ref().0, c, 0.0, f64::INFINITY)?),
            None => d.constant,
        },
        share: number("share", &g.share, d.share, 0.0, 1.0)?,
    };
    Ok((gates, fixed))
}

fn number(name: &str, raw: &Option<Spanned<Finite>>, default: f64, low: f64, high: f64) -> Result<f64, Fault> {
    raw.as_ref().map_or(Ok(default), |x| between(name, x.get_ref().0, x, low, high))
}

fn between<T>(name: &str, x: f64, raw: &Spanned<T>, low: f64, high: f64) -> Result<f64, Fault> {
    if low < x && x < high {
        return Ok(x);
    }
    let bound = if high.is_finite() { format!("lie between {low} and {high}") } else { format!("exceed {low}") };
    refuse(raw.span(), format!("{name} = {x} must {bound}"), "leave it out to keep the default")
}

/// Whether an agreement says how small the difference has to be.
pub fn has_bound(claim: &Claim, gates: &Gates, span: Range<usize>) -> Result<(), Fault> {
    if claim.kind != ClaimKind::Agreement || gates.constant.is_some() {
        return Ok(());
    }
    let next = "give `constant`, the largest relative difference, and a `reason` in [gates]";
    refuse(span, "kind `agreement` without a bound", next)
}

/// Whether what the claim judges is measured by the case: a lemma measures one quantity, which no contact problem has; a
/// difference from a formula needs the formula.
pub fn is_measured(claim: &Claim, subject: &Subject, span: Range<usize>) -> Result<(), Fault> {
    let norm = claim.norm.as_str();
    let of_lemmas = ["boundary_l2", "constant"].contains(&norm);
    match subject {
        Subject::Lemma(lemma) if lemma.norm() != norm => {
            let message = format!("the claim judges `{norm}`, and this lemma measures `{}`", lemma.norm());
            refuse(span, message, "choose the claim of the lemma, or state it as [own_claim]")
        }
        Subject::Contact(_) if of_lemmas => {
            let message = format!("the claim judges `{norm}`, which only a lemma measures");
            refuse(span, message, "give a table [lemma], or choose another claim")
        }
        Subject::Contact(scene) if Errors::OF_FORMULA.contains(&norm) && !gives(scene, norm) => {
            let message = format!("the claim judges `{norm}`, and no formula gives it");
            refuse(span, message, "state it in a table [formula], or choose another claim")
        }
        _ => Ok(()),
    }
}

/// Whether the scene's formula gives the number that a norm of [`Errors::OF_FORMULA`] compares with.
fn gives(scene: &Scene, norm: &str) -> bool {
    let Some(values) = scene.formula.as_ref().map(|f| &f.values) else { return false };
    match norm {
        "half_width" => values.half_width.is_some(),
        "peak_pressure" => values.peak_pressure.is_some(),
        "force" => values.force.is_some(),
        _ => *values != FormulaValues::default(),
    }
}
