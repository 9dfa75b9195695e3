//! JSON Schema of study files and of records, derived from the types that read them.
//!
//! An editor completes and checks a study file with the first (TOML is checked like the JSON of the same shape), and whoever
//! reads records finds every field in the second.

#[cfg(test)]
mod tests;
#[cfg(test)]
mod validate;

use crate::file::raw::RawStudy;
use crate::record::StudyRecord;
use schemars::JsonSchema;
use serde_json::{Value, json};

/// The schema of a study file.
pub fn study() -> Value {
    let mut schema = of::<RawStudy>("Signorini study", "A study file of Signorini, in TOML.");
    without_null(&mut schema);
    schema
}

/// The schema of a record.
pub fn record() -> Value {
    of::<StudyRecord>("Signorini record", "What a run of one case of a study leaves behind, in JSON.")
}

/// A schema as it is written to a file: indented, with a line break at the end.
pub fn text(schema: &Value) -> String {
    format!("{schema:#}\n")
}

fn of<T: JsonSchema>(title: &str, description: &str) -> Value {
    let schema = schemars::schema_for!(T).to_value();
    let mut schema = renamed(schema);
    schema["title"] = json!(title);
    schema["description"] = json!(description);
    schema
}

/// The names of our types in the words of the file: `RawBody` is a `Body`.
fn renamed(value: Value) -> Value {
    match value {
        Value::Object(map) => {
            Value::Object(map.into_iter().map(|(key, value)| (plain(&key), renamed(value))).collect())
        }
        Value::Array(list) => Value::Array(list.into_iter().map(renamed).collect()),
        Value::String(text) => Value::String(text.replace("#/$defs/Raw", "#/$defs/")),
        other => other,
    }
}

fn plain(key: &str) -> String {
    key.strip_prefix("Raw").unwrap_or(key).into()
}

/// TOML has no null: a field that may be missing is not required, and that is all.
fn without_null(value: &mut Value) {
    match value {
        Value::Object(map) => {
            if let Some(Value::Array(types)) = map.get_mut("type") {
                types.retain(|t| t != "null");
                if let [one] = types.as_slice() {
                    map["type"] = one.clone();
                }
            }
            if let Some(Value::Array(choices)) = map.get_mut("anyOf") {
                choices.retain(|c| *c != json!({ "type": "null" }));
                if let [Value::Object(one)] = choices.as_slice() {
                    let one = one.clone();
                    map.remove("anyOf");
                    map.extend(one);
                }
            }
            // `default: null` too
            if map.get("default").is_some_and(Value::is_null) {
                map.remove("default");
            }
            map.values_mut().for_each(without_null);
        }
        Value::Array(list) => list.iter_mut().for_each(without_null),
        _ => {}
    }
}
