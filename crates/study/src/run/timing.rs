//! Seconds and bytes of a level, kept in a file apart from the record so that records stay identical from run to run.

use super::processor::processor_seconds;
use crate::external::Used;
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// Wall seconds of each phase of a level.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct LevelTimes {
    /// Triangulation and refinement.
    pub mesh: f64,
    /// Loads (with the quadrature of the exact solution, if there is one) and stiffness.
    pub assembly: f64,
    /// Factorisation and condensation; nothing for methods that have no such phase.
    pub setup: f64,
    /// Active set or interior point, back-substitution, refinement.
    pub solve: f64,
    /// Errors, ledger, certificates.
    pub error: f64,
    /// Largest resident memory of the process so far, where the system tells.
    pub peak_bytes: Option<u64>,
    /// What the program used that solved the level in place of this one. Its wall time is in `solve`, and the peak is its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub external: Option<Used>,
    /// Seconds in which the level was written down for that program and its answer read; they are in no phase.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub handover: Option<f64>,
    /// Processor seconds of the whole process in each phase, in the order of [`LevelTimes::phases`], where the system tells. They
    /// are those of the level only where nothing else runs beside it, so they are not written with the others.
    #[serde(skip)]
    pub processor: Option<[f64; 5]>,
}

impl LevelTimes {
    /// Names of the phases.
    pub const PHASES: [&'static str; 5] = ["mesh", "assembly", "setup", "solve", "error"];

    /// Seconds of the phases in their order.
    pub fn phases(&self) -> [f64; 5] {
        [self.mesh, self.assembly, self.setup, self.solve, self.error]
    }
}

/// Times the phases of a level one after the other.
pub struct Stopwatch {
    last: Instant,
    times: LevelTimes,
    last_processor: Option<f64>,
    processor: LevelTimes,
}

impl Stopwatch {
    /// Starts the first phase.
    pub fn start() -> Self {
        Self {
            last: Instant::now(),
            times: LevelTimes::default(),
            last_processor: processor_seconds(),
            processor: LevelTimes::default(),
        }
    }

    /// Ends a phase: `lap(|t| &mut t.mesh)`.
    pub fn lap(&mut self, phase: impl Fn(&mut LevelTimes) -> &mut f64) {
        let now = Instant::now();
        *phase(&mut self.times) += (now - self.last).as_secs_f64();
        self.last = now;
        let used = processor_seconds();
        if let (Some(used), Some(last)) = (used, self.last_processor) {
            *phase(&mut self.processor) += used - last;
        }
        self.last_processor = used;
    }

    /// Ends a span in which files were written, another program solved, and its answer was read: its own time is the solve, the
    /// rest belongs to no phase.
    pub fn external(&mut self, used: Used) {
        let now = Instant::now();
        self.times.handover = Some(((now - self.last).as_secs_f64() - used.seconds).max(0.0));
        (self.last, self.last_processor) = (now, processor_seconds());
        self.times.solve += used.seconds;
        self.processor.solve += used.processor;
        self.times.external = Some(used);
    }

    /// The times, with the memory's high-water mark.
    pub fn finish(mut self) -> LevelTimes {
        self.times.peak_bytes = self.times.external.map(|used| used.peak_bytes).or_else(peak_bytes);
        self.times.processor = self.last_processor.map(|_| self.processor.phases());
        self.times
    }
}

/// `VmHWM` of this process on Linux.
fn peak_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse::<u64>().ok().map(|kb| 1024 * kb)
}
