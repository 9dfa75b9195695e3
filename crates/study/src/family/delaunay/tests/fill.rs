//! Properties that every filled polygon has, over shapes and seeds.

use super::*;
use std::collections::BTreeMap;

struct Case {
    name: String,
    boundary: Vec<Point>,
    size: Box<dyn Fn(Point) -> f64 + Sync>,
    /// The ratio of sides that a uniform size must reach.
    ratio: Option<f64>,
}

fn uniform(name: &str, boundary: Vec<Point>, size: f64) -> Case {
    Case { name: format!("{name} {size:.4}"), boundary, size: Box::new(move |_| size), ratio: Some(2.0) }
}

fn polygon(name: &str, corners: &[[f64; 2]], size: f64) -> Case {
    uniform(name, divided(corners, &|_| size), size)
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
const ELL: [[f64; 2]; 6] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
/// Angles 45°, 135° and more.
const SLANTED: [[f64; 2]; 4] = [[0.0, 0.0], [1.4, 0.0], [2.0, 0.6], [0.7, 0.7]];

fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for n in [1, 2, 3, 5, 8, 16, 32] {
        cases.push(polygon("square", &SQUARE, 1.0 / f64::from(n)));
    }
    for n in [4, 7, 12] {
        cases.push(polygon("L", &ELL, 1.0 / f64::from(n)));
        cases.push(polygon("slanted", &SLANTED, 0.5 / f64::from(n)));
    }
    for m in [4, 6, 9, 16, 32] {
        cases.push(uniform("inside", inside(m, chord(m)).nodes(), chord(m)));
        cases.push(uniform("outside", outside(m, chord(m)).nodes(), chord(m)));
    }
    let graded = |x: Point| 0.01 + 0.2 * x.norm();
    cases.push(Case {
        name: "graded square".into(),
        boundary: divided(&SQUARE, &graded),
        size: Box::new(graded),
        ratio: None,
    });
    let notch = |x: Point| 0.02 + 0.15 * (x - Point::new(1.0, 1.0)).norm();
    cases.push(Case { name: "graded L".into(), boundary: divided(&ELL, &notch), size: Box::new(notch), ratio: None });
    cases
}

fn filled(case: &Case, seed: u64) -> Triangulation {
    fill(&case.boundary, &case.size, seed).unwrap_or_else(|e| panic!("{}, seed {seed}: {e}", case.name))
}

/// Each directed side with the corner opposite to it.
fn directed(mesh: &Triangulation) -> BTreeMap<[u32; 2], u32> {
    let mut sides = BTreeMap::new();
    for &[a, b, c] in &mesh.triangles {
        for [i, j, k] in [[a, b, c], [b, c, a], [c, a, b]] {
            assert!(sides.insert([i, j], k).is_none(), "two triangles on one side of a side");
        }
    }
    sides
}

#[test]
fn boundary_is_kept_and_area_is_the_polygons() {
    for case in cases() {
        let mesh = filled(&case, 1);
        let n = case.boundary.len();
        assert_eq!(mesh.points[..n], case.boundary[..], "{}", case.name);
        let sides = directed(&mesh);
        let free: Vec<_> = sides.keys().copied().filter(|[i, j]| !sides.contains_key(&[*j, *i])).collect();
        let mut wanted: Vec<_> = (0..n as u32).map(|k| [k, (k + 1) % n as u32]).collect();
        wanted.sort_unstable();
        assert_eq!(free, wanted, "{}", case.name);
        let areas =
            mesh.triangles.iter().map(|t| t.map(|i| mesh.points[i as usize])).map(|[a, b, c]| twice_area(a, b, c));
        let (sum, whole) = (areas.sum::<f64>(), shoelace(&case.boundary));
        assert!((sum - whole).abs() <= 1e-12 * whole, "{}: {sum} against {whole}", case.name);
    }
}

#[test]
fn inner_sides_are_delaunay() {
    for case in cases() {
        let mesh = filled(&case, 2);
        let sides = directed(&mesh);
        for (&[a, b], &c) in &sides {
            let Some(&d) = sides.get(&[b, a]) else { continue };
            // Locally Delaunay: the angles opposite to a side sum to at most 180°.
            let [a, b, c, d] = [a, b, c, d].map(|i| mesh.points[i as usize]);
            let sum = (a - c).angle(&(b - c)) + (a - d).angle(&(b - d));
            assert!(sum <= std::f64::consts::PI + 1e-9, "{}: {} at {a}", case.name, sum.to_degrees());
        }
    }
}

#[test]
fn angles_and_side_ratios_are_bounded() {
    for case in cases() {
        for seed in 0..3 {
            let mesh = filled(&case, seed);
            let found = measure(&mesh, case.boundary.len());
            assert!(found.angle >= 20.0, "{}, seed {seed}: {found:?}", case.name);
            assert!(case.ratio.is_none_or(|r| found.ratio <= r), "{}, seed {seed}: {found:?}", case.name);
        }
    }
}

#[test]
fn blunt_corners_are_shared() {
    for case in cases() {
        let mesh = filled(&case, 3);
        let n = case.boundary.len() as u32;
        for t in &mesh.triangles {
            for k in 0..3 {
                let [a, x, b] = [0, 1, 2].map(|s| t[(k + s) % 3]);
                if a < n && x == (a + 1) % n && b == (x + 1) % n {
                    let [a, x, b] = [a, x, b].map(|i| mesh.points[i as usize]);
                    let angle = (a - x).angle(&(b - x)).to_degrees();
                    assert!(angle <= 120.0 + 1e-9, "{}: one triangle owns the corner of {angle}° at {x}", case.name);
                }
            }
        }
    }
}

#[test]
fn sizes_are_followed() {
    let size = |x: Point| 0.004 + 0.08 * x.norm();
    let boundary = divided(&SQUARE, &size);
    let mesh = fill(&boundary, &size, 4).unwrap();
    let sides = directed(&mesh);
    let share = |&[a, b]: &[u32; 2]| {
        let [a, b] = [a, b].map(|i| mesh.points[i as usize]);
        (b - a).norm() / size(0.5 * (a + b))
    };
    let (low, high) = sides.keys().map(share).fold((f64::INFINITY, 0.0), |(l, h): (f64, f64), s| (l.min(s), h.max(s)));
    assert!(low > 0.6 && high < 1.6, "{low} … {high}");
    // With triangles of the area √3/4 size², Euler's formula gives ½ (triangles + boundary nodes) + 1 nodes.
    let cells = 400;
    let at = |k: usize| (k as f64 + 0.5) / f64::from(cells);
    let density = |x: Point| 2.0 / (3.0_f64.sqrt() * size(x) * size(x) * f64::from(cells * cells));
    let whole = |f: &dyn Fn(usize) -> f64| (0..cells as usize).map(f).sum::<f64>();
    let expected = whole(&|i| whole(&|j| density(Point::new(at(i), at(j)))));
    assert!(
        (mesh.points.len() as f64 / expected - 1.0).abs() < 0.25,
        "{} nodes, {expected} expected",
        mesh.points.len()
    );
}

#[test]
fn same_input_gives_the_same_mesh() {
    let bits = |m: &Triangulation| m.points.iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect::<Vec<_>>();
    for case in cases().iter().filter(|c| c.boundary.len() > 16) {
        let [a, b] = [filled(case, 7), filled(case, 7)];
        assert_eq!((bits(&a), &a.triangles), (bits(&b), &b.triangles), "{}", case.name);
        let other = filled(case, 8);
        assert!(bits(&other) != bits(&a), "{}: the seed changes nothing", case.name);
    }
}
