//! Every family on four scenes: certificates, nestedness, reproducibility, refusals.

mod scenes;

use super::{Family, refinements};
use scenes::{Scene, disc, kinked, punch, sheared, squares};
use signorini_contact::geometry::twice_area;
use signorini_contact::mesh::Mesh;
use signorini_contact::{Body, Point, Vec2};

const PERTURBED: Family = Family::Perturbed { seed: 1, amount: 0.3 };
const REFINED: Family = Family::Refined { seed: 1, amount: 0.3 };
const ALL: [Family; 5] = [Family::Structured, Family::CrissCross, Family::UnionJack, PERTURBED, REFINED];

fn scenes() -> [Scene; 4] {
    [squares(), kinked(), punch(), sheared()]
}

fn area(mesh: &Mesh, body: Body) -> f64 {
    let own = (0..mesh.triangles.len()).filter(|&t| mesh.body(t) == body);
    own.map(|t| mesh.corners(t)).map(|[a, b, c]| 0.5 * twice_area(a, b, c)).sum()
}

/// The angle that the guard keeps at `n` cells: 20° or half of what the structured mesh has.
fn guard(scene: &Scene, n: usize) -> f64 {
    let structured = scene.level(Family::Structured, &[n], 0).unwrap();
    f64::min(20.0, 0.5 * structured.quality.min_angle) - 1e-9
}

#[test]
fn every_level_of_every_family_fills_the_bodies() {
    let cells = [2, 4, 8];
    for scene in scenes() {
        for family in ALL {
            for index in 0..cells.len() {
                let level = scene.level(family, &cells, index).unwrap();
                let what = format!("{} {family:?} level {index}", scene.name);
                let mesh = level.hierarchy.finest();
                for body in Body::BOTH {
                    let wrong = area(mesh, body) - scene.areas[body.index()];
                    assert!(wrong.abs() < 1e-13, "{what}: area off by {wrong}");
                }
                for side in &mesh.contact {
                    let at = |i: u32| mesh.points[i as usize];
                    assert_eq!(side.first.map(at), side.second.map(at), "{what}");
                }
                assert_eq!(level.hash, mesh.hash(), "{what}");
                assert_eq!(level.quality, mesh.quality(), "{what}");
                assert_eq!(level.nested, family.is_nested() && index > 0, "{what}");
                let own = cells[if family.is_nested() { 0 } else { index }];
                let guarded = family.amount().is_some();
                assert!(!guarded || level.quality.min_angle > guard(&scene, own), "{what}");
            }
        }
    }
}

#[test]
fn squares_have_the_known_certificate() {
    let level = squares().level(Family::Structured, &[4, 8, 16], 2).unwrap();
    let root2 = std::f64::consts::SQRT_2;
    assert!((level.quality.h - root2 / 16.0).abs() < 1e-15);
    assert!((level.quality.min_angle - 45.0).abs() < 1e-12);
    assert!((level.quality.side_ratio - root2).abs() < 1e-13);
    assert_eq!(level.hierarchy.levels().len(), 3);
    assert_eq!(level.hierarchy.finest().triangles.len(), 4 * 16 * 16);
}

#[test]
fn scenes_have_the_angles_stated_above() {
    for scene in scenes() {
        let level = scene.level(Family::Structured, &[1], 0).unwrap();
        assert!((level.quality.min_angle - scene.angle).abs() < 1e-10, "{}", scene.name);
    }
}

/// Levels that double are nested; others get a fresh mesh and say so. Equal cells make the same mesh.
#[test]
fn nestedness_follows_the_cells() {
    let cells = [4, 4, 8, 12, 24, 32];
    for family in [Family::Structured, Family::CrissCross] {
        let levels = [0, 1, 2, 3, 4, 5].map(|i| squares().level(family, &cells, i).unwrap());
        let nested = levels.each_ref().map(|l| l.nested);
        assert_eq!(nested, [false, true, true, false, false, false]);
        let depth = levels.each_ref().map(|l| l.hierarchy.levels().len());
        assert_eq!(depth, [1, 1, 2, 1, 1, 4]);
        assert_eq!(levels[0].hash, levels[1].hash);
        assert_ne!(levels[1].hash, levels[2].hash);
    }
    let nested = |family, i| squares().level(family, &cells, i).unwrap().nested;
    assert!((0..6).all(|i| !nested(Family::UnionJack, i) && !nested(PERTURBED, i)));
}

