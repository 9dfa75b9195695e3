//! Named arrays, as the files of other programs take them.

use super::packed::{Packed, bytes};

/// A table of numbers with a name: rows of `components` numbers each.
pub struct Array {
    /// Its name.
    pub name: &'static str,
    /// Number of rows.
    pub rows: usize,
    /// Numbers in a row.
    pub components: usize,
    /// How NumPy names the type.
    pub numpy: &'static str,
    /// How VTK names it.
    pub vtk: &'static str,
    /// Row after row, little-endian.
    pub bytes: Vec<u8>,
}

impl Array {
    /// The rows of a list.
    pub fn new<T: Packed>(name: &'static str, list: &[T]) -> Self {
        Self { name, rows: list.len(), components: T::COMPONENTS, numpy: T::NUMPY, vtk: T::VTK, bytes: bytes(list) }
    }
}
