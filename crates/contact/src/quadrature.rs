//! Quadrature on triangles and sides, cut at lines where the integrand breaks and graded towards singular points.
//!
//! A *leaf* is a piece on which the integrand is smooth on the piece's own scale: its diameter is at most
//! [`GRADING`] times its distance from the nearest singular point, or it has reached the floor.

use crate::geometry::{Point, Segment, cross, twice_area};

/// A leaf may be this large relative to its distance from a singular point.
pub const GRADING: f64 = 0.6;

/// A leaf of a triangle is not cut below this diameter.
pub const TRIANGLE_FLOOR: f64 = 1e-10;

/// A leaf of a side is not cut below this length.
pub const SIDE_FLOOR: f64 = 1e-14;

/// How to integrate over triangles and sides.
#[derive(Clone, Debug, Default)]
pub struct Cubature {
    /// Points to grade towards.
    pub singular: Vec<Point>,
    /// Segments to cut at.
    pub breaks: Vec<Segment>,
    /// Every leaf is split this many more times, a triangle into four, a side into two.
    pub depth: u32,
}

impl Cubature {
    /// The same pieces, each split once more: what a quadrature error is measured against.
    pub fn finer(&self) -> Self {
        Self { depth: self.depth + 1, ..self.clone() }
    }

    /// Calls `visit(point, weight)` at the quadrature points of a triangle. Exact for polynomials of degree 5.
    pub fn triangle(&self, corners: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
        self.pieces(corners, &mut |piece| split_triangle(piece, self.depth, &mut |t| seven_points(t, visit)));
    }

    /// Calls `visit(piece)` for the pieces of a triangle on which one rule may be used: leaves, cut at the breaks.
    pub fn pieces(&self, corners: [Point; 3], visit: &mut impl FnMut([Point; 3])) {
        if self.is_leaf(diameter(&corners), TRIANGLE_FLOOR, |p| distance_to_triangle(p, &corners)) {
            self.cut_leaf(corners, visit);
        } else {
            quarter(corners).into_iter().for_each(|child| self.pieces(child, visit));
        }
    }

    /// Calls `visit(point, weight)` at the quadrature points of the side `a b`. Exact for polynomials of degree 9.
    pub fn side(&self, a: Point, b: Point, visit: &mut impl FnMut(Point, f64)) {
        let side = Segment { a, b };
        let mut cuts = vec![0.0, 1.0];
        cuts.extend(self.breaks.iter().filter_map(|cut| crossing(&side, cut)));
        let on_side = |p: &&Point| side.distance(**p) < 1e-12 * side.length();
        cuts.extend(self.singular.iter().filter(on_side).map(|&p| side.parameter(p)));
        cuts.retain(|s| (0.0..=1.0).contains(s));
        cuts.sort_by(f64::total_cmp);
        for w in cuts.windows(2).filter(|w| w[1] - w[0] > SIDE_FLOOR) {
            self.graded_side(a + w[0] * (b - a), a + w[1] * (b - a), visit);
        }
    }

    /// Cuts a leaf at the breaks that cross it. Leaves are cut, not triangles: a long sliver would be graded into far too
    /// many pieces.
    fn cut_leaf(&self, leaf: [Point; 3], visit: &mut impl FnMut([Point; 3])) {
        let own = bounding_box(&leaf);
        let mut cuts = self.breaks.iter().filter(|cut| boxes_meet(own, bounding_box(&[cut.a, cut.b]))).peekable();
        if cuts.peek().is_none() {
            return visit(leaf);
        }
        let mut pieces = vec![leaf];
        for cut in cuts {
            pieces = pieces.into_iter().flat_map(|t| cut_triangle(t, cut)).collect();
        }
        pieces.into_iter().for_each(visit);
    }

