//! How regular the meshes of a case are, in sentences, where the claim asks for a regular or a strongly regular family.

use crate::format;
use signorini_study::claim::hypothesis::{LARGEST_SIDE_RATIO, Regularity, StrongRegularity};
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

/// Whether the smallest angle stays bounded on the levels measured; `None` where the claim does not ask for it.
pub fn angles(record: &StudyRecord) -> Option<String> {
    let found = Regularity::of(record)?;
    let smallest = found.angles.iter().copied().fold(f64::INFINITY, f64::min);
    let degrees = |angle: f64| format!("{}°", format::significant(angle, 3));
    Some(match found.falls_like {
        None => format!("the smallest angle is at least {} on every level, as of a regular family.", degrees(smallest)),
        Some(power) => format!(
            "the smallest angle falls from {} to {}, like h^{}: not a regular family, the claim's hypothesis is violated.",
            degrees(found.angles[0]),
            degrees(smallest),
            format::rate(power),
        ),
    })
}
