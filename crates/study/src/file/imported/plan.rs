//! Family and levels of a mesh out of a file.

use super::super::error::{Fault, refuse};
use super::super::raw::{FamilyName, RawFamily, RawLevels, RawReference, ReferenceName};
use crate::family::Family;
use crate::file::spanned::Spanned;
use std::ops::Range;

/// The family of a mesh out of a file is its own red refinement.
pub fn family(raw: Option<&Spanned<RawFamily>>) -> Result<Family, Fault> {
    let Some(raw) = raw else { return Ok(Family::Imported) };
    let f = raw.get_ref();
    let others = f.seed.is_some() || f.amount.is_some() || f.coarse.is_some();
    if f.name == FamilyName::Refined && !others {
        return Ok(Family::Imported);
    }
    refuse(raw.span(), "the family of a mesh file is its own refinement", "leave [family] out")
}

/// Levels count the parts of each side of the file's mesh: powers of two from 1 on, and no default would fit every file.
pub fn check_levels(
    levels: Option<&RawLevels>,
    reference: Option<&Spanned<RawReference>>,
    place: Range<usize>,
) -> Result<(), Fault> {
    let lists = levels.and_then(|l| Some([l.quick.as_ref()?, l.full.as_ref()?]));
    let Some(lists) = lists else {
        let message = "a mesh out of a file needs `quick` and `full` in [levels]";
        return refuse(place, message, "count the parts of each side of the file's mesh, e.g. quick = [1, 2, 4, 8]");
    };
    if let Some(list) = lists.into_iter().find(|l| l.get_ref().first() != Some(&1)) {
        let message = format!("the levels {:?} do not begin with 1, the mesh of the file", list.get_ref());
        return refuse(list.span(), message, "count the parts of each side of the file's mesh, e.g. [1, 2, 4, 8]");
    }
    match reference.filter(|r| r.get_ref().kind == ReferenceName::Overkill) {
        Some(r) if r.get_ref().quick.is_none() || r.get_ref().full.is_none() => {
            let message = "an overkill reference on a mesh out of a file needs `quick` and `full`";
            refuse(
                r.span(),
                message,
                "give the parts of each side of the file's mesh: several times those of the finest level",
            )
        }
        _ => Ok(()),
    }
}
