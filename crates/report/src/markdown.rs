//! The page of one case: question, claim, set-up, verdict, tables and pictures, in the order a reader asks.

use crate::borderline;
use crate::changed;
use crate::corner;
use crate::coverage;
use crate::extrapolation;
use crate::format;
use crate::formula;
use crate::ledger;
use crate::levels;
use crate::norm;
use crate::regularity;
use crate::splitting;
use crate::table::{Cell, Column, Row, Table};
use crate::verdict;
use signorini_study::record::{ClaimKind, Rate, Reference, StudyRecord};

/// Which pictures stand beside the page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pictures {
    /// `rates.png`.
    pub rates: bool,
    /// `ledger.png`.
    pub ledger: bool,
    /// `parts.png`.
    pub parts: bool,
    /// `pressure.png`.
    pub pressure: bool,
    /// `mesh.svg` and `deformed.svg`.
    pub bodies: bool,
}

/// `report.md` of one case.
pub fn page(record: &StudyRecord, pictures: Pictures) -> String {
    let sections = [
        head(record),
        section("Changed", &changed::section(record)),
        section("Question", &record.question),
        claim(record),
        set_up(record, pictures.bodies),
        verdict_section(record),
        section("What would refute it", &record.refuted_by),
        errors(record, pictures.rates),
        ledger_section(record, pictures),
        splitting(record),
        table_section("Corners", &corner::table(record), &corners_legend(record)),
        table_section("Energies", &extrapolation::table(record), &energies_legend(record)),
        table_section("Contact", &levels::contact(record), CONTACT_LEGEND),
        deformed(pictures.bodies),
        pressure(record, pictures.pressure),
        certificate(record),
        notes(record),
        reproduce(record),
    ];
    sections.into_iter().filter(|s| !s.is_empty()).collect::<Vec<_>>().join("\n")
}

const ERRORS_LEGEND: &str = "h is the largest side; a rate stands beside its norm and is taken between a level and the \
usable level before it, log(e₁/e₂) / log(h₁/h₂).";
const DOUBTFUL_RATES: &str = "\n† Not asymptotic: the pairwise rates still drift. Where no rate stands the errors \
scatter, and the 95 % interval is wider than ±0.5.\n";
const LEDGER_LEGEND: &str = "The estimate of the error, term by term: ½A(e,e) ≤ a + b + c with a = ½A(u−u_I, u−u_I), \
b and c the terms of the contact zone, δ the quadrature estimate of them all. Terms below 1e-14 ‖u‖² in the energy norm are rounding.";
const UNEVEN: &str = " With few switch points b depends on where they sit in their sides, so it falls unevenly or \
vanishes; its bound is what is claimed.";
const ARC_LEGEND: &str = "What b and c are bounded by, norms in L²(Γ_K). [u_I−u]ₙ: interpolation of the jump, in b. Uₕ: \
the jump [uₕ]ₙ on the arc; Ũₕ: the same with uₕ taken at the foot of the perpendicular to the chord; Φ: linear on each \
chord through the nodal values of Uₕ. Their differences bound c.";
const GAP_LEGEND: &str = "b on sides in full contact, ∫T_ξ(ε_I−ε) dη, and on sides that hold a switch point, which falls unevenly, \
as it depends on where the point sits; \
‖ε_I−ε‖₀, the interpolation error of the gap over the zone, bounds c.";
const TERMS_LEGEND: &str = "Rates of absolute values, since the last change of sign. Proven: the term is O(h^exponent); \
½A(e,e), a, b and c are squares, so half an exponent is a rate of the error. Where no rate stands the term vanishes, keeps \
changing its sign, or scatters.";
const DRIFTING_TERMS: &str =
    "\n† Not asymptotic, the pairwise rates still drift; or scattered, and then no rate is shown.\n";
