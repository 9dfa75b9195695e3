//! Which case runs when: large ones alone, the others side by side.

use super::RunSettings;
use super::settings::{cells_of, reference_cells};
use crate::study::{Case, Study};
use std::cmp::Reverse;
use std::sync::OnceLock;

/// Cases with a mesh larger than this, in cells per unit, run one at a time: two of them would not fit in memory.
const LARGE: usize = 512;

/// Calls `one` for every case of the studies, cases with large meshes one after the other and everything else side by
/// side. Results come study by study, in the order of the files.
pub fn each_case<T: Send + Sync>(
    studies: &[Study],
    settings: &RunSettings,
    one: impl Fn(&Study, &Case) -> T + Sync,
) -> Vec<Vec<T>> {
    let all: Vec<(&Study, &Case)> = studies.iter().flat_map(|s| s.cases.iter().map(move |c| (s, c))).collect();
    let is_large = |case: &Case| {
        cells_of(case, settings).iter().copied().chain(reference_cells(case, settings)).any(|n| n > LARGE)
    };
    let done: Vec<OnceLock<T>> = all.iter().map(|_| OnceLock::new()).collect();
    let run = |k: usize| {
        let (study, case) = all[k];
        // each number is run once, so the place is free
        let _ = done[k].set(one(study, case));
    };
    let (large, mut rest): (Vec<usize>, Vec<usize>) = (0..all.len()).partition(|&k| is_large(all[k].1));
    large.into_iter().for_each(&run);
    // the longest first, so that no thread is left with a long one at the end
    rest.sort_by_key(|&k| Reverse(area(all[k].1, settings)));
    rayon::scope_fifo(|scope| {
        rest.iter().for_each(|&k| {
            let run = &run;
            scope.spawn_fifo(move |_| run(k))
        })
    });
    let results: Vec<T> = done.into_iter().filter_map(OnceLock::into_inner).collect();
    let mut results = results.into_iter();
    studies.iter().map(|s| results.by_ref().take(s.cases.len()).collect()).collect()
}

/// How much there is to do, roughly: the cells of all meshes, up to a factor.
fn area(case: &Case, settings: &RunSettings) -> usize {
    cells_of(case, settings).iter().copied().chain(reference_cells(case, settings)).map(|n| n * n).sum()
}
