//! The expected rate as a study file may give it.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error, Unexpected, Visitor};
use std::borrow::Cow;
use std::fmt;

/// A finite number, `"none"`, or `"corners"`: what the program computes from the scene's corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ExpectedRate {
    /// The number itself, or none.
    Given(Option<f64>),
    /// `min(1, Re λ)` over the scene's corners.
    Corners,
}

impl<'de> Deserialize<'de> for ExpectedRate {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_any(ExpectedRateVisitor)
    }
}

struct ExpectedRateVisitor;

impl Visitor<'_> for ExpectedRateVisitor {
    type Value = ExpectedRate;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number, \"none\" or \"corners\"")
    }

    fn visit_i64<E: Error>(self, x: i64) -> Result<ExpectedRate, E> {
        Ok(ExpectedRate::Given(Some(x as f64)))
    }

    fn visit_f64<E: Error>(self, x: f64) -> Result<ExpectedRate, E> {
        if x.is_finite() {
            Ok(ExpectedRate::Given(Some(x)))
        } else {
            Err(E::custom(format!("{x} is not a finite number")))
        }
    }

    fn visit_str<E: Error>(self, word: &str) -> Result<ExpectedRate, E> {
        match word {
            "none" => Ok(ExpectedRate::Given(None)),
            "corners" => Ok(ExpectedRate::Corners),
            _ => Err(E::invalid_value(Unexpected::Str(word), &self)),
        }
    }
}

impl JsonSchema for ExpectedRate {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "ExpectedRate".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "type": "number" }, { "enum": ["none", "corners"] }] })
    }
}
