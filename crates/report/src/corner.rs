//! The corners of a scene and what they let expect.

use crate::format;
use crate::table::{Cell, Column, Row, Table};
use signorini_study::record::{Corner, StudyRecord, corner_rate};

/// One row per corner; no rows where the record has none.
pub fn table(record: &StudyRecord) -> Table {
    let columns = [("point", "corner"), ("wedges", "bodies"), ("states", "smallest exponent"), ("rate", "rate")];
    if record.corners.is_empty() {
        return Table::default();
    }
    Table {
        columns: columns.map(|(key, heading)| Column::new(key, heading)).to_vec(),
        rows: record.corners.iter().map(row).collect(),
    }
}

fn row(corner: &Corner) -> Row {
    let [x, y] = corner.point.map(format::bound);
    let states = if corner.governing.is_some() {
        corner.describe_states()
    } else {
        format!("{}; which one is not clear", corner.describe_states())
    };
    Row {
        cells: vec![
            Cell::text(format!("({x}, {y})")),
            Cell::text(corner.describe()),
            Cell::text(states),
            Cell::rate(Some(corner.rate())),
        ],
        excluded: None,
    }
}

/// The rate of all corners beside the fitted one, in a sentence.
pub fn sentence(record: &StudyRecord) -> String {
    let expected = format::rate(corner_rate(&record.corners));
    let fitted = ["h1", "energy", "strain"].into_iter().find_map(|norm| Some((norm, record.rates.get(norm)?)));
    let observed = fitted.map_or_else(String::new, |(norm, rate)| {
        format!(
            " The rate fitted in the {} norm is {}.",
            if norm == "h1" { "H¹" } else { norm },
            format::rate(rate.slope)
        )
    });
    format!("The corners together let expect a rate of {expected} in the strain, energy and H¹ norms.{observed}")
}
