//! Numbers as a study file may give them. TOML knows `nan` and `inf`; a study does not.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error, Visitor};
use std::borrow::Cow;
use std::fmt;

/// A finite number; integers are taken as well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finite(pub f64);

/// A finite number, or the word `"none"` (TOML has no null).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrNone(pub Option<f64>);

/// A finite number, or an expression that gives one.
#[derive(Clone, Debug, PartialEq)]
pub enum NumberOrText {
    /// The number itself.
    Number(f64),
    /// An expression in the parameters.
    Text(String),
}

impl<'de> Deserialize<'de> for Finite {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        // The check stands inside the visitor, because only there the parser still adds line and column.
        source.deserialize_any(NumberVisitor).map(Self)
    }
}

impl<'de> Deserialize<'de> for OrNone {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(OrNoneVisitor).map(Self)
    }
}

impl<'de> Deserialize<'de> for NumberOrText {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(NumberOrTextVisitor)
    }
}

struct NumberVisitor;

impl Visitor<'_> for NumberVisitor {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }

    fn visit_i64<E: Error>(self, x: i64) -> Result<f64, E> {
        Ok(x as f64)
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<f64, E> {
        if x.is_finite() { Ok(x) } else { Err(E::custom(format!("{x} is not a finite number"))) }
    }
}

struct OrNoneVisitor;

impl Visitor<'_> for OrNoneVisitor {
    type Value = Option<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or \"none\"")
    }

    fn visit_i64<E: Error>(self, x: i64) -> Result<Option<f64>, E> {
        NumberVisitor.visit_i64(x).map(Some)
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<Option<f64>, E> {
        NumberVisitor.visit_f64(x).map(Some)
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<Option<f64>, E> {
        if word == "none" { Ok(None) } else { Err(E::invalid_value(serde::de::Unexpected::Str(word), &self)) }
    }
}

struct NumberOrTextVisitor;

impl Visitor<'_> for NumberOrTextVisitor {
    type Value = NumberOrText;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number or an expression in quotes")
    }

    fn visit_i64<E: Error>(self, x: i64) -> Result<NumberOrText, E> {
        NumberVisitor.visit_i64(x).map(NumberOrText::Number)
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<NumberOrText, E> {
        NumberVisitor.visit_f64(x).map(NumberOrText::Number)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<NumberOrText, E> {
        Ok(NumberOrText::Text(text.to_string()))
    }
}

impl JsonSchema for Finite {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Finite".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "number" })
    }
}

impl JsonSchema for OrNone {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "OrNone".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "type": "number" }, { "const": "none" }] })
    }
}

impl JsonSchema for NumberOrText {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "NumberOrText".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["number", "string"] })
    }
}
