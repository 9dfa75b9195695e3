//! An initial distance between two bodies whose meshes share their nodes on the contact zone.
//!
//! ```text
//!        Ω'          n points out of Ω'; g(x) is measured along it. The bodies of the mesh touch along
//!   ──●──────●──     Γ_K, but count as g apart (g > 0), or as pressed into each other by −g (g < 0):
//!     ○──────○                      n·(v' − v'') ≤ g   at the nodes
//!        Ω''  │n
//! ```
//!
//! The distance is small against the bodies, as displacements are: the geometry is not changed by it.

use super::Point;
use std::fmt;
use std::sync::Arc;

/// `g(x)`, a length.
#[derive(Clone)]
pub struct InitialGap(Arc<dyn Fn(Point) -> f64 + Send + Sync>);

impl InitialGap {
    /// The distance given by a function of the point on `Γ_K`.
    pub fn new(distance: impl Fn(Point) -> f64 + Send + Sync + 'static) -> Self {
        Self(Arc::new(distance))
    }

    /// `g(x)`; whatever the function gives, NaN included.
    pub fn at(&self, x: Point) -> f64 {
        (self.0)(x)
    }
}

impl fmt::Debug for InitialGap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("InitialGap(…)")
    }
}

/// Two functions are the same if they are one.
impl PartialEq for InitialGap {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}
