//! Corners of shipped scenes, and the state that a solved zone takes at them.

use super::*;
use crate::family::build_level;
use crate::sample;
use crate::study::Case;

fn found(case: &Case, zone: Option<&ZoneProfile>) -> Vec<Corner> {
    let scene = case.scene().unwrap();
    let level = build_level(&case.family, &scene.domain(), &case.quick, 0).unwrap();
    corners(scene, level.hierarchy.finest(), zone).unwrap()
}

fn at(corners: &[Corner], x: f64, y: f64) -> &Corner {
    corners
        .iter()
        .find(|c| (c.point[0] - x).abs() + (c.point[1] - y).abs() < 1e-12)
        .unwrap_or_else(|| panic!("({x}, {y})"))
}

/// A straight zone from (0, 0) to (1, 0) that presses where `presses` says so.
fn zone(presses: impl Fn(f64) -> bool) -> ZoneProfile {
    let coordinate: Vec<f64> = (0..=32).map(|i| f64::from(i) / 32.0).collect();
    ZoneProfile {
        across_gap: false,
        symmetric: false,
        points: coordinate.iter().map(|x| [*x, 0.0]).collect(),
        pressure: coordinate.iter().map(|x| if presses(*x) { 1.0 } else { 0.0 }).collect(),
        gap: vec![0.0; coordinate.len()],
        coordinate,
        reference: None,
    }
}

fn close(a: Option<f64>, b: f64) -> bool {
    a.is_some_and(|a| (a - b).abs() < 5e-5)
}

#[test]
fn the_punch_has_eight_corners() {
    let case = sample::case("theorem-3-2", "flat-punch");
    let all = found(&case, None);
    assert_eq!(all.len(), 8, "{all:#?}");
    for x in [0.0, 1.0] {
        let edge = at(&all, x, 0.0);
        assert_eq!(edge.wedges.iter().map(|w| w.angle.round()).collect::<Vec<_>>(), [90.0, 180.0]);
        assert_eq!((edge.states[0].exponent, edge.governing), (None, None));
        assert!(edge.states[1].rays == [RayState::Closed] && close(edge.states[1].exponent, 0.7740), "{edge:?}");
        let clamp = at(&all, x, 1.0);
        assert!(close(clamp.states[0].exponent, 0.7112) && clamp.governing == Some(0), "{clamp:?}");
    }
    assert_eq!(at(&all, 2.0, 0.0).states[0].exponent, None);
    assert!((crate::record::corner_rate(&all) - 0.7112).abs() < 5e-5);
}

/// Contact up to both edges, at one of them, and at neither clearly: the state decides on the rate.
#[test]
fn the_pressure_near_a_corner_decides_its_state() {
    let case = sample::case("theorem-3-2", "flat-punch");
    let edges = |presses: &dyn Fn(f64) -> bool| {
        let all = found(&case, Some(&zone(presses)));
        [0.0, 1.0].map(|x| (at(&all, x, 0.0).governing, at(&all, x, 0.0).rate()))
    };
    let [left, right] = edges(&|_| true);
    assert!(left.0 == Some(1) && right.0 == Some(1) && (left.1 - 0.774).abs() < 1e-3);
    let [left, right] = edges(&|x| x > 0.5);
    assert_eq!((left, right.0), ((Some(0), 1.0), Some(1)));
    // of the four nodes 1/32 … 4/32 two press: the smallest exponent counts
    let [left, _] = edges(&|x| x > 0.08);
    assert!(left.0.is_none() && (left.1 - 0.774).abs() < 1e-3, "{left:?}");
}

/// At the corner of a kinked zone either flank may open; the odd mode of the closed state pulls and is passed over.
#[test]
fn a_kink_has_four_states() {
    let all = found(&sample::case("theorem-3-2", "kinked"), None);
    let kink = at(&all, 0.0, 0.0);
    let angles: Vec<f64> = kink.wedges.iter().map(|w| (10.0 * w.angle).round() / 10.0).collect();
    assert_eq!(angles, [126.9, 233.1]);
    let exponents: Vec<Option<f64>> = kink.states.iter().map(|s| s.exponent).collect();
    assert_eq!(kink.states.iter().map(|s| s.rays.len()).collect::<Vec<_>>(), [2; 4]);
    // open on both sides: the groove alone, a notch of 233.1° (sin λω = −λ sin ω)
    assert!(close(exponents[0], 0.6400) && close(exponents[3], 0.5870), "{exponents:?}");
    assert_eq!(exponents[1].map(|l| (1e6 * l).round()), exponents[2].map(|l| (1e6 * l).round()), "symmetric");
    assert!(close(kink.states[3].pulling, 0.3379) && kink.describe_states().contains("would pull"));
}

#[test]
fn across_a_gap_the_ends_are_open_and_smooth_faces_have_no_corner() {
    let all = found(&sample::case("theorem-3-5", "notch"), None);
    let notch = at(&all, 1.0, 0.0);
    assert!(close(notch.states[0].exponent, 0.5445) && (notch.wedges[0].angle - 270.0).abs() < 1e-9, "{notch:?}");
    for end in all.iter().filter(|c| c.wedges.len() == 2) {
        assert!(end.states.len() == 1 && end.states[0].rays == [RayState::Open], "{end:?}");
    }
    // where the gap vanishes in the middle of a smooth face nothing is a corner
    assert!(all.iter().all(|c| c.point != [0.0, 0.0]), "{all:?}");
}
