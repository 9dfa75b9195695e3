//! The rigid motions that the supports leave free, and whether the load can be borne.
//!
//! A rigid motion `y` is *allowed* if it respects `Γ_u`, `Γ_0` and opens or slides the contact zone,
//! `n·(y' − y'') ≤ 0`. The problem has a solution when `f(y) < 0` for every allowed one-sided `y` (the load presses the
//! bodies together) and `f(y) = 0` where `−y` is allowed as well. On a bilateral part `n·(y' − y'') = 0`, as at a support. The allowed motions form a polyhedral cone in at most
//! six dimensions, so its two-sided part is a null space and the rest is decided on its extreme rays.

mod cone;
#[cfg(test)]
mod tests;

use crate::Error;
use crate::basis::NodeSupports;
use crate::geometry::{Point, Vec2, tangent_of};
use crate::mesh::{Body, Mesh};
use crate::zone::{ConstraintKind, Zone};
use nalgebra::{DMatrix, DVector, Matrix6, SymmetricEigen, Vector6};
use rayon::prelude::*;

/// `|f(y)|` below this times `Σ |f_i| |y_i|` counts as zero: the loads that the motion meets, each with its arm. Loads on a body
/// that does not move do not blur the balance of one that does.
const BALANCED: f64 = 1e-10;

/// Eigenvalues below this share of the largest belong to the null space.
const NULL: f64 = 1e-12;

/// What the program says where it fixes a two-sided motion by itself.
pub(crate) const MEAN_IS_ZERO: &str = "its mean is set to zero";
/// Steps of a singular value decomposition, at most: without a limit it may go on for ever.
const SVD_STEPS: usize = 1000;

/// Motions of length 1 that open the zone by less than this leave it closed.
const CLOSED: f64 = 1e-12;

/// Motions that open the zone by less than this, but do open it, meet a resistance of the order of its square: too little to be
/// seen beside the stiffness in double precision.
const HELD: f64 = 1e-7;

/// What the supports and the contact leave free.
#[derive(Clone, Debug, Default)]
pub struct Balance {
    /// The two-sided rigid motions, as nodal fields with `max |y| = 1`.
    pub kernel: Vec<Vec<Vec2>>,
    /// What the program had to fix by itself.
    pub remarks: Vec<String>,
}

/// Coordinates of rigid motions, `(a_1, a_2, θ)` for each body: `y(x) = a + θ J(x − c)/R`, with `J` a right angle.
struct Frame {
    centre: Point,
    radius: f64,
}

impl Frame {
    fn new(mesh: &Mesh) -> Self {
        let low = mesh.points.iter().fold(mesh.points[0], |l, p| l.inf(p));
        let high = mesh.points.iter().fold(mesh.points[0], |h, p| h.sup(p));
        Self { centre: 0.5 * (low + high), radius: 0.5 * (high - low).norm() }
    }

    /// The row of `q ↦ m·y(x)` for a node of `body`.
    fn row(&self, body: Body, x: Point, m: Vec2) -> Vector6<f64> {
        let arm = tangent_of((x - self.centre) / self.radius);
        let mut row = Vector6::zeros();
        let first = 3 * body.index();
        (row[first], row[first + 1], row[first + 2]) = (m.x, m.y, m.dot(&arm));
        row
    }

    fn at(&self, q: &Vector6<f64>, body: Body, x: Point) -> Vec2 {
        Vec2::new(self.row(body, x, Vec2::x()).dot(q), self.row(body, x, Vec2::y()).dot(q))
    }

    /// The motion in words, e.g. `translation of Ω' along (0, 1)`.
    fn describe(&self, q: &Vector6<f64>) -> String {
        let words = |body: Body| -> Option<String> {
            let [a1, a2, theta] = [0, 1, 2].map(|k| q[3 * body.index() + k]);
            let name = ["Ω'", "Ω''"][body.index()];
            if Vec2::new(a1, a2).norm().max(theta.abs()) < 1e-9 * q.norm() {
                None
            } else if theta.abs() < 1e-9 * q.norm() {
                let a = Vec2::new(a1, a2).normalize();
                Some(format!("translation of {name} along ({}, {})", round(a.x), round(a.y)))
            } else {
                let fixed = self.centre + self.radius / theta * Vec2::new(-a2, a1);
                let sense = if theta > 0.0 { "counterclockwise" } else { "clockwise" };
                Some(format!("{sense} rotation of {name} about ({}, {})", round(fixed.x), round(fixed.y)))
            }
        };
        Body::BOTH.into_iter().filter_map(words).collect::<Vec<_>>().join(" with ")
    }
}

/// Rounds for display, without a negative zero.
fn round(x: f64) -> f64 {
    (x * 1e6).round() / 1e6 + 0.0
}

