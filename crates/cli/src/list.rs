//! `signorini list`: every claim and every study.

use crate::failure::Failure;
use crate::run::library;
use signorini_study::claim::catalogue::{Entry, Standing, catalogue};
use signorini_study::study::Study;

/// Prints the studies with their claims, then every claim with the studies that judge it.
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
        let judges: Vec<&str> = studies.iter().filter(|s| s.claim.id == entry.id).map(|s| s.id.as_str()).collect();
        sayln!("  {:<28} {}", entry.id, entry.statement);
        sayln!("  {:<28}   {}", "", standing(entry, &judges));
    }
    Ok(0)
}

/// Which studies judge the claim, or why there is nothing to run.
fn standing(entry: &Entry, judges: &[&str]) -> String {
    match entry.standing {
        Standing::Nothing(why) => format!("nothing to run: {why}"),
        Standing::Landed if judges.is_empty() => "no study here judges it".into(),
        Standing::Landed => format!("judged by {}", judges.join(", ")),
    }
}