    fn graded_side(&self, a: Point, b: Point, visit: &mut impl FnMut(Point, f64)) {
        let side = Segment { a, b };
        if self.is_leaf(side.length(), SIDE_FLOOR, |p| side.distance(p)) {
            let parts = 1u32 << self.depth;
            for k in 0..parts {
                let at = |i: u32| a + (f64::from(i) / f64::from(parts)) * (b - a);
                five_points(at(k), at(k + 1), visit);
            }
        } else {
            let middle = 0.5 * (a + b);
            self.graded_side(a, middle, visit);
            self.graded_side(middle, b, visit);
        }
    }

    fn is_leaf(&self, size: f64, floor: f64, distance: impl Fn(Point) -> f64) -> bool {
        size <= floor || self.singular.iter().all(|&p| size <= GRADING * distance(p))
    }
}

/// The 7-point rule of degree 5 (Radon 1948): the centroid and two orbits at `(6 ∓ √15)/21`.
pub fn seven_points(t: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
    let area = 0.5 * twice_area(t[0], t[1], t[2]).abs();
    let centroid = (t[0] + t[1] + t[2]) / 3.0;
    visit(centroid, 9.0 / 40.0 * area);
    let root = f64::sqrt(15.0);
    for (a, w) in [((6.0 - root) / 21.0, (155.0 - root) / 1200.0), ((6.0 + root) / 21.0, (155.0 + root) / 1200.0)] {
        // Barycentric (1−2a, a, a) = centroid + (1−3a)(corner − centroid).
        for corner in t {
            visit(centroid + (1.0 - 3.0 * a) * (corner - centroid), w * area);
        }
    }
}

/// The conical product of two Gauss–Legendre rules of 6 points, exact to degree 10: for integrands that one rule of
/// degree 5 does not resolve. `x = a + s((b − a) + t(c − b))`, Jacobian `2|T| s`.
pub fn conical_points([a, b, c]: [Point; 3], visit: &mut impl FnMut(Point, f64)) {
    let twice = twice_area(a, b, c).abs();
    for (s, ws) in SIX_POINTS {
        for (t, wt) in SIX_POINTS {
            visit(a + s * ((b - a) + t * (c - b)), twice * s * ws * wt);
        }
    }
}

/// Nodes and weights of the Gauss–Legendre rule of 6 points on `(0, 1)`.
const SIX_POINTS: [(f64, f64); 6] = [
    (0.033_765_242_898_423_99, 0.085_662_246_189_585_17),
    (0.169_395_306_766_867_74, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_56, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_4, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_3, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_17),
];

/// The Gauss–Legendre rule of 5 points.
fn five_points(a: Point, b: Point, visit: &mut impl FnMut(Point, f64)) {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let length = half.norm();
    visit(middle, 128.0 / 225.0 * length);
    let (r, s) = (2.0 * f64::sqrt(10.0 / 7.0), 13.0 * f64::sqrt(70.0));
    for (x, w) in [((5.0 - r).sqrt() / 3.0, (322.0 + s) / 900.0), ((5.0 + r).sqrt() / 3.0, (322.0 - s) / 900.0)] {
        visit(middle - x * half, w * length);
        visit(middle + x * half, w * length);
    }
}

fn split_triangle(t: [Point; 3], depth: u32, visit: &mut impl FnMut([Point; 3])) {
    if depth == 0 {
        visit(t);
    } else {
        quarter(t).into_iter().for_each(|child| split_triangle(child, depth - 1, visit));
    }
}

/// The four triangles of red refinement.
pub fn quarter([a, b, c]: [Point; 3]) -> [[Point; 3]; 4] {
    let (ab, bc, ca) = (0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]]
}

fn diameter(t: &[Point; 3]) -> f64 {
    (0..3).map(|i| (t[i] - t[(i + 1) % 3]).norm()).fold(0.0, f64::max)
}

