//! A mesh is the same whichever way it is written.

use super::super::Place;
use super::encode::binary;
use super::*;

/// Both files were written by Gmsh, from one geometry.
#[test]
fn text_and_binary_of_gmsh_are_one_mesh() {
    let (text, bytes) = (dovetail(), Msh::read(include_bytes!("dovetail-binary.msh")).unwrap());
    assert!(text.triangles.len() == 174 && text.names.len() == 8 && !text.lines.is_empty());
    assert_eq!((&text.names, &text.entities), (&bytes.names, &bytes.entities));
    assert_eq!((&text.lines, &text.triangles), (&bytes.lines, &bytes.triangles));
    // Gmsh prints 16 digits
    assert!(text.nodes.keys().eq(bytes.nodes.keys()));
    assert!(text.nodes.values().zip(bytes.nodes.values()).all(|(a, b)| (a - b).norm() < 1e-15));
}

#[test]
fn either_order_of_bytes_is_read() {
    let text = squares(3);
    let expected = Msh::read(text.as_bytes()).unwrap();
    for big in [false, true] {
        assert_eq!(Msh::read(&binary(&text, big)).unwrap(), expected);
    }
}

/// The places of a binary file are offsets: there, a node is not finite.
#[test]
fn a_fault_in_a_binary_file_is_found_by_its_byte() {
    let mut bytes = binary(&squares(1), false);
    let nodes = bytes.windows(6).position(|w| w == b"$Nodes").unwrap() + 7;
    // 4 counts, 3 numbers and the count of the block, 4 tags
    let x = nodes + 4 * 8 + 3 * 4 + 8 + 4 * 8;
    bytes[x..x + 8].copy_from_slice(&f64::NAN.to_le_bytes());
    let error = Msh::read(&bytes).unwrap_err();
    assert_eq!(error.place, Place::Byte(x + 8));
    assert_eq!(error.message, "x is NaN");
}
