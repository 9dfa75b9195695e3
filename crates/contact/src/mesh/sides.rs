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
    /// Sorts the `3 N` sides of `N` triangles by counting their lower ends: `O(N)` as long as few sides share an end. Needs
    /// `3 N < 2³²`.
    pub fn new(triangles: &[[u32; 3]]) -> Self {
        let buckets = Buckets::new(triangles);
        let count = buckets.list.len();
        let mut sides = Self {
            ends: Vec::with_capacity(count / 2),
            of: vec![[0; 3]; triangles.len()],
            start: Vec::with_capacity(count / 2),
            incidences: Vec::with_capacity(count),
        };
        for (lower, bucket) in buckets.iter() {
            let mut last = None;
            for &(higher, incidence) in bucket {
                if last.replace(higher) != Some(higher) {
                    sides.start.push(sides.incidences.len() as u32);
                    sides.ends.push([lower, higher]);
                }
                sides.of[incidence as usize / 3][incidence as usize % 3] = sides.ends.len() as u32 - 1;
                sides.incidences.push(incidence);
            }
        }
        sides.start.push(count as u32);
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

/// For each node `(higher end, 3 t + i)` of every side of a triangle whose lower end it is, ascending.
struct Buckets {
    /// The node's sides are `list[start[node]..start[node + 1]]`.
    start: Vec<u32>,
    list: Vec<(u32, u32)>,
}

impl Buckets {
    fn new(triangles: &[[u32; 3]]) -> Self {
        let sides = || (0..3 * triangles.len()).rev().map(|k| (side_nodes(triangles[k / 3], k % 3), k as u32));
        let nodes = triangles.iter().flatten().max().map_or(0, |&largest| largest as usize + 1);
        let mut start = vec![0; nodes + 1];
        sides().for_each(|([a, b], _)| start[a.min(b) as usize] += 1);
        // Each start is first the end of its bucket and moves down as the bucket is filled from behind.
        let mut end = 0;
        for s in &mut start {
            end += *s;
            *s = end;
        }
        let mut list = vec![(0, 0); 3 * triangles.len()];
        for ([a, b], k) in sides() {
            let place = &mut start[a.min(b) as usize];
            *place -= 1;
            list[*place as usize] = (a.max(b), k);
        }
        let mut buckets = Self { start, list };
        for node in 0..nodes {
            let range = buckets.start[node] as usize..buckets.start[node + 1] as usize;
            buckets.list[range].sort_unstable();
        }
        buckets
    }

    fn iter(&self) -> impl Iterator<Item = (u32, &[(u32, u32)])> {
        let bucket = |w: &[u32]| &self.list[w[0] as usize..w[1] as usize];
        (0..).zip(self.start.windows(2).map(bucket))
    }
}
