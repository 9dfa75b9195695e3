//! Finds the first number in a value that JSON cannot hold.
//!
//! A JSON writer turns NaN into `null`, and so a broken number into "no value". This serialiser writes nothing: it
//! walks the value, remembers where it is and stops at the first NaN or infinity.

use crate::record::RecordError;
use serde::ser::{self, Serialize, Serializer};
use std::fmt::Display;

/// Walks `value`.
///
/// # Errors
/// [`RecordError::NonFinite`] with the place of the first NaN or infinite number, e.g. `levels[3].errors.strain`.
pub(crate) fn check(value: &(impl Serialize + ?Sized)) -> Result<(), RecordError> {
    value.serialize(&mut Walker::default()).map_err(|stop| match stop {
        Stop::Number { path, value } => RecordError::NonFinite { path, value },
        Stop::Custom(message) => RecordError::Json(ser::Error::custom(message)),
    })
}

/// Where the walk is: the path from the root, `.name` or `[index]` each.
#[derive(Default)]
struct Walker {
    path: String,
}

/// Why the walk ended early.
#[derive(Debug, thiserror::Error)]
enum Stop {
    #[error("{path} is {value}")]
    Number { path: String, value: f64 },
    #[error("{0}")]
    Custom(String),
}

impl ser::Error for Stop {
    fn custom<T: Display>(message: T) -> Self {
        Self::Custom(message.to_string())
    }
}

impl Walker {
    /// Walks `value` one `step` further down.
    fn step(&mut self, step: &str, value: &(impl Serialize + ?Sized)) -> Result<(), Stop> {
        let here = self.path.len();
        self.path.push_str(step);
        value.serialize(&mut *self)?;
        self.path.truncate(here);
        Ok(())
    }

    fn name(&mut self, name: &str, value: &(impl Serialize + ?Sized)) -> Result<(), Stop> {
        let dot = if self.path.is_empty() { "" } else { "." };
        self.step(&format!("{dot}{name}"), value)
    }

    fn number(&self, value: f64) -> Result<(), Stop> {
        if value.is_finite() {
            return Ok(());
        }
        Err(Stop::Number { path: self.path.clone(), value })
    }
}

/// A list, map or structure on the way; a variant's name is a step that ends with it.
struct Inside<'a> {
    walker: &'a mut Walker,
    index: usize,
    key: String,
    outside: usize,
}

impl<'a> Inside<'a> {
    fn of(walker: &'a mut Walker) -> Self {
        let outside = walker.path.len();
        Self { walker, index: 0, key: String::new(), outside }
    }

    fn of_variant(walker: &'a mut Walker, variant: &str) -> Self {
        let outside = walker.path.len();
        let dot = if outside == 0 { "" } else { "." };
        walker.path.push_str(&format!("{dot}{variant}"));
        Self { walker, index: 0, key: String::new(), outside }
    }

    fn next(&mut self, value: &(impl Serialize + ?Sized)) -> Result<(), Stop> {
        let step = format!("[{}]", self.index);
        self.index += 1;
        self.walker.step(&step, value)
    }

    fn leave(self) {
        self.walker.path.truncate(self.outside);
    }
}

/// Values without a floating-point number in them.
macro_rules! nothing_to_see {
    ($($method:ident: $type:ty),*) => {
        $(fn $method(self, _: $type) -> Result<(), Stop> { Ok(()) })*
    };
}

impl<'a> Serializer for &'a mut Walker {
    type Ok = ();
    type Error = Stop;
    type SerializeSeq = Inside<'a>;
    type SerializeTuple = Inside<'a>;
    type SerializeTupleStruct = Inside<'a>;
    type SerializeTupleVariant = Inside<'a>;
    type SerializeMap = Inside<'a>;
    type SerializeStruct = Inside<'a>;
    type SerializeStructVariant = Inside<'a>;

    nothing_to_see!(
        serialize_bool: bool, serialize_char: char, serialize_str: &str, serialize_bytes: &[u8],
        serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64,
        serialize_u8: u8, serialize_u16: u16, serialize_u32: u32, serialize_u64: u64,
        serialize_unit_struct: &'static str
    );

    fn serialize_f32(self, v: f32) -> Result<(), Stop> {
        self.number(v.into())
    }
    fn serialize_f64(self, v: f64) -> Result<(), Stop> {
        self.number(v)
    }
    fn serialize_none(self) -> Result<(), Stop> {
        Ok(())
    }
    fn serialize_unit(self) -> Result<(), Stop> {
        Ok(())
    }
    fn serialize_some<T: Serialize + ?Sized>(self, v: &T) -> Result<(), Stop> {
        v.serialize(self)
    }
    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<(), Stop> {
        Ok(())
    }
    fn serialize_newtype_struct<T: Serialize + ?Sized>(self, _: &'static str, v: &T) -> Result<(), Stop> {
        v.serialize(self)
    }
    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        v: &T,
    ) -> Result<(), Stop> {
        self.name(variant, v)
    }
    fn serialize_seq(self, _: Option<usize>) -> Result<Inside<'a>, Stop> {
        Ok(Inside::of(self))
    }
    fn serialize_tuple(self, _: usize) -> Result<Inside<'a>, Stop> {
        Ok(Inside::of(self))
    }
    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Inside<'a>, Stop> {
        Ok(Inside::of(self))
    }
    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Inside<'a>, Stop> {
        Ok(Inside::of_variant(self, variant))
    }
    fn serialize_map(self, _: Option<usize>) -> Result<Inside<'a>, Stop> {
        Ok(Inside::of(self))
    }
    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Inside<'a>, Stop> {
        Ok(Inside::of(self))
    }
    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Inside<'a>, Stop> {
        Ok(Inside::of_variant(self, variant))
    }
}

/// Lists of every sort: elements have an index.
macro_rules! indexed {
    ($($sort:ident, $method:ident);*) => {
        $(impl ser::$sort for Inside<'_> {
            type Ok = ();
            type Error = Stop;
            fn $method<T: Serialize + ?Sized>(&mut self, v: &T) -> Result<(), Stop> {
                self.next(v)
            }
            fn end(self) -> Result<(), Stop> {
                self.leave();
                Ok(())
            }
        })*
    };
}

/// Structures of both sorts: elements have a name.
macro_rules! named {
    ($($sort:ident),*) => {
        $(impl ser::$sort for Inside<'_> {
            type Ok = ();
            type Error = Stop;
            fn serialize_field<T: Serialize + ?Sized>(&mut self, name: &'static str, v: &T) -> Result<(), Stop> {
                self.walker.name(name, v)
            }
            fn end(self) -> Result<(), Stop> {
                self.leave();
                Ok(())
            }
        })*
    };
}

indexed!(SerializeSeq, serialize_element; SerializeTuple, serialize_element;
    SerializeTupleStruct, serialize_field; SerializeTupleVariant, serialize_field);
named!(SerializeStruct, SerializeStructVariant);

impl ser::SerializeMap for Inside<'_> {
    type Ok = ();
    type Error = Stop;
    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Stop> {
        let text = serde_json::to_string(key).map_err(ser::Error::custom)?;
        self.key = text.trim_matches('"').to_string();
        Ok(())
    }
    fn serialize_value<T: Serialize + ?Sized>(&mut self, v: &T) -> Result<(), Stop> {
        self.walker.name(&self.key, v)
    }
    fn end(self) -> Result<(), Stop> {
        self.leave();
        Ok(())
    }
}
