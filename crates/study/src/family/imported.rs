//! The mesh of a file as the coarsest of its family.

use super::Domain;
use signorini_contact::Error;
use signorini_contact::mesh::Triangulation;

/// Both bodies as the file has them. The file's mesh is the one of `n = 1`: every side in one part.
pub(super) fn coarse(domain: &Domain, n: usize) -> Result<[Triangulation; 2], Error> {
    let [Some(first), Some(second)] = domain.shapes.each_ref().map(|s| s.imported.as_ref()) else {
        return Err(Error::Mesh(
            "a family out of a mesh file needs bodies out of a mesh file; name a `physical` of each".into(),
        ));
    };
    if n != 1 {
        return Err(Error::Mesh(format!("the mesh of a file is level 1, and the levels begin with {n}; begin with 1")));
    }
    Ok([first.mesh.clone(), second.mesh.clone()])
}

/// Refuses refinements whose triangles 32 bits cannot number.
pub(super) fn check_size(domain: &Domain, n: usize) -> Result<(), Error> {
    let coarse: usize = domain.shapes.iter().filter_map(|s| s.imported.as_ref()).map(|i| i.mesh.triangles.len()).sum();
    let (most, triangles) = (u32::MAX as usize / 8, coarse.saturating_mul(n.saturating_mul(n)));
    if triangles <= most {
        return Ok(());
    }
    Err(Error::Mesh(format!(
        "{coarse} triangles with every side in {n} parts are {triangles}; numbers of 32 bits reach to {most}: use fewer parts"
    )))
}
