//! Lists of a fixed length. The derived reader of `[T; N]` takes the first `N` entries and drops the rest in silence:
//! a point with three coordinates would pass.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error, IgnoredAny, SeqAccess, Visitor};
use std::borrow::Cow;
use std::fmt;
use std::marker::PhantomData;
use std::ops::Deref;

/// Exactly `N` entries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fixed<T, const N: usize>(pub [T; N]);

impl<T, const N: usize> Deref for Fixed<T, N> {
    type Target = [T; N];

    fn deref(&self) -> &[T; N] {
        &self.0
    }
}

impl<'de, T: Deserialize<'de>, const N: usize> Deserialize<'de> for Fixed<T, N> {
    fn deserialize<D: Deserializer<'de>>(source: D) -> Result<Self, D::Error> {
        source.deserialize_seq(FixedVisitor(PhantomData)).map(Self)
    }
}

struct FixedVisitor<T, const N: usize>(PhantomData<T>);

impl<'de, T: Deserialize<'de>, const N: usize> Visitor<'de> for FixedVisitor<T, N> {
    type Value = [T; N];

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{N} entries")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<[T; N], A::Error> {
        let mut list = Vec::with_capacity(N);
        while list.len() < N
            && let Some(entry) = entries.next_element()?
        {
            list.push(entry);
        }
        let mut length = list.len();
        while entries.next_element::<IgnoredAny>()?.is_some() {
            length += 1;
        }
        match <[T; N]>::try_from(list) {
            Ok(array) if length == N => Ok(array),
            _ => Err(A::Error::invalid_length(length, &self)),
        }
    }
}

impl<T: JsonSchema, const N: usize> JsonSchema for Fixed<T, N> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("{N}_{}", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "array",
            "items": generator.subschema_for::<T>(),
            "minItems": N,
            "maxItems": N,
        })
    }
}
