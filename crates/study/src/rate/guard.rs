//! What cannot carry a rate, caught before any fit.

use super::Point;

/// Two errors closer than this (relative) on different meshes are one error measured twice.
const REPEATED: f64 = 1e-10;

/// A refined mesh has at most this times the previous mesh size.
const REFINED: f64 = 0.99;

/// Why there is no rate.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoFit {
    /// Fewer levels than a rate needs.
    #[error("{usable} usable levels, {needed} are needed: add finer levels")]
    TooFew {
        /// Levels with a measured error.
        usable: usize,
        /// Levels needed.
        needed: usize,
    },
    /// The error is NaN, infinite, zero or negative.
    #[error("level {level}: the error is {error}, not a positive number")]
    NotPositive {
        /// Where.
        level: usize,
        /// The value.
        error: f64,
    },
    /// The error is no larger than rounding.
    #[error("level {level}: the error {error:.3e} is rounding (below {floor:.3e})")]
    Rounding {
        /// Where.
        level: usize,
        /// The value.
        error: f64,
        /// The size of rounding.
        floor: f64,
    },
    /// Two levels have the same error to ten digits.
    #[error("levels {first} and {second} have the same error {error:.6e}: was one solution measured twice?")]
    Repeated {
        /// Coarser level.
        first: usize,
        /// Finer level.
        second: usize,
        /// Their error.
        error: f64,
    },
    /// The mesh did not get finer.
    #[error(
        "level {level}: h = {h:.6e} after {previous:.6e}, {dofs} dofs after {previous_dofs}: the mesh did not refine"
    )]
    NotRefined {
        /// Where.
        level: usize,
        /// Its mesh size.
        h: f64,
        /// Mesh size of the level before.
        previous: f64,
        /// Its free displacement components.
        dofs: usize,
        /// Those of the level before.
        previous_dofs: usize,
    },
}

/// Refuses points that say nothing about convergence: too few of them, unusable or repeated errors, unrefined meshes.
///
/// `floor` is the size of rounding in the units of the error (0: unknown), `needed` the fewest levels.
///
/// # Errors
/// The first of the reasons of [`NoFit`], in the order above.
pub fn check(points: &[Point], floor: f64, needed: usize) -> Result<(), NoFit> {
    if points.len() < needed {
        return Err(NoFit::TooFew { usable: points.len(), needed });
    }
    points.iter().try_for_each(|p| positive(p, floor))?;
    points.windows(2).try_for_each(|p| refined(&p[0], &p[1]))?;
    (1..points.len()).try_for_each(|k| distinct(&points[..k], &points[k]))
}

fn positive(p: &Point, floor: f64) -> Result<(), NoFit> {
    let (level, error) = (p.level, p.error);
    if !(error.is_finite() && error > 0.0) {
        return Err(NoFit::NotPositive { level, error });
    }
    if error <= floor {
        return Err(NoFit::Rounding { level, error, floor });
    }
    Ok(())
}

fn refined(coarse: &Point, fine: &Point) -> Result<(), NoFit> {
    // written so that a NaN mesh size is refused too
    if fine.h > 0.0 && fine.h <= REFINED * coarse.h && fine.dofs > coarse.dofs {
        return Ok(());
    }
    Err(NoFit::NotRefined {
        level: fine.level,
        h: fine.h,
        previous: coarse.h,
        dofs: fine.dofs,
        previous_dofs: coarse.dofs,
    })
}

fn distinct(before: &[Point], p: &Point) -> Result<(), NoFit> {
    match before.iter().find(|q| (q.error - p.error).abs() <= REPEATED * p.error) {
        Some(q) => Err(NoFit::Repeated { first: q.level, second: p.level, error: p.error }),
        None => Ok(()),
    }
}
