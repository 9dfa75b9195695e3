//! Meshes, constants and errors against closed forms, and the defects that must turn a verdict.

mod boundary;
mod domain;
mod inverse;
mod strip;
mod twins;

use super::domain::{Domain, Side};
use super::ellipse::Ellipse;

/// A disc and two ellipses, from both sides.
fn domains() -> Vec<Domain> {
    let axes = [[1.0, 1.0], [1.5, 1.0], [2.0, 1.0]];
    let both = |semi_axes| [Side::Inside, Side::Outside].map(|side| Domain { ellipse: Ellipse { semi_axes }, side });
    axes.into_iter().flat_map(both).collect()
}

/// The unit disc.
fn disc() -> Domain {
    domains()[0]
}
