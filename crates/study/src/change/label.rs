//! Names of changed studies and their cases: they name folders, so letters, digits, `-` and `.` must do.

use super::Changes;
use super::option::Assignment;
use crate::record::Setting;
use signorini_contact::mesh::fnv1a;
use std::collections::BTreeMap;

/// Characters of a value, and of the changes in an id, before they are cut.
const LONGEST_VALUE: usize = 24;
const LONGEST_CHANGES: usize = 48;

/// Short names of the keys: their last steps, as many as tell them apart.
pub(super) fn keys(changes: &Changes) -> BTreeMap<String, String> {
    let all: Vec<&Assignment> = changes.all().collect();
    let most = all.iter().map(|a| a.steps.len()).max().unwrap_or(1);
    let name = |a: &Assignment| {
        let shared = |depth: usize| all.iter().filter(|b| tail(b, depth) == tail(a, depth)).count() > 1;
        let depth = (1..=most).find(|&d| !shared(d)).unwrap_or(most);
        (a.key.clone(), tail(a, depth))
    };
    all.iter().map(|a| name(a)).collect()
}

/// The last `depth` steps that are names, with the numbers behind them.
fn tail(a: &Assignment, depth: usize) -> String {
    let is_name = |s: &String| s.parse::<usize>().is_err() && s != "*";
    let names: Vec<usize> = (0..a.steps.len()).filter(|&k| is_name(&a.steps[k])).collect();
    let start = names.len().checked_sub(depth).map_or(0, |k| names[k]);
    plain(&a.steps[start..].join("-")).trim_start_matches(['-', '.']).to_owned()
}

/// `poisson-0.49`: what a swept value adds to the name of a case.
pub(super) fn of_value(changes: &Changes, setting: &Setting) -> String {
    let values = changes.sweep.iter().find(|a| a.key == setting.key).map_or(&[][..], |a| &a.values);
    let words: Vec<String> = values.iter().map(|(word, _)| plain(word)).collect();
    let telling =
        |w: &String| !w.is_empty() && w.len() <= LONGEST_VALUE && words.iter().filter(|v| *v == w).count() == 1;
    let position = values.iter().position(|(word, _)| *word == setting.value).unwrap_or(0);
    // long lists and expressions are numbered
    let word = if words.iter().all(telling) { words[position].clone() } else { (position + 1).to_string() };
    format!("{}-{word}", setting.name)
}

/// The id of a changed study: that of the file, what is changed, and a hash of every key and value.
pub(super) fn id(id: &str, changes: &Changes) -> String {
    let names = keys(changes);
    let set = changes.set.iter().map(|a| format!("{}-{}", names[&a.key], plain(&a.values[0].0)));
    let sweep = changes.sweep.iter().map(|a| names[&a.key].clone());
    let mut words: String = set.chain(sweep).collect::<Vec<_>>().join("_");
    words.truncate(LONGEST_CHANGES);
    let all: Vec<String> = changes.all().map(ToString::to_string).collect();
    let hash = fnv1a(all.join("\n").as_bytes());
    format!("{id}_{words}_{:08x}", hash as u32)
}

/// Lower-case letters, digits, dots and dashes.
fn plain(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars().map(|c| c.to_ascii_lowercase()) {
        if c.is_ascii_alphanumeric() || c == '.' || (c == '-' && !out.ends_with('-')) {
            out.push(c);
        } else if !out.is_empty() && !out.ends_with('-') && c != '+' {
            out.push('-');
        }
    }
    out.trim_end_matches('-').to_owned()
}
