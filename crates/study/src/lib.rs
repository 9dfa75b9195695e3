//! Convergence studies of elastic contact: from a study file to a [`record::StudyRecord`].
//!
//! A study is data (TOML), a result is data (JSON), and everything between is a pure function of the two and a seed.

pub mod bench;
pub mod change;
pub mod claim;
pub mod corner;
pub mod error;
pub mod exact;
pub mod expr;
pub mod external;
pub mod extrapolation;
pub mod falsify;
pub mod family;
pub mod fields;
pub mod file;
mod finite;
pub mod lemma;
pub mod msh;
pub mod nearest;
pub mod rate;
pub mod record;
pub mod reference;
pub mod run;
#[cfg(test)]
mod sample;
mod scene;
pub mod schema;
pub mod splitting;
pub mod store;
pub mod study;
pub mod verdict;
