//! Whether the discrete set is part of the continuous one, `K_h ⊂ K`, and so of that of every nested finer mesh.

use crate::study::{PartCondition, Scene};
use signorini_contact::Vec2;
use signorini_contact::mesh::Mesh;
use signorini_contact::problem::{Data, Support};
use std::collections::BTreeMap;

/// Prescribed displacements that miss their interpolant by more than this share of their size are not interpolated exactly.
const ROUNDING: f64 = 1e-12;

/// Points of a side where data are compared with their interpolant.
const SAMPLES: [f64; 3] = [0.25, 0.5, 0.75];

/// Whether `K_h ⊂ K` by construction: a common polygonal zone with the normals of its segments (Lemma 2.1), straight bodies, an
/// initial gap that is no smaller between nodes than its interpolant, and prescribed displacements that are linear on every side and
/// do not move along the normal of `Γ_0` where they end on it.
pub(super) fn is_inside(scene: &Scene, mesh: &Mesh) -> bool {
    let straight = mesh.direction.is_none() && !scene.domain().is_curved();
    straight && gap_is_concave(mesh) && data_are_interpolated(scene, mesh) && data_fit_the_slides(scene, mesh)
}

/// Whether the initial gap is at least its interpolant, side by side.
fn gap_is_concave(mesh: &Mesh) -> bool {
    (0..mesh.contact.len()).all(|side| {
        let view = mesh.contact_view(side);
        let [from, to] = [0.0, 1.0].map(|t| view.at(t).gap);
        SAMPLES.into_iter().all(|t| {
            let linear = (1.0 - t) * from + t * to;
            view.at(t).gap >= linear - ROUNDING * from.abs().max(to.abs())
        })
    })
}

fn data_are_interpolated(scene: &Scene, mesh: &Mesh) -> bool {
    let fixed = |part: u16| matches!(scene.parts[usize::from(part)].condition, PartCondition::Fixed(_));
    mesh.sides.iter().filter(|s| fixed(s.part)).all(|side| {
        let [a, b] = side.nodes.map(|i| mesh.points[i as usize]);
        let at = |x| scene.displacement(side.part as usize, x);
        let (u, v) = (at(a), at(b));
        let size = u.amax().max(v.amax());
        SAMPLES.into_iter().all(|t| {
            let difference = at((1.0 - t) * a + t * b) - ((1.0 - t) * u + t * v);
            difference.amax() <= ROUNDING * size.max(at(0.5 * (a + b)).amax())
        })
    })
}

/// Whether the prescribed displacement of every node that `Γ_u` shares with `Γ_0` has no normal component on `Γ_0`. Else the side of
/// `Γ_0` next to it moves along its normal, and a finer mesh forbids that.
fn data_fit_the_slides(scene: &Scene, mesh: &Mesh) -> bool {
    let supports = &scene.supports();
    let of = |support| mesh.sides.iter().filter(move |s| supports[usize::from(s.part)] == support);
    let given: BTreeMap<u32, Vec2> = of(Support::Fixed)
        .flat_map(|s| s.nodes.map(|i| (i, scene.displacement(usize::from(s.part), mesh.points[i as usize]))))
        .collect();
    of(Support::Sliding).all(|side| {
        let normal = mesh.boundary_view(side).piece.normal(0.0);
        let fits = |u: &Vec2| normal.dot(u).abs() <= ROUNDING * u.norm();
        side.nodes.iter().filter_map(|i| given.get(i)).all(fits)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::family::build_level;
    use crate::sample;
    use signorini_contact::Point;
    use std::sync::Arc;

    fn scene_and_mesh(study: &str, case: &str) -> (Scene, Mesh) {
        let case = sample::case(study, case);
        let scene = case.scene().unwrap().clone();
        let mesh = build_level(&case.family, &scene.domain(), &[4], 0).unwrap().hierarchy.finest().clone();
        (scene, mesh)
    }

    #[test]
    fn polygons_are_inside_and_curves_and_gaps_are_not() {
        for (study, case, inside) in [
            ("theorem-3-1-smooth", "structured", true),
            ("two-squares", "two-squares", true),
            ("lemma-2-1", "kinked", true),
            ("theorem-3-3", "structured", false),
            ("theorem-3-4", "convex-structured", false),
        ] {
            let (scene, mesh) = scene_and_mesh(study, case);
            assert_eq!(is_inside(&scene, &mesh), inside, "{study}");
        }
    }

    #[test]
    fn data_have_to_be_linear_on_every_side() {
        let (mut scene, mesh) = scene_and_mesh("two-squares", "two-squares");
        let mut with = |field: fn(Point) -> Vec2| {
            for part in &mut scene.parts {
                if let PartCondition::Fixed(value) = &mut part.condition {
                    *value = Some(Arc::new(move |x, _| field(x)));
                }
            }
            is_inside(&scene, &mesh)
        };
        assert!(with(|x| Vec2::new(0.1 * x.x, 3.0 - x.x)));
        assert!(!with(|x| Vec2::new(0.1 * x.x * x.x, 0.0)));
    }
}
