use super::{PATTERNS, kinked};
use crate::mesh::{Hierarchy, Mesh};

fn refined(coarse: Mesh, steps: usize) -> Hierarchy {
    let mut hierarchy = Hierarchy::new(coarse);
    (0..steps).for_each(|_| hierarchy.refine());
    hierarchy
}

/// Which macro-triangle claims each node of a level.
fn claims(hierarchy: &Hierarchy, level: usize) -> Vec<Option<usize>> {
    let mut of = vec![None; hierarchy.levels()[level].points.len()];
    for m in 0..hierarchy.macro_triangles() {
        for node in hierarchy.interior(level, m).flatten() {
            assert_eq!(of[node].replace(m), None, "node {node} of level {level} is claimed twice");
        }
    }
    of
}

/// The statement itself, from the triangles: a node is claimed exactly if all triangles around it lie in one macro-triangle
/// and it is no end of a boundary side, and then by that one.
#[test]
fn nodes_inside_macro_triangles_are_those_whose_triangles_all_lie_there() {
    for pattern in PATTERNS {
        let hierarchy = refined(kinked(1, pattern).build().unwrap(), 4);
        for (level, mesh) in hierarchy.levels().iter().enumerate() {
            let mut around = vec![Vec::new(); mesh.points.len()];
            for (t, corners) in mesh.triangles.iter().enumerate() {
                corners.iter().for_each(|&i| around[i as usize].push(t >> (2 * level)));
            }
            let mut on_boundary = vec![false; mesh.points.len()];
            let zone = mesh.contact.iter().flat_map(|c| [c.first, c.second]).flatten();
            zone.chain(mesh.sides.iter().flat_map(|s| s.nodes)).for_each(|i| on_boundary[i as usize] = true);
            for (node, claim) in claims(&hierarchy, level).into_iter().enumerate() {
                let only = around[node].iter().all(|m| *m == around[node][0]) && !on_boundary[node];
                assert_eq!(claim, only.then_some(around[node][0]), "node {node} of level {level}");
            }
        }
    }
}

#[test]
fn no_triangle_has_inner_nodes_of_two_macro_triangles() {
    for pattern in PATTERNS {
        let hierarchy = refined(kinked(2, pattern).build().unwrap(), 3);
        let of = claims(&hierarchy, 3);
        for corners in &hierarchy.finest().triangles {
            let mut inside = corners.iter().filter_map(|&i| of[i as usize]);
            let first = inside.next();
            assert!(inside.all(|m| Some(m) == first), "{corners:?}");
        }
        let claimed = of.iter().flatten().count();
        // (2^k − 1)(2^k − 2)/2 in each, k = 3
        assert_eq!(claimed, hierarchy.macro_triangles() * 21);
    }
}
