//! Triangles between boundary nodes alone are seen, opened, and refused.

use super::*;
use crate::family::delaunay::clean::clean;
use crate::family::delaunay::score::{Fault, accept, fault};

#[test]
fn arc_without_inner_nodes_is_forbidden_until_opened() {
    let boundary = inside(8, chord(8)).nodes();
    let size = |_: Point| chord(8);
    let wish = Wish::new(&boundary, &size).unwrap();
    let bare = Draft::new(boundary.clone(), boundary.len()).unwrap();
    assert_eq!(bare.points.len(), boundary.len());
    let score = Score::of(&bare, &wish);
    // Every triangle has three boundary nodes; at least one owns two chords of the arc.
    assert!(score.forbidden > 0 && score.bridges > 0, "{score:?}");
    let Err(Error::Mesh(message)) = accept(&bare, &score) else { panic!("accepted") };
    assert!(message.contains("both boundary sides of a corner of more than 120°"), "{message}");

    let opened = clean(&bare, &wish).unwrap();
    assert!(opened.points.len() > bare.points.len());
    let blunt =
        |d: &Draft| d.triangles.iter().filter(|t| matches!(fault(d, **t), Fault::Corner { blunt: true, .. })).count();
    assert!(blunt(&opened) < blunt(&bare), "{} against {}", blunt(&opened), blunt(&bare));
}

#[test]
fn corners_are_judged_by_their_angle() {
    // Interior angle at node 0, and whether one triangle may own it.
    for (angle, wanted) in [(60.0, None), (74.0, None), (76.0, Some(false)), (119.0, Some(false)), (121.0, Some(true))]
    {
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        let [a, b] = [Point::new(1.0, 0.0), Point::new(2.0 * cos, 2.0 * sin)];
        let draft = Draft::new(vec![Point::zeros(), a, 2.0 * (a + b), b], 4).unwrap();
        match (fault(&draft, [0, 1, 3]), wanted) {
            (Fault::None, None) => {}
            (Fault::Corner { node, blunt, inward }, Some(wanted)) => {
                assert_eq!((node, blunt), (0, wanted), "{angle}");
                let middle = f64::to_radians(0.5 * angle).sin_cos();
                assert!(inward.norm() > 1.49 && inward.dot(&Point::new(middle.1, middle.0)) > 0.0);
            }
            (found, _) => panic!("{angle}: {found:?}"),
        }
    }
}
