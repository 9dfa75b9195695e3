//! Derivatives of an exact solution against differences of its own values.

use super::condition::{Condition, VerifyError, demand};
use super::verify::not_finite;
use super::{Exact, Jet2};
use signorini_contact::geometry::LinePoint;
use signorini_contact::{Body, Point, Vec2};

/// Relative tolerance: the differences themselves are good to about 1e-8.
const TOLERANCE: f64 = 1e-5;
/// Step, and how far the probes stay from break lines and singular points, per length of the piece.
const STEP: f64 = 1e-5;
const CLEARANCE: f64 = 0.02;

/// Sizes of a solution, against which differences are judged.
pub(super) struct Scales {
    first: f64,
    second: f64,
}

impl Scales {
    /// Largest derivatives in `jets`; lower ones count too, divided by the `length` of the contact zone.
    pub(super) fn of<'a>(jets: impl Iterator<Item = &'a Jet2>, length: f64) -> Self {
        let mut sizes = [0.0f64; 3];
        for jet in jets {
            sizes[0] = sizes[0].max(jet.value.amax());
            sizes[1] = largest(sizes[1], jet.gradient.iter().flatten());
            sizes[2] = largest(sizes[2], jet.hessian.iter().flatten().flatten());
        }
        let first = sizes[1].max(sizes[0] / length);
        Self { first, second: sizes[2].max(first / length) }
    }
}

/// Probes a few points inside both bodies beside a piece of the contact zone of the given length; `on` is its point at a
/// parameter between 0 and 1.
pub(super) fn check(
    exact: &dyn Exact,
    on: impl Fn(f64) -> LinePoint,
    length: f64,
    scales: &Scales,
) -> Result<(), VerifyError> {
    let (points, lines) = (exact.singular_points(), exact.break_lines());
    for (along, away) in [(0.137, 0.05), (0.391, 0.11), (0.633, 0.07), (0.871, 0.13)] {
        let edge = on(along);
        for body in Body::BOTH {
            let outward = edge.conormals[body.index()].normalize();
            let at = edge.at[body.index()] - away * length * outward;
            let near = points.iter().any(|p| (p - at).norm() < CLEARANCE * length)
                || lines.iter().any(|l| l.distance(at) < CLEARANCE * length);
            if !near {
                probe(exact, body, at, STEP * length, scales)?;
            }
        }
    }
    Ok(())
}

fn probe(exact: &dyn Exact, body: Body, at: Point, step: f64, scales: &Scales) -> Result<(), VerifyError> {
    let jet = exact.jet2(body, at);
    let bad = not_finite(&jet);
    let finite = bad.is_none();
    demand(finite, Condition::Finite, Some(body), at, bad.unwrap_or(0.0), f64::MAX)?;
    // Scales are those of the contact zone; inside the body the solution may be larger.
    let inside = Scales::of([jet].iter(), 1.0);
    let bounds = [TOLERANCE * scales.first.max(inside.first), TOLERANCE * scales.second.max(inside.second)];
    let errors = deviations(exact, body, at, step, &jet);
    let conditions = [Condition::Gradient, Condition::Hessian];
    for ((condition, value), bound) in conditions.into_iter().zip(errors).zip(bounds) {
        demand(value <= bound, condition, Some(body), at, value, bound)?;
    }
    Ok(())
}

/// Largest deviation of `∇u` and of `∇∇u` from central differences of `u` and of `∇u`.
fn deviations(exact: &dyn Exact, body: Body, at: Point, step: f64, jet: &Jet2) -> [f64; 2] {
    let first_order = exact.jet(body, at);
    let mut found = [0.0f64; 2];
    for (k, e) in [Vec2::x(), Vec2::y()].into_iter().enumerate() {
        let (after, before) = (exact.jet(body, at + step * e), exact.jet(body, at - step * e));
        for i in 0..2 {
            let slope = (after.value[i] - before.value[i]) / (2.0 * step);
            for gradient in [jet.gradient, first_order.gradient] {
                found[0] = worse(found[0], slope - gradient[i][k]);
            }
            for j in 0..2 {
                let bend = (after.gradient[i][j] - before.gradient[i][j]) / (2.0 * step);
                found[1] = worse(found[1], bend - jet.hessian[i][j][k]);
            }
        }
    }
    found
}

/// The larger magnitude; a NaN stays.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.abs() <= a { a } else { b.abs() }
}

fn largest<'a>(start: f64, values: impl Iterator<Item = &'a f64>) -> f64 {
    values.fold(start, |m, v| m.max(v.abs()))
}
