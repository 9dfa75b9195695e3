//! Pointwise verification of an exact solution, before any mesh exists.
//!
//! With the points of both bodies that face each other, the normal `n` of the constraint, the gap `ε` and the forces
//! `t = τ ν` per unit of the zone's measure (`ν` each body's outward normal in that measure): `n·(u' − u'') ≤ ε`,
//! `n·t' = −n·t'' = T ≤ 0`, `t'` and `t''` without a tangential part, `T (n·(u' − u'') − ε) = 0`, each to 1e-9 of the
//! largest displacement or stress seen there. These are (3.9)–(3.12) on a common line, where `ε = 0`, and
//! (3.9')–(3.12') across a gap, where `n = −e_ξ`. On a bilateral part (Remark 3.3) `n·(u' − u'') = ε` and `T` may have either
//! sign. Beside it: the derivatives that the solution reports against
//! differences of its own values. A value that is not finite is refused wherever it is met.

pub use super::condition::{Condition, VerifyError, Zone};

use super::condition::demand;
use super::derived::{jump_at, stress, traction};
use super::differences::{self, Scales};
use super::{Exact, Jet2};
use signorini_contact::geometry::{LinePoint, Piece, tangent_of};
use signorini_contact::{Body, ContactLine, Material, Point};

/// Points per piece of the contact zone.
const POINTS: usize = 257;
/// Relative tolerance of the contact conditions.
const TOLERANCE: f64 = 1e-9;
/// Points nearer than this to a singular point are left out.
const AVOIDED: f64 = 1e-6;

/// How well the conditions hold: largest residuals, relative to the largest stress and displacement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Verification {
    /// Points of the contact zone that were checked.
    pub points: usize,
    /// Largest `|u|` at them.
    pub displacement: f64,
    /// Largest stress component at them.
    pub stress: f64,
    /// Largest `n·(u' − u'') − ε` over the largest displacement; 0 if never positive.
    pub penetration: f64,
    /// Largest `|n·(u' − u'') − ε|` on bilateral parts over the largest displacement.
    pub opening: f64,
    /// Largest `T` over the largest stress; 0 if never positive outside bilateral parts.
    pub tension: f64,
    /// Largest `|T' − T''|` over the largest stress.
    pub reaction: f64,
    /// Largest tangential force over the largest stress.
    pub tangential: f64,
    /// Largest `|T (n·(u' − u'') − ε)|` over the product of both.
    pub complementarity: f64,
}

/// Checks `exact` with the materials of both bodies on a contact zone without a bilateral part.
///
/// # Errors
/// The first condition that fails, in the order of [`Condition`] and then along the zone.
pub fn verify(
    exact: &dyn Exact,
    materials: &[Material; 2],
    contact: &ContactLine,
) -> Result<Verification, VerifyError> {
    verify_tied(exact, materials, contact, &[])
}

/// The same where the bodies may not part on some pieces of the zone, whose numbers are given.
///
/// # Errors
/// As [`verify`].
pub fn verify_tied(
    exact: &dyn Exact,
    materials: &[Material; 2],
    contact: &ContactLine,
    bilateral: &[usize],
) -> Result<Verification, VerifyError> {
    let zone = if contact.direction().is_some() { Zone::Gap } else { Zone::Common };
    checked(exact, materials, contact, bilateral).map_err(|e| VerifyError { zone, ..e })
}

fn checked(
    exact: &dyn Exact,
    materials: &[Material; 2],
    contact: &ContactLine,
    bilateral: &[usize],
) -> Result<Verification, VerifyError> {
    let samples = sampled(exact, materials, contact, bilateral)?;
    let result = measured(&samples);
    let checks: [Check; 6] = [
        (Condition::NoPenetration, result.displacement, |s| (None, s.jump)),
        (Condition::NoOpening, result.displacement, |s| (None, s.opening())),
        (Condition::Reaction, result.stress, |s| (None, (s.normal[0] - s.normal[1]).abs())),
        (Condition::NoTension, result.stress, Sample::tension),
        (Condition::NoFriction, result.stress, Sample::friction),
        (Condition::Complementarity, result.stress * result.displacement, |s| (None, s.work())),
    ];
    for (condition, scale, residual) in checks {
        let bound = TOLERANCE * scale;
        for s in &samples {
            let (body, value) = residual(s);
            let at = s.at[body.map_or(0, Body::index)];
            demand(value <= bound, condition, body, at, value, bound)?;
        }
    }
    let pieces = contact.pieces();
    let lengths: Vec<f64> = pieces.iter().map(|[first, _]| first.length()).collect();
    let scales = Scales::of(samples.iter().flat_map(|s| &s.jets), lengths.iter().sum());
    for (piece, length) in pieces.iter().zip(lengths) {
        differences::check(exact, |t| place(piece, contact, t), length, &scales)?;
    }
    Ok(result)
}

/// A value and the body that it belongs to.
type Residual = (Option<Body>, f64);

