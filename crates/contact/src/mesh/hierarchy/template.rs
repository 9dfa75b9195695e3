//! Where the new nodes of one macro-triangle lie: the same for all of them, so computed once for each step and then forgotten.

/// The place of a new node in its macro-triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Midpoint {
    /// On piece `piece` of macro-side `side`, counted from macro-corner `side + 1` to `side + 2`.
    OnSide { side: u32, piece: u32 },
    /// Inside, with this number among the inner ones.
    Inside(u32),
}

/// The new nodes of one refinement step, by path of the triangle and number of its side. 12 bytes for each triangle of one
/// macro-triangle, and 8 more while it is made.
pub(super) struct Template {
    /// Numbers of inner nodes; for those on a side `ON_SIDE | side · 2²⁹ | piece`.
    codes: Vec<[u32; 3]>,
}

/// Above every number of an inner node: 32 bits number all nodes of a mesh, and a macro-triangle has fewer than 2³¹ inside.
const ON_SIDE: u32 = 1 << 31;
const PIECE_BITS: u32 = 29;

/// Barycentric coordinates in units in which the midpoints of a step are whole.
type Lattice = [u32; 3];

impl Template {
    /// Of the step that halves the `pieces` pieces of each macro-side, a power of two.
    pub fn new(pieces: usize) -> Self {
        let size = 2 * pieces as u32;
        let mut numbering = Numbering { size, numbers: vec![u32::MAX; places_before(size, size) + 1], inside: 0 };
        let mut codes = Vec::with_capacity(pieces * pieces);
        numbering.descend([[size, 0, 0], [0, size, 0], [0, 0, size]], size, &mut codes);
        Self { codes }
    }

    /// How many triangles a macro-triangle has before the step.
    pub fn paths(&self) -> usize {
        self.codes.len()
    }

    /// The midpoint of side `i` of the triangle at `path`.
    pub fn midpoint(&self, path: usize, i: usize) -> Midpoint {
        let code = self.codes[path][i];
        if code & ON_SIDE == 0 {
            return Midpoint::Inside(code);
        }
        let rest = code & !ON_SIDE;
        Midpoint::OnSide { side: rest >> PIECE_BITS, piece: rest & ((1 << PIECE_BITS) - 1) }
    }
}

/// Numbers inner midpoints as they are met.
struct Numbering {
    size: u32,
    /// The number of the inner midpoint at each lattice place, once it has one.
    numbers: Vec<u32>,
    inside: u32,
}

impl Numbering {
    /// Codes of the triangles within the one with these corners, whose sides are `length` long, in the order of their paths.
    fn descend(&mut self, corners: [Lattice; 3], length: u32, codes: &mut Vec<[u32; 3]>) {
        let middle = [0, 1, 2].map(|i| middle(corners[(i + 1) % 3], corners[(i + 2) % 3]));
        if length == 2 {
            return codes.push(middle.map(|m| self.code(m)));
        }
        let ([c0, c1, c2], [m0, m1, m2]) = (corners, middle);
        for child in [[c0, m2, m1], [m2, c1, m0], [m1, m0, c2], middle] {
            self.descend(child, length / 2, codes);
        }
    }

    fn code(&mut self, m: Lattice) -> u32 {
        if let Some(side) = m.iter().position(|&x| x == 0) {
            let piece = (m[(side + 2) % 3] - 1) / 2;
            return ON_SIDE | (side as u32) << PIECE_BITS | piece;
        }
        let number = &mut self.numbers[places_before(self.size, m[1]) + m[2] as usize];
        if *number == u32::MAX {
            *number = self.inside;
            self.inside += 1;
        }
        *number
    }
}

/// The lattice places `(·, b, c)` of a triangle of this size with `b < row`: row `b` has `size + 1 − b`.
fn places_before(size: u32, row: u32) -> usize {
    let (size, row) = (size as usize, row as usize);
    row * (size + 1) - row * row.saturating_sub(1) / 2
}

fn middle(a: Lattice, b: Lattice) -> Lattice {
    [0, 1, 2].map(|k| (a[k] + b[k]) / 2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangle of four: three midpoints inside, two on each macro-side, pieces in the direction of the sides.
    #[test]
    fn the_second_step_has_three_nodes_inside() {
        let template = Template::new(2);
        assert_eq!(template.paths(), 4);
        let midpoints = |path| [0, 1, 2].map(|i| template.midpoint(path, i));
        let on = |side, piece| Midpoint::OnSide { side, piece };
        assert_eq!(midpoints(0), [Midpoint::Inside(0), on(1, 1), on(2, 0)]);
        assert_eq!(midpoints(1), [on(0, 0), Midpoint::Inside(1), on(2, 1)]);
        assert_eq!(midpoints(2), [on(0, 1), on(1, 0), Midpoint::Inside(2)]);
        assert_eq!(midpoints(3), [0, 1, 2].map(Midpoint::Inside));
    }
}