const CORNER_LEGEND: &str = "Near a corner u ~ r^λ; given is the smallest Re λ below 1 of the local problem, with Im λ where the \
solution oscillates. Angles and conditions counterclockwise. At the ends and corners of the contact zone every ray of it may be \
open or closed without friction; → marks the state of the finest discrete solution, the reference if there is one, read off its pressure at the four nearest nodes along the \
ray. Where they disagree the smallest exponent counts.";
const CONTACT_LEGEND: &str = "Active: constraints whose multiplier exceeds 1e-8 of the largest. Contact set: length of \
the symmetric difference with the reference's. Switch point: largest distance of one of the reference's switch points from the nearest discrete one.";
const FORMULA_LEGEND: &str = "The formula neglects something, the shape of the bodies far from the contact for instance, so \
the differences need not vanish with h. Force: sum of the multipliers. Half width: half the measure of the contact set, each \
switch point placed in its side by the gap beyond it. Peak pressure: the largest λᵢ/mᵢ. Of a symmetric half model all are \
those of the whole.";
const SOLUTION_LEGEND: &str = "Two-way: relative difference of A(e,e) by quadrature and by energies. KKT: scaled \
residuals of the optimality conditions, recomputed from the raw data. Algebraic, quadrature, reference, and geometry \
where it is not met exactly: shares of the energy error that are not discretisation.";
const CHORD_LEGEND: &str = " Straight/chord: longest straight side over the longest chord of a curved one.";

const MESH_LEGEND: &str = "No contact problem is solved here: the numbers are those of meshes and functions alone. \
Quadrature: share of the measured error that a finer rule would change.";
const CONSTANT_LEGEND: &str = "h is the largest side.";

fn head(record: &StudyRecord) -> String {
    let case = if record.several { format!(" · case `{}`", record.case) } else { String::new() };
    format!("# {}\n\nStudy `{}`{case} · **{}**\n", record.title, record.study, verdict::words(record))
}

fn section(title: &str, body: &str) -> String {
    if body.trim().is_empty() {
        return String::new();
    }
    format!("## {title}\n\n{}\n", body.trim())
}

fn table_section(title: &str, table: &Table, legend: &str) -> String {
    if table.rows.is_empty() {
        return String::new();
    }
    section(title, &format!("{}\n{legend}", table.to_markdown()))
}

fn corners_legend(record: &StudyRecord) -> String {
    format!("{} {CORNER_LEGEND}", corner::sentence(record))
}

fn energies_legend(record: &StudyRecord) -> String {
    record.extrapolation.as_ref().map_or_else(String::new, extrapolation::sentence)
}

/// Of a lemma there is only the mesh and its quadrature.
fn certificate(record: &StudyRecord) -> String {
    let table = levels::solution(record);
    if levels::has_solution(record) {
        let curved = table.columns.iter().any(|c| c.key == "straight_over_chord");
        let legend = format!("{SOLUTION_LEGEND}{}", if curved { CHORD_LEGEND } else { "" });
        table_section("Certificate, budget and solver", &table, &legend)
    } else {
        table_section("Mesh and quadrature", &table, MESH_LEGEND)
    }
}

fn claim(record: &StudyRecord) -> String {
    let judged = format!(
        "Claim `{}`, judged as {} in the norm *{}*.",
        record.claim,
        kind_words(record.kind),
        norm::words(&record.norm),
    );
    let observed = norm::judged_rate(record);
    let mut body = format!("{}\n\n{}{judged}\n", record.statement.trim(), hypotheses(record));
    let b = &record.bounds;
    if observed.is_some() || [b.paper, b.today, b.expected].iter().any(Option::is_some) {
        body += &format!("\n{}", bounds_table(record, observed).to_markdown());
    }
    if let Some(rate) = observed {
        body += &format!("\n{}", fit_words(rate));
    }
    section("Claim", &body)
}

fn hypotheses(record: &StudyRecord) -> String {
    if record.hypotheses.is_empty() {
        return String::new();
    }
    format!("Hypotheses: {}.\n\n", record.hypotheses.join("; "))
}

/// How a claim is judged, in words.
pub fn kind_words(kind: ClaimKind) -> &'static str {
    match kind {
        ClaimKind::Rate => "a rate",
        ClaimKind::Inequality => "an inequality on every level",
        ClaimKind::Exact => "exact to rounding on every level",
        ClaimKind::Convergence => "convergence from level to level",
        ClaimKind::Bounded => "a bounded constant",
        ClaimKind::Agreement => "agreement on the finest level",
        ClaimKind::Certificate => "a certified solve on every level, confirmed by a second solver",
    }
}

