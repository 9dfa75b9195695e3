//! A table for programs: CSV and JSON, with every digit.

use super::{Cell, Row, Table};
use crate::error::ReportError;
use serde_json::{Map, Value};

/// The column of CSV and JSON that says why a row does not count.
const EXCLUDED: &str = "excluded";

impl Table {
    /// CSV with a header of keys; a missing value is an empty field; the last column, `excluded`, is empty in rows
    /// that count.
    ///
    /// # Errors
    /// [`ReportError::NonFinite`] on NaN or infinity.
    pub fn to_csv(&self) -> Result<Vec<u8>, ReportError> {
        self.check_finite()?;
        let mut writer = csv::Writer::from_writer(Vec::new());
        let keys = self.columns.iter().map(|c| c.key.as_str());
        writer.write_record(keys.chain([EXCLUDED]))?;
        for row in &self.rows {
            let why = row.excluded.clone().unwrap_or_default();
            writer.write_record(row.cells.iter().map(csv_field).chain([why]))?;
        }
        writer.into_inner().map_err(|e| ReportError::Csv(e.into_error().into()))
    }

    /// JSON: an array with one object per row, `null` where there is no value, and `excluded`.
    ///
    /// # Errors
    /// [`ReportError::NonFinite`] on NaN or infinity.
    pub fn to_json(&self) -> Result<Value, ReportError> {
        self.check_finite()?;
        Ok(Value::Array(self.rows.iter().map(|row| self.json_row(row)).collect()))
    }

    fn json_row(&self, row: &Row) -> Value {
        let pairs = self.columns.iter().zip(&row.cells);
        let mut object: Map<String, Value> = pairs.map(|(c, cell)| (c.key.clone(), json_value(cell))).collect();
        let why = row.excluded.clone().map_or(Value::Null, Value::String);
        object.insert(EXCLUDED.into(), why);
        Value::Object(object)
    }

    fn check_finite(&self) -> Result<(), ReportError> {
        for (number, row) in self.rows.iter().enumerate() {
            for (column, cell) in self.columns.iter().zip(&row.cells) {
                if let Some(value) = cell.float().filter(|x| !x.is_finite()) {
                    let place = format!("column {}, row {number}", column.key);
                    return Err(ReportError::NonFinite { place, value });
                }
            }
        }
        Ok(())
    }
}

/// JSON as it is written to a file: indented, with a line break at the end.
///
/// # Errors
/// [`ReportError::Json`] if serialisation fails.
pub fn json_text(value: &Value) -> Result<Vec<u8>, ReportError> {
    let mut bytes = serde_json::to_vec_pretty(value)?;
    bytes.push(b'\n');
    Ok(bytes)
}

/// The shortest text that reads back as the same number.
fn csv_field(cell: &Cell) -> String {
    match cell {
        Cell::Missing => String::new(),
        Cell::Flag(yes) => yes.to_string(),
        _ => match cell.float() {
            Some(x) if x != 0.0 && !(1e-4..1e6).contains(&x.abs()) => format!("{x:e}"),
            Some(x) => format!("{x}"),
            None => cell.display(),
        },
    }
}

fn json_value(cell: &Cell) -> Value {
    match cell {
        Cell::Missing => Value::Null,
        Cell::Count(n) => Value::from(*n),
        Cell::Number(x) | Cell::Rate(x) | Cell::Bound(x) => Value::from(*x),
        Cell::Text(words) | Cell::Figure(words) => Value::String(words.clone()),
        Cell::Flag(yes) => Value::Bool(*yes),
    }
}
