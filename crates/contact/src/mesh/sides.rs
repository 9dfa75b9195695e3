//! All sides of a triangulation, each once: what shares a side, what lies on the boundary.

/// The sides of a triangulation, numbered by ascending end nodes `(lower, higher)`.
pub(super) struct Sides {
    /// End nodes of each side, lower first; ascending.
    pub ends: Vec<[u32; 2]>,
    /// The number of side `i` of each triangle.
    pub of: Vec<[u32; 3]>,
    /// Side `e` belongs to `incidences[start[e]..start[e + 1]]`, ascending; `3 t + i` is side `i` of triangle `t`.
    start: Vec<u32>,
    incidences: Vec<u32>,
}

impl Sides {
    /// Sorts the `3 N` sides of `N` triangles: `O(N log N)`. Needs `3 N < 2³²`.
    pub fn new(triangles: &[[u32; 3]]) -> Self {
        let mut keys = keys(triangles);
        keys.sort_unstable();
        let mut sides = Self {
            ends: Vec::with_capacity(keys.len() / 2),
            of: vec![[0; 3]; triangles.len()],
            start: Vec::with_capacity(keys.len() / 2),
            incidences: keys.iter().map(|k| k.1).collect(),
        };
        for (position, &(key, incidence)) in keys.iter().enumerate() {
            if position == 0 || keys[position - 1].0 != key {
                sides.ends.push([(key >> 32) as u32, key as u32]);
                sides.start.push(position as u32);
            }
            sides.of[incidence as usize / 3][incidence as usize % 3] = sides.ends.len() as u32 - 1;
        }
        sides.start.push(keys.len() as u32);
        sides
    }

    /// The number of sides.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// The triangles of side `e`, each with the local number of the side in it.
    pub fn owners(&self, e: usize) -> impl ExactSizeIterator<Item = (u32, usize)> + '_ {
        self.incidences[self.start[e] as usize..self.start[e + 1] as usize].iter().map(|&k| (k / 3, k as usize % 3))
    }

    /// The number of the side with the ends `a`, `b` in either order.
    pub fn find(&self, a: u32, b: u32) -> Option<u32> {
        let found = self.ends.binary_search(&[a.min(b), a.max(b)]);
        found.ok().map(|e| e as u32)
    }
}

/// The ends of side `i` of a triangle, the triangle on the left.
pub(super) fn side_nodes(triangle: [u32; 3], i: usize) -> [u32; 2] {
    [triangle[(i + 1) % 3], triangle[(i + 2) % 3]]
}

/// `(lower end · 2³² + higher end, 3 t + i)` for each side of each triangle.
fn keys(triangles: &[[u32; 3]]) -> Vec<(u64, u32)> {
    let mut keys = Vec::with_capacity(3 * triangles.len());
    for (t, &triangle) in triangles.iter().enumerate() {
        for i in 0..3 {
            let [a, b] = side_nodes(triangle, i);
            let key = (u64::from(a.min(b)) << 32) | u64::from(a.max(b));
            keys.push((key, (3 * t + i) as u32));
        }
    }
    keys
}
