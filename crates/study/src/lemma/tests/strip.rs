//! The strip between arc and chord: its area, and the constant against a search over many linear functions.

use super::*;
use crate::family::random::Random;
use crate::lemma::mesh::{BoundarySide, DomainMesh};
use crate::lemma::strip::{constant, ratio, strip_points};
use signorini_contact::Point;
use signorini_contact::geometry::{cross, twice_area};

fn ends(mesh: &DomainMesh, side: &BoundarySide) -> [Point; 2] {
    side.nodes.map(|i| mesh.points[i as usize])
}

#[test]
fn strips_have_the_area_of_circular_segments() {
    for domain in domains() {
        let [a, b] = domain.ellipse.semi_axes;
        for refinements in [0, 2, 6] {
            let mesh = domain.mesh(refinements);
            let side = &mesh.boundary[3];
            let mut area = 0.0;
            strip_points(&mesh.ellipse, side.angles, ends(&mesh, side), &mut |_, w| area += w);
            // ab/2 (Δt − sin Δt), the difference by its series where it cancels
            let t = side.angles[1] - side.angles[0];
            let known = 0.5 * a * b * t.powi(3) / 6.0
                * (1.0
                    - t * t / 20.0
                        * (1.0 - t * t / 42.0 * (1.0 - t * t / 72.0 * (1.0 - t * t / 110.0 * (1.0 - t * t / 156.0)))));
            assert!((area / known - 1.0).abs() < 1e-9, "{domain:?} {refinements}: {area} {known}");
        }
    }
}

/// `‖v‖²_1` over a region given by midpoints and weights, for `v = c + g·(x − x_0)`.
fn h1(points: &[(Point, f64)], c: f64, g: Point, origin: Point) -> f64 {
    points.iter().map(|(x, w)| w * ((c + g.dot(&(x - origin))).powi(2) + g.norm_squared())).sum()
}

/// Midpoints of the strip in rays from the centre of the disc: between the chord at `r = cos δ/cos φ` and the arc `r = 1`.
fn strip_of_disc(side: &BoundarySide) -> Vec<(Point, f64)> {
    const N: u32 = 120;
    let [from, to] = side.angles;
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let step = (to - from) / f64::from(N);
    let share = |k: u32| (f64::from(k) + 0.5) / f64::from(N);
    let ray = |k: u32| {
        let t = from + share(k) * (to - from);
        let chord = half.cos() / (t - middle).cos();
        let thickness = (1.0 - chord) / f64::from(N);
        (0..N).map(move |l| {
            let r = chord + share(l) * (1.0 - chord);
            (r * Point::new(t.cos(), t.sin()), step * thickness * r)
        })
    };
    (0..N).flat_map(ray).collect()
}

/// Midpoints of small triangles of a triangle.
fn points_of_triangle([a, b, c]: [Point; 3]) -> Vec<(Point, f64)> {
    const N: u32 = 60;
    let weight = 0.5 * twice_area(a, b, c) / f64::from(N * N);
    let at = |i: f64, j: f64| a + i / f64::from(N) * (b - a) + j / f64::from(N) * (c - a);
    let mut points = Vec::new();
    for i in 0..N {
        for j in 0..N - i {
            let (x, y) = (f64::from(i), f64::from(j));
            points.push((at(x + 1.0 / 3.0, y + 1.0 / 3.0), weight));
            if i + j + 1 < N {
                points.push((at(x + 2.0 / 3.0, y + 2.0 / 3.0), weight));
            }
        }
    }
    points
}

/// The constant is the largest ratio: none of many functions has a larger one, and some come close.
#[test]
fn no_linear_function_has_more_in_the_strip_than_the_constant_says() {
    for side in [Side::Inside, Side::Outside] {
        let mesh = Domain { side, ..disc() }.mesh(1);
        let arc = &mesh.boundary[0];
        let (strip, triangle) = (strip_of_disc(arc), points_of_triangle(mesh.corners(arc.triangle)));
        let bound = ratio(&mesh, arc);
        let mut random = Random::new(5, 0);
        let mut best = 0.0_f64;
        for _ in 0..1500 {
            let (c, [gx, gy]) = (random.signed(), random.in_disc());
            let (g, origin) = (Point::new(gx, gy), mesh.ellipse.at(arc.angles[0]));
            best = best.max(h1(&strip, c, g, origin) / h1(&triangle, c, g, origin));
        }
        assert!(best < 1.0005 * bound && best > 0.98 * bound, "{side:?}: {best} {bound}");
    }
}

/// On fine meshes the gradient decides: the constant is the largest ratio of the areas over `h`, up to a share of order
/// `h`.
#[test]
fn the_constant_tends_to_the_ratio_of_the_areas() {
    for domain in domains() {
        let mesh = domain.mesh(5);
        let h = mesh.quality().h;
        let areas = |s: &BoundarySide| {
            let [a, b] = ends(&mesh, s);
            let [p, q, r] = mesh.corners(s.triangle);
            // κ s³/12, with the curvature ab/|γ'|³ in the middle
            let speed = mesh.ellipse.velocity(0.5 * (s.angles[0] + s.angles[1]));
            let bend = mesh.ellipse.semi_axes[0] * mesh.ellipse.semi_axes[1] / speed.norm().powi(3);
            bend * (b - a).norm().powi(3) / 12.0 / (0.5 * cross(q - p, r - p))
        };
        let limit = mesh.boundary.iter().map(areas).fold(0.0, f64::max) / h;
        let found = constant(&mesh, h);
        assert!((found / limit - 1.0).abs() < 0.5 * h, "{domain:?}: {found} {limit}");
    }
}