/// The reference holds every study level to the last bit, and prolongs a linear field exactly.
#[test]
fn references_hold_the_study_levels() {
    let cells = [2, 4, 8];
    let field = |p: &Point| Vec2::new(1.0 - p.x + 2.0 * p.y, 0.5 * p.x);
    for scene in scenes() {
        for family in [Family::Structured, Family::CrissCross, REFINED] {
            let reference = scene.reference(family, &cells, 16).unwrap();
            assert_eq!(reference.levels().len(), 4);
            for (index, &n) in cells.iter().enumerate() {
                let k = refinements(cells[0], n).unwrap();
                let level = scene.level(family, &cells, index).unwrap();
                assert_eq!(level.hierarchy.levels(), &reference.levels()[..=k]);
                assert_eq!(level.hash, reference.levels()[k].hash());
                let coarse: Vec<_> = reference.levels()[k].points.iter().map(field).collect();
                let fine = reference.prolong(k, 3, &coarse);
                for (value, x) in fine.iter().zip(&reference.finest().points) {
                    assert!((value - field(x)).norm() < 1e-14);
                }
            }
        }
    }
}

/// Where no mesh refines another, the reference is the mesh that a level of its size would be.
#[test]
fn references_of_other_families_are_levels_like_the_others() {
    for scene in scenes() {
        for family in [Family::UnionJack, PERTURBED] {
            let reference = scene.reference(family, &[4, 6], 9).unwrap();
            let level = scene.level(family, &[4, 9], 1).unwrap();
            assert_eq!((reference.levels().len(), reference.finest().hash()), (1, level.hash));
        }
    }
}

/// Doubled twice or more, structured levels stand above coarser ones; the finest is still the mesh that it would be alone.
#[test]
fn on_curved_bodies_levels_are_mapped_anew_above_coarser_ones() {
    let cells = [1, 2, 3, 4, 8];
    let depth = |family| [0, 1, 2, 3, 4].map(|i| disc().level(family, &cells, i).unwrap().hierarchy.levels().len());
    assert_eq!(depth(Family::Structured), [1, 1, 1, 3, 4]);
    assert_eq!(depth(Family::CrissCross), [1; 5]);
    assert_eq!(depth(PERTURBED), [1; 5]);
    let level = disc().level(Family::Structured, &cells, 4).unwrap();
    let alone = disc().level(Family::Structured, &[8], 0).unwrap();
    assert!(!level.nested && alone.hierarchy.levels().len() == 1);
    assert_eq!(level.hash, alone.hash);
    let (quality, other) = (level.quality, alone.quality);
    assert!((quality.h - other.h).abs() < 1e-15 && (quality.min_angle - other.min_angle).abs() < 1e-11);
    let places = |mesh: &Mesh| {
        let mut places: Vec<_> = mesh.points.iter().map(|p| (p.x.to_bits(), p.y.to_bits())).collect();
        places.sort_unstable();
        places
    };
    assert_eq!(places(level.hierarchy.finest()), places(alone.hierarchy.finest()));
    for mesh in level.hierarchy.levels() {
        for body in Body::BOTH {
            let own = (0..mesh.triangles.len()).filter(|&t| mesh.body(t) == body);
            let wrong = own.map(|t| mesh.area(t)).sum::<f64>() - disc().areas[body.index()];
            assert!(wrong.abs() < 1e-13, "area off by {wrong}");
        }
    }
    let reference = disc().reference(Family::Structured, &cells, 16).unwrap();
    assert_eq!(reference.levels().len(), 5);
}

/// Corners, ends of parts and block corners stay; every other node moves, boundary nodes along their part.
#[test]
fn perturbed_nodes_move_within_bounds() {
    let (n, amount) = (8, 0.3);
    let family = Family::Perturbed { seed: 5, amount };
    for scene in scenes() {
        let plain = scene.level(Family::Structured, &[n], 0).unwrap().hierarchy;
        let moved = scene.level(family, &[n], 0).unwrap().hierarchy;
        let (plain, moved) = (plain.finest(), moved.finest());
        assert_eq!((&plain.triangles, &plain.sides), (&moved.triangles, &moved.sides));
        assert_eq!(plain.contact, moved.contact);
        let still = (0..plain.points.len()).filter(|&i| plain.points[i] == moved.points[i]).count();
        // Corners: 4 + 4; 6 + 6, each body with a block end in its outer side; 4 + 8.
        let expected = match scene.name {
            "squares" | "sheared" => 8,
            _ => 12,
        };
        assert_eq!(still, expected, "{}", scene.name);
        for (p, q) in plain.points.iter().zip(&moved.points) {
            let size = if scene.name == "kinked" { 1.6 } else { 1.0 } / n as f64;
            assert!((q - p).norm() <= amount * size);
        }
        // Boundary sides and contact sides keep their direction.
        let along = |m: &Mesh, [a, b]: [u32; 2]| (m.points[b as usize] - m.points[a as usize]).normalize();
        let contact = plain.contact.iter().flat_map(|c| [c.first, c.second]);
        for side in plain.sides.iter().map(|s| s.nodes).chain(contact) {
            assert!((along(plain, side) - along(moved, side)).norm() < 1e-13);
        }
    }
}

