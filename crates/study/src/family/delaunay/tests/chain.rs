//! Blocks → outer loop.

use super::*;

/// A block with straight sides.
fn block(corners: [[f64; 2]; 4], cells: [usize; 2]) -> BlockOutline {
    let corners = corners.map(|[x, y]| Point::new(x, y));
    BlockOutline { sides: [0, 1, 2, 3].map(|k| straight(corners[k], corners[(k + 1) % 4])), cells }
}

fn cell(i: i32, j: i32) -> BlockOutline {
    let (x, y) = (f64::from(i), f64::from(j));
    block([[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]], [2, 3])
}

fn message(blocks: &[BlockOutline]) -> String {
    match outer_loop(blocks) {
        Err(Error::Mesh(message)) => message,
        other => panic!("{other:?}"),
    }
}

#[test]
fn three_blocks_of_an_l() {
    let chain = outer_loop(&[cell(0, 0), cell(1, 0), cell(0, 1)]).unwrap();
    let corners: Vec<_> = chain.runs.iter().map(|r| r.piece.point(0.0)).collect();
    let wanted = [[0., 0.], [1., 0.], [2., 0.], [2., 1.], [1., 1.], [1., 2.], [0., 2.], [0., 1.]];
    assert_eq!(corners, points(&wanted));
    assert_eq!(chain.runs.iter().map(|r| r.steps).collect::<Vec<_>>(), [2, 2, 3, 2, 3, 2, 3, 3]);
    let nodes = chain.nodes();
    assert_eq!(nodes.len(), 20);
    assert!((shoelace(&nodes) - 6.0).abs() < 1e-14);
}

#[test]
fn two_blocks_around_an_arc() {
    // The square (0,2)² without the unit disc, cut along the diagonal.
    let [a, b] = [Point::new(0.5_f64.sqrt(), 0.5_f64.sqrt()), Point::new(2.0, 2.0)];
    let [e, f, g, h] = [[1.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 1.0]].map(|[x, y]| Point::new(x, y));
    let first =
        BlockOutline { sides: [straight(e, f), straight(f, b), straight(b, a), arc([0.5, 0.0])], cells: [4, 5] };
    let second =
        BlockOutline { sides: [arc([1.0, 0.5]), straight(a, b), straight(b, g), straight(g, h)], cells: [5, 4] };
    let chain = outer_loop(&[first, second]).unwrap();
    assert_eq!(chain.runs.iter().map(|r| r.steps).collect::<Vec<_>>(), [4, 5, 5, 4, 5, 5]);
    assert_eq!(chain.runs.iter().filter(|r| r.piece.curve().is_some()).count(), 2);
    let [low, high] = chain.chords().unwrap();
    assert!((low - chord(10)).abs() < 1e-14 && (high - chord(10)).abs() < 1e-14);
    // 4 − ½ · 10 sin 9°, twice: the polygon of the chords.
    let area = 4.0 - 5.0 * (FRAC_PI_2 / 10.0).sin();
    assert!((0.5 * shoelace(&chain.nodes()) - area).abs() < 1e-13);
}

#[test]
fn bodies_without_one_outer_loop() {
    let ring: Vec<_> = (0..9).filter(|&k| k != 4).map(|k| cell(k % 3, k / 3)).collect();
    assert!(message(&ring).contains("second boundary"));
    assert!(message(&[cell(0, 0), cell(2, 0)]).contains("second boundary"));
    assert!(message(&[cell(0, 0), cell(1, 1)]).contains("touches itself at (1, 1)"));
    assert!(message(&[]).contains("no blocks"));
    let mut empty = cell(0, 0);
    empty.cells[1] = 0;
    assert!(message(&[empty]).contains("side 1 of block 0"));
    // A large block beside a small one shares half a side.
    let large = block([[1.0, 0.0], [3.0, 0.0], [3.0, 2.0], [1.0, 2.0]], [1, 1]);
    assert!(message(&[cell(0, 0), large]).contains("touches itself at (1, 0)"));
    let mut open = cell(0, 0);
    open.sides[2] = straight(Point::new(1.0, 1.0), Point::new(0.0, 1.5));
    assert!(message(&[open]).contains("stops at (0, 1.5)"));
}
