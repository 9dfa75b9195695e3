//! The exact contact stress on one side of the zone, as a functional of nodal fields.

use crate::study::ExactScene;
use signorini_contact::Vec2;
use signorini_contact::mesh::Mesh;
use signorini_contact::quadrature::Cubature;

/// `∫ T n φ_k dμ` for the three nodes of the triangle of either body, and `∫ T ε dμ`. On a straight side the opposite nodes
/// have no share; on an arc with linear functions they have.
pub struct ContactLoad {
    nodes: [[u32; 3]; 2],
    weights: [[Vec2; 3]; 2],
    gap: f64,
}

impl ContactLoad {
    pub fn new(exact: &ExactScene, mesh: &Mesh, side: usize, cubature: &Cubature) -> Self {
        let view = mesh.contact_view(side);
        let mut load = Self { nodes: view.sides.each_ref().map(|s| s.nodes), weights: Default::default(), gap: 0.0 };
        view.points(cubature, &mut |t, point, weight| {
            let stress = weight * exact.contact_stress(point);
            load.gap += stress * point.gap;
            for (weights, side) in load.weights.iter_mut().zip(&view.sides) {
                weights.iter_mut().zip(side.hats(t)).for_each(|(w, hat)| *w += stress * hat * point.normal);
            }
        });
        load
    }

    /// Adds `∫ T [φ_k]_n dμ`, both components, to nodal loads.
    pub fn add_to(&self, load: &mut [Vec2]) {
        for (sign, (nodes, weights)) in [1.0, -1.0].into_iter().zip(self.nodes.iter().zip(&self.weights)) {
            nodes.iter().zip(weights).for_each(|(&i, w)| load[i as usize] += sign * w);
        }
    }

    /// `∫ T (n·(v' − v'') − ε) dμ`.
    pub fn work(&self, v: &[Vec2]) -> f64 {
        let of = |b: usize| (0..3).map(|k| self.weights[b][k].dot(&v[self.nodes[b][k] as usize])).sum::<f64>();
        of(0) - of(1) - self.gap
    }
}
