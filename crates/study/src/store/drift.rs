//! How far a run has moved from the baseline.
//!
//! Levels are matched by their dofs, so a longer or shorter run compares what both have; errors and rates are compared
//! only where they were measured against the same reference, rates only between runs of the same levels. What another machine may change is allowed for: energies to 1e-8, errors to four
//! significant digits (and to rounding, where the error is nothing else), rates to three decimals.

use super::Baseline;
use super::baseline::{BaselineCase, BaselineLevel, norm_rates, reference_dofs};
use crate::claim::quantity::in_words;
use crate::record::{Level, StudyRecord};

/// Relative change of an energy.
const ENERGY: f64 = 1e-8;

/// Change of a rate: half a unit of the third decimal.
const RATE: f64 = 5e-4;

/// An error below this share of `‖u‖_A` is rounding and differs from machine to machine.
const ROUNDING: f64 = 1e-11;

/// Every difference between a record and its baseline, in words; empty where there is none.
pub fn drift(baseline: &Baseline, record: &StudyRecord) -> Vec<String> {
    let Some(case) = baseline.cases.get(&record.case) else {
        return vec![format!("case {} has no baseline", record.case)];
    };
    let mut pairs: Vec<(&BaselineLevel, &Level)> =
        record.levels.iter().filter_map(|l| Some((case.levels.iter().find(|b| b.dofs == l.dofs)?, l))).collect();
    if case.profile != record.profile {
        // a refined family that starts from another coarse mesh has other meshes
        pairs.retain(|(b, l)| b.mesh_hash == l.mesh_hash);
        if pairs.is_empty() {
            return Vec::new();
        }
    }
    if pairs.is_empty() {
        return vec!["no level has as many dofs as a level of the baseline".into()];
    }
    let mut found: Vec<String> = pairs.iter().flat_map(|(b, l)| of_solution(b, l)).collect();
    if case.reference_dofs != reference_dofs(record) {
        return found;
    }
    found.extend(pairs.iter().flat_map(|(b, l)| of_errors(b, l)));
    if pairs.len() == record.levels.len() && pairs.len() == case.levels.len() {
        found.extend(of_rates(case, record));
    } else if case.profile == record.profile {
        found.push(format!("{} levels, the baseline has {}", record.levels.len(), case.levels.len()));
    }
    found
}

fn of_solution(b: &BaselineLevel, l: &Level) -> Vec<String> {
    let mut found = Vec::new();
    if b.mesh_hash != l.mesh_hash {
        found.push(format!("level {}: mesh {}, was {}", l.level, l.mesh_hash, b.mesh_hash));
    }
    // NaN is a change
    let moved = (l.energy - b.energy).abs();
    if moved.is_nan() || moved > ENERGY * b.energy.abs() {
        found.push(format!("level {}: energy {:.12e}, was {:.12e}", l.level, l.energy, b.energy));
    }
    found
}

fn of_errors(b: &BaselineLevel, l: &Level) -> Vec<String> {
    let floor = ROUNDING * l.solution_energy.unwrap_or(0.0);
    let errors = [
        ("strain error", l.errors.strain, b.strain_error),
        ("energy error", l.errors.energy, b.energy_error),
        ("boundary error", l.errors.boundary_l2, b.boundary_error),
        ("constant", l.errors.constant, b.constant),
    ];
    let moved = errors.into_iter().filter(|(_, now, was)| !same_error(*now, *was, floor));
    moved.map(|(name, now, was)| format!("level {}: {name} {}, was {}", l.level, number(now), number(was))).collect()
}

/// Equal to half a unit of the fourth significant digit, or to rounding.
fn same_error(now: Option<f64>, was: Option<f64>, floor: f64) -> bool {
    match (now, was) {
        (None, None) => true,
        (Some(now), Some(0.0)) => now.abs() <= floor,
        (Some(now), Some(was)) => {
            let unit = 10.0_f64.powi(was.abs().log10().floor() as i32 - 3);
            (now - was).abs() <= (0.5 * unit).max(floor)
        }
        _ => false,
    }
}

fn of_rates(case: &BaselineCase, record: &StudyRecord) -> Vec<String> {
    let lost = case.rates.keys().filter(|name| !record.rates.contains_key(*name));
    let mut found: Vec<String> = lost.map(|name| format!("{}: the rate is gone", in_words(name))).collect();
    for (name, rate) in norm_rates(record) {
        match case.rates.get(name) {
            None => found.push(format!("{}: rate {:.4}, was none", in_words(name), rate.slope)),
            Some(was) if (rate.slope - was).abs() > RATE => {
                found.push(format!("{}: rate {:.4}, was {was:.4}", in_words(name), rate.slope));
            }
            Some(_) => {}
        }
    }
    found
}

