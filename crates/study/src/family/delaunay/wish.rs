//! What a mesh should look like: its boundary and the length of its sides.

use super::near::Near;
use super::{at, refuse};
use signorini_contact::{Error, Point};

/// The boundary and the wished length of sides.
pub(super) struct Wish<'a> {
    /// The polygon.
    pub boundary: &'a [Point],
    /// Its sides, searchable by place.
    pub near: Near,
    /// Corners of the bounding box.
    pub bounds: [Point; 2],
    size: &'a (dyn Fn(Point) -> f64 + Sync),
}

impl<'a> Wish<'a> {
    /// Checks the size at the boundary's nodes.
    pub fn new(boundary: &'a [Point], size: &'a (dyn Fn(Point) -> f64 + Sync)) -> Result<Self, Error> {
        let bounds = boundary.iter().fold([boundary[0]; 2], |[l, u], p| [l.inf(p), u.sup(p)]);
        let wish = Self { boundary, near: Near::new(boundary, bounds), bounds, size };
        boundary.iter().try_for_each(|&p| wish.checked(p).map(drop))?;
        Ok(wish)
    }

    /// The wished length at `x`, moved into the bounding box.
    pub fn size(&self, x: Point) -> f64 {
        (self.size)(x.sup(&self.bounds[0]).inf(&self.bounds[1]))
    }

    /// The same, refused unless positive and finite.
    pub fn checked(&self, x: Point) -> Result<f64, Error> {
        let size = self.size(x);
        if size.is_finite() && size > 0.0 {
            return Ok(size);
        }
        refuse(format!(
            "the wished side length near {} is {size}; it must be positive and finite in the whole bounding box of the \
             body: check the size function",
            at(x)
        ))
    }

    /// The largest wished length at a node of the boundary.
    pub fn largest(&self) -> f64 {
        self.boundary.iter().map(|&p| self.size(p)).fold(0.0, f64::max)
    }
}
