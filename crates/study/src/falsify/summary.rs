//! What is told of searches: one row for each target, and the study files that reproduce the worst.

use super::draw::draw;
use super::measure::as_measured;
use super::search::{Found, Worst};
use super::shrink::Aim;
use crate::claim::catalogue;
use crate::record::{Bounds, to_json};
use crate::store::{StoreError, write_atomic};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Studies of candidates that are saved at most.
const SAVED_CANDIDATES: usize = 10;

/// The searches of one run of the command.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// The seed.
    pub seed: u64,
    /// One row for each target, in the order of the searches.
    pub rows: Vec<Row>,
}

/// One search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The target's name.
    pub target: String,
    /// The scenes that were drawn, in words.
    pub scenes: String,
    /// The constant, as a formula.
    pub constant: String,
    /// The proven bound of the constant.
    pub constant_bound: Option<f64>,
    /// The bounds of the rate.
    pub bounds: Bounds,
    /// Draws.
    pub draws: usize,
    /// Draws whose numbers may be used: not refused, solved, certified, within the error budget.
    pub judged: usize,
    /// Draws among them whose pairwise rates have settled.
    pub settled: usize,
    /// The smallest rate.
    pub worst_rate: Option<Saved>,
    /// The smallest of the last three pairwise rates of any draw.
    pub smallest_pair: Option<f64>,
    /// The largest constant.
    pub worst_constant: Option<Saved>,
    /// The smallest of `(a + b + c − ½A(e,e)) / ½A(e,e)` of any draw and level.
    pub least_slack: Option<f64>,
    /// Draws that break the claim.
    pub candidates: Vec<Candidate>,
    /// Why draws were not judged, the first of them.
    pub not_judged: Option<String>,
}

/// The worst of a search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Saved {
    /// Number of the draw.
    pub index: usize,
    /// The scene drawn.
    pub scene: String,
    /// Its rate or constant.
    pub figure: f64,
    /// The interval of its rate.
    pub interval: Option<[f64; 2]>,
    /// The rate or constant of the scene as simplified and saved.
    pub saved_figure: f64,
    /// That scene.
    pub saved_scene: String,
    /// Simplifications.
    pub steps: usize,
    /// The study, below the folder of the run.
    pub file: String,
}

/// A draw that breaks the claim.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Candidate {
    /// Number of the draw.
    pub index: usize,
    /// The scene.
    pub scene: String,
    /// Why its verdict is a failure.
    pub reason: String,
}

impl Summary {
    /// Writes `summary.json` and, for each target, the studies of the worst and of the candidates, into `folder`.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(folder: &Path, found: &[Found]) -> Result<Self, StoreError> {
        for f in found {
            write_studies(folder, f)?;
        }
        let summary = Self { seed: found.first().map_or(0, |f| f.seed), rows: found.iter().map(row).collect() };
        let path = folder.join("summary.json");
        let text = to_json(&summary).map_err(|source| StoreError::Content { path: path.clone(), source })?;
        write_atomic(&path, &text)?;
        Ok(summary)
    }

    /// Whether any claim was broken.
    pub fn has_candidates(&self) -> bool {
        self.rows.iter().any(|r| !r.candidates.is_empty())
    }
}

fn row(found: &Found) -> Row {
    let about = found.target.about();
    let bounds = about.claim.and_then(|id| catalogue::find(id).ok()).map_or_else(Bounds::default, |e| e.claim().bounds);
    let sound = || found.draws.iter().filter(|m| m.sound);
    let candidate =
        |m: &super::Measured| Candidate { index: m.index, scene: m.scene.clone(), reason: m.reason.clone() };
    Row {
        target: about.id.into(),
        scenes: about.scenes.into(),
        constant: about.constant.into(),
        constant_bound: about.constant_bound,
        bounds,
        draws: found.draws.len(),
        judged: sound().count(),
        settled: sound().filter(|m| m.settled).count(),
        worst_rate: found.worst_rate.as_ref().and_then(|w| saved(found, Aim::Rate, w)),
        smallest_pair: sound().filter_map(|m| m.smallest_pair).min_by(f64::total_cmp),
        worst_constant: found.worst_constant.as_ref().and_then(|w| saved(found, Aim::Constant, w)),
        least_slack: sound().filter_map(|m| m.slack).min_by(f64::total_cmp),
        candidates: found.candidates().map(candidate).collect(),
        not_judged: found.draws.iter().find(|m| !m.sound).map(|m| format!("draw {}: {}", m.index, m.reason)),
    }
}

fn saved(found: &Found, aim: Aim, worst: &Worst) -> Option<Saved> {
    let (drawn, shrunk) = (&worst.drawn, &worst.shrunk);
    Some(Saved {
        index: drawn.index,
        scene: drawn.scene.clone(),
        figure: aim.figure(drawn)?,
        interval: drawn.low.zip(drawn.high).filter(|_| aim == Aim::Rate).map(|(low, high)| [low, high]),
        saved_figure: aim.figure(&shrunk.measured)?,
        saved_scene: shrunk.draw.words(),
        steps: shrunk.steps,
        file: format!("{}/{}.toml", found.target.about().id, aim.file()),
    })
}

fn write_studies(folder: &Path, found: &Found) -> Result<(), StoreError> {
    let folder = folder.join(found.target.about().id);
    for (aim, worst) in [(Aim::Rate, &found.worst_rate), (Aim::Constant, &found.worst_constant)] {
        if let Some(worst) = worst {
            let text = worst.shrunk.draw.text(aim.file(), &remarks(found, aim, worst));
            write_atomic(&folder.join(format!("{}.toml", aim.file())), text)?;
        }
    }
    for m in found.candidates().take(SAVED_CANDIDATES) {
        let id = format!("candidate-{}", m.index);
        let drawn = as_measured(draw(found.target, found.seed, m.index), m);
        let text = drawn.text(&id, &[origin(found, m.index), m.reason.clone()]);
        write_atomic(&folder.join(format!("{id}.toml")), text)?;
    }
    Ok(())
}

fn origin(found: &Found, index: usize) -> String {
    format!("Draw {index} of `signorini falsify {} --seed {}`.", found.target.about().id, found.seed)
}

fn remarks(found: &Found, aim: Aim, worst: &Worst) -> Vec<String> {
    let about = found.target.about();
    let figures = |m: &super::Measured| {
        let rate = m.rate.map(|r| format!("rate {r:.4}"));
        let constant = m.constant.map(|c| format!("constant {c:.4e}"));
        [rate, constant].into_iter().flatten().collect::<Vec<_>>().join(", ")
    };
    let what = match aim {
        Aim::Rate => "The smallest rate",
        Aim::Constant => "The largest constant",
    };
    vec![
        format!("{what} among {} draws. {}", found.draws.len(), origin(found, worst.drawn.index)),
        format!("Drawn: {}.", figures(&worst.drawn)),
        format!("After {} simplifications: {}.", worst.shrunk.steps, figures(&worst.shrunk.measured)),
        format!("The constant is {}.", about.constant),
    ]
}
