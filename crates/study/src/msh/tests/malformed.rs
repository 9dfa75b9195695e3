//! What is no mesh for the program, and what it says.

use super::super::body::BodyMesh;
use super::*;

/// What is replaced in two squares of one cell, by what, and the beginning of the complaint.
const FILES: &[(&str, &str, &str)] = &[
    ("$MeshFormat\n4.1 0 8", "solid cube", "line 1: the file begins with `solid`, not with $MeshFormat"),
    ("4.1 0 8", "2.2 0 8", "line 2: version `2.2` of the format, where 4.1 is read"),
    ("4.1 0 8", "4.1 0 4", "line 2: file type 0, numbers of 4 bytes"),
    ("4.1 0 8", "4.1 7 8", "line 2: file type 7, numbers of 8 bytes"),
    ("$EndMeshFormat", "$Endmeshformat", "line 3: `$Endmeshformat` where $EndMeshFormat should stand"),
    ("1 1 \"upper:contact\"", "1 1 upper", "line 6: `upper` is no name between quotation marks"),
    ("$Entities", "$Entitys", "line 17: the section `Entitys` does not end"),
    ("$Nodes\n2 8", "$Nodes\n-2 8", "line 31: `-2` is no number, where the number of blocks should stand"),
    ("\n0.0 1.0 0\n", "\n0.0 nan 0\n", "line 39: y is NaN"),
    ("\n0.0 1.0 0\n", "\n0.0 1.0 0.5\n", "line 39: node 3 lies at z = 0.5"),
    ("\n0.0 1.0 0\n", "\n0.0 one 0\n", "line 39: `one` is no number, where y should stand"),
    ("\n2\n3\n4\n", "\n2\n2\n4\n", "line 39: two nodes have the tag 2"),
    ("\n2 1 2 2\n", "\n2 1 3 2\n", "line 53: entity 1 consists of quadrangles with 4 nodes"),
    ("\n2 1 2 2\n", "\n2 1 9 2\n", "line 53: entity 1 consists of triangles of second order"),
    ("\n2 1 2 2\n", "\n2 1 4 2\n", "line 53: entity 1 consists of tetrahedra"),
    ("\n2 1 2 2\n", "\n2 1 77 2\n", "line 53: entity 1 consists of elements of kind 77"),
    ("\n1 1 2 4\n", "\n1 1 2 99\n", "line 54: element 1 has the node 99, which the file does not list"),
    ("$EndElements", "", "line 76: the end of the file where $EndElements should stand"),
    ("$EndElements", "$EndElements\n$Nodes", "line 76: a second section `$Nodes`"),
    ("$EndElements", "$EndElements\n$PartitionedEntities", "line 76: the mesh is partitioned"),
    ("$EndElements", "$EndElements\nthanks", "line 76: `thanks` where a section should begin"),
];

#[test]
fn files_that_make_no_sense_are_refused_with_their_line() {
    let text = squares(1);
    for (old, new, complaint) in FILES {
        assert!(text.contains(old), "{old} is not in\n{text}");
        let error = Msh::read(text.replacen(old, new, 1).as_bytes()).expect_err(new);
        assert!(error.to_string().starts_with(complaint), "{new}: {error}\nnot {complaint}");
        assert!(!error.next.is_empty());
    }
}

#[test]
fn files_that_end_too_early_are_refused() {
    let text = squares(1);
    for section in ["PhysicalNames", "Entities", "Nodes", "Elements"] {
        let (before, rest) = text.split_once(&format!("${section}\n")).unwrap();
        let (_, after) = rest.split_once(&format!("$End{section}\n")).unwrap();
        let error = Msh::read(format!("{before}{after}").as_bytes()).unwrap_err();
        let missing = format!("the file has no section ${section}");
        let of_nodes = error.message.contains("which the file does not list");
        assert!(error.message == missing || section == "Nodes" && of_nodes, "{error}");
    }
    for length in 0..text.len() - "$EndElements\n".len() {
        assert!(Msh::read(&text.as_bytes()[..length]).is_err(), "{length} bytes are read as a mesh");
    }
}

/// Changes to two squares of two cells that leave a sound file and no sound body.
#[test]
fn bodies_that_make_no_sense_are_refused_by_name() {
    type Change = fn(&mut Msh);
    let table: &[(Change, &str, &str)] = &[
        (|_| {}, "uper", "the file has no physical surface \"uper\""),
        (|m| m.triangles.clear(), "upper", "the physical surface \"upper\" has no triangle"),
        (
            |m| m.triangles.push(m.triangles[0]),
            "upper",
            "triangles 1, 1 of \"upper\" overlap along the side from node 1 at",
        ),
        (
            |m| {
                let [a, b, c] = m.triangles[0].nodes;
                let middle = 0.5 * (m.nodes[&a] + m.nodes[&b]);
                m.nodes.insert(c, middle);
            },
            "upper",
            "triangle 1 of \"upper\" is degenerate: twice its area is 0.000e0 at the corners node 1 at (0, 0)",
        ),
        (
            // the last triangle gets a corner of its own where another one is already
            |m| {
                let last = m.triangles.iter_mut().rfind(|t| t.entity == 1).unwrap();
                let place = m.nodes[&last.nodes[0]];
                last.nodes[0] = 1000;
                m.nodes.insert(1000, place);
            },
            "upper",
            "are two nodes at one place",
        ),
    ];
    for (change, name, complaint) in table {
        let mut msh = Msh::read(squares(2).as_bytes()).unwrap();
        change(&mut msh);
        let error = BodyMesh::new(&msh, name).expect_err(complaint);
        assert!(error.to_string().contains(complaint), "{error}");
    }
}

#[test]
fn names_that_the_file_does_not_have_are_mended() {
    let msh = dovetail();
    let next = |name| BodyMesh::new(&msh, name).unwrap_err().next;
    assert_eq!(next("tonge"), "did you mean \"tongue\"?");
    assert_eq!(next("pin"), "the file has \"tongue\", \"groove\"");
    let body = BodyMesh::new(&msh, "tongue").unwrap();
    let error = body.sides(&msh, "groove-bottom").unwrap_err();
    assert!(
        error.message.starts_with("line ") && error.message.ends_with("is no boundary side of the body \"tongue\""),
        "{error}"
    );
}

/// Clockwise triangles are turned, nodes that no triangle uses are left out: the body is the same.
#[test]
fn orientation_and_unused_nodes_are_mended() {
    let mut msh = dovetail();
    let expected = BodyMesh::new(&msh, "groove").unwrap();
    for t in msh.triangles.iter_mut().step_by(3) {
        t.nodes.swap(1, 2);
    }
    msh.nodes.insert(10_000, signorini_contact::Point::new(7.0, 7.0));
    let mended = BodyMesh::new(&msh, "groove").unwrap();
    assert_eq!((mended.mesh, mended.boundary), (expected.mesh, expected.boundary));
}
