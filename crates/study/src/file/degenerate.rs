//! The family whose cells become ever flatter.

use super::error::{Fault, refuse};
use super::raw::{RawFamily, TrianglesName};
use super::spanned::Spanned;
use crate::family::{Degenerate, Family};

/// `{ name = "degenerate", direction, strength, triangles }`.
pub fn degenerate(raw: &Spanned<RawFamily>) -> Result<Family, Fault> {
    let f = raw.get_ref();
    let (Some(direction), Some(strength), Some(triangles)) = (&f.direction, &f.strength, &f.triangles) else {
        let next = "give them, e.g. direction = 2, strength = 0.25, triangles = \"right\"";
        return refuse(raw.span(), "a degenerate family needs `direction`, `strength` and `triangles`", next);
    };
    let axis = *direction.get_ref();
    if !(1..=2).contains(&axis) {
        let message = format!("direction = {axis}, where blocks have the directions 1 and 2");
        return refuse(direction.span(), message, "1 runs along corner 1 → 2, 2 along corner 1 → 4");
    }
    let s = strength.get_ref().0;
    if !(0.0 < s && s <= 1.0) {
        let message = format!("strength = {s} must exceed 0 and be at most 1");
        return refuse(strength.span(), message, "with 0.25 cells of n = 16 are four times as long as wide");
    }
    let obtuse = *triangles.get_ref() == TrianglesName::Obtuse;
    Ok(Family::Degenerate(Degenerate { direction: axis - 1, strength: s, obtuse }))
}
