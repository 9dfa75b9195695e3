//! The quantities of an exact solution that the constants of the theorems are divided by.
//!
//! Stress is measured in units of the smaller shear modulus, so that a change of its unit changes no constant.

use crate::error::RunError;
use crate::family;
use crate::study::{Case, ExactScene, Scene};
use signorini_contact::geometry::{LinePoint, Piece, Vec2, tangent_of};
use signorini_contact::quadrature::Cubature;
use signorini_contact::{Body, Point};

/// Norms of an exact solution. Across a gap `T_n` is `T_ξ`, `u_n` is `u_ξ`, and derivatives are by `η`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Size {
    /// `‖u‖²_2` over both bodies.
    pub h2_squared: f64,
    /// `‖T_n‖_∞`.
    pub stress_max: f64,
    /// `‖T_n‖_0`.
    pub stress_l2: f64,
    /// `|u'_n|_{1,∞} + |u''_n|_{1,∞}`.
    pub slopes: f64,
    /// `|[u]_n|_{1,∞}`, of the gap that remains.
    pub jump_slope: f64,
    /// `|u'_n|_{2,Γ} + |u''_n|_{2,Γ}`; straight zones only.
    pub curvatures: f64,
    /// `|ε|_{1,∞} + |ε|_{2,∞}` of the initial gap.
    pub initial_gap: f64,
    /// Number of switch points.
    pub switches: usize,
    /// The smaller shear modulus, in the study's unit of stress.
    pub unit: f64,
}

/// Points per piece of the zone where maxima are looked for.
const POINTS: usize = 2000;

/// Measures the solution over the second level's mesh and along the zone.
///
/// # Errors
/// If the mesh cannot be made.
pub fn size(scene: &Scene, exact: &ExactScene, case: &Case) -> Result<Size, RunError> {
    let cubature = scene.cubature(1, false);
    let unit = exact.materials.iter().filter_map(|m| Some(m.lame_constants()?.mu)).fold(f64::INFINITY, f64::min);
    let mut size = Size { h2_squared: h2_squared(scene, exact, case, &cubature)?, ..Size::default() };
    size.unit = unit;
    size.switches = exact.solution.switch_points().len();
    let mut squares = [0.0; 3];
    let mut slopes = [0.0_f64; 2];
    for pieces in &scene.contact.pieces() {
        let zone = Along { exact, pieces, direction: scene.contact.direction() };
        (0..POINTS).map(|k| (k as f64 + 0.5) / POINTS as f64).for_each(|t| zone.maxima(t, &mut size, &mut slopes));
        cubature.along(&pieces[0], &mut |t, w| zone.add_squares(t, w, &mut squares));
    }
    size.stress_max /= unit;
    size.stress_l2 = squares[0].sqrt() / unit;
    size.slopes = slopes[0] + slopes[1];
    size.curvatures = squares[1].sqrt() + squares[2].sqrt();
    Ok(size)
}

/// `Σ_M ∫ |u|² + |∇u|² + |∇∇u|²`.
fn h2_squared(scene: &Scene, exact: &ExactScene, case: &Case, cubature: &Cubature) -> Result<f64, RunError> {
    let level = family::build_level(&case.family, &scene.domain(), &case.quick, 1.min(case.quick.len() - 1))?;
    let mesh = level.hierarchy.finest();
    let mut sum = 0.0;
    for t in 0..mesh.triangles.len() {
        let body = mesh.body(t);
        match mesh.curved_triangle(t) {
            Some(triangle) => cubature.curved(&triangle, &mut |p, w| sum += w * density(exact, body, p.x)),
            None => cubature.triangle(mesh.corners(t), &mut |x, w| sum += w * density(exact, body, x)),
        }
    }
    Ok(sum)
}

fn density(exact: &ExactScene, body: Body, x: Point) -> f64 {
    let jet = exact.solution.jet2(body, x);
    let first = jet.gradient.iter().flatten().map(|d| d * d).sum::<f64>();
    let second = jet.hessian.iter().flatten().flatten().map(|d| d * d).sum::<f64>();
    jet.value.norm_squared() + first + second
}

/// A piece of the zone.
struct Along<'a> {
    exact: &'a ExactScene,
    pieces: &'a [Piece; 2],
    direction: Option<Vec2>,
}

impl Along<'_> {
    fn at(&self, t: f64) -> LinePoint {
        LinePoint::new([&self.pieces[0], &self.pieces[1]], self.direction, t)
    }

    /// `n·u` of both bodies, and the initial gap.
    fn normal(&self, t: f64) -> [f64; 3] {
        let point = self.at(t);
        let [first, second] = Body::BOTH.map(|b| point.normal.dot(&self.exact.solution.value(b, point.at[b.index()])));
        [first, second, point.gap]
    }

    fn maxima(&self, t: f64, size: &mut Size, slopes: &mut [f64; 2]) {
        // central differences by the parameter
        const STEP: f64 = 1e-6;
        let (point, before, here, after) = (self.at(t), self.normal(t - STEP), self.normal(t), self.normal(t + STEP));
        let slope = |k: usize| (after[k] - before[k]) / (2.0 * STEP * point.measure);
        size.stress_max = size.stress_max.max(self.exact.contact_stress(&point).abs());
        (0..2).for_each(|k| slopes[k] = slopes[k].max(slope(k).abs()));
        size.jump_slope = size.jump_slope.max((slope(2) - slope(0) + slope(1)).abs());
        // a wider step for the second derivative of the gap, a smooth function
        const WIDE: f64 = 1e-3;
        if self.direction.is_some() && (WIDE..1.0 - WIDE).contains(&t) {
            let (left, right) = (self.at(t - WIDE).gap, self.at(t + WIDE).gap);
            let second = (left - 2.0 * here[2] + right) / (WIDE * point.measure).powi(2);
            size.initial_gap = size.initial_gap.max(slope(2).abs() + second.abs());
        }
    }

    /// Adds `∫T_n²`, and of both bodies `∫ (∂²_s u_n)²`.
    fn add_squares(&self, t: f64, weight: f64, squares: &mut [f64; 3]) {
        let point = self.at(t);
        let w = weight * point.measure;
        squares[0] += w * self.exact.contact_stress(&point).powi(2);
        let (n, s) = (point.normal, tangent_of(point.normal));
        for body in Body::BOTH {
            let h = self.exact.solution.jet2(body, point.at[body.index()]).hessian;
            // n_i s_j s_k ∂_j ∂_k u_i
            let second: f64 =
                (0..8).map(|m| (m / 4, m / 2 % 2, m % 2)).map(|(i, j, k)| n[i] * s[j] * s[k] * h[i][j][k]).sum();
            squares[1 + body.index()] += w * second * second;
        }
    }
}
