//! The steps of a run, its levels and references, and how much work each is: what a bar with the time left needs to know.

use super::{RunSettings, Watch, cells_of, reference_cells};
use crate::error::RunError;
use crate::study::{Case, Study};

/// A level, or the reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step<'a> {
    /// Study id.
    pub study: &'a str,
    /// Case name.
    pub case: &'a str,
    /// Cells per unit.
    pub cells: usize,
    /// Whether it is the reference.
    pub is_reference: bool,
    /// Roughly how long it takes, in the time of one cell.
    pub work: u64,
}

/// The steps of a case.
pub struct Steps<'a> {
    study: &'a str,
    case: &'a str,
    cells: &'a [usize],
    reference: Option<usize>,
}

/// Errors against a finer mesh are summed over its cells, in about this share of the time of solving on it.
const COMPARED: u64 = 8;

impl<'a> Steps<'a> {
    /// Of a case under these settings.
    pub fn of(study: &'a Study, case: &'a Case, settings: &RunSettings) -> Self {
        let (cells, reference) = (cells_of(case, settings), reference_cells(case, settings));
        Self { study: &study.id, case: &case.name, cells, reference }
    }

    /// The level at an index. Unknowns grow like the square of the cells per unit, and time like the unknowns.
    pub fn level(&self, index: usize) -> Step<'a> {
        let work = square(self.cells[index]) + self.reference.map_or(0, square) / COMPARED;
        self.step(self.cells[index], false, work)
    }

    /// The reference.
    pub fn reference(&self, cells: usize) -> Step<'a> {
        self.step(cells, true, square(cells))
    }

    fn step(&self, cells: usize, is_reference: bool, work: u64) -> Step<'a> {
        Step { study: self.study, case: self.case, cells, is_reference, work }
    }

    fn all(&self) -> impl Iterator<Item = Step<'a>> {
        let levels = (0..self.cells.len()).map(|index| self.level(index));
        levels.chain(self.reference.map(|cells| self.reference(cells)))
    }
}

fn square(cells: usize) -> u64 {
    (cells as u64).pow(2)
}

/// The work of a study: the sum over its steps.
pub fn work(study: &Study, settings: &RunSettings) -> u64 {
    study.cases.iter().flat_map(|case| Steps::of(study, case, settings).all().map(|s| s.work).collect::<Vec<_>>()).sum()
}

/// Makes one step, unless the run is to stop.
pub fn stepped<T>(
    watch: &dyn Watch,
    step: &Step<'_>,
    make: impl FnOnce() -> Result<T, RunError>,
) -> Result<T, RunError> {
    if watch.stops() {
        return Err(RunError::Interrupted);
    }
    watch.begun(step);
    let made = make();
    watch.done(step);
    made
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::{Profile, run_case};
    use crate::sample;
    use std::sync::Mutex;
    use std::sync::atomic::{AtomicU64, Ordering};

    /// Adds up work, and stops the run after so many steps.
    struct Counter {
        work: AtomicU64,
        begun: Mutex<Vec<usize>>,
        last: usize,
    }

    impl Watch for Counter {
        fn begun(&self, step: &Step<'_>) {
            self.begun.lock().unwrap().push(step.cells);
        }

        fn done(&self, step: &Step<'_>) {
            self.work.fetch_add(step.work, Ordering::SeqCst);
        }

        fn stops(&self) -> bool {
            self.begun.lock().unwrap().len() >= self.last
        }
    }

    fn settings() -> RunSettings {
        RunSettings { profile: Profile::Quick, levels: Some(2), solver: None, partial: None, keep: Default::default() }
    }

    #[test]
    fn the_steps_of_a_run_are_as_much_work_as_was_announced() {
        let study = sample::study("theorem-3-1-smooth");
        let watch = Counter { work: AtomicU64::new(0), begun: Mutex::default(), last: usize::MAX };
        let study = Study { cases: study.cases[..1].to_vec(), ..study };
        run_case(&study, &study.cases[0], &settings(), &watch).unwrap();
        assert_eq!(watch.work.into_inner(), work(&study, &settings()));
        assert_eq!(work(&study, &settings()), 8 * 8 + 16 * 16);
    }

    #[test]
    fn a_run_that_is_to_stop_begins_no_further_step() {
        let study = sample::study("theorem-3-1-smooth");
        let watch = Counter { work: AtomicU64::new(0), begun: Mutex::default(), last: 0 };
        let run = run_case(&study, &study.cases[0], &settings(), &watch);
        assert!(matches!(run, Err(RunError::Interrupted)));
        assert_eq!(watch.begun.into_inner().unwrap(), [0; 0]);
    }
}
