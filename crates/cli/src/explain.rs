//! `signorini explain`: a claim in full.

use crate::failure::Failure;
use crate::run::library;
use signorini_report::format;
use signorini_report::markdown::kind_words;
use signorini_report::norm;
use signorini_study::claim::catalogue::{Entry, Standing, UnknownClaim, find};
use signorini_study::file::Library;
use signorini_study::study::Study;

/// Columns of the labels.
const LABELS: usize = 12;

/// Prints statement, hypotheses, bounds with their sources, and the studies that judge the claim.
pub fn explain(claim: &str) -> Result<u8, Failure> {
    let library = library()?;
    let entry = find(claim).map_err(|unknown| no_claim(&unknown, &library))?;
    sayln!("{}\n", entry.id);
    line("statement", entry.statement);
    lines("hypotheses", entry.hypotheses.iter().map(|h| (*h).to_string()));
    line("judged", &format!("{}, in {}", kind_words(entry.kind), norm::words(entry.norm)));
    lines("bounds", bounds(entry));
    lines("sources", entry.sources.iter().map(|s| (*s).to_string()));
    lines("studies", judges(entry, &library)?);
    Ok(0)
}

fn bounds(entry: &Entry) -> Vec<String> {
    let one = |whose: &str, bound: Option<f64>| bound.map(|b| format!("{whose}: {}", format::order(b)));
    let stated: Vec<String> =
        [one("the paper's", entry.paper), one("today's", entry.today)].into_iter().flatten().collect();
    if stated.is_empty() { vec!["none on a rate; a study may state the rate that it expects".into()] } else { stated }
}

fn judges(entry: &Entry, library: &Library) -> Result<Vec<String>, Failure> {
    if let Standing::Nothing(why) = entry.standing {
        return Ok(vec![format!("nothing to run: {why}")]);
    }
    let studies: Vec<Study> =
        library.sources.iter().map(|s| s.load().map_err(Failure::from)).collect::<Result<_, _>>()?;
    let judges = studies.iter().filter(|s| s.claim.id == entry.id);
    let rows: Vec<String> = judges.map(|s| format!("{}: {}", s.id, s.title)).collect();
    Ok(if rows.is_empty() { vec!["no study here judges it".into()] } else { rows })
}

/// The nearest claim; of a study's id, the claim that it judges.
fn no_claim(unknown: &UnknownClaim, library: &Library) -> Failure {
    let study = library.sources.iter().find(|s| s.id == unknown.id).and_then(|s| s.load().ok());
    match study {
        Some(study) if study.claim.id == "own" => {
            let what = format!("`{}` is a study with a claim of its own: {}", study.id, study.claim.statement);
            Failure::new(what, format!("`signorini check {}` shows its hypotheses", study.id))
        }
        Some(study) => {
            let what = format!("`{}` is a study, no claim", study.id);
            Failure::new(what, format!("it judges a claim: `signorini explain {}`", study.claim.id))
        }
        None => {
            let hint = format!("did you mean `{}`? `signorini list` shows every claim", unknown.nearest);
            Failure::new(format!("there is no claim `{}`", unknown.id), hint)
        }
    }
}

fn line(label: &str, text: &str) {
    sayln!("{label:<LABELS$}{text}");
}

/// A label, and one line for each text.
fn lines(label: &str, texts: impl IntoIterator<Item = String>) {
    for (number, text) in texts.into_iter().enumerate() {
        line(if number == 0 { label } else { "" }, &text);
    }
}
