//! Parameters of built-in solutions: known names, defaults and ranges.

use crate::nearest::nearest;
use std::collections::BTreeMap;

/// What a parameter means and may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its name.
    pub name: &'static str,
    /// Its meaning and range.
    pub meaning: &'static str,
    /// Its value when it is not given; `None`: it must be given, or the meaning says what stands in.
    pub default: Option<f64>,
}

/// Values given for the allowed parameters of one solution.
pub(super) struct Values<'a> {
    allowed: &'static [Parameter],
    given: &'a BTreeMap<String, f64>,
}

impl<'a> Values<'a> {
    /// Refuses a name that is not allowed.
    pub(super) fn new(allowed: &'static [Parameter], given: &'a BTreeMap<String, f64>) -> Result<Self, String> {
        let known = |name: &str| allowed.iter().any(|p| p.name == name);
        match given.keys().find(|name| !known(name)) {
            Some(name) => Err(unknown(name, allowed)),
            None => Ok(Self { allowed, given }),
        }
    }

    /// The value of `name`, if it is given or has a default.
    pub(super) fn optional(&self, name: &str) -> Option<f64> {
        let default = || self.allowed.iter().find(|p| p.name == name)?.default;
        self.given.get(name).copied().or_else(default)
    }

    /// The value of `name`, given or by default.
    pub(super) fn get(&self, name: &str) -> Result<f64, String> {
        self.optional(name).ok_or_else(|| format!("parameter {name} is missing; {}", list(self.allowed)))
    }
}

fn unknown(name: &str, allowed: &[Parameter]) -> String {
    let hint = match nearest(name, allowed.iter().map(|p| p.name)) {
        Some(meant) => format!("did you mean {meant}? "),
        None => String::new(),
    };
    format!("unknown parameter {name}; {hint}{}", list(allowed))
}

/// `low ≤ value ≤ high`.
pub(super) fn within(name: &str, value: f64, low: f64, high: f64) -> Result<(), String> {
    let bound = format!("{low} ≤ {name} ≤ {high}");
    check(name, value, value >= low && value <= high, &bound)
}

/// `low < value ≤ high`.
pub(super) fn above(name: &str, value: f64, low: f64, high: f64) -> Result<(), String> {
    let bound = format!("{low} < {name} ≤ {high}");
    check(name, value, value > low && value <= high, &bound)
}

/// `low < value < high`.
pub(super) fn between(name: &str, value: f64, low: f64, high: f64) -> Result<(), String> {
    let bound = format!("{low} < {name} < {high}");
    check(name, value, value > low && value < high, &bound)
}

/// A whole number with `low ≤ value ≤ high`.
pub(super) fn whole(name: &str, value: f64, low: f64, high: f64) -> Result<(), String> {
    let valid = value.fract() == 0.0 && value >= low && value <= high;
    let bound = format!("{low} ≤ {name} ≤ {high} and be whole");
    check(name, value, valid, &bound)
}

fn check(name: &str, value: f64, valid: bool, bound: &str) -> Result<(), String> {
    if valid { Ok(()) } else { Err(format!("{name} = {value} must satisfy {bound}")) }
}

/// The allowed parameters with meaning and default, for messages.
pub(super) fn list(allowed: &[Parameter]) -> String {
    if allowed.is_empty() {
        return "no parameters are allowed".to_string();
    }
    let each: Vec<String> = allowed
        .iter()
        .map(|p| match p.default {
            Some(d) => format!("{} ({}, default {d})", p.name, p.meaning),
            None => format!("{} ({})", p.name, p.meaning),
        })
        .collect();
    format!("allowed: {}", each.join("; "))
}