fn number(value: Option<f64>) -> String {
    value.map_or("–".into(), |v| format!("{v:.5e}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Reference;
    use crate::sample;
    use crate::store::scratch::Scratch;

    fn record(levels: usize) -> StudyRecord {
        sample::record("s", "structured", sample::levels(levels, |h| 0.3 * h))
    }

    fn blessed() -> Baseline {
        let hashes = [("structured".to_string(), "0123456789abcdef".to_string())].into();
        Baseline::from_records(&[record(5)], &hashes, "0.1.0").unwrap()
    }

    fn moved(change: impl Fn(&mut StudyRecord)) -> Vec<String> {
        let mut record = record(5);
        change(&mut record);
        drift(&blessed(), &record)
    }

    #[test]
    fn a_baseline_survives_writing_and_reading() {
        let scratch = Scratch::new("baseline");
        let path = blessed().write(&scratch.0).unwrap();
        assert!(path.ends_with("s.json"));
        assert_eq!(Baseline::read(&scratch.0, "s").unwrap(), Some(blessed()));
        assert_eq!(Baseline::read(&scratch.0, "other").unwrap(), None);
        std::fs::write(&path, "{}").unwrap();
        assert!(matches!(Baseline::read(&scratch.0, "s"), Err(crate::store::StoreError::Content { .. })));
        assert_eq!(blessed().cases["structured"].scene_hash.as_deref(), Some("0123456789abcdef"));
        assert_eq!(Baseline::from_records(&[], &Default::default(), "0.1.0"), None);
    }

    #[test]
    fn the_same_run_has_not_moved_and_noise_of_machines_is_allowed() {
        assert_eq!(moved(|_| {}), [""; 0]);
        let noise = |r: &mut StudyRecord| {
            r.levels[2].energy *= 1.0 + 5e-9;
            r.levels[2].errors.energy = r.levels[2].errors.energy.map(|e| e * (1.0 + 2e-5));
            r.rates.get_mut("strain").unwrap().slope += 4e-4;
        };
        assert_eq!(moved(noise), [""; 0]);
    }

    #[test]
    fn every_change_is_told() {
        type Change = fn(&mut StudyRecord);
        let changes: [(Change, &str); 9] = [
            (|r| r.levels[2].energy *= 1.0 + 2e-8, "level 2: energy"),
            (|r| r.levels[2].energy = f64::NAN, "level 2: energy NaN"),
            (|r| r.levels[1].errors.strain = r.levels[1].errors.strain.map(|e| 1.001 * e), "level 1: strain error"),
            (|r| r.levels[1].errors.energy = None, "level 1: energy error –"),
            (|r| r.levels[4].mesh_hash = "f".repeat(16), "level 4: mesh"),
            (|r| r.rates.get_mut("strain").unwrap().slope += 6e-4, "strain: rate 1.0006, was 1.0000"),
            (|r| r.levels[1].errors.constant = Some(1.0), "level 1: constant 1.00000e0, was –"),
            (|r| drop(r.rates.remove("dofs")), "dofs: the rate is gone"),
            (|r| r.case = "delaunay".into(), "case delaunay has no baseline"),
        ];
        for (change, told) in changes {
            let found = moved(change);
            assert!(found.len() == 1 && found[0].contains(told), "{told}: {found:?}");
        }
    }

    /// Slopes of single terms may scatter: they are no part of a baseline, and their change is no drift.
    #[test]
    fn rates_of_ledger_terms_are_not_stored() {
        let with_term = |r: &mut StudyRecord| drop(r.rates.insert("ledger.b".into(), r.rates["strain"].clone()));
        assert_eq!(moved(with_term), [""; 0]);
        let mut record = record(5);
        with_term(&mut record);
        let stored = Baseline::from_records(&[record], &Default::default(), "0.1.0").unwrap();
        assert_eq!(stored.cases["structured"].rates.keys().collect::<Vec<_>>(), ["dofs", "energy", "strain"]);
    }

    #[test]
    fn rounding_errors_may_be_anything_below_rounding() {
        let rounding = |e: f64| move |r: &mut StudyRecord| r.levels[0].errors.energy = Some(e);
        let mut baseline = blessed();
        baseline.cases.get_mut("structured").unwrap().levels[0].energy_error = Some(1e-15);
        let drifted = |e| {
            let mut record = record(5);
            rounding(e)(&mut record);
            drift(&baseline, &record)
        };
        assert_eq!(drifted(7e-15), [""; 0]);
        assert_eq!(drifted(1e-9).len(), 1);
    }

    #[test]
    fn runs_of_other_lengths_compare_what_both_have() {
        let mut longer = record(6);
        longer.profile = "full".into();
        longer.rates.get_mut("strain").unwrap().slope += 0.1;
        assert_eq!(drift(&blessed(), &longer), [""; 0]);
        longer.levels[1].energy *= 1.1;
        assert_eq!(drift(&blessed(), &longer).len(), 1);
        // another coarse mesh, refined: as many unknowns on other triangles
        longer.levels[1].mesh_hash = "f".repeat(16);
        assert_eq!(drift(&blessed(), &longer), [""; 0]);
        assert!(drift(&blessed(), &record(6))[0].contains("6 levels, the baseline has 5"));
        let mut other = record(5);
        other.levels.iter_mut().for_each(|l| l.dofs += 1);
        assert!(drift(&blessed(), &other)[0].contains("no level has as many dofs"));
    }

    #[test]
    fn errors_against_another_reference_are_no_drift_but_energies_are() {
        let against = |dofs, error| {
            move |r: &mut StudyRecord| {
                r.reference = Reference::Overkill {
                    h: 0.01,
                    dofs,
                    energy: -1.0,
                    estimated_error: None,
                    stationarity: 0.0,
                    solver: "condensed".into(),
                };
                r.levels[0].errors.strain = Some(error);
            }
        };
        let mut coarse = record(5);
        against(1000, 0.2)(&mut coarse);
        let baseline = Baseline::from_records(&[coarse], &Default::default(), "0.1.0").unwrap();
        let moved = |change: &dyn Fn(&mut StudyRecord)| {
            let mut record = record(5);
            change(&mut record);
            drift(&baseline, &record)
        };
        assert!(moved(&against(1000, 0.2)).is_empty());
        assert!(!moved(&against(1000, 0.25)).is_empty());
        assert!(moved(&against(4000, 0.25)).is_empty());
        let energy = moved(&|r| {
            against(4000, 0.25)(r);
            r.levels[0].energy *= 1.0 + 1e-6;
        });
        assert_eq!(energy.len(), 1, "{energy:?}");
    }
}
