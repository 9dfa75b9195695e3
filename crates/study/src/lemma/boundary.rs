//! Lemma 3.2: interpolation on the boundary, `‖u − u_I‖_{0,∂Ω} ≤ c h^{3/2} ‖u‖_2`.
//!
//! `u_I` is linear in the physical coordinates on every triangle, the curved ones included: on an arc it is the linear
//! function through the three nodes of its triangle, continued to the arc. It is *not* the interpolant of the trace along
//! the arc, which would not even reproduce a linear function.
//!
//! The function may depend on `r`, the distance from one point of the boundary: `r^α` is in `H^{1+α−δ}` and has the trace
//! `|s|^α`, so its error is expected to fall like `h^{min(2, α+1/2)}`. The point sits at one third of the first coarse arc.
//! Arcs are halved by length, so the point is at one or two thirds of its arc on every level and the constant does not
//! depend on the level.

use super::domain::Domain;
use super::mesh::{BoundarySide, DomainMesh};
use crate::error::RunError;
use crate::expr::Expression;
use signorini_contact::Point;
use signorini_contact::element::hats;
use signorini_contact::quadrature::Cubature;

/// A function to interpolate.
#[derive(Clone, Debug)]
pub struct BoundaryFunction {
    /// In the variables `x, y, r`.
    pub expression: Expression,
    /// The angle of the point from which `r` is measured.
    pub angle: f64,
    /// That point.
    pub origin: Point,
}

impl BoundaryFunction {
    /// The variables of the expression.
    pub const VARIABLES: [&'static str; 3] = ["x", "y", "r"];

    /// With `r` measured from one third of the domain's first coarse arc.
    pub fn new(expression: Expression, domain: &Domain) -> Self {
        let angle = domain.ellipse.divide(domain.first_arc(), 1.0 / 3.0);
        Self { expression, angle, origin: domain.ellipse.at(angle) }
    }

    /// `u(x)`.
    pub fn value(&self, x: Point) -> f64 {
        self.expression.eval(&[x.x, x.y, (x - self.origin).norm()])
    }
}

/// `‖u − u_I‖_{0,∂Ω}`, and how much a quadrature one refinement coarser would change it.
pub fn error(mesh: &DomainMesh, u: &BoundaryFunction) -> Result<[f64; 2], RunError> {
    let nodes: Vec<f64> = mesh.points.iter().map(|x| u.value(*x)).collect();
    if let Some(i) = nodes.iter().position(|v| !v.is_finite()) {
        let (x, text) = (mesh.points[i], u.expression.text());
        return Err(RunError::Study(format!(
            "the function `{text}` is {} at ({}, {}); choose one that is finite on the whole domain",
            nodes[i], x.x, x.y
        )));
    }
    let interpolant = |side: &BoundarySide, _: f64, x: Point| {
        let values = mesh.triangles[side.triangle as usize].map(|i| nodes[i as usize]);
        let hats = hats(mesh.corners(side.triangle), x);
        (0..3).map(|k| values[k] * hats[k]).sum()
    };
    let [coarse, fine] = [0, 1].map(|depth| distance(mesh, u, interpolant, depth));
    Ok([fine, (fine - coarse).abs()])
}

/// `‖u − w‖_{0,∂Ω}` for a function `w(side, angle, point)`; quadrature is graded towards the singular point.
pub(super) fn distance(
    mesh: &DomainMesh,
    u: &BoundaryFunction,
    w: impl Fn(&BoundarySide, f64, Point) -> f64,
    depth: u32,
) -> f64 {
    // Angles are put on a line, where the rule for sides knows how to grade.
    let on_line = |t: f64| Point::new(t, 0.0);
    let cubature = Cubature { singular: vec![on_line(u.angle)], depth, ..Cubature::default() };
    let mut square = 0.0;
    for side in &mesh.boundary {
        let [from, to] = side.angles.map(on_line);
        cubature.side(from, to, &mut |t, weight| {
            let x = mesh.ellipse.at(t.x);
            // ds = |γ'(t)| dt
            square += weight * mesh.ellipse.velocity(t.x).norm() * (u.value(x) - w(side, t.x, x)).powi(2);
        });
    }
    square.sqrt()
}
