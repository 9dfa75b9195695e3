//! Pairs, normals and masses on the straight and on the kinked zone.

use super::*;
use crate::mesh::blocks::Pattern;
use crate::mesh::tests::{kinked, squares};

/// The whole mass of the constraints: every segment counts once, whatever is merged at its ends.
fn mass(zone: &Zone) -> f64 {
    zone.pairs.iter().flat_map(|p| &p.constraints).map(|c| c.mass).sum()
}

#[test]
fn masses_add_up_to_the_length_of_the_zone() {
    let straight = Zone::new(&squares(3, Pattern::Structured).build().unwrap());
    assert!((mass(&straight) - 1.0).abs() < 1e-15);
    let bent = Zone::new(&kinked(3, Pattern::CrissCross).build().unwrap());
    assert!((mass(&bent) - (1.04f64.sqrt() + 1.25f64.sqrt())).abs() < 1e-14);
}

#[test]
fn normals_point_out_of_the_first_body_and_nodes_lie_on_one_another() {
    for scene in [squares(2, Pattern::UnionJack), kinked(2, Pattern::Structured)] {
        let mesh = scene.build().unwrap();
        let zone = Zone::new(&mesh);
        assert!(zone.side_normals.iter().flatten().all(|n| n.y < 0.0 && (n.norm() - 1.0).abs() < 1e-15));
        for p in &zone.pairs {
            assert!((mesh.points[p.first as usize] - mesh.points[p.second as usize]).norm() < 1e-15);
            assert_eq!([p.first, p.second].map(|i| mesh.node_bodies[i as usize].index()), [0, 1]);
        }
    }
}

#[test]
fn an_end_and_a_smooth_node_have_one_constraint_the_kink_two() {
    let zone = Zone::new(&kinked(4, Pattern::Structured).build().unwrap());
    let counts: Vec<usize> = zone.pairs.iter().map(|p| p.constraints.len()).collect();
    assert_eq!(counts, [1, 1, 1, 1, 2, 1, 1, 1, 1]);
    assert_eq!(zone.constraints(), 10);
    // the two flanks have the slopes −0.2 and 0.5, with the normals below them
    let normals: Vec<Vec2> = zone.pairs[4].constraints.iter().map(|c| c.normal).collect();
    let expected = [Vec2::new(-0.2, -1.0), Vec2::new(0.5, -1.0)].map(|n| n.normalize());
    assert!(normals.iter().zip(expected).all(|(n, e)| (n - e).norm() < 1e-15), "{normals:?}");
    assert_eq!(zone.side_ends[3][1], (4, 0));
    assert_eq!(zone.side_ends[4][0], (4, 1));
    assert!(zone.warnings.is_empty());
}

/// Two squares sheared so that the contact line is flat up to the middle and has this slope beyond it.
fn bent_by(slope: f64) -> Zone {
    let mut mesh = squares(2, Pattern::Structured).build().unwrap();
    for p in mesh.points.iter_mut().filter(|p| p.x > 0.5) {
        p.y += slope * (p.x - 0.5);
    }
    Zone::new(&mesh)
}

#[test]
fn collinear_flanks_are_merged_and_nearly_collinear_ones_are_told() {
    let flat = bent_by(1e-9);
    assert_eq!((flat.pairs[1].constraints.len(), flat.warnings.len()), (1, 0));
    assert!((flat.pairs[1].constraints[0].mass - 0.5).abs() < 1e-9);
    let nearly = bent_by(0.04);
    assert_eq!((nearly.pairs[1].constraints.len(), nearly.warnings.len()), (2, 1));
    assert!(nearly.warnings[0].contains("(0.5, 0)") && nearly.warnings[0].contains("4.0e-2"), "{:?}", nearly.warnings);
    assert!(bent_by(0.06).warnings.is_empty());
}

#[test]
fn a_bilateral_part_is_closed_and_a_corner_keeps_its_own_kinds() {
    use crate::zone::ConstraintKind::{Bilateral, Unilateral};
    let mesh = kinked(4, Pattern::Structured).build().unwrap();
    let kinds = |pieces: &[usize]| {
        let mut zone = Zone::new(&mesh);
        zone.make_bilateral(&mesh, pieces);
        zone.pairs.iter().map(|p| p.constraints.iter().map(|c| c.kind).collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    let right = kinds(&[1]);
    assert!(right[..4].iter().all(|k| *k == [Unilateral]) && right[5..].iter().all(|k| *k == [Bilateral]));
    assert_eq!(right[4], [Unilateral, Bilateral]);
    assert!(kinds(&[0, 1]).iter().flatten().all(|k| *k == Bilateral));
    assert!(kinds(&[2]).iter().flatten().all(|k| *k == Unilateral));
    // on a straight line the two segments share a constraint: the end of the bilateral part belongs to it
    let mut scene = squares(4, Pattern::Structured);
    scene.contact = crate::mesh::tests::points([[0.0, 0.0], [0.25, 0.0], [1.0, 0.0]]).to_vec();
    let mesh = scene.build().unwrap();
    let mut zone = Zone::new(&mesh);
    zone.make_bilateral(&mesh, &[0]);
    let kinds: Vec<_> = zone.pairs.iter().map(|p| (p.constraints.len(), p.constraints[0].kind)).collect();
    assert_eq!(kinds, [(1, Bilateral), (1, Bilateral), (1, Unilateral), (1, Unilateral), (1, Unilateral)]);
}
