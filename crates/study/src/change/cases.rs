//! All keys of all cases.
//!
//! A table of a case replaces that of the study as a whole. So a case that has no table of its own where a key points to gets a copy of the
//! study's before the key is changed in it; only `parameters` are merged name by name anyway.

use super::option::Assignment;
use super::{Changes, Refused, edit, label};
use crate::nearest::nearest;
use crate::record::Setting;
use crate::study::Study;
use std::collections::BTreeMap;
use toml::{Table, Value};

/// Fields that a study has and a case has not.
const OF_STUDY: [&str; 8] = ["id", "title", "question", "setup", "refuted_by", "claim", "own_claim", "name"];
/// The first step of a key that is changed in one case alone.
const CASE: &str = "case";
/// The table that cases add to.
const PARAMETERS: &str = "parameters";

/// What a case of the changed study is made of.
#[derive(Clone)]
pub(super) struct Made {
    /// The case of the file.
    pub from: String,
    /// Every key that was changed.
    pub settings: Vec<Setting>,
    /// Swept numbers by their short names.
    pub numbers: BTreeMap<String, f64>,
    /// The name in the changed study.
    name: String,
    table: Table,
}

/// The text of the changed study and what its cases are made of, in their order. `text` is that of the study `plain`.
pub(super) fn changed(text: &str, plain: &Study, changes: &Changes) -> Result<(String, Vec<Made>), Refused> {
    let unreadable = |e: String| Refused::new(e, "change the file itself");
    let mut study: Table = text.parse().map_err(|e: toml::de::Error| unreadable(e.to_string()))?;
    let mut made = originals(&study, plain);
    for option in &changes.set {
        set(&mut study, &mut made, option)?;
    }
    for option in &changes.sweep {
        made = swept(&study, &made, option)?;
    }
    made.iter_mut().for_each(|m| m.finish(changes, plain));
    let tables = made.iter().map(|m| Value::Table(m.table.clone())).collect();
    study.insert(CASE.into(), Value::Array(tables));
    let text = toml::to_string(&study).map_err(|e| unreadable(e.to_string()))?;
    Ok((text, made))
}

/// Carries out a `--set`: in the study, in one case, or in all of them.
fn set(study: &mut Table, made: &mut [Made], option: &Assignment) -> Result<(), Refused> {
    let steps = &option.steps;
    match (steps[0].as_str(), &steps[1..]) {
        (first, rest) if OF_STUDY.contains(&first) => {
            edit::in_table(study, first, rest, &option.values[0].1, "").map_err(|e| in_option(option, e))?;
            made.iter_mut().for_each(|m| m.note(option, 0));
            Ok(())
        }
        (CASE, [name, first, rest @ ..]) => {
            let one = chosen(made, name).ok_or_else(|| no_case(made, option))?;
            made[one].change(study, option, 0, first, rest)
        }
        (CASE, _) => Err(no_case(made, option)),
        (first, rest) => made.iter_mut().try_for_each(|m| m.change(study, option, 0, first, rest)),
    }
}

/// Every case under every value of a `--sweep`.
fn swept(study: &Table, made: &[Made], option: &Assignment) -> Result<Vec<Made>, Refused> {
    let first = option.steps[0].as_str();
    if first == CASE || OF_STUDY.contains(&first) {
        let message = format!("{option}: a sweep goes over all cases, and `{}` is no key of them", option.key);
        return Err(Refused::new(
            message,
            "sweep a key such as `family.name`, without `case`; `--set` changes this one",
        ));
    }
    let under = |m: &Made, k: usize| {
        let mut made = m.clone();
        made.change(study, option, k, first, &option.steps[1..]).map(|()| made)
    };
    made.iter().flat_map(|m| (0..option.values.len()).map(move |k| under(m, k))).collect()
}

/// The case of a name, or of a number from 0.
fn chosen(made: &[Made], step: &str) -> Option<usize> {
    let number = || step.parse().ok().filter(|k| *k < made.len());
    made.iter().position(|m| m.from == step).or_else(number)
}

