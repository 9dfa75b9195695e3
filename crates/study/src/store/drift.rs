//! How far a run has moved from the baseline.
//!
//! Levels are matched by their dofs, so a longer or shorter run compares what both have; errors and rates are compared
//! only where they were measured against the same reference, rates only between runs of the same levels. What another machine may change is allowed for: energies to 1e-8, errors to four
//! significant digits (and to rounding, where the error is nothing else), rates to three decimals.

use super::Baseline;
use super::baseline::{BaselineCase, BaselineLevel, norm_rates, reference_dofs};
use crate::claim::quantity::in_words;
use crate::record::{Level, StudyRecord};
use std::fmt;

/// Relative change of an energy.
const ENERGY: f64 = 1e-8;

/// Change of a rate: half a unit of the third decimal.
const RATE: f64 = 5e-4;

/// An error below this share of `‖u‖_A` is rounding and differs from machine to machine.
const ROUNDING: f64 = 1e-11;

/// One difference between a record and its baseline. Prints as one line.
#[derive(Clone, Debug, PartialEq)]
pub struct Drift {
    /// What has moved, e.g. `level 2: energy`.
    pub quantity: String,
    /// The baseline's value; `None` where it has none.
    pub was: Option<String>,
    /// The run's.
    pub now: Option<String>,
    /// The change, as a share of the baseline's value; `None` of what is no number.
    pub change: Option<f64>,
    /// The largest change that counts as none, as a share too.
    pub allowed: Option<f64>,
    words: String,
}

impl Drift {
    /// Of numbers, which may move by `allowed`; `words` is the line.
    fn of_numbers(quantity: String, was: Option<f64>, now: Option<f64>, allowed: f64, words: String) -> Self {
        let share = |part: f64| was.filter(|was| *was != 0.0).map(|was| part.abs() / was.abs());
        Self {
            quantity,
            was: was.map(shown),
            now: now.map(shown),
            change: now.zip(was).and_then(|(now, was)| share(now - was)).filter(|c| c.is_finite()),
            allowed: share(allowed),
            words,
        }
    }

    /// Of what is no number.
    fn of_words(quantity: impl Into<String>, was: Option<String>, now: Option<String>, words: String) -> Self {
        Self { quantity: quantity.into(), was, now, change: None, allowed: None, words }
    }
}

impl fmt::Display for Drift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words)
    }
}

/// Enough digits to tell the smallest change that counts.
fn shown(value: f64) -> String {
    format!("{value:.9e}")
}

/// Every difference between a record and its baseline; empty where there is none.
pub fn drift(baseline: &Baseline, record: &StudyRecord) -> Vec<Drift> {
    let Some(case) = baseline.cases.get(&record.case) else {
        return vec![Drift::of_words("case", None, None, format!("case {} has no baseline", record.case))];
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
        let words = "no level has as many dofs as a level of the baseline".into();
        return vec![Drift::of_words("dofs", None, None, words)];
    }
    let mut found: Vec<Drift> = pairs.iter().flat_map(|(b, l)| of_solution(b, l)).collect();
    if case.reference_dofs != reference_dofs(record) {
        return found;
    }
    found.extend(pairs.iter().flat_map(|(b, l)| of_errors(b, l)));
    if pairs.len() == record.levels.len() && pairs.len() == case.levels.len() {
        found.extend(of_rates(case, record));
    } else if case.profile == record.profile {
        let (was, now) = (case.levels.len(), record.levels.len());
        let words = format!("{now} levels, the baseline has {was}");
        found.push(Drift::of_words("levels", Some(was.to_string()), Some(now.to_string()), words));
    }
    found
}

fn of_solution(b: &BaselineLevel, l: &Level) -> Vec<Drift> {
    let mut found = Vec::new();
    if b.mesh_hash != l.mesh_hash {
        let words = format!("level {}: mesh {}, was {}", l.level, l.mesh_hash, b.mesh_hash);
        let (was, now) = (Some(b.mesh_hash.clone()), Some(l.mesh_hash.clone()));
        found.push(Drift::of_words(format!("level {}: mesh", l.level), was, now, words));
    }
    // NaN is a change
    let moved = (l.energy - b.energy).abs();
    let allowed = ENERGY * b.energy.abs();
    if moved.is_nan() || moved > allowed {
        let words = format!("level {}: energy {:.12e}, was {:.12e}", l.level, l.energy, b.energy);
        let quantity = format!("level {}: energy", l.level);
        found.push(Drift::of_numbers(quantity, Some(b.energy), Some(l.energy), allowed, words));
    }
    found
}

