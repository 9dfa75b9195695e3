//! The projection of a given `v ∈ K` onto `K_h` in the energy norm: how far `v` is from `K_h`.
//!
//! ```text
//! min { ½A(v−v_h, v−v_h) : v_h ∈ K_h }  =  min { ½A(v_h,v_h) − A(v,v_h) : v_h ∈ K_h } + ½A(v,v)
//! ```
//!
//! A contact problem with the load `A(v, ·)`. Its energy gives the square of the error a second time, so `two_way` holds with
//! no contact term; the estimate of the theorems is not about it, so there is no ledger.

use super::parts::relative_difference;
use crate::record::Level;

/// Of an exact `v`: its error and `two_way` stand; the energy gap is that of the projection.
pub(super) fn of_exact(level: &mut Level, energy_of_v: f64) {
    level.ledger = None;
    level.errors.energy_gap = Some(level.energy + 0.5 * energy_of_v);
}

/// Of a discrete `v` on a finer nested mesh: loads and errors are exact, and `v` has no error of its own.
pub(super) fn of_discrete(level: &mut Level, energy_of_v: f64) {
    of_exact(level, energy_of_v);
    let square = level.errors.energy.map(|e| e * e);
    let by_energies = level.errors.energy_gap.map(|gap| 2.0 * gap);
    level.two_way = square.zip(by_energies).and_then(|(a, b)| relative_difference(a, b, energy_of_v));
    level.budget.quadrature = Some(0.0);
    level.budget.reference = Some(0.0);
}