fn distance_to_triangle(p: Point, t: &[Point; 3]) -> f64 {
    let orientation = twice_area(t[0], t[1], t[2]).signum();
    if (0..3).all(|i| orientation * twice_area(t[i], t[(i + 1) % 3], p) >= 0.0) {
        return 0.0;
    }
    (0..3).map(|i| Segment { a: t[i], b: t[(i + 1) % 3] }.distance(p)).fold(f64::INFINITY, f64::min)
}

fn bounding_box(points: &[Point]) -> (Point, Point) {
    points.iter().fold((points[0], points[0]), |(low, high), p| (low.inf(p), high.sup(p)))
}

fn boxes_meet(a: (Point, Point), b: (Point, Point)) -> bool {
    (0..2).all(|k| a.0[k] <= b.1[k] && b.0[k] <= a.1[k])
}

/// The pieces of a triangle on both sides of the line through `cut`; pieces below rounding are dropped.
fn cut_triangle(t: [Point; 3], cut: &Segment) -> Vec<[Point; 3]> {
    let d = cut.b - cut.a;
    let height = t.map(|p| cross(d, p - cut.a) / d.norm());
    let tolerance = 1e-13 * diameter(&t);
    if height.iter().all(|&h| h >= -tolerance) || height.iter().all(|&h| h <= tolerance) {
        return vec![t];
    }
    [1.0, -1.0].into_iter().flat_map(|sign| fan(&half_plane_part(&t, &height.map(|h| sign * h)))).collect()
}

/// The corners of the part of the triangle where the height is not negative, in order.
fn half_plane_part(t: &[Point; 3], height: &[f64; 3]) -> Vec<Point> {
    let mut corners = Vec::with_capacity(4);
    for i in 0..3 {
        let j = (i + 1) % 3;
        if height[i] >= 0.0 {
            corners.push(t[i]);
        }
        if height[i] * height[j] < 0.0 {
            corners.push(t[i] + height[i] / (height[i] - height[j]) * (t[j] - t[i]));
        }
    }
    corners
}

fn fan(polygon: &[Point]) -> Vec<[Point; 3]> {
    (2..polygon.len()).map(|i| [polygon[0], polygon[i - 1], polygon[i]]).collect()
}

