//! Where the new nodes of one macro-triangle lie: the same for all of them, so computed once per level.

/// The place of a new node in its macro-triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Midpoint {
    /// On piece `piece` of macro-side `side`, counted from macro-corner `side + 1` to `side + 2`.
    OnSide { side: u32, piece: u32 },
    /// Inside, with this number among the inner ones.
    Inside(u32),
}

/// Barycentric coordinates in units of `2^{-k}`.
type Lattice = [u32; 3];

/// The new nodes of one refinement step, by path of the triangle and number of its side.
#[derive(Clone, Debug)]
pub(super) struct Template {
    /// Corners of the triangle at each path, on the lattice of this level.
    corners: Vec<[Lattice; 3]>,
    /// The midpoint of each side of the triangle at each path.
    pub midpoints: Vec<[Midpoint; 3]>,
    /// How many midpoints lie inside the macro-triangle.
    pub inside: usize,
}

impl Template {
    /// The template of a macro-triangle as it is.
    pub fn new() -> Self {
        Self::of(vec![[[1, 0, 0], [0, 1, 0], [0, 0, 1]]])
    }

    /// The template after one more refinement.
    pub fn refine(&self) -> Self {
        let children = self.corners.iter().flat_map(|&c| {
            // The lattice of the next level is twice as fine: a corner doubles, a midpoint is the sum of the ends.
            let double = c.map(|x| sum(x, x));
            let m = [sum(c[1], c[2]), sum(c[2], c[0]), sum(c[0], c[1])];
            [[double[0], m[2], m[1]], [m[2], double[1], m[0]], [m[1], m[0], double[2]], m]
        });
        Self::of(children.collect())
    }

    fn of(corners: Vec<[Lattice; 3]>) -> Self {
        let pieces = corners[0][0].iter().sum::<u32>() as usize;
        // Number of the inner midpoint at lattice place (·, b, c), once it has one.
        let mut numbers = vec![u32::MAX; (2 * pieces + 1).pow(2)];
        let mut inside = 0;
        let mut place = |m: Lattice| match m.iter().position(|&x| x == 0) {
            Some(side) => {
                let piece = (m[(side + 2) % 3] - 1) / 2;
                Midpoint::OnSide { side: side as u32, piece }
            }
            None => {
                let number = &mut numbers[m[1] as usize * (2 * pieces + 1) + m[2] as usize];
                if *number == u32::MAX {
                    *number = inside;
                    inside += 1;
                }
                Midpoint::Inside(*number)
            }
        };
        let midpoints = corners.iter().map(|c| [0, 1, 2].map(|i| place(sum(c[(i + 1) % 3], c[(i + 2) % 3])))).collect();
        Self { midpoints, inside: inside as usize, corners }
    }
}

fn sum(a: Lattice, b: Lattice) -> Lattice {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
