//! The paper statement by statement: which study judges it, the bounds, what was observed, the verdict.

use crate::format;
use crate::norm::judged_rate;
use crate::table::{Cell, Column, Row, Table};
use crate::verdict::{self, outcome_word};
use signorini_study::claim::catalogue::{Standing, catalogue};
use signorini_study::record::{Bounds, Outcome, Rate, StudyRecord};
use std::collections::BTreeMap;

/// `statements.md`: one row per statement of the catalogue and study that judges it, then the studies that state a claim
/// of their own. Controls are left out: they are built to be refused.
pub fn statements_markdown(records: &[StudyRecord]) -> String {
    let judged: Vec<&StudyRecord> = records.iter().filter(|r| r.expect.is_none()).collect();
    let catalogued: Vec<Row> = catalogue()
        .iter()
        .flat_map(|entry| {
            let studies = by_study(judged.iter().copied().filter(|r| r.claim == entry.id));
            if studies.is_empty() {
                return vec![unjudged(entry.id, entry.statement, entry.standing)];
            }
            studies.values().map(|cases| judged_row(entry.id, entry.statement, cases)).collect()
        })
        .collect();
    let known = |r: &StudyRecord| catalogue().iter().any(|e| e.id == r.claim);
    let own = by_study(judged.iter().copied().filter(|r| !known(r)));
    let own: Vec<Row> = own.values().map(|cases| judged_row("own", &cases[0].statement, cases)).collect();
    let mut out = format!("# Statements\n\n{INTRODUCTION}\n\n{}", table(catalogued).to_markdown());
    if !own.is_empty() {
        out += &format!("\n## Claims that studies state themselves\n\n{}", table(own).to_markdown());
    }
    out
}

const INTRODUCTION: &str = "One row for each statement of the paper, and each study that judges it. Paper, today: proven \
bounds on the rate; expected: from the regularity of the solution. Observed: the fitted rates of all cases, from the \
smallest to the largest, and in brackets what their 95 % intervals cover together; of claims without a rate what was \
seen. Every case has its own page, linked from the [summary](summary.md).";

/// The cases of each study, by id.
fn by_study<'a>(records: impl Iterator<Item = &'a StudyRecord>) -> BTreeMap<&'a str, Vec<&'a StudyRecord>> {
    let mut studies: BTreeMap<&str, Vec<&StudyRecord>> = BTreeMap::new();
    records.for_each(|r| studies.entry(&r.study).or_default().push(r));
    studies
}

fn table(rows: Vec<Row>) -> Table {
    let columns = [
        ("statement", "statement"),
        ("claim", "claim"),
        ("study", "study"),
        ("paper", "paper"),
        ("today", "today"),
        ("expected", "expected"),
        ("observed", "observed"),
        ("verdict", "verdict"),
    ];
    Table { rows, columns: columns.map(|(key, heading)| Column::new(key, heading)).to_vec() }
}

fn unjudged(id: &str, statement: &str, standing: Standing) -> Row {
    let why = match standing {
        Standing::Landed => "not in this run".into(),
        Standing::Nothing(why) => format!("nothing to run: {why}"),
    };
    let gap = || Cell::Missing;
    let cells = vec![Cell::text(id), Cell::text(statement), gap(), gap(), gap(), gap(), Cell::Text(why), gap()];
    Row { cells, excluded: None }
}

fn judged_row(id: &str, statement: &str, cases: &[&StudyRecord]) -> Row {
    let bound = |of: fn(&Bounds) -> Option<f64>| bounds(cases.iter().filter_map(|r| of(&r.bounds)));
    let link = cases[0].several.then_some("summary.md").map_or_else(
        || format!("[{0}]({0}/report.md)", cases[0].study),
        |page| format!("[{}]({page}), {} cases", cases[0].study, cases.len()),
    );
    Row {
        cells: vec![
            Cell::text(id),
            Cell::text(statement),
            Cell::Text(link),
            bound(|b| b.paper),
            bound(|b| b.today),
            bound(|b| b.expected),
            Cell::Text(observed(cases)),
            Cell::Text(outcomes(cases)),
        ],
        excluded: None,
    }
}

/// The values that occur, each once, ascending.
fn bounds(values: impl Iterator<Item = f64>) -> Cell {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    match values.as_slice() {
        [] => Cell::Missing,
        [one] => Cell::bound(Some(*one)),
        [first, .., last] => Cell::Text(format!("{}–{}", format::bound(*first), format::bound(*last))),
    }
}

/// `0.975–1.034 [0.930, 1.059]`; where no rate was fitted the reason of the worst verdict.
fn observed(cases: &[&StudyRecord]) -> String {
    let rates: Vec<&Rate> = cases.iter().filter_map(|r| judged_rate(r)).collect();
    let Some(worst) = cases.iter().max_by_key(|r| r.verdict.outcome) else {
        return String::new();
    };
    if rates.is_empty() {
        return worst.verdict.reasons.first().cloned().unwrap_or_default();
    }
    let least = |of: fn(&Rate) -> f64| rates.iter().map(|r| of(r)).fold(f64::INFINITY, f64::min);
    let most = |of: fn(&Rate) -> f64| rates.iter().map(|r| of(r)).fold(f64::NEG_INFINITY, f64::max);
    let (low, high) = (least(|r| r.low), most(|r| r.high));
    match (least(|r| r.slope), most(|r| r.slope)) {
        (one, same) if rates.len() == 1 || one == same => format::interval(one, low, high),
        (from, to) => {
            let slopes = format!("{}–{}", format::rate(from), format::rate(to));
            format!("{slopes} [{}, {}]", format::rate(low), format::rate(high))
        }
    }
}

/// `5 pass, 1 inconclusive`.
fn outcomes(cases: &[&StudyRecord]) -> String {
    let count = |outcome: Outcome| cases.iter().filter(|r| r.verdict.outcome == outcome).count();
    let expected = cases.iter().filter(|r| verdict::standing(r) == verdict::Standing::ExpectedInconclusive).count();
    let words = [Outcome::Pass, Outcome::Fail, Outcome::Inconclusive].into_iter().filter_map(|outcome| {
        let n = count(outcome);
        let announced = outcome == Outcome::Inconclusive && n == expected;
        (n > 0).then(|| {
            format!("{n} {}{}", outcome_word(outcome), if announced { " (expected at this size)" } else { "" })
        })
    });
    words.collect::<Vec<_>>().join(", ")
}
