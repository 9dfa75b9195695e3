//! From the worst scene that was drawn to a simple one that is nearly as bad.

use super::draw::{Draw, simpler};
use super::measure::{Measured, as_measured, measure};

/// In which way a draw is bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// A small rate.
    Rate,
    /// A large constant.
    Constant,
}

/// A simpler scene may have a rate larger by this.
pub const RATE_KEPT: f64 = 0.02;

/// A simpler scene has at least this share of the constant.
pub const CONSTANT_KEPT: f64 = 0.9;

/// Scenes that are tried at most.
const TRIALS: usize = 48;

impl Aim {
    /// The name of the file.
    pub fn file(self) -> &'static str {
        match self {
            Self::Rate => "worst-rate",
            Self::Constant => "worst-constant",
        }
    }

    /// The figure that is judged; none where the draw has none that may be used.
    pub fn figure(self, m: &Measured) -> Option<f64> {
        match self {
            Self::Rate => m.rate,
            Self::Constant => m.constant,
        }
        .filter(|_| m.sound)
    }

    /// Whether the figure `new` is as bad as `worst`, nearly.
    fn keeps(self, new: f64, worst: f64) -> bool {
        match self {
            Self::Rate => new <= worst + RATE_KEPT,
            Self::Constant => new >= CONSTANT_KEPT * worst,
        }
    }
}

/// A simple scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Shrunk {
    /// It.
    pub draw: Draw,
    /// What it gives.
    pub measured: Measured,
    /// Simplifications that were kept.
    pub steps: usize,
}

/// Simplifies greedily: the first simpler scene that stays nearly as bad as the worst itself takes its place, until none does.
pub fn shrink(aim: Aim, worst: &Draw, measured: &Measured) -> Shrunk {
    let worst = as_measured(worst.clone(), measured);
    let mut best = Shrunk { draw: worst, measured: measured.clone(), steps: 0 };
    let Some(figure) = aim.figure(measured) else { return best };
    let mut refused: Vec<Draw> = Vec::new();
    while refused.len() + best.steps < TRIALS {
        let untried = simpler(&best.draw).into_iter().find(|d| !refused.contains(d));
        let Some(untried) = untried else { break };
        let (candidate, found) = measure(measured.index, &untried);
        let bad = aim.figure(&found).is_some_and(|new| aim.keeps(new, figure));
        // what was settled, or a candidate, stays so
        let alike = found.settled >= measured.settled && found.is_candidate() >= measured.is_candidate();
        if bad && alike {
            best = Shrunk { draw: candidate, measured: found, steps: best.steps + 1 };
        } else {
            refused.push(untried);
        }
    }
    best
}
