//! The contact in numbers beside those of a formula.

use crate::levels::{Measured, build, h_column, level_column, measured, without_empty};
use crate::table::{Cell, Table};
use signorini_study::record::{ContactMeasure, FormulaValues, Level, StudyRecord};

/// Half width, peak pressure and force beside those of the study's formula; `None` if it states none of them.
pub fn table(record: &StudyRecord) -> Option<Table> {
    record.levels.iter().find(|l| l.errors.size("formula").is_some())?;
    let mut all = vec![level_column(), h_column()];
    all.extend(columns());
    Some(without_empty(build(record, all)))
}

/// Each measured number, the formula's, and their relative difference.
pub(crate) fn columns() -> Vec<Measured<'static>> {
    let number = |value: fn(&ContactMeasure) -> f64| move |l: &Level| Cell::number(l.contact.as_ref().map(value));
    let given = |value: fn(&FormulaValues) -> Option<f64>| {
        move |l: &Level| Cell::number(l.contact.as_ref().and_then(|c| value(c.formula.as_ref()?)))
    };
    vec![
        measured("half_width", "half width", number(|c| c.half_width)),
        measured("half_width_formula", "by the formula", given(|f| f.half_width)),
        measured("half_width_difference", "difference", |l| Cell::number(l.errors.half_width)),
        measured("peak_pressure", "peak pressure", number(|c| c.peak_pressure)),
        measured("peak_pressure_formula", "by the formula", given(|f| f.peak_pressure)),
        measured("peak_pressure_difference", "difference", |l| Cell::number(l.errors.peak_pressure)),
        measured("force", "force", number(|c| c.force)),
        measured("force_formula", "by the formula", given(|f| f.force)),
        measured("force_difference", "difference", |l| Cell::number(l.errors.force)),
    ]
}
