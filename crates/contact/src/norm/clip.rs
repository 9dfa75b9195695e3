//! What two triangles have in common: a convex polygon of at most six corners.

use crate::geometry::{Point, cross, twice_area};

/// A convex polygon, corners counterclockwise.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polygon {
    corners: [Point; 8],
    len: usize,
}

impl Polygon {
    /// `a ∩ b` of two triangles with corners counterclockwise: `a`, cut along one side of `b` after the other (Sutherland and
    /// Hodgman 1974).
    pub fn common(a: [Point; 3], b: [Point; 3]) -> Self {
        let mut common = Self { corners: [Point::zeros(); 8], len: 0 };
        a.into_iter().for_each(|x| common.push(x));
        (0..3).fold(common, |polygon, i| polygon.left_of(b[i], b[(i + 1) % 3]))
    }

    pub fn corners(&self) -> &[Point] {
        &self.corners[..self.len]
    }

    /// The triangles from the first corner to every side.
    pub fn triangles(&self) -> impl Iterator<Item = [Point; 3]> + '_ {
        self.corners().get(1..).unwrap_or_default().windows(2).map(|w| [self.corners[0], w[0], w[1]])
    }

    pub fn area(&self) -> f64 {
        self.triangles().map(|[a, b, c]| 0.5 * twice_area(a, b, c)).sum()
    }

    /// The part on the left of the line from `a` to `b`.
    fn left_of(&self, a: Point, b: Point) -> Self {
        let height = |x: Point| cross(b - a, x - a);
        let mut left = Self { len: 0, ..*self };
        for (i, &x) in self.corners().iter().enumerate() {
            let next = self.corners[(i + 1) % self.len];
            let (here, there) = (height(x), height(next));
            if here >= 0.0 {
                left.push(x);
            }
            if (here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0) {
                left.push(x + here / (here - there) * (next - x));
            }
        }
        left
    }

    /// A cut of a convex polygon by three lines has no more than six corners, and rounding adds no more than one.
    fn push(&mut self, x: Point) {
        if self.len < self.corners.len() {
            self.corners[self.len] = x;
            self.len += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(seed: u32) -> [Point; 3] {
        let at =
            |k: u32| Point::new(f64::from(seed * 7 + k) * 0.618_034 % 1.0, f64::from(seed * 5 + k) * 0.754_878 % 1.0);
        let [a, b, c] = [at(1), at(2), at(3)];
        if twice_area(a, b, c) > 0.0 { [a, b, c] } else { [a, c, b] }
    }

    #[test]
    fn a_triangle_in_another_is_what_they_have_in_common() {
        let [a, b, c] = triangle(3);
        let middle = (a + b + c) / 3.0;
        let inner = [a, b, c].map(|x| middle + 0.5 * (x - middle));
        for common in [Polygon::common(inner, [a, b, c]), Polygon::common([a, b, c], inner)] {
            assert!((common.area() - 0.125 * twice_area(a, b, c)).abs() < 1e-15);
        }
        let away = inner.map(|x| x + Point::new(3.0, 0.0));
        assert_eq!(
            (Polygon::common(away, [a, b, c]).area(), Polygon::common(away, [a, b, c]).corners().len()),
            (0.0, 0)
        );
    }

    /// The four quarters of one triangle cover another as far as the triangle does.
    #[test]
    fn areas_in_common_add_up() {
        for seed in 0..200 {
            let (a, b) = (triangle(seed), triangle(seed + 911));
            let whole = Polygon::common(a, b);
            let parts: f64 = crate::quadrature::quarter(b).map(|part| Polygon::common(a, part).area()).iter().sum();
            assert!((whole.area() - parts).abs() < 1e-15, "{seed}");
            assert!((whole.area() - Polygon::common(b, a).area()).abs() < 1e-15, "{seed}");
            assert!(whole.corners().len() <= 6);
        }
    }
}