#[test]
fn angles_are_guarded_for_many_seeds_and_sizes() {
    for scene in scenes() {
        for seed in 0..40 {
            for n in [1, 2, 5, 16] {
                for family in [Family::Perturbed { seed, amount: 0.49 }, Family::Refined { seed, amount: 0.49 }] {
                    let angle = scene.level(family, &[n], 0).unwrap().quality.min_angle;
                    assert!(angle > guard(&scene, n), "{} {family:?} n = {n}: {angle}", scene.name);
                }
            }
        }
    }
}

/// Without the guard the angles would be below it: the guard has something to do.
#[test]
fn the_guard_is_reached() {
    let family = Family::Perturbed { seed: 3, amount: 0.49 };
    let angle = squares().level(family, &[16], 0).unwrap().quality.min_angle;
    assert!(angle < 21.0, "{angle}");
}

#[test]
fn seeds_reproduce_and_tell_meshes_apart() {
    let hash = |family, cells: &[usize], i| squares().level(family, cells, i).unwrap().hash;
    for make in [|seed, amount| Family::Perturbed { seed, amount }, |seed, amount| Family::Refined { seed, amount }] {
        let family = make(1, 0.2);
        assert_eq!(hash(family, &[4], 0), hash(family, &[4], 0));
        assert_ne!(hash(family, &[4], 0), hash(make(2, 0.2), &[4], 0));
        assert_ne!(hash(family, &[4], 0), hash(make(1, 0.25), &[4], 0));
    }
    // A perturbed level does not depend on the other levels; a refined one does, on the coarsest.
    assert_eq!(hash(PERTURBED, &[2, 8], 1), hash(PERTURBED, &[8], 0));
    assert_ne!(hash(REFINED, &[2, 8], 1), hash(REFINED, &[8], 0));
    // Refined meshes have diagonals turned: their connectivity differs from the structured one.
    let triangles = |family| squares().level(family, &[8], 0).unwrap().hierarchy.finest().triangles.clone();
    assert_ne!(triangles(REFINED), triangles(Family::Structured));
}

/// The same names on every machine: nothing but exact conversions, sums, products, quotients and roots is used.
#[test]
fn hashes_are_stable() {
    // Written down once; a change renames every mesh on record.
    let hash = |family| kinked().level(family, &[2, 4], 1).unwrap().hash;
    assert_eq!(
        ALL.map(hash),
        ["3d28e1a84437b33f", "8b520a017b336ebd", "9ec1d179b604b9c9", "178afdc0c4593b3f", "6363e6f6391ead82"]
    );
}

#[test]
fn refinements_are_powers_of_two() {
    let table = [(8, 8, Some(0)), (8, 64, Some(3)), (3, 12, Some(2)), (8, 24, None), (8, 4, None), (0, 4, None)];
    for (coarse, n, k) in table {
        assert_eq!(refinements(coarse, n), k);
    }
}

#[test]
fn meaningless_levels_are_refused() {
    let scene = squares();
    let level = |family, cells: &[usize], i| scene.level(family, cells, i).unwrap_err().to_string();
    let reference = |family, cells: &[usize], n| scene.reference(family, cells, n).unwrap_err().to_string();
    let amount = |amount| Family::Perturbed { seed: 0, amount };
    let table = [
        (level(Family::Structured, &[], 0), "cells []"),
        (level(Family::Structured, &[0, 8], 0), "cells [0, 8]"),
        (level(Family::Structured, &[8, 4], 0), "must not descend"),
        (level(Family::Structured, &[8], 1), "level 1 does not exist"),
        (level(amount(0.5), &[8], 0), "by 0.5 of a cell"),
        (level(amount(-0.1), &[8], 0), "by -0.1 of a cell"),
        (level(amount(f64::NAN), &[8], 0), "by NaN of a cell"),
        (level(REFINED, &[8, 12], 1), "12 cells are no refinement of the coarsest level's 8"),
        (level(Family::Structured, &[usize::MAX], 0), "body \"upper\": the blocks have"),
        (reference(PERTURBED, &[8], 7), "fewer than the finest level's 8"),
        (reference(Family::UnionJack, &[], 16), "cells []"),
        (reference(Family::Structured, &[8, 16], 8), "fewer than the finest level's 16"),
        (reference(Family::Structured, &[8, 16], 24), "24 cells are no refinement"),
        (reference(Family::Structured, &[8, 12], 16), "12 cells are no refinement"),
        (reference(Family::Structured, &[], 16), "cells []"),
    ];
    for (error, message) in table {
        assert!(error.contains(message), "“{message}” is not in: {error}");
    }
}
