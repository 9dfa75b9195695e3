//! What cannot be filled is refused, with the reason and the place.

use super::*;

fn message(boundary: &[[f64; 2]], size: &(dyn Fn(Point) -> f64 + Sync)) -> String {
    match fill(&points(boundary), size, 0) {
        Err(Error::Mesh(message)) => message,
        other => panic!("{boundary:?}: {other:?}"),
    }
}

#[test]
fn boundaries_that_are_no_polygons() {
    let cases: [(&[[f64; 2]], &str); 9] = [
        (&[], "at least 3 nodes"),
        (&[[0.0, 0.0], [1.0, 0.0]], "at least 3 nodes"),
        (&[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]], "counterclockwise"),
        (&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]], "nodes 0 and 3 are both at (0, 0)"),
        (&[[0.0, 0.0], [1.0, 0.0], [-0.0, 1.0], [-1.0, 0.5], [0.0, -0.0]], "nodes 0 and 4 are both"),
        (&[[0.0, 0.0], [1.0, 0.0], [f64::NAN, 1.0]], "node 2"),
        // A bow with the larger wing counterclockwise.
        (&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.5, -1.0], [0.0, 1.0]], "meets another side"),
        // A node on another side.
        (&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.0], [0.0, 2.0]], "meets another side"),
        // A corner of atan 0.2 = 11.3°.
        (&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.2]], "angle of 11.3° at (0, 0)"),
    ];
    for (boundary, words) in cases {
        let message = message(boundary, &|_| 0.3);
        assert!(message.contains(words), "{boundary:?}: {message}");
    }
}

#[test]
fn sizes_that_are_no_lengths() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for size in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(message(&square, &move |_| size).contains("positive and finite"), "{size}");
    }
    // Good on the boundary, bad inside.
    let hollow = |x: Point| 0.3 * ((x - Point::new(0.5, 0.5)).norm() - 0.3);
    assert!(message(&square, &hollow).contains("positive and finite"));
    assert!(message(&square, &|_| 1e-5).contains("ask for longer sides"));
}

#[test]
fn flat_angles_are_refused_with_place_and_angle() {
    // A side of 1 opposite to one of 0.05: whatever is inside, the triangle on the long side is flat.
    let thin = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.05], [0.0, 0.05]];
    let message = message(&thin, &|_| 0.5);
    assert!(message.contains("°, in the triangle at (") && message.contains("20°"), "{message}");
}
