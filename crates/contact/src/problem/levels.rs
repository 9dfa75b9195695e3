//! The levels of a hierarchy as multigrid wants them.
//!
//! Nodes keep their numbers under refinement, so a coarse level inherits supports, pairs, normals and gaps from the finest one: its
//! basis is the finest one's on its own nodes. Between two levels `x_f = T_f⁻¹ P T_c x_c`, with `P` the mean over parent edges.

use super::Discrete;
use crate::assembly;
use crate::basis::Basis;
use crate::geometry::{Vec2, tangent_of};
use crate::material::Material;
use crate::mesh::{Body, Hierarchy, Mesh};
use crate::solver::multigrid::{CoarseLevel, Disorder, Levels, Order, Slots, SpecialRow, Transfer};
use crate::sparse::BlockMatrix;
use nalgebra::{Matrix6, SymmetricEigen};
use std::collections::BTreeMap;

/// Eigenvalues below this share of the largest belong to a free motion.
const FREE: f64 = 1e-12;

impl Discrete {
    /// The levels below this problem, which lives on the finest mesh of the hierarchy.
    ///
    /// # Panics
    /// If the numbers of nodes differ.
    pub fn levels<'a>(&self, hierarchy: &'a Hierarchy, materials: &[Material; 2]) -> Levels<'a> {
        let finest = hierarchy.levels().len() - 1;
        assert_eq!(self.basis.nodes(), hierarchy.finest().points.len(), "the problem of the hierarchy's finest mesh");
        let mut coarse = Vec::with_capacity(finest);
        for level in 0..finest {
            let mesh = &hierarchy.levels()[level];
            let basis = self.basis.on_first(mesh.points.len());
            let matrix = assembly::stiffness(mesh, materials, &basis);
            let bounds = self.qp.bounds.iter().filter(|b| (b.dof as usize) < matrix.dimension()).copied().collect();
            let order = order(hierarchy, level, &matrix);
            let transfer = transfer(hierarchy, level, &self.basis);
            coarse.push(CoarseLevel { matrix, bounds, pairs: basis.pairs().collect(), order, transfer });
        }
        Levels {
            coarse,
            pairs: self.basis.pairs().collect(),
            order: order(hierarchy, finest, &self.qp.matrix),
            motions: motions(&hierarchy.levels()[0], &self.basis),
        }
    }
}

/// Macro-triangles side by side; where couplings reach from one into the next, everything in sequence.
fn order(hierarchy: &Hierarchy, level: usize, matrix: &BlockMatrix) -> Order {
    let inside = |t: usize| -> Vec<Slots> {
        hierarchy.interior(level, t).filter(|r| !r.is_empty()).map(|r| r.start as u32..r.end as u32).collect()
    };
    let parts = (0..hierarchy.macro_triangles()).map(inside).filter(|p| !p.is_empty()).collect();
    Order::new(matrix, parts).unwrap_or_else(|Disorder { .. }| Order::natural(matrix.rows()))
}

/// From `level` to the next finer one.
fn transfer<'a>(hierarchy: &'a Hierarchy, level: usize, basis: &Basis) -> Transfer<'a> {
    let coarse = hierarchy.levels()[level].points.len();
    let parents = hierarchy.parents(level + 1);
    let is_special = |(i, ends): &(usize, &[u32; 2])| {
        !(basis.is_plain(coarse + i) && ends.iter().all(|&p| basis.is_plain(p as usize)))
    };
    let special = parents.iter().enumerate().filter(is_special);
    let special = special.map(|(i, _)| special_row(basis, coarse, parents, coarse + i)).collect();
    Transfer { coarse, parents, special }
}

/// Row `slot` of `T_f⁻¹ P T_c`, without fixed components.
fn special_row(basis: &Basis, coarse: usize, parents: &[[u32; 2]], slot: usize) -> SpecialRow {
    let mut entries: BTreeMap<u32, [f64; 4]> = BTreeMap::new();
    let (nodes, n) = basis.inverse_slots(slot);
    for (node, inverse) in &nodes[..n] {
        for parent in parents[*node as usize - coarse] {
            let (slots, m) = basis.slots(parent as usize);
            for (column, block) in &slots[..m] {
                let sum = entries.entry(*column).or_default();
                let product = assembly::product(inverse, block);
                (0..4).for_each(|k| sum[k] += 0.5 * product[k]);
            }
        }
    }
    for (column, block) in &mut entries {
        for k in 0..4 {
            if basis.fixed[2 * slot + k / 2] || basis.fixed[2 * *column as usize + k % 2] {
                block[k] = 0.0;
            }
        }
    }
    SpecialRow { slot: slot as u32, entries: entries.into_iter().filter(|(_, b)| *b != [0.0; 4]).collect() }
}

/// The rigid motions of both bodies that the supports leave free on a mesh, contact aside, in the coordinates of the basis.
fn motions(mesh: &Mesh, basis: &Basis) -> Vec<Vec<f64>> {
    let basis = basis.on_first(mesh.points.len());
    let candidates: Vec<Vec<Vec2>> = Body::BOTH.iter().flat_map(|&b| (0..3).map(move |k| rigid(mesh, b, k))).collect();
    let coordinates: Vec<Vec<f64>> = candidates.iter().map(|v| basis.coordinates(v)).collect();
    // what the supports take from each motion
    let taken = |k: usize| -> Vec<Vec2> {
        let left = basis.displacement(&coordinates[k]);
        (0..left.len()).map(|i| candidates[k][i] - (left[i] - basis.offset(i))).collect()
    };
    let taken: Vec<Vec<Vec2>> = (0..6).map(taken).collect();
    let work = |a: &[Vec2], b: &[Vec2]| a.iter().zip(b).map(|(a, b)| a.dot(b)).sum::<f64>();
    let eigen = SymmetricEigen::new(Matrix6::from_fn(|i, j| work(&taken[i], &taken[j])));
    let largest = eigen.eigenvalues.max();
    let free = (0..6).filter(|&k| eigen.eigenvalues[k] <= FREE * largest);
    free.map(|k| combine(&coordinates, |j| eigen.eigenvectors[(j, k)])).collect()
}

/// `Σ c_j y_j`.
fn combine(vectors: &[Vec<f64>], coefficient: impl Fn(usize) -> f64) -> Vec<f64> {
    let entry = |i: usize| vectors.iter().enumerate().map(|(j, y)| coefficient(j) * y[i]).sum();
    (0..vectors[0].len()).map(entry).collect()
}

/// A shift along an axis, or a turn about the middle scaled to the size of the mesh, of one body.
fn rigid(mesh: &Mesh, body: Body, k: usize) -> Vec<Vec2> {
    let low = mesh.points.iter().fold(mesh.points[0], |l, p| l.inf(p));
    let high = mesh.points.iter().fold(mesh.points[0], |h, p| h.sup(p));
    let (middle, radius) = (0.5 * (low + high), 0.5 * (high - low).norm());
    let motion = |x: Vec2| match k {
        0 => Vec2::x(),
        1 => Vec2::y(),
        _ => tangent_of((x - middle) / radius),
    };
    let of_node = |(x, of): (&Vec2, &Body)| if *of == body { motion(*x) } else { Vec2::zeros() };
    mesh.points.iter().zip(&mesh.node_bodies).map(of_node).collect()
}