/// Tests the load against the cone of allowed rigid motions.
pub fn balance(mesh: &Mesh, supports: &NodeSupports, zone: &Zone, load: &[Vec2]) -> Result<Balance, Error> {
    let frame = Frame::new(mesh);
    let free = null_space(&(support_gram(mesh, supports, &frame) + bilateral_gram(mesh, zone, &frame)));
    if free.is_empty() {
        return Ok(Balance::default());
    }
    let contact = contact_rows(mesh, zone, &frame);
    let (kernel, one_sided) = split(&free, &contact);
    refuse_nearly_free(&frame, &one_sided, &contact)?;
    let judge = Judge { mesh, frame: &frame, load };
    for y in &kernel {
        judge.demand_equilibrium(y)?;
    }
    for ray in extreme_rays(&one_sided, &contact) {
        judge.demand_pressing(&ray)?;
    }
    let remark = |y: &Vector6<f64>| format!("{} is free in both directions; {MEAN_IS_ZERO}", frame.describe(y));
    Ok(Balance {
        remarks: kernel.iter().map(remark).collect(),
        kernel: kernel.iter().map(|y| judge.field(y)).collect(),
    })
}

/// A motion that is neither free nor held.
fn refuse_nearly_free(frame: &Frame, one_sided: &[Vector6<f64>], contact: &[Vector6<f64>]) -> Result<(), Error> {
    let opening = |y: &Vector6<f64>| contact.iter().map(|r| r.dot(y).powi(2)).sum::<f64>().sqrt();
    match one_sided.iter().map(|y| (y, opening(y))).find(|(_, o)| *o < HELD) {
        None => Ok(()),
        Some((y, opening)) => Err(Error::Solvability(format!(
            "nearly free: the {} opens the contact zone by {opening:.1e} of itself only, too little to hold the body in double \
             precision (below {HELD:.0e}) and too much to count as a free slide (above {CLOSED:.0e}); make the zone flat or \
             steeper, or support the body",
            frame.describe(y)
        ))),
    }
}

struct Judge<'a> {
    mesh: &'a Mesh,
    frame: &'a Frame,
    load: &'a [Vec2],
}

impl Judge<'_> {
    /// The nodal field of a motion, scaled to `max |y| = 1`.
    fn field(&self, q: &Vector6<f64>) -> Vec<Vec2> {
        let largest = self.largest(q);
        (0..self.mesh.points.len()).into_par_iter().map(|i| self.at(q, i) / largest).collect()
    }

    /// The motion of node `i`.
    fn at(&self, q: &Vector6<f64>, i: usize) -> Vec2 {
        self.frame.at(q, self.mesh.node_bodies[i], self.mesh.points[i])
    }

    /// `max |y|` over all nodes.
    fn largest(&self, q: &Vector6<f64>) -> f64 {
        let nodes = (0..self.mesh.points.len()).into_par_iter().with_min_len(1024);
        nodes.map(|i| self.at(q, i).norm()).reduce(|| 0.0, f64::max)
    }

    /// `f(y)` for the motion scaled to `max |y| = 1`, and what counts as zero for it.
    fn work(&self, q: &Vector6<f64>) -> (f64, f64) {
        let largest = self.largest(q);
        let loaded = self.load.iter().enumerate().filter(|(_, f)| **f != Vec2::zeros());
        let (work, size) = loaded.fold((0.0, 0.0), |(work, size), (i, f)| {
            let y = self.at(q, i) / largest;
            (work + f.dot(&y), size + f.norm() * y.norm())
        });
        (work, BALANCED * size)
    }

    fn demand_equilibrium(&self, y: &Vector6<f64>) -> Result<(), Error> {
        let (work, tolerance) = self.work(y);
        if work.abs() <= tolerance {
            return Ok(());
        }
        Err(Error::Solvability(format!(
            "no equilibrium: the {} meets no resistance in either direction, but the load works on it with resultant {work:.6e} \
             (must vanish within {tolerance:.1e}); balance the load or support the body",
            self.frame.describe(y)
        )))
    }

    fn demand_pressing(&self, ray: &Vector6<f64>) -> Result<(), Error> {
        let (work, tolerance) = self.work(ray);
        if work < -tolerance {
            return Ok(());
        }
        let motion = self.frame.describe(ray);
        Err(Error::Solvability(if work > tolerance {
            format!(
                "no solution: the load pushes a body away by the {motion}, with resultant {work:.6e} > 0; \
                 press the bodies together or support the body"
            )
        } else {
            format!(
                "limit load: the {motion} opens the contact and the load does no work on it (resultant {work:.1e}, zero within \
                 {tolerance:.1e}), so contact holds the body only just; press the bodies together or support the body"
            )
        }))
    }
}

/// `Σ r rᵀ` over the rows of the held directions of all nodes.
fn support_gram(mesh: &Mesh, supports: &NodeSupports, frame: &Frame) -> Matrix6<f64> {
    let mut gram = Matrix6::zeros();
    for (node, support) in supports.held() {
        let i = node as usize;
        let held: &[Vec2] = match support.free.as_slice() {
            [_, _] => &[],
            [t] => &[tangent_of(*t)],
            _ => &[Vec2::x(), Vec2::y()],
        };
        for m in held {
            let row = frame.row(mesh.node_bodies[i], mesh.points[i], *m);
            gram += row * row.transpose();
        }
    }
    gram
}

