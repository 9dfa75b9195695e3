//! Whether the measured meshes meet the hypotheses of regularity and of strong regularity, where the claim asks for them.

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

/// The smallest angle falls like at least this power of `h`: no family that looks regular.
const FALLING: f64 = 0.25;

/// Whether the smallest angle stays away from zero, as far as the levels can tell.
#[derive(Clone, Debug, PartialEq)]
pub struct Regularity {
    /// Smallest angle of each level in degrees, coarsest first.
    pub angles: Vec<f64>,
    /// `p` of `ϑ ~ h^p` between the coarsest and the finest level, where that is a fall.
    pub falls_like: Option<f64>,
}

impl Regularity {
    /// Of a record whose claim asks for a regular family and whose levels have angles; `None` for others.
    pub fn of(record: &StudyRecord) -> Option<Self> {
        let asked = record.hypotheses.iter().any(|h| h.contains("regular family") || h.contains("strongly regular"));
        let angles: Vec<f64> = record.levels.iter().map(|l| l.min_angle).collect();
        // an angle of 0 is that of a family of intervals
        if !asked || angles.is_empty() || angles.contains(&0.0) {
            return None;
        }
        let (first, last) = (record.levels.first()?, record.levels.last()?);
        // ϑ_0/ϑ_N = (h_0/h_N)^p
        let power = (first.min_angle / last.min_angle).ln() / (first.h / last.h).ln();
        Some(Self { angles, falls_like: Some(power).filter(|p| *p > FALLING && record.levels.len() > 1) })
    }

    /// Whether the family looks regular.
    pub fn is_met(&self) -> bool {
        self.falls_like.is_none()
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

    fn with_angles(angles: &[f64]) -> StudyRecord {
        let mut levels = sample::levels(angles.len(), |h| h);
        levels.iter_mut().zip(angles).for_each(|(l, a)| l.min_angle = *a);
        sample::record("s", "s", levels)
    }

    #[test]
    fn angles_that_fall_with_h_are_no_regular_family() {
        let falling = Regularity::of(&with_angles(&[26.0, 13.0, 6.5, 3.25])).unwrap();
        assert!(!falling.is_met() && (falling.falls_like.unwrap() - 1.0).abs() < 1e-12);
        // random meshes lose some degrees without a trend
        let steady = Regularity::of(&with_angles(&[27.0, 21.0, 24.0, 20.0])).unwrap();
        assert!(steady.is_met() && steady.angles[1] == 21.0);
        assert!(Regularity::of(&with_angles(&[26.0])).unwrap().is_met());
        assert_eq!(Regularity::of(&with_angles(&[0.0, 0.0])), None);
        let unasked = StudyRecord { hypotheses: vec!["p linear".into()], ..with_angles(&[26.0, 13.0]) };
        assert_eq!(Regularity::of(&unasked), None);
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