/// A condition, the scale of its tolerance and the residual that must not exceed it.
type Check = (Condition, f64, fn(&Sample) -> Residual);

/// Everything at one point of the contact zone.
struct Sample {
    /// On the boundary of `Ω'` and of `Ω''`.
    at: [Point; 2],
    jets: [Jet2; 2],
    /// Whether the bodies may not part here.
    bilateral: bool,
    /// Largest `|u|`, largest stress component.
    size: [f64; 2],
    /// `n·(u' − u'') − ε`.
    jump: f64,
    /// `T', T''`: `n·t'` and `−n·t''`.
    normal: [f64; 2],
    /// The tangential parts of `t'` and `t''`.
    tangential: [f64; 2],
}

impl Sample {
    fn new(exact: &dyn Exact, materials: &[Material; 2], point: &LinePoint, bilateral: bool) -> Self {
        let (at, n) = (point.at, point.normal);
        let tau = Body::BOTH.map(|b| stress(exact, &materials[b.index()], b, at[b.index()]));
        let [first, second] =
            Body::BOTH.map(|b| traction(exact, &materials[b.index()], b, at[b.index()], point.conormals[b.index()]));
        let u = Body::BOTH.map(|b| exact.value(b, at[b.index()]).norm());
        Self {
            at,
            jets: Body::BOTH.map(|b| exact.jet2(b, at[b.index()])),
            bilateral,
            size: [u[0].max(u[1]), tau.iter().flatten().fold(0.0, |m: f64, t| m.max(t.abs()))],
            jump: jump_at(exact, point) - point.gap,
            normal: [n.dot(&first), -n.dot(&second)],
            tangential: [first, second].map(|t| tangent_of(n).dot(&t)),
        }
    }

    /// `T`, where it may not be positive.
    fn tension(&self) -> Residual {
        larger(if self.bilateral { [0.0; 2] } else { self.normal })
    }

    /// `|n·(u' − u'') − ε|`, where it has to vanish.
    fn opening(&self) -> f64 {
        if self.bilateral { self.jump.abs() } else { 0.0 }
    }

    fn friction(&self) -> Residual {
        larger(self.tangential.map(f64::abs))
    }

    fn work(&self) -> f64 {
        (self.normal[0] * self.jump).abs()
    }
}

fn larger(values: [f64; 2]) -> Residual {
    let body = Body::BOTH[usize::from(values[1] > values[0])];
    (Some(body), values[body.index()])
}

/// The samples of every piece; all of them finite.
fn sampled(
    exact: &dyn Exact,
    materials: &[Material; 2],
    contact: &ContactLine,
    bilateral: &[usize],
) -> Result<Vec<Sample>, VerifyError> {
    let singular = exact.singular_points();
    let near = |at: &Point| singular.iter().any(|s| (s - at).norm() < AVOIDED);
    let mut all = Vec::new();
    for (number, piece) in contact.pieces().iter().enumerate() {
        for point in midpoints().map(|t| place(piece, contact, t)) {
            if point.at.iter().any(near) {
                continue;
            }
            let sample = Sample::new(exact, materials, &point, bilateral.contains(&number));
            for body in Body::BOTH {
                let bad = not_finite(&sample.jets[body.index()]);
                let (at, value) = (point.at[body.index()], bad.unwrap_or(0.0));
                demand(bad.is_none(), Condition::Finite, Some(body), at, value, f64::MAX)?;
            }
            all.push(sample);
        }
    }
    Ok(all)
}

fn place([first, second]: &[Piece; 2], contact: &ContactLine, t: f64) -> LinePoint {
    LinePoint::new([first, second], contact.direction(), t)
}

/// Parameters in the middle of equal parts: never an end of the piece.
fn midpoints() -> impl Iterator<Item = f64> {
    (0..POINTS).map(|i| (i as f64 + 0.5) / POINTS as f64)
}

/// The first entry of a jet that is no finite number.
pub(super) fn not_finite(jet: &Jet2) -> Option<f64> {
    let second = jet.hessian.iter().flatten().flatten();
    jet.value.iter().chain(jet.gradient.iter().flatten()).chain(second).copied().find(|v| !v.is_finite())
}

fn measured(samples: &[Sample]) -> Verification {
    let largest = |f: &dyn Fn(&Sample) -> f64| samples.iter().map(f).fold(0.0, f64::max);
    let displacement = largest(&|s| s.size[0]);
    let stress = largest(&|s| s.size[1]);
    let relative = |value: f64, scale: f64| if value == 0.0 { 0.0 } else { value / scale };
    Verification {
        points: samples.len(),
        displacement,
        stress,
        penetration: relative(largest(&|s| s.jump), displacement),
        opening: relative(largest(&Sample::opening), displacement),
        tension: relative(largest(&|s| s.tension().1), stress),
        reaction: relative(largest(&|s| (s.normal[0] - s.normal[1]).abs()), stress),
        tangential: relative(largest(&|s| s.friction().1), stress),
        complementarity: relative(largest(&Sample::work), stress * displacement),
    }
}
