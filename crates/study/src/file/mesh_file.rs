//! Where the mesh files that a study names are: beside the study, or built into the program.

use super::error::{Fault, refuse};
use super::raw::{RawMesh, RawStudy};
use super::shipped::MESHES;
use std::path::Path;
use std::sync::Arc;

/// Largest file that is read, in bytes: a coarsest mesh has its refinements before it.
const LARGEST: u64 = 1 << 28;

/// Where the names of mesh files lead.
pub enum Files<'a> {
    /// From the folder of this study file.
    Beside(&'a Path),
    /// Into the program, from this folder of `studies/`.
    Shipped(&'a str),
}

/// Reads the mesh files that the study and its cases name.
pub fn attach(raw: &mut RawStudy, files: &Files<'_>) -> Result<(), Fault> {
    let cases = raw.case.iter_mut().filter_map(|c| c.mesh.as_mut());
    for mesh in raw.mesh.iter_mut().chain(cases) {
        mesh.content = files.read(mesh)?;
    }
    Ok(())
}

impl Files<'_> {
    fn read(&self, mesh: &RawMesh) -> Result<Arc<[u8]>, Fault> {
        let name = mesh.file.get_ref();
        match self {
            Self::Shipped(folder) => {
                let path = Path::new(folder).join(name);
                let found = MESHES.iter().find(|(known, _)| path == Path::new(known));
                found.map(|(_, bytes)| Arc::from(*bytes)).ok_or_else(|| {
                    let message = format!("no mesh file `{}` was built into the program", path.display());
                    Fault::new(mesh.file.span(), message, "run the study from the folder that it came from")
                })
            }
            Self::Beside(study) => {
                let path = study.parent().unwrap_or(Path::new("")).join(name);
                match std::fs::metadata(&path).map(|m| m.len()) {
                    Ok(size) if size > LARGEST => {
                        let message =
                            format!("the mesh file `{}` has {size} bytes, more than {LARGEST}", path.display());
                        return refuse(mesh.file.span(), message, "give a coarser mesh; the program refines it");
                    }
                    _ => {}
                }
                std::fs::read(&path).map(Arc::from).map_err(|e| {
                    let message = format!("cannot read the mesh file `{}`: {e}", path.display());
                    Fault::new(mesh.file.span(), message, "give its path from the folder of the study file")
                })
            }
        }
    }
}
