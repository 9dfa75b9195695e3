//! The pieces of the test of rigid motions, each against a case that can be seen.

use super::*;
use crate::mesh::blocks::Pattern;
use crate::mesh::tests::squares;

fn unit(k: usize) -> Vector6<f64> {
    Vector6::from_fn(|i, _| f64::from(u8::from(i == k)))
}

fn frame() -> (Mesh, Frame) {
    let mesh = squares(1, Pattern::Structured).build().unwrap();
    let frame = Frame::new(&mesh);
    (mesh, frame)
}

#[test]
fn motions_are_rigid_and_rotate_about_the_centre() {
    let (_, frame) = frame();
    // the box of both squares is (0, 1) × (−1, 1)
    assert_eq!((frame.centre, frame.radius), (Point::new(0.5, 0.0), 0.5 * 5.0f64.sqrt()));
    let q = 0.3 * unit(3) + 2.0 * unit(5);
    let (a, b) = (Point::new(0.2, -0.9), Point::new(0.8, -0.1));
    let (u, v) = (frame.at(&q, Body::Second, a), frame.at(&q, Body::Second, b));
    assert!((u - v).dot(&(a - b)).abs() < 1e-15, "distances change");
    assert_eq!(frame.at(&q, Body::First, a), Vec2::zeros());
    assert!((frame.at(&q, Body::Second, frame.centre) - Vec2::new(0.3, 0.0)).norm() < 1e-15);
}

#[test]
fn motions_are_named() {
    let (_, frame) = frame();
    assert_eq!(frame.describe(&(2.0 * unit(1))), "translation of Ω' along (0, 1)");
    assert_eq!(frame.describe(&-unit(5)), "clockwise rotation of Ω'' about (0.5, 0)");
    assert_eq!(
        frame.describe(&(unit(0) + unit(3))),
        "translation of Ω' along (1, 0) with translation of Ω'' along (1, 0)"
    );
    // y = a + θJ(x − c)/R vanishes at x = c + (R/θ)(−a_2, a_1)
    let q = 0.5 * unit(0) + unit(2);
    let fixed = frame.centre + frame.radius * Vec2::new(0.0, 0.5);
    assert!(frame.at(&q, Body::First, fixed).norm() < 1e-15);
    assert!(frame.describe(&q).contains(&format!("({}, {})", round(fixed.x), round(fixed.y))));
}

#[test]
fn what_no_row_holds_is_the_null_space() {
    let gram = Matrix6::from_diagonal(&Vector6::new(1.0, 0.0, 3.0, 1e-16, 2.0, 5.0));
    let free = null_space(&gram);
    assert_eq!(free.len(), 2);
    assert!(free.iter().all(|q| (gram * q).norm() < 1e-14 && (q.norm() - 1.0).abs() < 1e-14));
    assert_eq!(null_space(&Matrix6::zeros()).len(), 6);
}

#[test]
fn a_wedge_has_its_two_edges_as_rays() {
    // r_1·q ≤ 0 and (r_2)·q ≤ 0 in the plane of q_0 and q_1; a third row that follows from the two changes nothing
    let rows = [unit(0), unit(1) - unit(0), unit(1)];
    let mut rays = extreme_rays(&[unit(0), unit(1)], &rows);
    rays.iter_mut().for_each(|r| *r /= r.amax());
    let has = |wanted: Vector6<f64>| rays.iter().any(|r| (r - wanted).norm() < 1e-12);
    assert!(has(-unit(1)) && has(-unit(0) - unit(1)), "{rays:?}");
    assert!(rays.iter().all(|r| rows.iter().all(|row| row.dot(r) <= 1e-12)));
    // one direction: the half line that the row allows
    assert_eq!(extreme_rays(&[unit(4)], &[unit(4)]), [-unit(4)]);
    assert!(extreme_rays(&[], &rows).is_empty());
}

/// A groove of the slope `s` opens by `s` of its motion: held, free, or neither.
#[test]
fn a_groove_holds_is_flat_or_is_neither() {
    let frame = frame().1;
    let groove = |s: f64| [unit(1) - s * unit(0), unit(1) + s * unit(0)];
    let sort = |s: f64| {
        let (kernel, one_sided) = split(&[unit(0), unit(1)], &groove(s));
        (kernel.len(), refuse_nearly_free(&frame, &one_sided, &groove(s)).is_ok())
    };
    assert_eq!(sort(1e-2), (0, true));
    assert_eq!(sort(1e-6), (0, true));
    assert_eq!(sort(1e-9), (0, false));
    assert_eq!(sort(1e-14), (1, true));
    let (_, one_sided) = split(&[unit(0), unit(1)], &groove(1e-9));
    let error = refuse_nearly_free(&frame, &one_sided, &groove(1e-9)).unwrap_err().to_string();
    assert!(error.contains("translation of Ω' along (1, 0)") || error.contains("along (-1, 0)"), "{error}");
}

/// Loads that a motion does not meet do not blur its balance.
#[test]
fn a_load_on_the_other_body_blurs_nothing() {
    let (mesh, frame) = frame();
    let mut load = vec![Vec2::zeros(); mesh.points.len()];
    let heavy = mesh.node_bodies.iter().position(|b| *b == Body::Second).unwrap();
    let light = mesh.node_bodies.iter().position(|b| *b == Body::First).unwrap();
    load[heavy] = Vec2::new(1.0, 1.0);
    load[light] = Vec2::new(0.0, -1e-13);
    let judge = Judge { mesh: &mesh, frame: &frame, load: &load };
    assert!(judge.demand_pressing(&unit(1)).is_ok());
    load[light] = Vec2::new(1.0, -1e-13);
    let judge = Judge { mesh: &mesh, frame: &frame, load: &load };
    assert!(judge.demand_pressing(&unit(1)).unwrap_err().to_string().contains("limit load"));
}

#[test]
fn motions_are_split_into_those_that_leave_the_zone_closed_and_the_rest() {
    let contact = [unit(1) - unit(4)];
    let (kernel, one_sided) = split(&[unit(0), unit(1), unit(4)], &contact);
    assert_eq!((kernel.len(), one_sided.len()), (2, 1));
    assert!(kernel.iter().all(|q| contact[0].dot(q).abs() < 1e-14));
    assert!((contact[0].dot(&one_sided[0]).abs() - 2.0f64.sqrt()).abs() < 1e-14);
}
