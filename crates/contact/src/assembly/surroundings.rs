//! Which triangles lie around each node.

use crate::mesh::Mesh;

/// The triangles around node `i` are `list[start[i]..start[i + 1]]`, ascending; `3 t + k` stands for corner `k` of triangle `t`.
/// 4 bytes per corner of a triangle and 4 per node.
pub(super) struct Surroundings {
    start: Vec<u32>,
    list: Vec<u32>,
}

impl Surroundings {
    /// Lists the triangles around every node by counting. `O(N)`. Needs `3 N < 2³²`.
    pub fn new(mesh: &Mesh) -> Self {
        let mut start = vec![0u32; mesh.points.len() + 1];
        let corners = mesh.triangles.as_flattened();
        corners.iter().for_each(|&i| start[i as usize] += 1);
        // Each start is first the end of its list and moves down as the list is filled from behind.
        let mut end = 0;
        for s in &mut start {
            end += *s;
            *s = end;
        }
        let mut list = vec![0; corners.len()];
        for (incidence, &i) in corners.iter().enumerate().rev() {
            start[i as usize] -= 1;
            list[start[i as usize] as usize] = incidence as u32;
        }
        Self { start, list }
    }

    /// The triangles around a node, ascending, each with the node's corner.
    pub fn of(&self, node: usize) -> impl ExactSizeIterator<Item = (usize, usize)> + '_ {
        let range = self.start[node] as usize..self.start[node + 1] as usize;
        self.list[range].iter().map(|&k| (k as usize / 3, k as usize % 3))
    }
}
