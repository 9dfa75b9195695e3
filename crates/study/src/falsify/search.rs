//! Draws, measures, keeps the worst, makes it simple.

use super::draw::draw;
use super::measure::{Measured, measure, study_hash};
use super::shrink::{Aim, Shrunk, shrink};
use super::state::State;
use super::target::Target;
use crate::store::StoreError;
use rayon::prelude::*;
use std::path::Path;

/// How long and from where.
#[derive(Clone, Debug)]
pub struct Plan<'a> {
    /// Number of draws.
    pub budget: usize,
    /// Seed.
    pub seed: u64,
    /// Where finished draws are kept; nowhere without it.
    pub state: Option<&'a Path>,
    /// Version of the program: results of another version are computed anew.
    pub version: &'a str,
}

/// What a search found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// What was searched.
    pub target: Target,
    /// The seed.
    pub seed: u64,
    /// Every draw, in order.
    pub draws: Vec<Measured>,
    /// The scene with the smallest rate, simplified; settled ones before others.
    pub worst_rate: Option<Worst>,
    /// The scene with the largest constant, simplified.
    pub worst_constant: Option<Worst>,
}

/// The worst draw, and what became of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Worst {
    /// As drawn.
    pub drawn: Measured,
    /// As saved.
    pub shrunk: Shrunk,
}

impl Found {
    /// The draws that break the claim.
    pub fn candidates(&self) -> impl Iterator<Item = &Measured> {
        self.draws.iter().filter(|m| m.is_candidate())
    }
}

/// Searches. `done` is called after each draw; draws run side by side, results do not depend on how.
///
/// # Errors
/// If finished draws cannot be kept.
pub fn search(target: Target, plan: &Plan, done: &(dyn Fn() + Sync)) -> Result<Found, StoreError> {
    let state = plan.state.map(|folder| State::open(folder, target, plan.seed, plan.version)).transpose()?;
    let one = |index: usize| {
        let measured = known_or_measured(target, plan.seed, index, state.as_ref());
        done();
        measured
    };
    let draws: Result<Vec<Measured>, StoreError> =
        (0..plan.budget).into_par_iter().with_max_len(1).map(one).collect::<Vec<_>>().into_iter().collect();
    let draws = draws?;
    if let Some(state) = &state {
        state.finish(&draws)?;
    }
    let simplify = |aim: Aim| {
        let drawn = worst(aim, &draws)?;
        let shrunk = shrink(aim, &draw(target, plan.seed, drawn.index), drawn);
        Some(Worst { drawn: drawn.clone(), shrunk })
    };
    let (worst_rate, worst_constant) = rayon::join(|| simplify(Aim::Rate), || simplify(Aim::Constant));
    Ok(Found { target, seed: plan.seed, draws, worst_rate, worst_constant })
}

fn known_or_measured(target: Target, seed: u64, index: usize, state: Option<&State>) -> Result<Measured, StoreError> {
    let drawn = draw(target, seed, index);
    let known = state.and_then(|s| s.known.get(&index)).filter(|m| m.study == study_hash(&drawn));
    if let Some(known) = known {
        return Ok(known.clone());
    }
    let measured = measure(index, &drawn).1;
    if let Some(state) = state {
        state.keep(&measured)?;
    }
    Ok(measured)
}

/// The first draw with the worst figure. A rate counts where it has settled, or, if no draw has, wherever there is one.
fn worst(aim: Aim, draws: &[Measured]) -> Option<&Measured> {
    let with_figure = || draws.iter().filter_map(|m| Some((m, aim.figure(m)?)));
    match aim {
        Aim::Rate => {
            let least =
                |settled: bool| with_figure().filter(|(m, _)| m.settled || !settled).min_by(|a, b| a.1.total_cmp(&b.1));
            least(true).or_else(|| least(false)).map(|(m, _)| m)
        }
        // the first of equals: max_by gives the last
        Aim::Constant => with_figure().min_by(|a, b| b.1.total_cmp(&a.1)).map(|(m, _)| m),
    }
}
