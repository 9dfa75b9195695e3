//! Tests of the reader: shipped studies, the documented example, malformed files.

mod bilateral;
mod curves;
mod documented;
mod formula;
mod lemma;
mod malformed;
mod resolved;
mod shipped;
mod traces;
