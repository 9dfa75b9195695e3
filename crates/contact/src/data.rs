//! Supports, loads and boundary data, as functions of the point.

use crate::geometry::{Point, Vec2};
use crate::mesh::Body;

/// The condition on a boundary part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// `Γ_u`: the displacement is prescribed by [`Data::displacement`].
    Fixed,
    /// `Γ_0`: no normal displacement, no tangential traction.
    Sliding,
    /// `Γτ`: the traction is given by [`Data::traction`].
    Traction,
    /// `Γτ` without traction.
    Free,
}

/// Loads and boundary data as functions of the point.
pub trait Data: Sync {
    /// Whether `body` carries a body force at all.
    fn has_body_force(&self, _body: Body) -> bool {
        false
    }
    /// `F` at `x`, force per area.
    fn body_force(&self, _body: Body, _x: Point) -> Vec2 {
        Vec2::zeros()
    }
    /// `P` at `x` on boundary part `part` with outward unit normal `normal`, force per length.
    fn traction(&self, _part: usize, _x: Point, _normal: Vec2) -> Vec2 {
        Vec2::zeros()
    }
    /// `u_D` at `x` on boundary part `part`.
    fn displacement(&self, _part: usize, _x: Point) -> Vec2 {
        Vec2::zeros()
    }
}

/// No loads and zero data.
pub struct Unloaded;

impl Data for Unloaded {}
