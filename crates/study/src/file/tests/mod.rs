//! Tests of the reader: shipped studies, the documented example, malformed files.

mod documented;
mod malformed;
mod resolved;
mod shipped;
mod traces;
