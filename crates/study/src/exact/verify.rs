//! Pointwise verification of an exact solution, before any mesh exists.
//!
//! At points of the contact zone: `n·(u' − u'') ≤ 0`, `T'_n = T''_n ≤ 0`, `T'_t = T''_t = 0`, `T_n n·(u' − u'') = 0`, each to
//! 1e-9 of the largest displacement or stress seen there. Beside it: the derivatives that the solution reports against
//! differences of its own values. A value that is not finite is refused wherever it is met.

pub use super::condition::{Condition, VerifyError};

use super::condition::demand;
use super::derived::{apply, stress};
use super::differences::{self, Scales};
use super::{Exact, Jet2};
use signorini_contact::geometry::{Segment, right_normal, segments, tangent_of};
use signorini_contact::{Body, Material, Point, Vec2};

/// Points per contact segment.
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
    /// Largest `n·(u' − u'')` over the largest displacement; 0 if never positive.
    pub penetration: f64,
    /// Largest `T_n` over the largest stress; 0 if never positive.
    pub tension: f64,
    /// Largest `|T'_n − T''_n|` over the largest stress.
    pub reaction: f64,
    /// Largest `|T_t|` over the largest stress.
    pub tangential: f64,
    /// Largest `|T_n n·(u' − u'')|` over the product of both.
    pub complementarity: f64,
}

/// Checks `exact` with the materials of both bodies on the contact polyline, which has `Ω'` on its left.
///
/// # Errors
/// The first condition that fails, in the order of [`Condition`] and then along the polyline.
pub fn verify(exact: &dyn Exact, materials: &[Material; 2], contact: &[Point]) -> Result<Verification, VerifyError> {
    let samples = sampled(exact, materials, contact)?;
    let result = measured(&samples);
    let checks: [Check; 5] = [
        (Condition::NoPenetration, result.displacement, |s| (None, s.jump)),
        (Condition::Reaction, result.stress, |s| (None, (s.normal[0] - s.normal[1]).abs())),
        (Condition::NoTension, result.stress, Sample::tension),
        (Condition::NoFriction, result.stress, Sample::friction),
        (Condition::Complementarity, result.stress * result.displacement, |s| (None, s.work())),
    ];
    for (condition, scale, residual) in checks {
        let bound = TOLERANCE * scale;
        for s in &samples {
            let (body, value) = residual(s);
            demand(value <= bound, condition, body, s.at, value, bound)?;
        }
    }
    let scales = Scales::of(samples.iter().flat_map(|s| &s.jets), contact);
    for segment in segments(contact) {
        differences::check(exact, segment, &scales)?;
    }
    Ok(result)
}

/// A value and the body that it belongs to.
type Residual = (Option<Body>, f64);

/// A condition, the scale of its tolerance and the residual that must not exceed it.
type Check = (Condition, f64, fn(&Sample) -> Residual);

/// Everything at one point of the contact zone.
struct Sample {
    at: Point,
    jets: [Jet2; 2],
    /// Largest `|u|`, largest stress component.
    size: [f64; 2],
    /// `n·(u' − u'')`.
    jump: f64,
    /// `T'_n, T''_n`, both with `n`.
    normal: [f64; 2],
    /// `T'_t, T''_t`.
    tangential: [f64; 2],
}

impl Sample {
    fn new(exact: &dyn Exact, materials: &[Material; 2], at: Point, n: Vec2) -> Self {
        let tau = Body::BOTH.map(|b| stress(exact, &materials[b.index()], b, at));
        let jets = Body::BOTH.map(|b| exact.jet2(b, at));
        let forces = tau.map(|t| apply(t, n));
        let u = Body::BOTH.map(|b| exact.value(b, at));
        Self {
            at,
            jets,
            size: [u[0].norm().max(u[1].norm()), tau.iter().flatten().fold(0.0, |m: f64, t| m.max(t.abs()))],
            jump: n.dot(&(u[0] - u[1])),
            normal: forces.map(|t| n.dot(&t)),
            tangential: forces.map(|t| tangent_of(n).dot(&t)),
        }
    }

    fn tension(&self) -> Residual {
        larger(self.normal)
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

/// The samples of every segment; all of them finite.
fn sampled(exact: &dyn Exact, materials: &[Material; 2], contact: &[Point]) -> Result<Vec<Sample>, VerifyError> {
    let singular = exact.singular_points();
    let mut all = Vec::new();
    for segment in segments(contact) {
        let n = right_normal(segment.a, segment.b);
        for at in points(segment) {
            if singular.iter().any(|s| (s - at).norm() < AVOIDED) {
                continue;
            }
            let sample = Sample::new(exact, materials, at, n);
            for body in Body::BOTH {
                let bad = not_finite(&sample.jets[body.index()]);
                let value = bad.unwrap_or(0.0);
                demand(bad.is_none(), Condition::Finite, Some(body), at, value, f64::MAX)?;
            }
            all.push(sample);
        }
    }
    Ok(all)
}

/// Midpoints of equal pieces: never an end of the segment.
fn points(segment: Segment) -> impl Iterator<Item = Point> {
    (0..POINTS).map(move |i| {
        let t = (i as f64 + 0.5) / POINTS as f64;
        segment.a + t * (segment.b - segment.a)
    })
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
        tension: relative(largest(&|s| s.tension().1), stress),
        reaction: relative(largest(&|s| (s.normal[0] - s.normal[1]).abs()), stress),
        tangential: relative(largest(&|s| s.friction().1), stress),
        complementarity: relative(largest(&Sample::work), stress * displacement),
    }
}
