//! Meshes in the format of Gmsh, version 4.1.
//!
//! [`Msh::read`] takes a file, text or binary, as it stands.
//! [`write()`] puts any mesh of a study into the text form, with its bodies, boundary parts and contact faces as physical groups.
//! The format: C. Geuzaine, J.-F. Remacle, *Gmsh reference manual*, section “MSH file format”.

pub mod body;
pub mod chain;
mod cursor;
mod error;
mod kind;
mod read;
#[cfg(test)]
mod tests;
mod write;
pub mod zone;

pub use error::{MshError, Place};
pub use read::{Element, Msh};
pub use write::write;
