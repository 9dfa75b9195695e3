//! What both kinds of reference have in common: errors as a record holds them, the ledger's verdict, shares.

use crate::rate;
use crate::record::{Errors, Ledger};
use crate::run::contact::ContactErrors;
use signorini_contact::Vec2;
use signorini_contact::norm::Squares;
use signorini_contact::problem::Discrete;

/// Below this share of `A(u,u)` a squared error is rounding, and a relative difference of it means nothing.
const ROUNDING: f64 = 1e-12;

pub(super) fn ledger(lhs: f64, [a, b, c]: [f64; 3], delta: f64, solution: f64) -> Ledger {
    let excess = lhs - (a + b + c + 1e-14 * solution);
    let holds = if excess <= delta {
        Some(true)
    } else if excess <= 10.0 * delta {
        None
    } else {
        Some(false)
    };
    Ledger { lhs, a, b, c, parts: Default::default(), delta, holds }
}

pub(super) fn set_errors(
    errors: &mut Errors,
    e: &Squares,
    contact: &ContactErrors,
    interpolation: f64,
    energy_gap: f64,
) {
    errors.strain = Some(e.strain_seminorm());
    errors.energy = Some(e.energy_norm());
    errors.h1 = Some(e.h1_norm());
    errors.l2 = Some(e.l2_norm());
    errors.pressure_l2 = Some(contact.pressure);
    errors.pressure_dual = Some(contact.pressure_dual);
    errors.contact_set = Some(contact.contact_set);
    errors.switch_position = contact.switch_position;
    errors.energy_gap = Some(energy_gap);
    errors.strain_bodies = Some(e.strain.map(f64::sqrt));
    errors.interpolation = Some(interpolation);
}

pub(super) fn differences(a: &[Vec2], b: &[Vec2]) -> Vec<Vec2> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// Block-Jacobi estimate of the energy norm of the solution's change under a change of load, `(δfᵀ D⁻¹ δf)^{1/2}`: sharp for
/// the rough changes that a local quadrature error makes.
pub(super) fn dual_norm(discrete: &Discrete, change: &[Vec2]) -> f64 {
    let force = discrete.basis.force(change);
    let node = |i: usize| {
        let [a, b, c, d] = discrete.qp.matrix.diagonal_block(i);
        let (x, y) = (force[2 * i], force[2 * i + 1]);
        (d * x * x - (b + c) * x * y + a * y * y) / (a * d - b * c)
    };
    (0..discrete.qp.matrix.rows()).map(node).sum::<f64>().sqrt()
}

/// `|a − b|/a`, or nothing where `a` is rounding.
pub(super) fn relative_difference(a: f64, b: f64, scale: f64) -> Option<f64> {
    (a > ROUNDING * scale).then(|| (a - b).abs() / a)
}

/// `part/whole`, or nothing where the whole is rounding.
pub(super) fn share(part: f64, whole: f64, scale: f64) -> Option<f64> {
    (whole > rate::ROUNDING * scale).then_some(part / whole)
}
