//! Convergence studies of elastic contact: from a study file to a [`record::StudyRecord`].
//!
//! A study is data (TOML), a result is data (JSON), and everything between is a pure function of the two and a seed.

pub mod claim;
pub mod exact;
pub mod expr;
pub mod family;
pub mod record;
pub mod study;
