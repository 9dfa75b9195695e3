//! Meshes in the format of Gmsh, version 4.1.
//!
//! [`write()`] puts any mesh of a study into the text form, with its bodies, boundary parts and contact faces as physical groups.
//! The format: C. Geuzaine, J.-F. Remacle, *Gmsh reference manual*, section “MSH file format”.

mod write;

pub use write::write;

/// The numbers of Gmsh for the elements that appear here.
pub(crate) mod kind {
    /// Line with 2 nodes.
    pub const LINE: u64 = 1;
    /// Triangle with 3 nodes.
    pub const TRIANGLE: u64 = 2;
}
