//! Interpolation on the boundary: what it reproduces, and the error against another quadrature.

use super::*;
use crate::expr::Expression;
use crate::lemma::boundary::{BoundaryFunction, distance, error};
use crate::lemma::mesh::{BoundarySide, DomainMesh};
use signorini_contact::Point;
use signorini_contact::geometry::twice_area;
use std::collections::BTreeMap;

pub fn function(text: &str, domain: &Domain) -> BoundaryFunction {
    let expression = Expression::parse(text, &BoundaryFunction::VARIABLES, &BTreeMap::new()).unwrap();
    BoundaryFunction::new(expression, domain)
}

/// The interpolant of the trace along the arc, linear in the angle: what a curved element does not do.
fn along_the_arc(mesh: &DomainMesh, u: &BoundaryFunction) -> f64 {
    let interpolant = |side: &BoundarySide, t: f64, _: Point| {
        let [a, b] = side.nodes.map(|i| u.value(mesh.points[i as usize]));
        let share = (t - side.angles[0]) / (side.angles[1] - side.angles[0]);
        (1.0 - share) * a + share * b
    };
    distance(mesh, u, interpolant, 1)
}

#[test]
fn linear_functions_are_reproduced_on_the_arcs_and_not_by_interpolation_along_them() {
    for domain in domains().into_iter().filter(|d| d.side == Side::Inside) {
        let u = function("1 - 2*x + 3*y", &domain);
        let meshes = [2, 3, 4].map(|k| domain.mesh(k));
        assert!(meshes.iter().all(|m| error(m, &u).unwrap()[0] < 1e-13), "{domain:?}");
        let wrong = meshes.each_ref().map(|m| along_the_arc(m, &u));
        // κ s²/8 times the normal derivative: falls like h², so no rate of 3/2 would tell
        assert!(wrong[2] > 1e-3 && wrong.windows(2).all(|e| (3.9..4.1).contains(&(e[0] / e[1]))), "{wrong:?}");
    }
}

/// The same norm by the midpoint rule in many points, with the linear function from areas of triangles.
fn by_midpoints(mesh: &DomainMesh, u: &BoundaryFunction) -> f64 {
    const POINTS: u32 = 20_000;
    let of_side = |side: &BoundarySide| -> f64 {
        let c = mesh.corners(side.triangle);
        let whole = twice_area(c[0], c[1], c[2]);
        let step = (side.angles[1] - side.angles[0]) / f64::from(POINTS);
        let at = |k: u32| {
            let t = side.angles[0] + (f64::from(k) + 0.5) * step;
            let x = mesh.ellipse.at(t);
            let part = |k: usize| twice_area(x, c[(k + 1) % 3], c[(k + 2) % 3]) / whole;
            let w: f64 = (0..3).map(|k| u.value(c[k]) * part(k)).sum();
            step * mesh.ellipse.velocity(t).norm() * (u.value(x) - w).powi(2)
        };
        (0..POINTS).map(at).sum()
    };
    mesh.boundary.iter().map(of_side).sum::<f64>().sqrt()
}

#[test]
fn errors_are_those_of_another_quadrature() {
    for (text, domain) in [("r + 0.2*sin(2*x + y)", domains()[0]), ("r^1.05", domains()[2]), ("r^0.75", disc())] {
        let (u, mesh) = (function(text, &domain), domain.mesh(2));
        let ([found, change], other) = (error(&mesh, &u).unwrap(), by_midpoints(&mesh, &u));
        assert!((found / other - 1.0).abs() < 1e-5 && change < 1e-8 * found, "{text}: {found} {other} {change:e}");
    }
}

/// One or two thirds of its arc on every level: the constant does not depend on where the point happens to lie.
#[test]
fn the_singular_point_keeps_its_place_in_its_arc() {
    for domain in [domains()[0], domains()[2]] {
        let u = function("r", &domain);
        for k in 0..6 {
            let mesh = domain.mesh(k);
            let holds = |s: &&BoundarySide| s.angles[0] < u.angle && u.angle < s.angles[1];
            let side = mesh.boundary.iter().find(holds).unwrap();
            let share = domain.ellipse.length([side.angles[0], u.angle]) / domain.ellipse.length(side.angles);
            let third = share.min(1.0 - share);
            assert!((third - 1.0 / 3.0).abs() < 1e-10, "level {k}: {share}");
        }
    }
}

#[test]
fn a_function_that_is_not_finite_is_refused_with_its_place() {
    let u = function("1/(x - 0.5)", &disc());
    let message = error(&disc().mesh(1), &u).unwrap_err().to_string();
    assert!(message.contains("1/(x - 0.5)") && message.contains("(0.5, 0)"), "{message}");
}