fn bounds_table(record: &StudyRecord, observed: Option<&Rate>) -> Table {
    let row = |words: &str, rate: Cell, from: Cell, to: Cell| Row {
        cells: vec![Cell::text(words), rate, from, to],
        excluded: None,
    };
    let bound = |words: &str, value| row(words, Cell::bound(value), Cell::Missing, Cell::Missing);
    Table {
        columns: ["", "rate", "95 % from", "to"].map(|heading| Column::new(heading, heading)).to_vec(),
        rows: vec![
            bound("paper", record.bounds.paper),
            bound("today", record.bounds.today),
            bound("expected from the regularity", record.bounds.expected),
            row(
                "**observed**",
                Cell::rate(observed.map(|r| r.slope)),
                Cell::rate(observed.map(|r| r.low)),
                Cell::rate(observed.map(|r| r.high)),
            ),
        ],
    }
}

/// The window and the quality of the fit, in a sentence.
fn fit_words(rate: &Rate) -> String {
    format!(
        "Fitted over {}: standard error {}, R² {:.6}, change of the pairwise rate per level {}; \
         against dofs^(−1/2) the slope is {}.{} {}\n{}",
        format::level_words(&rate.levels),
        format::significant(rate.stderr, 2),
        rate.r2,
        format::rate(rate.curvature),
        format::rate(rate.dofs_slope),
        norm::Trust::of(rate).remark().map_or(String::new(), |why| format!(" No firm rate: {why}.")),
        coverage::sentence(),
        borderline::words(rate),
    )
}

fn set_up(record: &StudyRecord, picture: bool) -> String {
    let mut lines = vec![format!("- Family: {}", family_words(record))];
    lines.extend(regularity::angles(record).map(|words| format!("- Angles: {words}")));
    lines.extend(regularity::sentence(record).map(|words| format!("- Regularity: {words}")));
    if levels::has_solution(record) {
        lines.push(format!("- Reference: {}", reference_words(&record.reference)));
    }
    lines.push(format!("- Profile: {}, {} levels", record.profile, record.levels.len()));
    if !record.parameters.is_empty() {
        let values = record.parameters.iter();
        let words: Vec<String> = values.map(|(name, x)| format!("{name} = {x}")).collect();
        lines.push(format!("- Parameters: {}", words.join(", ")));
    }
    let image = image(picture, "mesh.svg", "Both bodies, their triangles, boundary parts and contact zone");
    section("Set-up", &format!("{}\n\n{}\n\n{image}", record.setup.trim(), lines.join("\n")))
}

fn family_words(record: &StudyRecord) -> String {
    let nested = if record.levels.iter().skip(1).all(|l| l.nested) { "nested" } else { "not nested" };
    let seed = if record.seed == 0 { String::new() } else { format!(", seed {}", record.seed) };
    if record.levels.len() < 2 {
        return format!("{}{seed}", record.family);
    }
    format!("{}, {nested}{seed}", record.family)
}

fn reference_words(reference: &Reference) -> String {
    let Reference::Overkill { h, dofs, energy, estimated_error, stationarity, solver } = reference else {
        return match reference {
            Reference::Exact => "exact, a closed form".into(),
            _ => "none: energies and certificates alone".into(),
        };
    };
    let own = estimated_error.map_or(format::MISSING.into(), |e| format::significant(e, 3));
    format!(
        "overkill, the discrete solution at h = {} ({dofs} dofs, solver {solver}); its energy {}, its own \
         error in the energy norm about {own}, its stationarity residual {}",
        format::significant(*h, 5),
        format::significant(*energy, 10),
        format::significant(*stationarity, 3),
    )
}

