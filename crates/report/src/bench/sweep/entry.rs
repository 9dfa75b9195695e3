//! A case of a sweep on one mesh under one solver.

use signorini_study::bench::record::{BenchStudy, Measured, Size, SolverCurve};
use signorini_study::record::Setting;

/// A measurement, or why there is none.
pub(super) struct Entry<'a> {
    /// Every key that was changed.
    pub settings: Vec<&'a Setting>,
    pub curve: &'a SolverCurve,
    pub size: &'a Size,
    pub run: Result<&'a Measured, &'a str>,
}

/// All entries of a case, solver by solver, coarsest first.
pub(super) fn entries(study: &BenchStudy) -> Vec<Entry<'_>> {
    let settings: Vec<&Setting> = study.changed.iter().flat_map(|c| &c.settings).collect();
    let mut found = Vec::new();
    for curve in &study.solvers {
        for size in &study.sizes {
            let run = curve.runs.iter().find(|r| r.level == size.level).map(Ok);
            let reason = || curve.left_out.iter().find(|l| l.level == size.level).map(|l| Err(l.reason.as_str()));
            if let Some(run) = run.or_else(reason) {
                found.push(Entry { settings: settings.clone(), curve, size, run });
            }
        }
    }
    found
}

impl<'a> Entry<'a> {
    /// The swept settings.
    pub fn swept(&self) -> impl Iterator<Item = &'a Setting> + '_ {
        self.settings.iter().copied().filter(|s| s.swept)
    }

    /// The value of a key.
    pub fn value(&self, key: &str) -> Option<&'a Setting> {
        self.swept().find(|s| s.key == key)
    }

    pub fn work(&self) -> Option<f64> {
        self.run.ok()?.work
    }

    pub fn iterations(&self) -> Option<f64> {
        Some(self.run.ok()?.iterations as f64)
    }

    /// Processor seconds of set-up and solve.
    pub fn processor(&self) -> Option<f64> {
        Some(self.run.ok()?.processor?.system.median)
    }

    /// Microseconds of the processor per unknown.
    pub fn cost(&self) -> Option<f64> {
        Some(1e6 * self.processor()? / self.size.dofs as f64)
    }

    /// Work of the contact problem over that of the linear one.
    pub fn over_linear(&self) -> Option<f64> {
        let run = self.run.ok()?;
        run.work.zip(run.linear?.work).map(|(contact, linear)| contact / linear)
    }

    /// Whether all but the value of one key is the same.
    pub fn is_beside(&self, other: &Self, key: &str) -> bool {
        let rest = |e: &Self| e.swept().filter(|s| s.key != key).map(|s| s.value.clone()).collect::<Vec<_>>();
        (self.size.level, &self.curve.solver) == (other.size.level, &other.curve.solver) && rest(self) == rest(other)
    }
}

/// The swept keys with their short names, in the order of the options.
pub(super) fn keys<'a>(entries: &[Entry<'a>]) -> Vec<(&'a str, &'a str)> {
    entries.first().map_or_else(Vec::new, |e| e.swept().map(|s| (s.key.as_str(), s.name.as_str())).collect())
}

/// The values of a key in the order of the option.
pub(super) fn values<'a>(entries: &[Entry<'a>], key: &str) -> Vec<&'a Setting> {
    let mut found: Vec<&Setting> = Vec::new();
    for setting in entries.iter().filter_map(|e| e.value(key)) {
        if !found.iter().any(|f| f.value == setting.value) {
            found.push(setting);
        }
    }
    found
}