fn of_errors(b: &BaselineLevel, l: &Level) -> Vec<Drift> {
    let floor = ROUNDING * l.solution_energy.unwrap_or(0.0);
    let errors = [
        ("strain error", l.errors.strain, b.strain_error),
        ("energy error", l.errors.energy, b.energy_error),
        ("boundary error", l.errors.boundary_l2, b.boundary_error),
        ("constant", l.errors.constant, b.constant),
    ];
    let moved = errors.into_iter().filter(|(_, now, was)| !same_error(*now, *was, floor));
    let one = |(name, now, was): (&str, Option<f64>, Option<f64>)| {
        let words = format!("level {}: {name} {}, was {}", l.level, number(now), number(was));
        Drift::of_numbers(
            format!("level {}: {name}", l.level),
            was,
            now,
            allowed_error(was.unwrap_or(0.0), floor),
            words,
        )
    };
    moved.map(one).collect()
}

/// Equal as far as an error may be.
fn same_error(now: Option<f64>, was: Option<f64>, floor: f64) -> bool {
    match (now, was) {
        (None, None) => true,
        (Some(now), Some(was)) => (now - was).abs() <= allowed_error(was, floor),
        _ => false,
    }
}

/// Half a unit of the fourth significant digit, or rounding.
fn allowed_error(was: f64, floor: f64) -> f64 {
    if was == 0.0 {
        return floor;
    }
    let unit = 10.0_f64.powi(was.abs().log10().floor() as i32 - 3);
    (0.5 * unit).max(floor)
}

fn of_rates(case: &BaselineCase, record: &StudyRecord) -> Vec<Drift> {
    let one = |name: &str, was: Option<f64>, now: Option<f64>, words: String| {
        Drift::of_numbers(format!("{}: rate", in_words(name)), was, now, RATE, words)
    };
    let lost = case.rates.iter().filter(|(name, _)| !record.rates.contains_key(*name));
    let lost = lost.map(|(name, was)| one(name, Some(*was), None, format!("{}: the rate is gone", in_words(name))));
    let mut found: Vec<Drift> = lost.collect();
    for (name, rate) in norm_rates(record) {
        let told = format!("{}: rate {:.4}, was ", in_words(name), rate.slope);
        match case.rates.get(name).copied() {
            None => found.push(one(name, None, Some(rate.slope), told + "none")),
            Some(was) if (rate.slope - was).abs() > RATE => {
                found.push(one(name, Some(was), Some(rate.slope), format!("{told}{was:.4}")));
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

    /// The differences as lines.
    fn drift(baseline: &Baseline, record: &StudyRecord) -> Vec<String> {
        super::drift(baseline, record).iter().map(Drift::to_string).collect()
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

    /// The share of the change and the share that is allowed, for a table.
    #[test]
    fn a_change_is_measured_against_what_is_allowed() {
        let mut run = record(5);
        run.levels[2].energy *= 1.0 + 3e-8;
        run.levels[1].errors.strain = run.levels[1].errors.strain.map(|e| 1.25 * e);
        run.levels[4].mesh_hash = "f".repeat(16);
        run.rates.get_mut("strain").unwrap().slope = 0.9;
        let found = super::drift(&blessed(), &run);
        let quantities: Vec<&str> = found.iter().map(|d| d.quantity.as_str()).collect();
        assert_eq!(quantities, ["level 2: energy", "level 4: mesh", "level 1: strain error", "strain: rate"]);
        let near = |x: Option<f64>, y: f64| x.is_some_and(|x| (x / y - 1.0).abs() < 1e-3);
        assert!(near(found[0].change, 3e-8) && near(found[0].allowed, 1e-8), "{:?}", found[0]);
        assert!(found[1].change.is_none() && found[1].now.as_deref() == Some("ffffffffffffffff"));
        assert!(near(found[2].change, 0.25) && found[2].allowed.is_some_and(|a| a < 5e-4), "{:?}", found[2]);
        assert!(near(found[3].change, 0.1) && near(found[3].allowed, 5e-4), "{:?}", found[3]);
        assert_eq!(found[3].was.as_deref(), Some("1.000000000e0"));
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
