//! Hard cases from the command line: units change nothing, refusals are shown, the page has a row for every case.

mod common;

use common::Folder;
use signorini_study::record::{Level, Outcome, StudyRecord};

/// The square of `LOADED` in units of the length `l` and the modulus `e`: an initial wave, loads, supports, all scaled.
fn scaled(l: f64, e: f64) -> String {
    format!(
        r#"id = "scaled"
title = "A square on another one, in other units"
claim = "certificate"
question = "Do units matter?"
setup = "The same scene, lengths and moduli multiplied."
refuted_by = "Another table."

[parameters]
l = {l:?}
e = {e:?}

[levels]
quick = [4, 8, 16]
full = [4, 8, 16]

[reference]
kind = "overkill"
quick = 32
full = 32

[solver]
second = "interior-point"

[[body]]
name = "upper"
material = {{ young = {e:?}, poisson = 0.3 }}
rectangle = [[0, 0], [{l:?}, {l:?}]]

[[body]]
name = "lower"
material = {{ young = {young:?}, poisson = 0.2 }}
rectangle = [[0, {minus:?}], [{l:?}, 0]]

[[boundary]]
body = "upper"
name = "top"
along = [[0, {l:?}], [{l:?}, {l:?}]]
condition = "traction"
value = ["0", "-0.1*e*(1 - 1.75*x/l)"]

[[boundary]]
body = "upper"
name = "left"
along = [[0, 0], [0, {l:?}]]
condition = "sliding"

[[boundary]]
body = "upper"
name = "right"
along = [[{l:?}, 0], [{l:?}, {l:?}]]
condition = "free"

[[boundary]]
body = "lower"
name = "bottom"
along = [[0, {minus:?}], [{l:?}, {minus:?}]]
condition = "fixed"
value = ["0", "0.01*x"]

[[boundary]]
body = "lower"
name = "left"
along = [[0, {minus:?}], [0, 0]]
condition = "free"

[[boundary]]
body = "lower"
name = "right"
along = [[{l:?}, {minus:?}], [{l:?}, 0]]
condition = "free"

[contact]
along = [[0, 0], [{l:?}, 0]]
initial_gap = "0.002*l*sin(5*x/l)"
"#,
        young = 3.0 * e,
        minus = -l
    )
}

fn run(l: f64, e: f64) -> StudyRecord {
    let folder = Folder::with_study(&format!("units-{l:e}-{e:e}"), &scaled(l, e));
    folder.signorini("run scaled --quiet").expect(0);
    folder.record("reports/scaled")
}

/// What a level says once its units are taken away: energies are `e l²` per depth, errors in the energy norm its root.
fn without_units(level: &Level, l: f64, e: f64) -> Vec<(&'static str, f64)> {
    let energy = e * l * l;
    let contact = level.contact.as_ref().expect("a contact zone");
    vec![
        ("h", level.h / l),
        ("energy", level.energy / energy),
        ("error", level.errors.energy.unwrap_or(f64::NAN) / energy.sqrt()),
        ("strain", level.errors.strain.unwrap_or(f64::NAN) / l),
        ("L2", level.errors.l2.unwrap_or(f64::NAN) / (l * l)),
        ("pressure", level.errors.pressure_l2.unwrap_or(f64::NAN) / (e * l.sqrt())),
        ("contact set", level.errors.contact_set.unwrap_or(f64::NAN) / l),
        ("force", contact.force / (e * l)),
        ("peak", contact.peak_pressure / e),
        ("lhs", level.ledger.as_ref().expect("a ledger").lhs / energy),
        ("active", level.active as f64),
        ("weakly active", level.kkt.weakly_active as f64),
        ("steps", level.solver.iterations as f64),
    ]
}

/// Units a power of two apart round alike, so what is left is what really depends on them. Decimal ones round every datum anew, and the
/// solution answers to that with its condition: about 1e-14 of its size here, which is 1e-11 of an L² error of a thousandth of it, give or
/// take the order of summation.
#[test]
fn units_change_nothing() {
    let one = run(1.0, 1.0);
    assert!(one.levels.iter().all(|l| l.active > 0 && l.active < l.constraints), "contact opens nowhere or everywhere");
    let (nano, giga) = (2f64.powi(-30), 2f64.powi(36));
    demand_the_same(&one, [(nano, giga), (1.0 / nano, 1.0 / giga)], 1e-14);
    demand_the_same(&one, [(1e-9, 1e11), (1e9, 1e-11)], 1e-11);
    demand_the_same(&one, [(1e-9, 1e-11), (1e9, 1e11)], 1e-11);
}

fn demand_the_same(one: &StudyRecord, units: [(f64, f64); 2], tolerance: f64) {
    for (l, e) in units {
        let other = run(l, e);
        assert_eq!(other.verdict.outcome, Outcome::Pass);
        for (a, b) in one.levels.iter().zip(&other.levels) {
            for ((name, a), (_, b)) in without_units(a, 1.0, 1.0).into_iter().zip(without_units(b, l, e)) {
                assert!((a - b).abs() <= tolerance * a.abs(), "{name} at l = {l:e}, e = {e:e}: {a} {b}");
            }
            assert!(b.kkt.stationarity < 1e-15 && b.kkt.componentwise < Some(1e-15), "{:?}", b.kkt);
        }
    }
}

#[test]
fn the_page_of_hard_cases_has_a_row_for_each() {
    let folder = Folder::new("hard");
    folder.signorini("run hard-balance hard-smallest --levels 1 --quiet").expect(0);
    let page = folder.text("reports/hard.md");
    for words in [
        "## Solved",
        "### Confirmed by a second solver",
        "## Refused",
        "hard-smallest · one-pair",
        "pushes a body away",
    ] {
        assert!(page.contains(words), "no {words:?} in\n{page}");
    }
    assert_eq!(page.matches("limit load:").count(), 4, "twice in the table, twice in the reasons\n{page}");
    assert!(folder.text("reports/summary.md").contains("(hard.md)"));
    let refused = folder.text("reports/hard-balance/edge/report.md");
    assert!(
        refused.contains("**pass**") && refused.contains("refused on every level, as it should be: limit load"),
        "{refused}"
    );
    // what the records say is enough to write it again
    folder.signorini("report reports").expect(0);
    assert_eq!(folder.text("reports/hard.md").matches("limit load:").count(), 4);
    // and a run without hard cases takes the page away
    folder.add(common::LOADED);
    folder.signorini("run loaded --levels 1 --quiet");
    assert!(!folder.path("reports/hard.md").exists());
}

#[test]
fn check_knows_what_is_to_be_refused() {
    let folder = Folder::new("hard-check");
    let ended = folder.signorini("check hard-balance").expect(0);
    assert!(ended.out.contains("3 of 3 levels refused, as all should be"), "{}", ended.out);
    assert!(ended.out.contains("limit load"), "{}", ended.out);
}
