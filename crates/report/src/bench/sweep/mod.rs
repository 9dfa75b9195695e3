//! Cases that differ in swept values: one table of all of them, and a short one for each key that is swept.

mod entry;
mod picture;
mod tables;
#[cfg(test)]
mod tests;

use super::words::error_source;
use crate::plot::PanelChart;
use entry::{Entry, entries};
use signorini_study::bench::record::{BenchRecord, BenchStudy};

/// Widest table on a terminal.
const TEXT_WIDTH: usize = 170;
/// Above this ratio linear triangles lock in plane strain.
const LOCKING: f64 = 0.45;

/// What stands together on the page.
pub(super) enum Group<'a> {
    /// A case by itself, with its position.
    One(usize, &'a BenchStudy),
    /// The cases of a sweep.
    Sweep(Sweep<'a>),
}

/// The cases of a sweep, at least one.
pub(super) struct Sweep<'a> {
    studies: Vec<&'a BenchStudy>,
}

/// The studies of a record in their order, cases of a sweep together.
pub(super) fn groups(record: &BenchRecord) -> Vec<Group<'_>> {
    let mut groups: Vec<Group> = Vec::new();
    for (position, study) in record.studies.iter().enumerate() {
        match groups.last_mut() {
            Some(Group::Sweep(sweep)) if sweep.has(study) => sweep.studies.push(study),
            _ if is_swept(study) => groups.push(Group::Sweep(Sweep { studies: vec![study] })),
            _ => groups.push(Group::One(position, study)),
        }
    }
    groups
}

fn is_swept(study: &BenchStudy) -> bool {
    study.changed.as_ref().is_some_and(|c| c.swept().next().is_some())
}

impl<'a> Sweep<'a> {
    /// Whether the case belongs to the same sweep of the same case of the file.
    fn has(&self, study: &BenchStudy) -> bool {
        let of = |s: &BenchStudy| s.changed.as_ref().map(|c| (c.study.clone(), c.case.clone(), c.options.clone()));
        is_swept(study) && of(self.studies[0]) == of(study)
    }

    fn entries(&self) -> Vec<Entry<'a>> {
        self.studies.iter().flat_map(|s| entries(s)).collect()
    }

    /// Study and case of the file.
    fn name(&self) -> String {
        let study = self.studies[0];
        let case = study.changed.as_ref().map_or(&study.case, |c| &c.case);
        if *case == study.study { study.study.clone() } else { format!("{}/{case}", study.study) }
    }

    fn options(&self) -> String {
        self.studies[0].changed.as_ref().map_or_else(String::new, |c| c.options.join(" "))
    }

    /// The part of the page.
    pub(super) fn page(&self, picture: Option<&str>) -> String {
        let (study, entries) = (self.studies[0], self.entries());
        let name = self.name();
        let mut out =
            format!("## Sweep of {name}\n\n{}. Family `{}`. {}\n\n", study.title, study.family, error_source(study));
        out += &format!("Changed: `{}`. {LEGEND}\n\n", self.options());
        if locks(&entries) {
            out += &format!("{LOCKS}\n\n");
        }
        for (key, table) in tables::by_key(&entries) {
            out += &format!("### By {key}\n\n{BY_KEY}\n\n{}\n", table.to_markdown());
        }
        if let Some(picture) = picture {
            out += &format!("![Work and seconds against the swept values]({picture})\n\n");
        }
        out + &format!("### Every case\n\n{}\n", tables::all(&entries).to_markdown())
    }

    /// The same in short, for the terminal.
    pub(super) fn text(&self) -> String {
        let entries = self.entries();
        let mut out = format!("{}: {}\n{}\n", self.name(), self.options(), tables::all(&entries).to_text(TEXT_WIDTH));
        for (key, table) in tables::by_key(&entries) {
            out += &format!("by {key}\n{}\n", table.to_text(TEXT_WIDTH));
        }
        if locks(&entries) { out + LOCKS + "\n" } else { out }
    }

    /// Work and seconds against the swept numbers, if there are numbers.
    pub(super) fn chart(&self, record: &BenchRecord) -> Option<PanelChart> {
        picture::chart(record, &self.name(), &self.entries())
    }

    /// `sweep.png`, of further sweeps with the study's id.
    pub(super) fn picture_name(&self, number: usize) -> String {
        if number == 0 { "sweep.png".into() } else { format!("sweep-{number}-{}.png", self.studies[0].study) }
    }
}

const LEGEND: &str = "*Closed* is the share of the constraints that press. *CPU* counts processor seconds of set-up and solve, all threads together; \
*linear* is the same mesh and material with every pair tied. No products are timed here.";
const BY_KEY: &str = "From the smallest to the largest over everything else that is swept and all sizes. The last column compares each case with that of the first value, all else equal.";
const LOCKS: &str = "Linear triangles lock near incompressibility (plane strain, ν above 0.45): there the error on a given mesh \
grows with 1/(1 − 2ν), whatever solves the equations. Work and seconds are those of the solver alone.";

fn locks(entries: &[Entry]) -> bool {
    let near =
        |e: &Entry| e.settings.iter().any(|s| s.key.ends_with(".poisson") && s.number.is_some_and(|nu| nu > LOCKING));
    entries.iter().any(near)
}
