//! Where the asymptotic range begins.

use super::{DRIFT, MIN_LEVELS};

/// A tail of the levels.
pub(super) struct Window {
    /// Position of its first level.
    pub start: usize,
    /// Whether its pairwise rates have settled.
    pub asymptotic: bool,
}

/// The longest tail whose successive pairwise rates differ by less than [`DRIFT`], if it has [`MIN_LEVELS`] levels;
/// else the last [`MIN_LEVELS`] levels, marked as not asymptotic.
///
/// `pairwise[i]` is the rate from level `i` to level `i + 1`; at least `MIN_LEVELS − 1` of them.
pub(super) fn choose(pairwise: &[f64]) -> Window {
    let settled = pairwise.windows(2).rev().take_while(|r| (r[1] - r[0]).abs() < DRIFT).count();
    // k small changes join k + 1 pairwise rates, and these k + 2 levels
    let length = settled + 2;
    let levels = pairwise.len() + 1;
    Window { start: levels - length.max(MIN_LEVELS), asymptotic: length >= MIN_LEVELS }
}
