//! Meshes of discs and ellipses: where their nodes are, what they cover, how regular they are.

use super::*;
use crate::lemma::mesh::{BoundarySide, DomainMesh};
use signorini_contact::geometry::twice_area;
use std::f64::consts::PI;

/// The perimeter by the arithmetic–geometric mean (Gauss): `2π (a² − Σ 2^{n−1} c_n²) / M(a, b)`.
fn perimeter([a0, b0]: [f64; 2]) -> f64 {
    let (mut a, mut b, mut c, mut power, mut sum) = (a0, b0, (a0 * a0 - b0 * b0).sqrt(), 0.5, 0.0);
    for _ in 0..8 {
        sum += power * c * c;
        (a, b, c) = (0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b));
        power *= 2.0;
    }
    2.0 * PI * (a0 * a0 - sum) / a
}

#[test]
fn the_perimeter_is_that_of_the_arithmetic_geometric_mean() {
    for semi_axes in [[1.0, 1.0], [1.5, 1.0], [3.0, 1.0]] {
        let (found, known) = (Ellipse { semi_axes }.perimeter(), perimeter(semi_axes));
        assert!((found / known - 1.0).abs() < 1e-13, "{semi_axes:?}: {found} {known}");
    }
}

#[test]
fn arcs_are_equal_in_length_and_their_ends_on_the_curve() {
    for domain in domains() {
        let mesh = domain.mesh(3);
        let length = domain.ellipse.perimeter() / mesh.boundary.len() as f64;
        assert_eq!(mesh.boundary.len(), 8 * domain.coarse_arcs());
        for side in &mesh.boundary {
            assert!((domain.ellipse.length(side.angles) / length - 1.0).abs() < 1e-12, "{domain:?}: {side:?}");
            for (node, angle) in side.nodes.into_iter().zip(side.angles) {
                let x = mesh.points[node as usize];
                assert!((x - domain.ellipse.at(angle)).norm() < 1e-14);
            }
            let corners = mesh.triangles[side.triangle as usize];
            assert!(side.nodes.iter().all(|n| corners.contains(n)), "{side:?} {corners:?}");
        }
    }
}

/// The area between an arc and its chord: `ab/2 (Δt − sin Δt)`.
fn segment(mesh: &DomainMesh, side: &BoundarySide) -> f64 {
    let ([a, b], turn) = (mesh.ellipse.semi_axes, side.angles[1] - side.angles[0]);
    0.5 * a * b * (turn - turn.sin())
}

fn triangles(mesh: &DomainMesh) -> f64 {
    (0..mesh.triangles.len() as u32).map(|t| 0.5 * twice_area_of(mesh, t)).sum()
}

fn twice_area_of(mesh: &DomainMesh, t: u32) -> f64 {
    let [a, b, c] = mesh.corners(t);
    twice_area(a, b, c)
}

/// The polygon `R_0 Q_0 R_1 Q_1 …` around the outer layer.
fn polygon(mesh: &DomainMesh, arcs: usize) -> f64 {
    let corner = |k: usize| mesh.points[if k.is_multiple_of(2) { 2 * arcs + k / 2 } else { arcs + k / 2 }];
    let origin = signorini_contact::Point::zeros();
    (0..2 * arcs).map(|k| 0.5 * twice_area(origin, corner(k), corner((k + 1) % (2 * arcs)))).sum()
}

#[test]
fn curved_triangles_fill_the_domain_exactly() {
    for domain in domains() {
        let [a, b] = domain.ellipse.semi_axes;
        for refinements in [0, 1, 4] {
            let mesh = domain.mesh(refinements);
            let strips: f64 = mesh.boundary.iter().map(|s| segment(&mesh, s)).sum();
            let (area, known) = match domain.side {
                Side::Inside => (triangles(&mesh) + strips, PI * a * b),
                Side::Outside => (triangles(&mesh) - strips, polygon(&mesh, domain.coarse_arcs()) - PI * a * b),
            };
            assert!((area - known).abs() < 1e-13 * known, "{domain:?}, {refinements}: {area} {known}");
            assert!((0..mesh.triangles.len() as u32).all(|t| twice_area_of(&mesh, t) > 0.0));
        }
    }
}

#[test]
fn families_are_strongly_regular_where_the_lemmas_use_them() {
    for domain in domains().into_iter().filter(|d| d.ellipse.semi_axes[0] <= 1.5) {
        let h: Vec<f64> = (2..6).map(|k| domain.mesh(k).quality().h).collect();
        assert!(h.windows(2).all(|h| (1.85..2.05).contains(&(h[0] / h[1]))), "{domain:?}: {h:?}");
        let quality = domain.mesh(5).quality();
        assert!(quality.side_ratio <= 2.0 && quality.min_angle > 34.0, "{domain:?}: {quality:?}");
    }
}

#[test]
fn meshes_of_two_levels_are_told_apart() {
    assert_eq!(disc().mesh(2).hash(), disc().mesh(2).hash());
    assert_ne!(disc().mesh(2).hash(), disc().mesh(3).hash());
    assert_eq!(disc().mesh(3).points.len(), 1 + 3 * 8 * 9, "the nodes of a hexagon with 8 parts to a side");
}