fn verdict_section(record: &StudyRecord) -> String {
    let mut lines = vec![format!("**{}**\n", verdict::words(record))];
    lines.extend(record.verdict.reasons.iter().map(|why| format!("- {why}")));
    if let Some(expect) = record.expect {
        let wanted = verdict::outcome_word(expect);
        lines.push(format!("- This case is a control: it is built so that the verdict must be *{wanted}*."));
    }
    if let Some(why) = &record.expected_inconclusive {
        lines.push(format!("- At the sizes of the quick profile no verdict is expected: {why}"));
    }
    section("Verdict", &lines.join("\n"))
}

fn errors(record: &StudyRecord, picture: bool) -> String {
    if record.levels.is_empty() {
        return String::new();
    }
    let mut body = image(
        picture,
        "rates.png",
        if record.norm == "constant" { "Constants against mesh size" } else { "Errors against mesh size" },
    );
    let legend = if record.norm == "constant" { CONSTANT_LEGEND } else { ERRORS_LEGEND };
    body += &format!("{}\n{legend}\n", levels::errors(record).to_markdown());
    if !record.rates.is_empty() {
        let table = levels::rates(record);
        let marked = table.rows.iter().any(|row| row.excluded.is_some());
        body += &format!("\n{}", table.to_markdown_above(if marked { DOUBTFUL_RATES } else { "" }));
    }
    section(if record.norm == "constant" { "Constants" } else { "Errors" }, &body)
}

fn ledger_section(record: &StudyRecord, pictures: Pictures) -> String {
    let Some(terms) = ledger::terms(record) else {
        return String::new();
    };
    let mut body = image(pictures.ledger, "ledger.png", "Terms of the ledger against mesh size");
    let parts = ledger::parts(record);
    let has = |key: &str| parts.iter().flat_map(|t| &t.columns).any(|c| c.key == key);
    let uneven = if parts.is_some() { "" } else { UNEVEN };
    body += &format!("{}\n{LEDGER_LEGEND}{uneven}\n", terms.to_markdown());
    if let Some(parts) = &parts {
        let gap = has("ledger_gap_interpolation");
        let image = image(pictures.parts, "parts.png", "Parts of the ledger against mesh size");
        body += &format!("\n{image}{}\n{}\n", parts.to_markdown(), if gap { GAP_LEGEND } else { ARC_LEGEND });
    }
    if let Some(rates) = ledger::rates(record) {
        let marked = rates.rows.iter().any(|row| row.excluded.is_some());
        let note = if marked { DRIFTING_TERMS } else { "" };
        body += &format!("\n{}\n{TERMS_LEGEND}\n", rates.to_markdown_above(note));
    }
    section("Ledger", &body)
}

/// Falk's splitting on the finest level, and how tight it is on the others.
fn splitting(record: &StudyRecord) -> String {
    section("Falk's splitting", &splitting::body(record))
}

/// The contact pressure of the finest level, and what a formula says of it.
fn pressure(record: &StudyRecord, picture: bool) -> String {
    let image = image(picture, "pressure.png", "Contact pressure and gap along the zone");
    let table = formula::table(record).map_or_else(String::new, |t| format!("{}\n{FORMULA_LEGEND}", t.to_markdown()));
    section("Contact pressure", &format!("{image}{table}"))
}

/// The bodies under load.
fn deformed(picture: bool) -> String {
    section("Deformed bodies", &image(picture, "deformed.svg", "Deformed bodies with the stress of von Mises"))
}

fn image(there: bool, file: &str, words: &str) -> String {
    if there { format!("![{words}]({file})\n\n") } else { String::new() }
}

fn notes(record: &StudyRecord) -> String {
    let lines: Vec<String> = record.notes.iter().map(|note| format!("- {note}")).collect();
    section("Notes", &lines.join("\n"))
}

/// The command that makes this record again.
pub fn command(record: &StudyRecord) -> String {
    let sizes = match record.profile.as_str() {
        "quick" => String::new(),
        "custom" => format!(" --levels {}", record.levels.len()),
        profile => format!(" --profile {profile}"),
    };
    format!("signorini run {}{sizes}", changed::arguments(record))
}

fn reproduce(record: &StudyRecord) -> String {
    let tables = "The same numbers with every digit: [table.csv](table.csv), [table.json](table.json).";
    section("Reproduce it", &format!("```sh\n{}\n```\n\n{tables}", command(record)))
}