fn no_case(made: &[Made], option: &Assignment) -> Refused {
    let known: Vec<&str> = made.iter().map(|m| m.from.as_str()).collect();
    let next = match option.steps.get(1).and_then(|s| nearest(s, known.iter().copied())) {
        Some(meant) if option.steps.len() > 2 => format!("did you mean `{CASE}.{meant}`?"),
        _ => format!("write `{CASE}.NAME.KEY`; the cases are {}", known.join(", ")),
    };
    Refused::new(format!("{option}: `{}` is no key of a case", option.key), next)
}

/// The cases of the file; a study without any is one case.
fn originals(study: &Table, plain: &Study) -> Vec<Made> {
    let tables: Vec<Table> = match study.get("case").and_then(Value::as_array) {
        Some(list) => list.iter().filter_map(Value::as_table).cloned().collect(),
        None => vec![[("name".to_owned(), Value::String(plain.id.clone()))].into_iter().collect()],
    };
    let name = |t: &Table| t.get("name").and_then(Value::as_str).unwrap_or(&plain.id).to_owned();
    let made = |table: Table| Made {
        from: name(&table),
        name: name(&table),
        settings: Vec::new(),
        numbers: BTreeMap::new(),
        table,
    };
    tables.into_iter().map(made).collect()
}

impl Made {
    /// Gives the key `first.rest` the k-th value of an option.
    fn change(
        &mut self,
        study: &Table,
        option: &Assignment,
        k: usize,
        first: &str,
        rest: &[String],
    ) -> Result<(), Refused> {
        if first == PARAMETERS {
            is_known(study, &self.table, option, rest)?;
        } else if let (false, Some(own)) = (self.table.contains_key(first), study.get(first)) {
            self.table.insert(first.to_owned(), own.clone());
        }
        edit::in_table(&mut self.table, first, rest, &option.values[k].1, "").map_err(|e| in_option(option, e))?;
        self.note(option, k);
        Ok(())
    }

    fn note(&mut self, option: &Assignment, k: usize) {
        let (word, value) = &option.values[k];
        self.settings.push(Setting {
            key: option.key.clone(),
            name: String::new(),
            value: word.clone(),
            number: number(value),
            swept: option.swept,
        });
    }

    /// Short names for the keys, and of them one for the case.
    fn finish(&mut self, changes: &Changes, plain: &Study) {
        let names = label::keys(changes);
        for setting in &mut self.settings {
            setting.name = names.get(&setting.key).cloned().unwrap_or_else(|| setting.key.clone());
        }
        let swept: Vec<&Setting> = self.settings.iter().filter(|s| s.swept).collect();
        self.numbers = swept.iter().filter_map(|s| Some((s.name.clone(), s.number?))).collect();
        let alone = self.name == plain.id;
        let head = (!alone || swept.is_empty()).then(|| self.name.clone());
        let pieces = swept.iter().map(|s| label::of_value(changes, s));
        self.name = head.into_iter().chain(pieces).collect::<Vec<_>>().join("-");
        self.table.insert("name".into(), Value::String(self.name.clone()));
    }
}

/// A parameter that no expression knows would change nothing, and nobody would see it.
fn is_known(study: &Table, case: &Table, option: &Assignment, rest: &[String]) -> Result<(), Refused> {
    let tables = [study, case].into_iter().filter_map(|t| t.get(PARAMETERS)?.as_table());
    let known: Vec<&str> = tables.flat_map(Table::keys).map(String::as_str).collect();
    let Some(name) = rest.first() else { return Ok(()) };
    if known.contains(&name.as_str()) {
        return Ok(());
    }
    let next = match nearest(name, known.iter().copied()) {
        Some(meant) => format!("did you mean `{PARAMETERS}.{meant}`?"),
        None if known.is_empty() => "this study has no parameters; choose another key".into(),
        None => format!("use one of: {}", known.join(", ")),
    };
    Err(Refused::new(format!("{option}: the study has no parameter `{name}`"), next))
}

fn number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|i| i as f64)).filter(|x| x.is_finite())
}

fn in_option(option: &Assignment, refused: Refused) -> Refused {
    Refused { message: format!("{option}: {}", refused.message), ..refused }
}
