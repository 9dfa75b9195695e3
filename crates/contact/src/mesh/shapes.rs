//! Which triangles are copies of one another.
//!
//! Red refinement makes every triangle of a straight macro-triangle similar to it, corner by corner: three children are half its
//! size, the middle one is turned by 180° as well. The stiffness of linear functions depends on angles alone, so that of the
//! macro-triangle serves them all, to the last bit.

use super::Mesh;
use crate::geometry::Point;
use std::sync::Arc;

/// The macro-triangles that the triangles of a refined mesh are similar to. Points of such a mesh must not be moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Shapes {
    /// Corners of each macro-triangle; none where a side is curved, whose refinement bends all of it.
    corners: Arc<Vec<Option<[Point; 3]>>>,
    /// Refinements that lead from there.
    steps: u32,
}

impl Shapes {
    /// The shapes of a coarse mesh.
    pub(super) fn of_coarse(mesh: &Mesh) -> Self {
        let straight = |t: usize| mesh.curved.of(t).is_none().then(|| mesh.corners(t));
        Self { corners: Arc::new((0..mesh.triangles.len()).map(straight).collect()), steps: 0 }
    }

    /// The same after one more refinement.
    pub(super) fn refined(&self) -> Self {
        Self { steps: self.steps + 1, ..self.clone() }
    }

    /// Corners of the macro-triangles.
    pub fn corners(&self) -> &[Option<[Point; 3]>] {
        &self.corners
    }

    /// The macro-triangle of a triangle.
    pub fn of(&self, t: usize) -> usize {
        t >> (2 * self.steps)
    }
}