/// The parameter on `side` where the line through `cut` crosses it, if within the cut.
fn crossing(side: &Segment, cut: &Segment) -> Option<f64> {
    let (d, e) = (side.b - side.a, cut.b - cut.a);
    let det = cross(d, e);
    if det.abs() < 1e-14 * d.norm() * e.norm() {
        return None;
    }
    let s = cross(cut.a - side.a, e) / det;
    let t = cross(cut.a - side.a, d) / det;
    ((0.0..=1.0).contains(&s) && (-1e-12..=1.0 + 1e-12).contains(&t)).then_some(s)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integrate(c: &Cubature, t: [Point; 3], f: impl Fn(Point) -> f64) -> f64 {
        let mut sum = 0.0;
        c.triangle(t, &mut |x, w| sum += w * f(x));
        sum
    }

    fn unit() -> [Point; 3] {
        [Point::new(0.0, 0.0), Point::new(1.0, 0.0), Point::new(0.0, 1.0)]
    }

    fn factorial(n: u32) -> f64 {
        (1..=n).map(f64::from).product()
    }

    #[test]
    fn monomials_to_degree_five_are_exact_and_degree_six_is_not() {
        // ∫ x^p y^q over the unit triangle = p! q! / (p+q+2)!
        let error = |p: u32, q: u32| {
            let exact = factorial(p) * factorial(q) / factorial(p + q + 2);
            (integrate(&Cubature::default(), unit(), |x| x.x.powi(p as i32) * x.y.powi(q as i32)) - exact).abs()
        };
        for p in 0..=5 {
            for q in 0..=5 - p {
                assert!(error(p, q) < 1e-16, "x^{p} y^{q}: {}", error(p, q));
            }
        }
        assert!(error(6, 0) > 1e-6);
    }

    #[test]
    fn the_conical_product_is_exact_to_degree_ten() {
        let error = |p: u32, q: u32| {
            let mut sum = 0.0;
            conical_points(unit(), &mut |x, w| sum += w * x.x.powi(p as i32) * x.y.powi(q as i32));
            (sum - factorial(p) * factorial(q) / factorial(p + q + 2)).abs()
        };
        for p in 0..=10 {
            for q in 0..=10 - p {
                assert!(error(p, q) < 1e-15, "x^{p} y^{q}: {}", error(p, q));
            }
        }
        assert!(error(6, 7) > 1e-15, "degree 13 is beyond the rule: {}", error(6, 7));
    }

    #[test]
    fn sides_are_exact_to_degree_nine() {
        let (a, b) = (Point::new(1.0, 2.0), Point::new(4.0, 6.0));
        for p in 0..=10 {
            let mut sum = 0.0;
            Cubature::default().side(a, b, &mut |x, w| sum += w * ((x.x - 1.0) / 3.0).powi(p));
            let error = (sum - 5.0 / f64::from(p + 1)).abs();
            assert_eq!(error < 1e-13, p < 10, "degree {p}: {error}");
        }
    }

    #[test]
    fn a_kink_on_a_declared_line_costs_nothing() {
        let s = 0.3;
        let cut = Segment { a: Point::new(s, -1.0), b: Point::new(s, 1.0) };
        let c = Cubature { breaks: vec![cut], ..Default::default() };
        // ∫ (x−s)_+ over the unit triangle = (1−s)³/6.
        let f = |x: Point| (x.x - s).max(0.0);
        let exact = (1.0_f64 - s).powi(3) / 6.0;
        assert!((integrate(&c, unit(), f) - exact).abs() < 1e-16);
        assert!((integrate(&Cubature::default(), unit(), f) - exact).abs() > 1e-5);
        let mut sum = 0.0;
        c.side(unit()[0], unit()[1], &mut |x, w| sum += w * f(x));
        assert!((sum - 0.5 * (1.0 - s) * (1.0 - s)).abs() < 1e-16);
    }

    #[test]
    fn grading_integrates_a_singularity_inside_and_reports_its_error() {
        // ∫ r^{-1/2} over the square (−1,1)² cut into two triangles, singular point on their common diagonal.
        let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| Point::new(x, y));
        let f = |x: Point| x.norm().powf(-0.5);
        let over = |c: &Cubature| {
            integrate(c, [square[0], square[1], square[2]], f) + integrate(c, [square[0], square[2], square[3]], f)
        };
        // 8 ∫_0^{π/4} ∫_0^{1/cos θ} r^{1/2} dr dθ = (16/3) ∫_0^{π/4} cos^{-3/2} θ dθ by a fine midpoint rule.
        let n = 200_000;
        let step = std::f64::consts::FRAC_PI_4 / f64::from(n);
        let exact: f64 =
            (0..n).map(|i| ((f64::from(i) + 0.5) * step).cos().powf(-1.5) * step).sum::<f64>() * 16.0 / 3.0;
        let graded = Cubature { singular: vec![Point::zeros()], ..Default::default() };
        let error = (over(&graded) - exact).abs();
        assert!(error < 1e-5, "{error}");
        let estimate = (over(&graded) - over(&graded.finer())).abs();
        assert!(error < 3.0 * estimate + 1e-9, "{error} against the estimate {estimate}");
        assert!((over(&Cubature::default()) - exact).abs() > 1e-2, "a fixed rule must be visibly worse");
    }

    #[test]
    fn weights_sum_to_the_area_however_it_is_cut() {
        let c = Cubature {
            singular: vec![Point::new(0.2, 0.1)],
            breaks: vec![Segment { a: Point::new(-1.0, 0.35), b: Point::new(2.0, 0.1) }],
            depth: 1,
        };
        let error = (integrate(&c, unit(), |_| 1.0) - 0.5).abs();
        assert!(error < 1e-13, "{error:e}");
    }
}
