//! Points found again: in their own triangle, in a coarser mesh of the same bodies, on either side of an arc.

use super::quarter_disc;
use crate::element::CurvedElement;
use crate::geometry::{Point, Vec2};
use crate::mesh::{Body, Located, Locator, Mesh};
use crate::quadrature::Cubature;
use std::f64::consts::FRAC_PI_2;

const ZLAMAL: CurvedElement = CurvedElement::Isoparametric { skew: 0.0 };

/// Calls `visit(t, x, hats)` at quadrature points of every triangle.
fn each_point(mesh: &Mesh, visit: &mut impl FnMut(usize, Point, [f64; 3])) {
    for t in 0..mesh.triangles.len() {
        match mesh.curved_triangle(t) {
            Some(curved) => curved.points(&mut |p, _| visit(t, p.x, p.hats)),
            None => {
                let corners = mesh.corners(t);
                Cubature::default().triangle(corners, &mut |x, _| visit(t, x, crate::element::hats(corners, x)));
            }
        }
    }
}

fn linear(x: Point) -> Vec2 {
    Vec2::new(0.3 - 0.7 * x.x + 0.2 * x.y, 1.1 * x.x + 0.9 * x.y)
}

#[test]
fn a_point_is_found_in_its_own_triangle_with_the_element_s_own_values() {
    for element in [CurvedElement::Physical, ZLAMAL, CurvedElement::Isoparametric { skew: 0.2 }] {
        let mesh = quarter_disc(3, element);
        let locator = Locator::new(&mesh);
        each_point(&mesh, &mut |t, x, hats| {
            let found = locator.locate(mesh.body(t), x);
            assert_eq!((found.triangle, found.outside), (t, 0.0), "{element:?} at {x}");
            assert!((0..3).all(|k| (found.hats[k] - hats[k]).abs() < 1e-13), "{found:?} {hats:?}");
        });
    }
}

#[test]
fn every_point_of_a_finer_mesh_lies_in_a_triangle_of_a_coarser_one() {
    for element in [CurvedElement::Physical, ZLAMAL] {
        // 3 and 16 cells have next to no node in common
        let (coarse, fine) = (quarter_disc(3, element), quarter_disc(16, element));
        let locator = Locator::new(&coarse);
        let nodal: Vec<Vec2> = coarse.points.iter().map(|x| linear(*x)).collect();
        each_point(&fine, &mut |t, x, _| {
            let Located { triangle, hats, outside, .. } = locator.locate(fine.body(t), x);
            assert!(outside < 1e-14 && coarse.body(triangle) == fine.body(t), "{x} is {outside} outside");
            assert!((hats.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            let found = locator.locate(fine.body(t), x);
            if element == CurvedElement::Physical || coarse.curved.of(triangle).is_none() {
                assert!((found.value(&coarse, &nodal) - linear(x)).norm() < 1e-14);
                let gradient = found.gradient(&coarse, &nodal);
                let expected = [[-0.7, 0.2], [1.1, 0.9]];
                let off = |i: usize, j: usize| (gradient[i][j] - expected[i][j]).abs();
                assert!((0..4).all(|k| off(k / 2, k % 2) < 1e-13));
            }
        });
    }
}

/// The grid finds what a search through all triangles finds.
#[test]
fn no_other_triangle_holds_a_point_better() {
    let mesh = quarter_disc(4, CurvedElement::Physical);
    let locator = Locator::new(&mesh);
    for k in 0..2000u32 {
        // off the lattice, in and around both bodies
        let x = 2.4 * Point::new(f64::from(k) * 0.618_033_988_75 % 1.0, f64::from(k) * 0.754_877_666_25 % 1.0)
            - Point::new(0.2, 0.2);
        for body in Body::BOTH {
            let own = (0..mesh.triangles.len()).filter(|&t| mesh.body(t) == body);
            let least = own.map(|t| locator.excess(t, x)).fold(f64::INFINITY, f64::min);
            let found = locator.locate(body, x);
            assert_eq!(least <= 0.0, found.outside == 0.0, "{body} at {x}: {least} {found:?}");
            // the hull of the least excess of a far point is not unique; near the body it is the least
            assert!(found.outside <= least.max(0.0) + 0.2, "{body} at {x}: {least} {found:?}");
        }
    }
}

#[test]
fn between_chord_and_arc_a_point_belongs_to_the_body_that_bulges() {
    let mesh = quarter_disc(2, CurvedElement::Physical);
    let locator = Locator::new(&mesh);
    // four arcs of 22.5°: at the middle of one the chord is at r = cos 11.25° = 0.98
    let at = |r: f64| r * Point::new(f64::cos(FRAC_PI_2 / 8.0), f64::sin(FRAC_PI_2 / 8.0));
    let outside = |body: Body, r: f64| locator.locate(body, at(r)).outside;
    // along a ray from the apex, so at least the distance of 0.01
    assert!(outside(Body::First, 0.99) == 0.0 && (0.01..0.015).contains(&outside(Body::Second, 0.99)));
    assert!(outside(Body::Second, 1.01) == 0.0 && (0.01..0.015).contains(&outside(Body::First, 1.01)));
    // beyond the chord the physical element continues its linear function: the hat of the apex is negative
    let bulging = locator.locate(Body::First, at(0.99));
    let curved = mesh.curved_triangle(bulging.triangle).unwrap();
    assert!(bulging.hats[curved.apex] < -0.01 && bulging.hats.iter().all(|h| *h < 0.6));
    // with chords in place of arcs the same point is outside of both polygons' common side: it is the frame's
    let mut chords = mesh.clone();
    chords.curved = Default::default();
    let locator = Locator::new(&chords);
    assert!(locator.locate(Body::First, at(0.99)).outside > 5e-3);
    assert_eq!(locator.locate(Body::Second, at(0.99)).outside, 0.0);
}

#[test]
fn points_of_the_common_arc_are_found_on_both_sides() {
    for (n, element) in [(3, CurvedElement::Physical), (5, ZLAMAL)] {
        let mesh = quarter_disc(n, element);
        let locator = Locator::new(&mesh);
        for k in 0..1000 {
            let angle = (f64::from(k) + 0.5) / 1000.0 * FRAC_PI_2;
            let x = Point::new(angle.cos(), angle.sin());
            for body in Body::BOTH {
                let found = locator.locate(body, x);
                assert!(found.outside < 1e-15 && mesh.curved.of(found.triangle).is_some(), "{found:?}");
            }
        }
    }
}
