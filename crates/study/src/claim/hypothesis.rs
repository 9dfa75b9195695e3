//! Whether the measured meshes meet the hypothesis of strong regularity, where the claim asks for it.

use crate::record::StudyRecord;

/// Largest `β`, the ratio of any two sides of one mesh, that the paper's strongly regular families have.
pub const LARGEST_SIDE_RATIO: f64 = 2.0;

/// Equal lengths that were computed apart may differ by this share.
const ROUNDING: f64 = 1e-9;

/// How regular the meshes of a case are, against the hypothesis.
#[derive(Clone, Debug, PartialEq)]
pub struct StrongRegularity {
    /// Largest `β` of any level; at most [`LARGEST_SIDE_RATIO`] is asked for.
    pub side_ratio: f64,
    /// Largest ratio of a straight side to the longest chord of its mesh, at most 1 is asked for; `None` where no level
    /// measured it.
    pub straight_over_chord: Option<f64>,
    /// Levels that miss one of the two.
    pub missed: Vec<usize>,
}

impl StrongRegularity {
    /// Of a record whose claim asks for a strongly regular family and that has levels; `None` for others.
    pub fn of(record: &StudyRecord) -> Option<Self> {
        let asked = record.hypotheses.iter().any(|h| h.contains("strongly regular"));
        if !asked || record.levels.is_empty() {
            return None;
        }
        let largest = |values: &mut dyn Iterator<Item = f64>| values.reduce(f64::max);
        let exceeds = |value: f64, bound: f64| value > bound * (1.0 + ROUNDING);
        let missed = record.levels.iter().filter(|l| {
            exceeds(l.side_ratio, LARGEST_SIDE_RATIO) || l.straight_over_chord.is_some_and(|s| exceeds(s, 1.0))
        });
        Some(Self {
            side_ratio: largest(&mut record.levels.iter().map(|l| l.side_ratio))?,
            straight_over_chord: largest(&mut record.levels.iter().filter_map(|l| l.straight_over_chord)),
            missed: missed.map(|l| l.level).collect(),
        })
    }

    /// Whether every level meets the hypothesis.
    pub fn is_met(&self) -> bool {
        self.missed.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn record(ratios: &[(f64, f64)]) -> StudyRecord {
        let mut levels = sample::levels(ratios.len(), |h| h);
        for (level, (beta, chord)) in levels.iter_mut().zip(ratios) {
            (level.side_ratio, level.straight_over_chord) = (*beta, Some(*chord));
        }
        let hypotheses = vec!["u ∈ H²".into(), "strongly regular family".into()];
        StudyRecord { hypotheses, ..sample::record("s", "s", levels) }
    }

    #[test]
    fn both_conditions_count_on_every_level() {
        let met = StrongRegularity::of(&record(&[(1.5, 0.9), (2.0, 1.0 + 1e-12), (1.9, 0.8)])).unwrap();
        assert!(met.is_met());
        assert_eq!((met.side_ratio, met.straight_over_chord), (2.0, Some(1.0 + 1e-12)));
        let missed = StrongRegularity::of(&record(&[(2.1, 0.9), (2.0, 1.0), (1.9, 1.1)])).unwrap();
        assert_eq!(missed.missed, [0, 2]);
        assert!(!missed.is_met());
    }

    #[test]
    fn claims_that_do_not_ask_get_no_answer() {
        let mut silent = record(&[(3.0, 0.9)]);
        silent.hypotheses = vec!["regular family".into()];
        assert_eq!(StrongRegularity::of(&silent), None);
        assert_eq!(StrongRegularity::of(&record(&[])), None);
    }

    #[test]
    fn a_mesh_without_curves_is_judged_by_its_sides() {
        let mut record = record(&[(1.7, 0.0)]);
        record.levels[0].straight_over_chord = None;
        let found = StrongRegularity::of(&record).unwrap();
        assert!(found.is_met() && found.straight_over_chord.is_none());
    }
}
