//! One draw, run and measured.

use super::draw::Draw;
use super::size::{Size, size};
use super::target::Target;
use crate::error::RunError;
use crate::file::StudyError;
use crate::record::{Level, Outcome, StudyRecord};
use crate::run::{Profile, RunSettings, Unwatched, run_case};
use crate::study::Study;
use crate::verdict::{JudgeInput, doubt};
use serde::{Deserialize, Serialize};
use signorini_contact::mesh::fnv1a;
use std::path::Path;

/// What a draw gave.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Number of the draw.
    pub index: usize,
    /// Hash of its study, 16 hex digits: a result is used again only for the same study.
    pub study: String,
    /// The scene in a few words.
    pub scene: String,
    /// Levels that were added to it.
    pub finer: usize,
    /// The verdict of its study; none if it was refused.
    pub outcome: Option<Outcome>,
    /// The first reason of the verdict, or why it was refused.
    pub reason: String,
    /// Whether its numbers may be used: solved, certified, within the error budget.
    pub sound: bool,
    /// Fitted rate.
    pub rate: Option<f64>,
    /// Its 95 % interval.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
    /// Whether the pairwise rates have settled.
    pub settled: bool,
    /// Smallest of the last three pairwise rates.
    pub smallest_pair: Option<f64>,
    /// The target's constant, the largest over the levels.
    pub constant: Option<f64>,
    /// `(a + b + c − ½A(e,e)) / ½A(e,e)`, the smallest over the levels.
    pub slack: Option<f64>,
}

impl Measured {
    /// Whether the theory is broken: a rate below its bound, or an inequality.
    pub fn is_candidate(&self) -> bool {
        self.outcome == Some(Outcome::Fail)
    }
}

/// The id that a study has while it is measured.
const ID: &str = "draw";

/// Runs the study of a draw. A rate that fails is tried again with finer levels beside the others: on coarse meshes a rate may still
/// be rising. What a level has broken stays broken.
pub fn measure(index: usize, draw: &Draw) -> (Draw, Measured) {
    let study = study_hash(draw);
    let (mut tried, mut measured) = (draw.clone(), once(index, draw));
    while let Some(finer) = tried.finer().filter(|_| measured.is_candidate() && measured.rate.is_some()) {
        measured = Measured { finer: measured.finer + 1, ..once(index, &finer) };
        tried = finer;
    }
    (tried, Measured { study, ..measured })
}

/// The draw with as many more levels as it was measured on.
pub fn as_measured(draw: Draw, measured: &Measured) -> Draw {
    (0..measured.finer).fold(draw, |d, _| d.finer().unwrap_or(d))
}

/// The hash by which a result is known again.
pub fn study_hash(draw: &Draw) -> String {
    hash(&draw.text(ID, &[]))
}

fn once(index: usize, draw: &Draw) -> Measured {
    let mut measured = Measured {
        index,
        study: String::new(),
        scene: draw.words(),
        finer: 0,
        outcome: None,
        reason: String::new(),
        sound: false,
        rate: None,
        low: None,
        high: None,
        settled: false,
        smallest_pair: None,
        constant: None,
        slack: None,
    };
    match run(&draw.text(ID, &[])) {
        Ok(ran) => fill(&mut measured, draw.target, &ran),
        Err(why) => measured.reason = why.to_string().lines().next().unwrap_or_default().into(),
    }
    measured
}

/// 16 hex digits of a study's text.
fn hash(text: &str) -> String {
    format!("{:016x}", fnv1a(text.as_bytes()))
}

#[derive(Debug, thiserror::Error)]
enum Refused {
    #[error(transparent)]
    Study(#[from] StudyError),
    #[error(transparent)]
    Run(#[from] RunError),
    #[error("the study has no case with a scene")]
    Empty,
}

struct Ran {
    record: StudyRecord,
    size: Option<Size>,
    sound: bool,
}

fn run(text: &str) -> Result<Ran, Refused> {
    let path = format!("{ID}.toml");
    let study = Study::parse(text, Path::new(&path))?;
    let case = study.cases.first().ok_or(Refused::Empty)?;
    let settings =
        RunSettings { profile: Profile::Quick, levels: None, solver: None, partial: None, keep: Default::default() };
    let record = run_case(&study, case, &settings, &Unwatched)?.record;
    let scene = case.scene().ok_or(Refused::Empty)?;
    let size = scene.exact.as_ref().map(|exact| size(scene, exact, case)).transpose()?;
    let sound = doubt::all(&JudgeInput {
        kind: record.kind,
        norm: &record.norm,
        levels: &record.levels,
        bounds: &record.bounds,
        gates: &case.gates,
        expected_is_asymptotic: false,
    });
    Ok(Ran { record, size, sound: sound.is_empty() })
}

fn fill(measured: &mut Measured, target: Target, ran: &Ran) {
    let (record, size) = (&ran.record, ran.size.as_ref());
    measured.sound = ran.sound;
    measured.outcome = Some(record.verdict.outcome);
    measured.reason = record.verdict.reasons.first().cloned().unwrap_or_default();
    if let Some(rate) = record.rates.get("strain").filter(|_| target.about().power.is_some()) {
        (measured.rate, measured.low, measured.high) = (Some(rate.slope), Some(rate.low), Some(rate.high));
        measured.settled = rate.asymptotic;
        let last = rate.pairwise.iter().rev().take(3).map(|(_, r)| *r);
        measured.smallest_pair = last.min_by(f64::total_cmp);
    }
    let usable = || record.levels.iter().filter(|l| l.excluded.is_none());
    let finite = |x: &f64| x.is_finite();
    measured.constant = usable().filter_map(|l| constant(target, l, size)).filter(finite).max_by(f64::total_cmp);
    measured.slack = record.levels.iter().filter_map(slack).filter(finite).min_by(f64::total_cmp);
}

fn slack(level: &Level) -> Option<f64> {
    let ledger = level.ledger.as_ref().filter(|l| l.lhs > 0.0)?;
    Some(ledger.sum() / ledger.lhs - 1.0)
}

/// The constant of [`Target::about`] on one level.
fn constant(target: Target, level: &Level, size: Option<&Size>) -> Option<f64> {
    match target {
        Target::Lemma21 => Some(level.errors.penetration_l2? / level.solution_trace.filter(|t| *t > 0.0)?),
        Target::Falk => slack(level).map(|s| 1.0 / (1.0 + s)),
        Target::ManySwitches => {
            let s = size?;
            let bound = level.h * level.h * s.switches as f64 * s.stress_max * s.jump_slope;
            // b is work: in units of stress, as T_n
            (bound > 0.0).then_some(level.ledger.as_ref()?.b.abs() / (s.unit * bound))
        }
        _ => {
            let squared = normaliser(target, level, size?)?;
            let power = target.about().power?;
            (squared > 0.0).then_some(level.errors.strain? / (level.h.powf(power) * squared.sqrt()))
        }
    }
}

/// What stands in braces in the target's constant.
fn normaliser(target: Target, level: &Level, s: &Size) -> Option<f64> {
    let u = s.h2_squared;
    Some(match target {
        Target::Remark32a => u + s.stress_l2 * s.curvatures,
        Target::Remark32b => u + s.stress_l2 * u.sqrt(),
        Target::Theorem33 => u + s.stress_l2 * (u.sqrt() + level.solution_h1?),
        Target::Theorem34 => u + s.stress_max * (s.slopes + s.initial_gap),
        _ => u + s.stress_max * s.slopes,
    })
}
