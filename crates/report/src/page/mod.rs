//! `index.html`: one page for a run that needs no network and no server. Everything of the reports is in it, pictures included.
//!
//! It is made of what the reports are made of: the Markdown of [`statements`](crate::statements), [`summary`](crate::summary), [`hard`](crate::hard) and
//! of each case, turned into HTML, and the SVG files beside it. Times alone are not of the records; they stand between the comments
//! `<!--times-->` and `<!--/times-->`, and where a run has left none, nothing does.

mod html;
mod times;

use crate::error::ReportError;
use crate::norm::judged_rate;
use crate::summary::name;
use crate::{format, hard, markdown, statements, summary, verdict};
use askama::Template;
use signorini_study::record::StudyRecord;
use signorini_study::store::record_folder;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What the template shows.
#[derive(Template)]
#[template(path = "page.html")]
struct Page<'a> {
    version: &'a str,
    counts: String,
    style: &'a str,
    script: &'a str,
    statements: String,
    summary: String,
    hard: Option<String>,
    studies: Vec<Study<'a>>,
}

struct Study<'a> {
    id: &'a str,
    title: &'a str,
    cases: Vec<Case<'a>>,
}

struct Case<'a> {
    /// The folder of the case, by which links find it.
    place: String,
    name: &'a str,
    class: &'static str,
    verdict: String,
    observed: String,
    body: String,
    times: String,
}

/// The page of the records below `dir`.
///
/// # Errors
/// [`ReportError`] for names that are no folders, and where the template fails.
pub(crate) fn page(records: &[StudyRecord], dir: &Path) -> Result<String, ReportError> {
    let page = Page {
        version: env!("CARGO_PKG_VERSION"),
        counts: verdict::counts(records),
        style: include_str!("../../templates/page.css"),
        script: include_str!("../../templates/page.js"),
        statements: without_heading(&statements::statements_markdown(records)),
        summary: without_heading(&summary::summary_markdown(records)),
        hard: hard::page(records).map(|text| without_heading(&text)),
        studies: studies(records, dir)?,
    };
    page.render().map_err(|e| ReportError::Page(e.to_string()))
}

/// HTML of a Markdown page but its first line, which the template says itself.
fn without_heading(text: &str) -> String {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    html::html(if first.starts_with('#') { rest } else { text }, |_| None)
}

/// The studies in the order of their first records.
fn studies<'a>(records: &'a [StudyRecord], dir: &Path) -> Result<Vec<Study<'a>>, ReportError> {
    let mut place = BTreeMap::new();
    let mut studies: Vec<Study> = Vec::new();
    for record in records {
        let k = *place.entry(&record.study).or_insert_with(|| {
            studies.push(Study { id: &record.study, title: &record.title, cases: Vec::new() });
            studies.len() - 1
        });
        studies[k].cases.push(case(record, dir)?);
    }
    Ok(studies)
}

fn case<'a>(record: &'a StudyRecord, dir: &Path) -> Result<Case<'a>, ReportError> {
    let folder = record_folder(dir, record)?;
    let svg = |file: &str| fs::read_to_string(folder.join(file).with_extension("svg")).ok();
    let is_there = |name: &str| folder.join(name).with_extension("svg").is_file();
    let pictures = markdown::Pictures {
        rates: is_there("rates"),
        ledger: is_there("ledger"),
        parts: is_there("parts"),
        pressure: is_there("pressure"),
        bodies: is_there("mesh"),
    };
    let observed = judged_rate(record).map(|r| format::interval(r.slope, r.low, r.high));
    let words = verdict::words(record);
    Ok(Case {
        place: if record.several { format!("{}/{}", record.study, record.case) } else { record.study.clone() },
        name: &record.case,
        class: html::class(&words).unwrap_or("met"),
        verdict: words,
        observed: observed.unwrap_or_default(),
        body: html::html(&body(record, pictures), svg),
        times: html::html(&times::markdown(record, dir), |_| None),
    })
}

/// The report without its head, which the page shows itself.
fn body(record: &StudyRecord, pictures: markdown::Pictures) -> String {
    let page = markdown::page(record, pictures);
    page.find("\n## ").map_or_else(|| name(record), |start| page[start..].to_owned())
}
