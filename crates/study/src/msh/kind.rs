//! The kinds of elements by Gmsh's numbers.

/// Line with 2 nodes.
pub const LINE: i32 = 1;
/// Triangle with 3 nodes.
pub const TRIANGLE: i32 = 2;
/// A single node.
const POINT: i32 = 15;

/// The kinds that are read.
pub const TAKEN: [i32; 3] = [LINE, TRIANGLE, POINT];

/// The kind in words.
pub fn name(number: i32) -> String {
    let known = match number {
        3 => "quadrangles with 4 nodes",
        10 | 16 => "quadrangles of second order",
        8 => "lines of second order",
        9 => "triangles of second order",
        4 => "tetrahedra",
        5 => "hexahedra",
        6 => "prisms",
        7 => "pyramids",
        20..=25 | 42..=46 => "triangles of higher order",
        26..=28 => "lines of higher order",
        _ => return format!("elements of kind {number}"),
    };
    known.into()
}

/// What to do about a kind that is not read.
pub fn instead(number: i32) -> &'static str {
    match number {
        3 | 10 | 16 => "triangles with 3 nodes are read: leave out Recombine Surface and mesh again",
        4..=7 => "the bodies are plane: save the mesh of dimension 2, gmsh -2",
        _ => {
            "triangles with 3 nodes are read: set Mesh.ElementOrder = 1; and mesh again, curves are named in the study"
        }
    }
}
