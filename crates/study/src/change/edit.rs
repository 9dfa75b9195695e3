//! One key of a tree of tables and lists.
//!
//! A step is the name of a field, or of a list's entry: its `name`, its number from 0, or `*` for all of them. A field that is missing is put
//! in: the reader of studies knows which ones there are, and names the nearest of a mistyped one.

use super::Refused;
use crate::nearest::nearest;
use toml::{Table, Value};

/// Every entry of a list.
const ALL: &str = "*";

/// Gives the key `steps` below `value` a new value. `path` is how messages name the place of `value`.
///
/// # Errors
/// A step that leads nowhere.
pub(super) fn set(value: &mut Value, steps: &[String], new: &Value, path: &str) -> Result<(), Refused> {
    let Some((step, rest)) = steps.split_first() else {
        *value = new.clone();
        return Ok(());
    };
    match value {
        Value::Table(table) => in_table(table, step, rest, new, path),
        Value::Array(list) => in_list(list, step, rest, new, path),
        other => {
            let message = format!("`{path}` is {other}, with nothing named `{step}` in it");
            Err(Refused::new(message, format!("end the key at `{path}`")))
        }
    }
}

/// As [`set`], in a table.
pub(super) fn in_table(table: &mut Table, step: &str, rest: &[String], new: &Value, path: &str) -> Result<(), Refused> {
    let path = join(path, step);
    if step == ALL {
        let known: Vec<&str> = table.keys().map(String::as_str).collect();
        return Err(Refused::new(
            format!("`{path}`: `*` stands for all entries of a list, and here is none"),
            format!("name one of: {}", known.join(", ")),
        ));
    }
    set(table.entry(step).or_insert_with(|| Value::Table(Table::new())), rest, new, &path)
}

fn in_list(list: &mut [Value], step: &str, rest: &[String], new: &Value, path: &str) -> Result<(), Refused> {
    let chosen = entries(list, step, path)?;
    chosen.into_iter().try_for_each(|k| set(&mut list[k], rest, new, &join(path, step)))
}

/// The numbers of the entries that a step means.
fn entries(list: &[Value], step: &str, path: &str) -> Result<Vec<usize>, Refused> {
    let names: Vec<Option<&str>> = list.iter().map(name).collect();
    let named: Vec<usize> = (0..list.len()).filter(|&k| names[k] == Some(step)).collect();
    match (&named[..], step.parse::<usize>()) {
        _ if step == ALL && !list.is_empty() => Ok((0..list.len()).collect()),
        ([_], _) => Ok(named),
        ([], Ok(k)) if k < list.len() => Ok(vec![k]),
        ([], _) => Err(no_entry(&names, step, path)),
        _ => Err(Refused::new(
            format!("`{path}` has {} entries named `{step}`: numbers {}", named.len(), listed(&named)),
            format!("choose one by its number, e.g. `{path}.{}`", named[0]),
        )),
    }
}

fn no_entry(names: &[Option<&str>], step: &str, path: &str) -> Refused {
    let of = |(k, name): (usize, &Option<&str>)| name.map_or(format!("{k}"), |n| format!("{k} (`{n}`)"));
    let known: Vec<String> = names.iter().enumerate().map(of).collect();
    let has = if known.is_empty() { "is empty".into() } else { format!("has the entries {}", known.join(", ")) };
    let next = match nearest(step, names.iter().flatten().copied()) {
        Some(meant) => format!("did you mean `{path}.{meant}`?"),
        None => "name an entry, or take its number, or `*` for all".into(),
    };
    Refused::new(format!("`{path}` has no entry `{step}`; it {has}"), next)
}

fn name(entry: &Value) -> Option<&str> {
    entry.get("name").and_then(Value::as_str)
}

fn listed(numbers: &[usize]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

fn join(path: &str, step: &str) -> String {
    if path.is_empty() { step.to_owned() } else { format!("{path}.{step}") }
}
