//! Rows and element matrices that repeat.

use crate::element::{gradients, stiffness_row};
use crate::material::Material;
use crate::mesh::{Mesh, Shapes};
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, DefaultHasher, Hash, Hasher};

/// The nine blocks of an element matrix.
type ElementBlocks = [[[f64; 4]; 3]; 3];

/// The element matrix of every macro-triangle whose descendants are similar to it.
pub(super) struct ShapeBlocks<'a> {
    shapes: Option<&'a Shapes>,
    blocks: Vec<Option<ElementBlocks>>,
}

impl<'a> ShapeBlocks<'a> {
    pub fn new(mesh: &'a Mesh, materials: &[Material; 2]) -> Self {
        let Some(shapes) = &mesh.shapes else { return Self { shapes: None, blocks: Vec::new() } };
        let per_macro = mesh.triangles.len() / shapes.corners().len().max(1);
        let blocks = |(k, corners): (usize, &Option<_>)| {
            let material = &materials[mesh.body(k * per_macro).index()];
            // The size cancels: gradients grow as the triangle shrinks.
            let (g, area) = gradients((*corners)?);
            Some([0, 1, 2].map(|corner| stiffness_row(material, area, &g, corner)))
        };
        Self { shapes: Some(shapes), blocks: shapes.corners().iter().enumerate().map(blocks).collect() }
    }

    /// Whether no triangle repeats another.
    pub fn is_empty(&self) -> bool {
        self.shapes.is_none()
    }

    /// The element matrix of a triangle, if it repeats that of its macro-triangle.
    pub fn of(&self, t: usize) -> Option<&ElementBlocks> {
        self.blocks[self.shapes?.of(t)].as_ref()
    }
}

/// Rows in their order, each distinct one stored once. What is looked up is compared, so the hash decides nothing.
#[derive(Default)]
pub(super) struct KnownRows {
    /// Where the blocks of each row start.
    pub start: Vec<u32>,
    pub blocks: Vec<[f64; 4]>,
    known: HashMap<u64, u32, BuildHasherDefault<DefaultHasher>>,
}

impl KnownRows {
    /// Appends a row; one that may not be shared gets blocks of its own.
    pub fn add(&mut self, row: &[[f64; 4]], may_share: bool) {
        if !may_share {
            return self.append(row);
        }
        let hash = hash(row);
        match self.known.get(&hash) {
            Some(&start) if self.is_at(start as usize, row) => self.start.push(start),
            _ => {
                self.known.insert(hash, self.blocks.len() as u32);
                self.append(row);
            }
        }
    }

    fn append(&mut self, row: &[[f64; 4]]) {
        self.start.push(self.blocks.len() as u32);
        self.blocks.extend_from_slice(row);
    }

    fn is_at(&self, start: usize, row: &[[f64; 4]]) -> bool {
        self.blocks.get(start..start + row.len()) == Some(row)
    }
}

fn hash(row: &[[f64; 4]]) -> u64 {
    let mut hasher = DefaultHasher::new();
    row.as_flattened().iter().for_each(|x| x.to_bits().hash(&mut hasher));
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::stiffness;
    use crate::basis::{Basis, NodeSupports};
    use crate::mesh::Hierarchy;
    use crate::mesh::blocks::Pattern;
    use crate::mesh::tests::{kinked, quarter_disc};

    /// A mesh refined four times, and the same mesh that does not know its shapes.
    fn with_and_without(coarse: Mesh) -> [Mesh; 2] {
        let mut hierarchy = Hierarchy::new(coarse);
        (0..4).for_each(|_| hierarchy.refine());
        let mesh = hierarchy.finest().clone();
        [Mesh { shapes: None, ..mesh.clone() }, mesh]
    }

    #[test]
    fn rows_that_repeat_are_those_of_the_triangles_themselves() {
        let kinked = || kinked(2, Pattern::Structured).build().unwrap();
        for (coarse, few) in [(kinked(), 0.4), (quarter_disc(2, Default::default()), 0.9)] {
            let materials = [Material::lame(1.5, 1.0).unwrap(), Material::lame(3.0, 2.0).unwrap()];
            let [plain, shared] = with_and_without(coarse).map(|mesh| {
                let basis = Basis::new(&NodeSupports::new(mesh.points.len()));
                stiffness(&mesh, &materials, &basis)
            });
            let size = plain.norm_inf();
            for i in 0..plain.rows() {
                assert_eq!(plain.columns_of(i), shared.columns_of(i));
                for ((_, a), (_, b)) in plain.row(i).zip(shared.row(i)) {
                    assert!((0..4).all(|k| (a[k] - b[k]).abs() < 1e-13 * size), "row {i}: {a:?} {b:?}");
                }
            }
            assert!((shared.bytes() as f64) < few * plain.bytes() as f64, "{} {}", shared.bytes(), plain.bytes());
        }
    }

    #[test]
    fn a_row_is_stored_once_unless_it_may_not_be_shared() {
        let (a, b) = ([[1.0; 4], [2.0; 4]], [[1.0; 4], [3.0; 4]]);
        let mut rows = KnownRows::default();
        for (row, may_share) in [(a, true), (b, true), (a, true), (a, false), (b, true)] {
            rows.add(&row, may_share);
        }
        assert_eq!(rows.start, [0, 2, 0, 4, 2]);
        assert_eq!(rows.blocks.len(), 6);
        // a longer row that begins like a known one is another
        rows.add(&[[1.0; 4], [2.0; 4], [0.0; 4]], true);
        assert_eq!(rows.start[5], 6);
    }
}
