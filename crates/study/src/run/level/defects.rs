//! Departures from the paper that a study may ask for: other normals of the constraints, chords in place of arcs, and what
//! the latter does to the geometry.

use crate::exact::derived;
use crate::study::{Discretisation, ExactScene, Normals};
use signorini_contact::geometry::{ContactLine, Piece, Segment, Vec2, cross};
use signorini_contact::material::{contract, strain};
use signorini_contact::mesh::Mesh;
use signorini_contact::quadrature::GAUSS_8;
use signorini_contact::zone::Zone;
use signorini_contact::{Body, Material};

/// The constraints with the normals that the study asks for.
pub fn with_normals(mut zone: Zone, mesh: &Mesh, discretisation: &Discretisation) -> Zone {
    if discretisation.normals == Normals::True {
        return zone;
    }
    let mut chords: Vec<Vec<Vec2>> = vec![Vec::new(); zone.pairs.len()];
    for (side, ends) in zone.side_ends.iter().enumerate() {
        let [a, b] = mesh.contact[side].first.map(|i| mesh.points[i as usize]);
        ends.iter().for_each(|(pair, _)| chords[*pair].push(signorini_contact::geometry::right_normal(a, b)));
    }
    for (pair, normals) in zone.pairs.iter_mut().zip(&chords) {
        let normal = match discretisation.normals {
            Normals::Averaged => normals.iter().sum::<Vec2>().normalize(),
            _ => normals[0],
        };
        if let [constraint] = &mut pair.constraints[..] {
            constraint.normal = normal;
        }
    }
    zone
}

/// The energy norm of the exact solution, continued across the zone, in the strips between its arcs and the chords of a mesh
/// with straight sides: what the bodies of the mesh differ by from those of the scene. Zero where the mesh follows the arcs.
pub fn geometry_error(exact: &ExactScene, materials: &[Material; 2], line: &ContactLine, mesh: &Mesh) -> f64 {
    if !mesh.curved.sides.is_empty() {
        return 0.0;
    }
    let pieces = line.pieces();
    let strip = |side: usize| -> f64 {
        let contact = &mesh.contact[side];
        let ends = [contact.first, contact.second];
        Body::BOTH
            .into_iter()
            .filter(|body| mesh.direction.is_some() || *body == Body::First)
            .map(|body| {
                let b = body.index();
                let Piece::Curved { curve, .. } = &pieces[usize::from(contact.segment)][b] else { return 0.0 };
                let [p, q] = ends[b].map(|i| mesh.points[i as usize]);
                of_strip(exact, materials, &Piece::on_curve(curve, p, q), Segment { a: p, b: q })
            })
            .sum()
    };
    (0..mesh.contact.len()).map(strip).sum::<f64>().sqrt()
}

/// `∫ w (τ':ε' + τ'':ε'') ds` along the arc, `w` its height over the chord.
fn of_strip(exact: &ExactScene, materials: &[Material; 2], arc: &Piece, chord: Segment) -> f64 {
    let at = |t: f64| {
        let x = arc.point(t);
        let height = (cross(chord.b - chord.a, x - chord.a) / chord.length()).abs();
        let density = |body: Body| {
            let e = strain(exact.solution.jet(body, x).gradient);
            contract(derived::stress(exact.solution.as_ref(), &materials[body.index()], body, x), e)
        };
        height * (density(Body::First) + density(Body::Second)) * arc.velocity(t).norm()
    };
    GAUSS_8.iter().map(|&(t, w)| w * at(t)).sum()
}
