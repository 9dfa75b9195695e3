//! Seconds, bytes and spreads in words.

use crate::format::{MISSING, significant};
use signorini_study::bench::record::{BenchRecord, BenchStudy, ErrorSource, Exponent};
use signorini_study::bench::spread::Spread;

/// Significant digits of a time: more are noise.
const DIGITS: usize = 3;

/// `0.0123`, or nothing.
pub(super) fn number(x: Option<f64>) -> String {
    x.map_or(MISSING.into(), |x| significant(x, DIGITS))
}

/// The median.
pub(super) fn median(spread: Option<Spread>) -> String {
    number(spread.map(|s| s.median))
}

/// `1.23 (1.20–1.31)`: median, smallest and largest; the median alone of a single run.
pub(super) fn spread(spread: Option<Spread>) -> String {
    match spread {
        Some(s) if s.runs > 1 => {
            let [median, min, max] = [s.median, s.min, s.max].map(|x| significant(x, DIGITS));
            format!("{median} ({min}–{max})")
        }
        other => median(other),
    }
}

/// A spread in another unit.
pub(super) fn scaled(spread: Spread, factor: f64) -> Spread {
    Spread { median: factor * spread.median, min: factor * spread.min, max: factor * spread.max, runs: spread.runs }
}

/// `N^{1.03 ± 0.01}`.
pub(super) fn exponent(fitted: Option<Exponent>) -> String {
    fitted.map_or(MISSING.into(), |e| format!("N^{{{:.2} ± {:.2}}}", e.value, e.stderr))
}

/// The same where nothing can be raised.
pub(super) fn plain_exponent(fitted: Option<Exponent>) -> String {
    fitted.map_or(MISSING.into(), |e| format!("{:.2} ± {:.2} ({} meshes)", e.value, e.stderr, e.sizes))
}

/// `study`, or `study/case` where the two differ.
pub(super) fn name(study: &BenchStudy) -> String {
    if study.study == study.case { study.study.clone() } else { format!("{}/{}", study.study, study.case) }
}

/// What the errors are.
pub(super) fn error_source(study: &BenchStudy) -> &'static str {
    match study.error {
        ErrorSource::Exact => "Errors in the energy norm against the exact solution.",
        ErrorSource::Energies => {
            "Errors √(2(L(uₕ) − L*)) from the energies and their extrapolated limit L*; none where the limit is too uncertain."
        }
        ErrorSource::None => {
            "No errors: there is no exact solution, and too few nested levels to extrapolate the energy."
        }
    }
}

/// `AMD EPYC, 2 processors, 24 GiB, linux x86_64`.
pub(super) fn machine(record: &BenchRecord) -> String {
    let m = &record.machine;
    let processors = if m.processors == 1 { "1 processor".into() } else { format!("{} processors", m.processors) };
    let memory = m.memory_bytes.map(|b| format!("{:.1} GiB", b as f64 / f64::from(1 << 30)));
    let known = m.processor.clone().into_iter().chain([processors]).chain(memory).chain([m.system.clone()]);
    known.collect::<Vec<_>>().join(", ")
}

/// `2 threads`.
pub(super) fn threads(record: &BenchRecord) -> String {
    if record.threads == 1 { "1 thread".into() } else { format!("{} threads", record.threads) }
}

/// `median of 3 rounds`, or `one round`.
pub(super) fn rounds(record: &BenchRecord) -> String {
    if record.repeat == 1 { "one round".into() } else { format!("medians of {} rounds", record.repeat) }
}
