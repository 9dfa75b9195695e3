//! Cells that become flatter as they become smaller: the smallest angle falls like `h`, so the family is not regular.
//!
//! ```text
//!  right                obtuse             n cells per unit along a row, n k across, k ≈ strength · n:
//!  +---+---+---+        +---+---+---+      sides 1/n and 1/(n k), angles down to about 1/k
//!  | / | / | / |        +-+---+---+-+
//!  +---+---+---+        +---+---+---+
//! ```
//!
//! Right triangles keep their largest angle at 90° however flat they are; with the rows staggered the largest angle tends to
//! 180°.

use signorini_contact::mesh::blocks::Pattern;

/// How the cells of a degenerate family are squeezed and cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Degenerate {
    /// The direction of the blocks that is divided more finely: 0 along corner 1 → 2, 1 along 1 → 4.
    pub direction: usize,
    /// Cells are `strength · n` times as long as they are wide, or as wide as long where that is less than 1.
    pub strength: f64,
    /// Whether rows are staggered, so that the largest angle tends to 180°.
    pub obtuse: bool,
}

impl Degenerate {
    /// How the cells are cut.
    pub fn pattern(&self) -> Pattern {
        if self.obtuse { Pattern::Staggered(self.direction) } else { Pattern::Structured }
    }

    /// The divisions of a block with `divisions` per unit of `n`.
    pub fn cells(&self, divisions: [usize; 2], n: usize) -> [usize; 2] {
        let mut cells = divisions.map(|d| d.saturating_mul(n));
        let flatness = (self.strength * n as f64).round().max(1.0);
        cells[self.direction] = cells[self.direction].saturating_mul(flatness as usize);
        cells
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::family::{Family, build_level};
    use crate::sample;
    use signorini_contact::mesh::Mesh;

    fn angles(mesh: &Mesh) -> [f64; 2] {
        let of = |t: usize| {
            let c = mesh.corners(t);
            [0, 1, 2].map(|k| {
                let (a, b) = (c[(k + 1) % 3] - c[k], c[(k + 2) % 3] - c[k]);
                (a.dot(&b) / (a.norm() * b.norm())).acos().to_degrees()
            })
        };
        let all: Vec<f64> = (0..mesh.triangles.len()).flat_map(of).collect();
        [all.iter().copied().fold(180.0, f64::min), all.iter().copied().fold(0.0, f64::max)]
    }

    fn mesh(study: &str, case: &str, direction: usize, obtuse: bool, n: usize) -> Mesh {
        let case = sample::case(study, case);
        let family = Family::Degenerate(Degenerate { direction, strength: 0.5, obtuse });
        let level = build_level(&family, &case.scene().unwrap().domain(), &[n], 0).unwrap();
        level.hierarchy.finest().clone()
    }

    #[test]
    fn the_smallest_angle_halves_with_h() {
        for (n, flatness) in [(4, 2.0_f64), (8, 4.0), (16, 8.0)] {
            let smallest = (1.0 / flatness).atan().to_degrees();
            let right = mesh("theorem-3-1-smooth", "structured", 1, false, n);
            let [least, most] = angles(&right);
            assert!((least - smallest).abs() < 1e-9 && (most - 90.0).abs() < 1e-9, "{n}: {least} {most}");
            let obtuse = mesh("theorem-3-1-smooth", "structured", 1, true, n);
            let [_, most] = angles(&obtuse);
            // an isosceles triangle with base 1/n and height 1/(n k): its apex sees the base under 2 atan(k/2)
            assert!(most >= 2.0 * (0.5 * flatness).atan().to_degrees() - 1e-9, "{n}: {most}");
            assert_eq!(obtuse.triangles.len(), right.triangles.len());
        }
    }

    /// Bodies are filled whatever the cells look like, and the two bodies still match.
    #[test]
    fn squeezed_meshes_fill_their_bodies() {
        for (study, case, direction) in [
            ("theorem-3-1-smooth", "structured", 1),
            ("theorem-3-3", "structured", 0),
            ("theorem-3-4", "convex-structured", 0),
        ] {
            for obtuse in [false, true] {
                let mesh = mesh(study, case, direction, obtuse, 6);
                let area: f64 = (0..mesh.triangles.len())
                    .map(|t| {
                        let [a, b, c] = mesh.corners(t);
                        let twice = (b - a).perp(&(c - a));
                        assert!(twice > 0.0, "{study}: triangle {t}");
                        0.5 * twice
                    })
                    .sum();
                assert!(area > 1.0 && !mesh.contact.is_empty(), "{study}: {area}");
                if study == "theorem-3-1-smooth" {
                    assert!((area - 2.0).abs() < 1e-12, "{area}");
                }
            }
        }
    }
}
