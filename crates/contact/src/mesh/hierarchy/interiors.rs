//! The nodes inside each macro-triangle: pieces of a mesh that meet along their rims alone.
//!
//! ```text
//!        o           o  on a macro-side or macro-corner
//!       / \          •  inside: every triangle around • lies in this macro-triangle, so no
//!      o---o            triangle has inner nodes of two macro-triangles.
//!     / \ / \
//!    o---•---o       Step s of the refinement puts n_s = 3·2^k(2^k−1)/2 nodes, k = s − 1, inside
//!   / \ / \ / \      each macro-triangle, one after another: one range for each step but the first.
//!  o---o---o---o
//! ```

use super::Hierarchy;
use std::ops::Range;

impl Hierarchy {
    /// The number of triangles of the coarse mesh.
    pub fn macro_triangles(&self) -> usize {
        self.levels[0].triangles.len()
    }

    /// The nodes of `level` strictly inside a macro-triangle, as disjoint ranges of node numbers in ascending order: one for
    /// each refinement step that put nodes there, so at most `level − 1`. `O(level)`.
    ///
    /// No triangle of `level` has nodes inside two macro-triangles. What no range contains lies on the macro-sides: the
    /// nodes of level 0, and of each step the first `sides · 2^(step − 1)`.
    ///
    /// # Panics
    /// If there is no such level or macro-triangle.
    pub fn interior(&self, level: usize, macro_triangle: usize) -> impl Iterator<Item = Range<usize>> + '_ {
        assert!(level < self.levels.len(), "level {level} of a hierarchy of {}", self.levels.len());
        assert!(
            macro_triangle < self.macro_triangles(),
            "macro-triangle {macro_triangle} of {}",
            self.macro_triangles()
        );
        (2..=level).map(move |step| {
            let pieces = 1 << (step - 1);
            let inside = inside(pieces);
            let rims = self.levels[step - 1].points.len() + self.macro_sides.count * pieces;
            rims + macro_triangle * inside..rims + (macro_triangle + 1) * inside
        })
    }
}

/// How many midpoints lie inside a macro-triangle whose sides have `pieces` pieces: its triangles have `3·pieces²` sides, of
/// which `3·pieces` lie on the rim and the others are shared by two.
pub(super) fn inside(pieces: usize) -> usize {
    3 * pieces * (pieces - 1) / 2
}
