//! Writing, refusing and reading records.

use super::*;
use crate::sample;

#[test]
fn a_record_survives_writing_and_reading_to_the_last_bit() {
    let mut record = sample::record("s", "s", sample::levels(5, |h| h.powf(0.9)));
    record.parameters.insert("alpha".into(), 0.1 + 0.2);
    let text = record.to_json().unwrap();
    assert!(text.ends_with("}\n"));
    let back = StudyRecord::from_json(&text).unwrap();
    assert_eq!(back, record);
    assert_eq!(back.to_json().unwrap(), text);
}

#[test]
fn a_missing_value_is_null_and_stays_so() {
    let record = sample::record("s", "s", sample::levels(4, |h| h));
    let value: serde_json::Value = serde_json::from_str(&record.to_json().unwrap()).unwrap();
    assert!(value["levels"][0]["errors"]["pressure_l2"].is_null());
    assert_eq!(value["levels"][0]["errors"]["energy"], record.levels[0].errors.energy.unwrap());
}

#[test]
fn non_finite_numbers_are_refused_by_name() {
    let clean = sample::record("s", "s", sample::levels(4, |h| h));
    type Spoil = fn(&mut StudyRecord);
    let spoilt: [(Spoil, &str); 6] = [
        (|r| r.levels[3].errors.strain = Some(f64::NAN), "levels[3].errors.strain"),
        (|r| r.levels[1].energy = f64::INFINITY, "levels[1].energy"),
        (|r| r.levels[2].errors.strain_bodies = Some([0.0, f64::NAN]), "levels[2].errors.strain_bodies[1]"),
        (|r| r.rates.get_mut("energy").unwrap().pairwise[0].1 = f64::NAN, "rates.energy.pairwise[0][1]"),
        (|r| *r.parameters.get_mut("k").unwrap() = f64::NEG_INFINITY, "parameters.k"),
        (|r| overkill(r).clone_from(&f64::NAN), "reference.overkill.energy"),
    ];
    for (spoil, place) in spoilt {
        let mut record = clean.clone();
        spoil(&mut record);
        match record.to_json() {
            Err(RecordError::NonFinite { path, value }) => {
                assert!(path == place && !value.is_finite(), "{path}")
            }
            other => panic!("{place}: {other:?}"),
        }
    }
}

/// Gives the record an overkill reference and hands out its energy.
fn overkill(record: &mut StudyRecord) -> &mut f64 {
    record.reference = Reference::Overkill {
        h: 0.01,
        dofs: 100,
        energy: -1.0,
        estimated_error: None,
        stationarity: 1e-15,
        solver: "condensed".into(),
    };
    match &mut record.reference {
        Reference::Overkill { energy, .. } => energy,
        _ => unreachable!("just set"),
    }
}

#[test]
fn another_schema_is_told_apart_from_nonsense() {
    assert!(matches!(StudyRecord::from_json(r#"{"schema": 99}"#), Err(RecordError::Schema { found: 99 })));
    assert!(matches!(StudyRecord::from_json(r#"{"schema": 1}"#), Err(RecordError::Json(_))));
    assert!(matches!(StudyRecord::from_json("nonsense"), Err(RecordError::Json(_))));
}