/// `Σ r rᵀ` over the rows of the bilateral constraints.
fn bilateral_gram(mesh: &Mesh, zone: &Zone, frame: &Frame) -> Matrix6<f64> {
    let mut gram = Matrix6::zeros();
    for pair in &zone.pairs {
        let [x, y] = [pair.first, pair.second].map(|i| mesh.points[i as usize]);
        for c in pair.constraints.iter().filter(|c| c.kind == ConstraintKind::Bilateral) {
            let row = frame.row(Body::First, x, c.normal) - frame.row(Body::Second, y, c.normal);
            gram += row * row.transpose();
        }
    }
    gram
}

fn null_space(gram: &Matrix6<f64>) -> Vec<Vector6<f64>> {
    let eigen = SymmetricEigen::new(*gram);
    let largest = eigen.eigenvalues.max().max(f64::MIN_POSITIVE);
    let null = |i: &usize| eigen.eigenvalues[*i] < NULL * largest || eigen.eigenvalues.max() == 0.0;
    (0..6).filter(null).map(|i| eigen.eigenvectors.column(i).into_owned()).collect()
}

/// The rows of `q ↦ n·(y' − y'')` at the contact nodes; of a straight piece of the zone only at its two ends, since it is
/// linear between them.
fn contact_rows(mesh: &Mesh, zone: &Zone, frame: &Frame) -> Vec<Vector6<f64>> {
    let mut rows = Vec::new();
    let mut add = |side: usize, end: usize| {
        let n = zone.side_normals[side][end];
        let [x, y] = [mesh.contact[side].first, mesh.contact[side].second].map(|s| mesh.points[s[end] as usize]);
        rows.push(frame.row(Body::First, x, n) - frame.row(Body::Second, y, n));
    };
    let is_curved = |side: usize| mesh.contact[side].triangles.iter().any(|&t| mesh.curved.of(t as usize).is_some());
    for side in 0..mesh.contact.len() {
        let segment = mesh.contact[side].segment;
        if side == 0 || mesh.contact[side - 1].segment != segment {
            add(side, 0);
        }
        if is_curved(side) || side + 1 == mesh.contact.len() || mesh.contact[side + 1].segment != segment {
            add(side, 1);
        }
    }
    rows
}

/// Splits the span of `free` into the motions that leave the zone closed and an orthonormal complement.
fn split(free: &[Vector6<f64>], contact: &[Vector6<f64>]) -> (Vec<Vector6<f64>>, Vec<Vector6<f64>>) {
    // Square at least, so that the decomposition spans the whole of `free`. Squared, a wedge of 1e-6 would be lost in rounding.
    let height = contact.len().max(free.len());
    let row = |i: usize, j: usize| contact.get(i).map_or(0.0, |r| r.dot(&free[j]));
    let svd = DMatrix::from_fn(height, free.len(), row).try_svd(false, true, f64::EPSILON, SVD_STEPS);
    let Some((values, directions)) = svd.and_then(|svd| Some((svd.singular_values, svd.v_t?.transpose()))) else {
        return (Vec::new(), free.to_vec());
    };
    let combine = |c: DVector<f64>| (0..free.len()).fold(Vector6::zeros(), |q, j| q + c[j] * free[j]);
    let mut parts = (Vec::new(), Vec::new());
    for (i, &value) in values.iter().enumerate() {
        let motion = combine(directions.column(i).into_owned());
        if value <= CLOSED { parts.0.push(directed(motion)) } else { parts.1.push(motion) }
    }
    parts
}

/// One of `±q`: the one whose first coordinate of more than half the largest size is positive, so that a motion has one name
/// on every mesh.
fn directed(q: Vector6<f64>) -> Vector6<f64> {
    let largest = q.amax();
    let first = q.iter().find(|x| x.abs() > 0.5 * largest).copied().unwrap_or(0.0);
    if first < 0.0 { -q } else { q }
}

/// The extreme rays of `{ q ∈ span(directions) : r·q ≤ 0 for every row r }`, a pointed cone.
fn extreme_rays(directions: &[Vector6<f64>], rows: &[Vector6<f64>]) -> Vec<Vector6<f64>> {
    let d = directions.len();
    if d == 0 {
        return Vec::new();
    }
    let reduced: Vec<DVector<f64>> = rows.iter().map(|r| DVector::from_fn(d, |j, _| r.dot(&directions[j]))).collect();
    let combine = |ray: DVector<f64>| (0..d).fold(Vector6::zeros(), |q, j| q + ray[j] * directions[j]);
    cone::extreme_rays(d, &reduced).into_iter().map(combine).collect()
}
