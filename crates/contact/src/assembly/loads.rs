//! Nodal loads: of forces and tractions by quadrature, of the stresses of a field exactly.

use super::scatter;
use crate::data::{Data, Support};
use crate::element::{CurvedTriangle, gradients, hats, linear_strain};
use crate::geometry::Vec2;
use crate::material::Material;
use crate::mesh::side::SideView;
use crate::mesh::{Body, Mesh};
use crate::quadrature::Cubature;
use crate::{Error, Point};
use std::convert::Infallible;

/// The nodal loads `f(φ_i)`: body forces and tractions by quadrature. A load that is not a number is refused, with its place.
pub fn loads(mesh: &Mesh, supports: &[Support], data: &dyn Data, cubature: &Cubature) -> Result<Vec<Vec2>, Error> {
    let mut nodal = vec![Vec2::zeros(); mesh.points.len()];
    for body in Body::BOTH.into_iter().filter(|body| data.has_body_force(*body)) {
        scatter(mesh, mesh.triangles_of(body), &mut nodal, |t| {
            let load = element_load(mesh, data, cubature, t);
            check_load(&load, || format!("body force in triangle {t} around {}", place(&mesh.corners(t))))?;
            Ok(Some(load))
        })?;
    }
    for side in mesh.sides.iter().filter(|s| supports[s.part as usize] == Support::Traction) {
        let view = mesh.boundary_view(side);
        let load = side_load(&view, data, side.part as usize, cubature);
        let name = &mesh.parts[side.part as usize].name;
        let corners = side.nodes.map(|i| mesh.points[i as usize]);
        check_load(&load, || format!("traction on part '{name}' near {}", place(&corners)))?;
        view.nodes.iter().zip(&load).for_each(|(&i, l)| nodal[i as usize] += l);
    }
    Ok(nodal)
}

/// `∫_T F φ_k dx` for the three corners.
fn element_load(mesh: &Mesh, data: &dyn Data, cubature: &Cubature, t: usize) -> [Vec2; 3] {
    let body = mesh.body(t);
    let mut load = [Vec2::zeros(); 3];
    let mut add = |x: Point, hats: &[f64; 3], w: f64| {
        let force = w * data.body_force(body, x);
        load.iter_mut().zip(hats).for_each(|(l, hat)| *l += *hat * force);
    };
    match mesh.curved_triangle(t) {
        Some(curved) => cubature.curved(&curved, &mut |p, w| add(p.x, &p.hats, w)),
        None => {
            let corners = mesh.corners(t);
            cubature.triangle(corners, &mut |x, w| add(x, &hats(corners, x), w));
        }
    }
    load
}

/// `∫ P φ_k ds` over a side for the three nodes of its triangle.
fn side_load(side: &SideView, data: &dyn Data, part: usize, cubature: &Cubature) -> [Vec2; 3] {
    let mut load = [Vec2::zeros(); 3];
    side.points(cubature, &mut |x, normal, hats, ds| {
        let traction = ds * data.traction(part, x, normal);
        (0..3).for_each(|k| load[k] += hats[k] * traction);
    });
    load
}

/// Refuses a load that is no number; `what` says whose it is.
///
/// # Errors
/// [`Error::Load`] with the value.
pub fn check_load(load: &[Vec2], what: impl Fn() -> String) -> Result<(), Error> {
    match load.iter().find(|l| !(l.x.is_finite() && l.y.is_finite())) {
        None => Ok(()),
        Some(l) => Err(Error::Load(format!(
            "{} integrates to ({}, {}), which is no number; check its expression there (a division by zero, a root or logarithm of a negative number)",
            what(),
            l.x,
            l.y
        ))),
    }
}

fn place(points: &[Point]) -> String {
    let middle = points.iter().sum::<Point>() / points.len() as f64;
    format!("({:.6}, {:.6})", middle.x, middle.y)
}

/// `A(v, φ_i)` for every node, in the components of the plane: what prescribed displacements take off the load.
pub fn internal_forces(mesh: &Mesh, materials: &[Material; 2], v: &[Vec2]) -> Vec<Vec2> {
    let mut nodal = vec![Vec2::zeros(); mesh.points.len()];
    let forces = |t: usize| {
        let values = mesh.triangles[t].map(|i| v[i as usize]);
        if values.iter().all(|v| *v == Vec2::zeros()) {
            return None;
        }
        let material = &materials[mesh.body(t).index()];
        Some(match mesh.curved_triangle(t) {
            Some(curved) => curved_forces(&curved, material, &values),
            None => straight_forces(mesh.corners(t), material, values),
        })
    };
    let Ok(()) = scatter(mesh, 0..mesh.triangles.len(), &mut nodal, |t| Ok::<_, Infallible>(forces(t)));
    nodal
}

fn straight_forces(corners: [Point; 3], material: &Material, values: [Vec2; 3]) -> [Vec2; 3] {
    let (g, area) = gradients(corners);
    let stress = material.stress(linear_strain(&g, values));
    // A(v, φ_k e_p) = |T| τ_pq ∂_q φ_k
    g.map(|g| area * Vec2::new(stress[0] * g.x + stress[2] * g.y, stress[2] * g.x + stress[1] * g.y))
}

/// The same for a triangle with a curved side, `Σ_j k_ij v_j`.
fn curved_forces(curved: &CurvedTriangle, material: &Material, values: &[Vec2; 3]) -> [Vec2; 3] {
    let times = |(b, v): (&[f64; 4], &Vec2)| Vec2::new(b[0] * v.x + b[1] * v.y, b[2] * v.x + b[3] * v.y);
    [0, 1, 2].map(|corner| curved.stiffness_row(material, corner).iter().zip(values).map(times).sum())
}
