//! Strong regularity with `β = 2` on two bodies that share an arc, and on every red refinement of them.

use super::*;
use crate::family::delaunay::refined::Lengths;
use crate::family::delaunay::strong::divide;
use std::collections::BTreeMap;

/// A mesh with its curved sides, refined red with new nodes on the unit circle.
struct Refined {
    points: Vec<Point>,
    triangles: Vec<[u32; 3]>,
    curved: Vec<[u32; 2]>,
}

impl Refined {
    fn new(body: &Strong) -> Self {
        let n = body.outline.nodes().len() as u32;
        let m = body.outline.runs[0].steps as u32;
        let Triangulation { points, triangles } = body.triangulation.clone();
        Self { points, triangles, curved: (0..m).map(|k| [k, (k + 1) % n]).collect() }
    }

    fn refine(&mut self) {
        let mut middles: BTreeMap<[u32; 2], u32> = BTreeMap::new();
        let mut curved = Vec::new();
        for &[a, b] in &self.curved {
            let middle = self.points.len() as u32;
            self.points.push((self.points[a as usize] + self.points[b as usize]).normalize());
            middles.insert([a.min(b), a.max(b)], middle);
            curved.extend([[a, middle], [middle, b]]);
        }
        self.curved = curved;
        let points = &mut self.points;
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                points.push(0.5 * (points[a as usize] + points[b as usize]));
                points.len() as u32 - 1
            })
        };
        let mut fine = Vec::new();
        for &[a, b, c] in &self.triangles {
            let [k, l, m] = [middle(a, b), middle(b, c), middle(c, a)];
            fine.extend([[a, k, m], [k, b, l], [m, l, c], [k, l, m]]);
        }
        self.triangles = fine;
    }

    /// Shortest, longest straight side; shortest, longest chord.
    fn sides(&self) -> [f64; 4] {
        let curved: std::collections::BTreeSet<_> = self.curved.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        let mut range = [f64::INFINITY, 0.0, f64::INFINITY, 0.0];
        for t in &self.triangles {
            for [a, b] in [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]] {
                let length = (self.points[a as usize] - self.points[b as usize]).norm();
                let k = 2 * usize::from(curved.contains(&[a.min(b), a.max(b)]));
                range[k] = f64::min(range[k], length);
                range[k + 1] = f64::max(range[k + 1], length);
            }
        }
        range
    }
}

#[test]
fn every_refinement_of_both_bodies_keeps_ratio_and_chord() {
    for m in [4, 7, 11] {
        for seed in 0..2 {
            let bodies = strongly_regular([&inside(m, 1.0), &outside(m, 1.0)], seed).unwrap();
            let mut meshes = bodies.each_ref().map(Refined::new);
            for level in 0..4 {
                let [a, b] = meshes.each_ref().map(Refined::sides);
                let straight = [a[0].min(b[0]), a[1].max(b[1])];
                let chords = [a[2].min(b[2]), a[3].max(b[3])];
                let ratio = straight[1].max(chords[1]) / straight[0].min(chords[0]);
                let share = straight[1] / chords[1];
                let angles = meshes.each_ref().map(|r| {
                    let mesh = Triangulation { points: r.points.clone(), triangles: r.triangles.clone() };
                    measure(&mesh, bodies[0].outline.nodes().len()).angle
                });
                assert!(ratio <= 2.0, "m {m}, seed {seed}, level {level}: β = {ratio}");
                assert!(share <= 1.0, "m {m}, seed {seed}, level {level}: a straight side of {share} chords");
                assert!(angles.iter().all(|&a| a >= 20.0), "m {m}, seed {seed}, level {level}: {angles:?}");
                meshes.iter_mut().for_each(Refined::refine);
            }
        }
    }
}

#[test]
fn fresh_meshes_meet_the_bounds_at_each_size() {
    for m in [24, 36] {
        let bodies = strongly_regular([&inside(m, 1.0), &outside(m, 1.0)], 0).unwrap();
        for body in bodies {
            let [low, high] = body.sides.map(|s| s / chord(m));
            assert!(low >= 0.5 && high <= 1.0 + 1e-12, "m {m}: {low} … {high}");
            // The reported sides are those of the mesh.
            let found = measure(&body.triangulation, body.outline.nodes().len());
            assert!((found.ratio - high / low).abs() < 1e-12 && found.longest_inner <= body.sides[1]);
        }
    }
}

#[test]
fn straight_pieces_get_the_same_steps_in_both_bodies() {
    // Quotients of length and chord, with the step nearest to 1/√2 by hand: q/k against q/(k+1).
    for (q, steps) in [(0.5, 1), (0.7, 1), (0.99, 1), (1.01, 2), (1.7, 2), (1.75, 3), (7.0, 10)] {
        let length = q * chord(6);
        let lid = closed_by(arc([0.0, 1.0]), 6, &[[0.0, 1.0], [0.0, 1.0 - length], [0.0, 0.0], [1.0, 0.0]], 0.1);
        let divided = divide(&lid, chord(6)).unwrap();
        assert_eq!(divided.runs[1].steps, steps, "{q}");
        assert_eq!(divided.runs[0].steps, 6);
    }
}

#[test]
fn refusals_say_what_is_missing() {
    let message = |first: &Loop, second: &Loop| match strongly_regular([first, second], 0) {
        Err(Error::Mesh(message)) => message,
        other => panic!("{other:?}"),
    };
    let mut square = outside(1, 1.0);
    square.runs[0].piece = straight(Point::new(0.0, 1.0), Point::new(1.0, 0.0));
    assert!(message(&square, &square).contains("no side of the bodies is curved"));
    assert!(message(&inside(6, 1.0), &outside(13, 1.0)).contains("more than a factor of 2"));
    assert!(message(&inside(1, 1.0), &outside(1, 1.0)).contains("less than half of the longest chord"));
}

#[test]
fn lengths_foretell_what_refinement_makes() {
    for outline in [inside(5, chord(5)), outside(5, chord(5))] {
        let nodes = outline.nodes();
        let mesh = fill(&nodes, &|_| chord(5), 1).unwrap();
        let draft = Draft { points: mesh.points.clone(), fixed: nodes.len(), triangles: mesh.triangles.clone() };
        let foretold = Lengths::up_to(4, &draft, &outline);
        let mut refined = Refined::new(&Strong { outline, triangulation: mesh, sides: [0.0; 2] });
        let mut met = [f64::INFINITY, 0.0, f64::INFINITY, 0.0];
        for level in 0..5 {
            let scaled = refined.sides().map(|s| s * f64::from(1 << level));
            met = [met[0].min(scaled[0]), met[1].max(scaled[1]), met[2].min(scaled[2]), met[3].max(scaled[3])];
            refined.refine();
        }
        for (a, b) in foretold.straight.iter().chain(&foretold.chord).zip(met) {
            assert!((a - b).abs() < 1e-13, "{foretold:?} against {met:?}");
        }
        // Sides near the chord's length leave no room for the longer ones: not strongly regular.
        assert!(foretold.spread([foretold.chord[0], foretold.chord[1]]) > 1.0);
    }
}
