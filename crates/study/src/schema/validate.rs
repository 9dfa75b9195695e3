//! Whether a value is as a schema says: the words that our schemas use, and an error for any other, so that nothing is passed
//! over in silence.

use serde_json::Value;

/// The first place where `value` is not as `schema` says, e.g. `/body/0/material: …`.
pub fn complaint(root: &Value, value: &Value) -> Option<String> {
    at(root, root, value, "")
}

/// Words that describe and do not restrict.
const REMARKS: [&str; 7] = ["$schema", "$defs", "title", "description", "default", "format", "properties"];

fn at(root: &Value, schema: &Value, value: &Value, path: &str) -> Option<String> {
    let schema = match schema {
        Value::Bool(true) => return None,
        Value::Object(map) => map,
        other => return Some(format!("{path}: no schema: {other}")),
    };
    let properties = &schema.get("properties").cloned().unwrap_or_default();
    schema
        .iter()
        .find_map(|(word, rule)| {
            let wrong = |ok: bool| (!ok).then(|| format!("{path}: {word} {rule} does not allow {value}"));
            let list = || rule.as_array().map(Vec::as_slice).unwrap_or_default();
            match word.as_str() {
                word if REMARKS.contains(&word) => None,
                "$ref" => {
                    let target = rule.as_str().and_then(|r| r.strip_prefix('#')).and_then(|r| root.pointer(r));
                    target.map_or(Some(format!("{path}: {rule} leads nowhere")), |s| at(root, s, value, path))
                }
                "type" if rule.is_array() => wrong(list().iter().any(|t| is(t, value))),
                "type" => wrong(is(rule, value)),
                "const" => wrong(rule == value),
                "enum" => wrong(list().contains(value)),
                "anyOf" => wrong(list().iter().any(|s| at(root, s, value, path).is_none())),
                "oneOf" => wrong(list().iter().filter(|s| at(root, s, value, path).is_none()).count() == 1),
                "minimum" => wrong(value.as_f64().is_none_or(|x| rule.as_f64().is_some_and(|least| x >= least))),
                "maximum" => wrong(value.as_f64().is_none_or(|x| rule.as_f64().is_some_and(|most| x <= most))),
                "minItems" => wrong(length(value).is_none_or(|n| rule.as_u64().is_some_and(|least| n >= least))),
                "maxItems" => wrong(length(value).is_none_or(|n| rule.as_u64().is_some_and(|most| n <= most))),
                "items" => value.as_array().and_then(|items| {
                    items
                        .iter()
                        .enumerate()
                        .skip(prefix(schema))
                        .find_map(|(i, v)| at(root, rule, v, &format!("{path}/{i}")))
                }),
                "prefixItems" => value.as_array().and_then(|items| {
                    let pairs = items.iter().zip(list()).enumerate();
                    pairs.into_iter().find_map(|(i, (v, s))| at(root, s, v, &format!("{path}/{i}")))
                }),
                "required" => {
                    let missing =
                        |key: &&Value| value.is_object() && key.as_str().is_some_and(|k| value.get(k).is_none());
                    list().iter().find(missing).map(|key| format!("{path}: no {key}"))
                }
                "additionalProperties" => value.as_object().and_then(|map| {
                    let others = map.iter().filter(|(key, _)| properties.get(key).is_none());
                    let mut others = others.map(|(key, v)| (format!("{path}/{key}"), v));
                    if *rule == Value::Bool(false) {
                        others.next().map(|(path, _)| format!("{path}: unknown"))
                    } else {
                        others.find_map(|(path, v)| at(root, rule, v, &path))
                    }
                }),
                other => Some(format!("{path}: no rule for `{other}`")),
            }
        })
        .or_else(|| {
            let map = value.as_object()?;
            let known = map.iter().filter_map(|(key, v)| Some((key, v, properties.get(key)?)));
            known.into_iter().find_map(|(key, v, s)| at(root, s, v, &format!("{path}/{key}")))
        })
}

/// How many entries `items` leaves to `prefixItems`.
fn prefix(schema: &serde_json::Map<String, Value>) -> usize {
    schema.get("prefixItems").and_then(Value::as_array).map_or(0, Vec::len)
}

fn length(value: &Value) -> Option<u64> {
    value.as_array().map(|items| items.len() as u64)
}

fn is(name: &Value, value: &Value) -> bool {
    match name.as_str() {
        Some("object") => value.is_object(),
        Some("array") => value.is_array(),
        Some("string") => value.is_string(),
        Some("boolean") => value.is_boolean(),
        Some("null") => value.is_null(),
        Some("number") => value.is_number(),
        Some("integer") => value.as_f64().is_some_and(|x| x.fract() == 0.0),
        _ => false,
    }
}
