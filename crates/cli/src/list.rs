//! `signorini list`: every claim and every study.

use crate::failure::Failure;
use crate::run::library;
use signorini_study::claim::catalogue::{Entry, Standing, catalogue};
use signorini_study::study::Study;

/// Prints the studies with their claims, then the claims that have no study yet.
pub fn list() -> Result<u8, Failure> {
    let library = library()?;
    let studies: Vec<Study> =
        library.sources.iter().map(|s| s.load().map_err(Failure::from)).collect::<Result<_, _>>()?;
    match &library.folder {
        Some(folder) => sayln!("studies in {}:", folder.display()),
        None => sayln!("studies shipped with the program (no studies/ folder here or above):"),
    }
    for (source, study) in library.sources.iter().zip(&studies) {
        let group = source.group.folder();
        let group = if group.is_empty() { String::new() } else { format!(" [{group}]") };
        sayln!("  {:<28} {:<16} {}{group}", study.id, study.claim.id, study.title);
    }
    sayln!("\nclaims:");
    for entry in catalogue() {
        sayln!("  {:<28} {:<16} {}", entry.id, standing(entry, &studies), entry.statement);
        if let Standing::Nothing(why) = entry.standing {
            sayln!("  {:<28} {:<16} {why}", "", "");
        }
    }
    Ok(0)
}

fn standing(entry: &Entry, studies: &[Study]) -> String {
    match (entry.standing, studies.iter().filter(|s| s.claim.id == entry.id).count()) {
        (Standing::NotYet, _) => "not yet".into(),
        (Standing::Nothing(_), _) => "nothing to run:".into(),
        (Standing::Landed, 1) => "1 study".into(),
        (Standing::Landed, n) => format!("{n} studies"),
    }
}
