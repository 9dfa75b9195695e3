//! How regular the meshes of a case are, in a sentence, where the claim asks for a strongly regular family.

use crate::format;
use signorini_study::claim::hypothesis::{LARGEST_SIDE_RATIO, StrongRegularity};
use signorini_study::record::StudyRecord;

/// Digits of the ratios.
const DIGITS: usize = 4;

/// Whether the hypothesis is met, with the largest ratios of all levels; `None` where the claim does not ask for it.
pub fn sentence(record: &StudyRecord) -> Option<String> {
    let found = StrongRegularity::of(record)?;
    let reach = if found.is_met() { "at most" } else { "up to" };
    let beta = format!(
        "β {reach} {} ({} allowed)",
        format::significant(found.side_ratio, DIGITS),
        format::bound(LARGEST_SIDE_RATIO),
    );
    let chord = found.straight_over_chord.map_or_else(String::new, |ratio| {
        format!(", straight sides {reach} {} of the longest chord (1 allowed)", format::significant(ratio, DIGITS))
    });
    Some(if found.is_met() {
        format!("strongly regular on every level, as the claim asks: {beta}{chord}.")
    } else {
        let levels = format::level_words(&found.missed);
        format!(
            "not strongly regular on {levels}: {beta}{chord}. The claim asks for it, so this family only illustrates it."
        )
    })
}
