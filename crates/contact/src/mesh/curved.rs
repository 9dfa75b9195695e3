//! Which sides of a mesh are curved, and the triangles that own them.

use super::Mesh;
use super::triangulation::{at, mesh_error};
use crate::Error;
use crate::element::{CurvedElement, CurvedTriangle};
use crate::geometry::SharedCurve;

/// A side that is a piece of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvedSide {
    /// The triangle that owns it.
    pub triangle: u32,
    /// The corner opposite.
    pub apex: u8,
    /// Index into [`CurvedSides::curves`].
    pub curve: u16,
    /// Parameters of the curve at the corners `apex + 1` and `apex + 2`.
    pub span: [f64; 2],
}

/// The curved sides of a mesh.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurvedSides {
    /// What displacements are on their triangles.
    pub element: CurvedElement,
    /// The curves.
    pub curves: Vec<SharedCurve>,
    /// By ascending triangle, at most one for each.
    pub sides: Vec<CurvedSide>,
}

impl CurvedSides {
    /// The curved side of triangle `t`. `O(log n)`, and nothing to do where nothing is curved.
    #[inline]
    pub fn of(&self, t: usize) -> Option<&CurvedSide> {
        if self.sides.is_empty() {
            return None;
        }
        let found = self.sides.binary_search_by_key(&(t as u32), |s| s.triangle);
        found.ok().map(|k| &self.sides[k])
    }

    /// The number of `curve` in the list, which takes it up if it is new.
    pub(super) fn number(&mut self, curve: &SharedCurve) -> u16 {
        let known = self.curves.iter().position(|c| c == curve);
        known.unwrap_or_else(|| {
            self.curves.push(curve.clone());
            self.curves.len() - 1
        }) as u16
    }
}

impl Mesh {
    /// Triangle `t` with its exact region, if it has a curved side.
    pub fn curved_triangle(&self, t: usize) -> Option<CurvedTriangle<'_>> {
        self.curved.of(t).map(|side| CurvedTriangle {
            corners: self.corners(t),
            apex: usize::from(side.apex),
            curve: self.curved.curves[usize::from(side.curve)].as_ref(),
            span: side.span,
            element: self.curved.element,
        })
    }

    /// Every curved triangle with its number.
    pub fn curved_triangles(&self) -> impl Iterator<Item = (usize, CurvedTriangle<'_>)> {
        self.curved.sides.iter().filter_map(|s| Some((s.triangle as usize, self.curved_triangle(s.triangle as usize)?)))
    }

    /// The exact area of triangle `t`.
    pub fn area(&self, t: usize) -> f64 {
        self.curved_triangle(t).map_or_else(|| crate::element::gradients(self.corners(t)).1, |c| c.area())
    }

    /// Refuses curved triangles whose map folds at a quadrature point: a region that is not star-shaped about its apex, a
    /// map with `det J ≤ 0`.
    pub(crate) fn check_curved(&self) -> Result<(), Error> {
        for (t, triangle) in self.curved_triangles() {
            let least = triangle.least_jacobian();
            // NaN is no sound Jacobian either
            if least.is_nan() || least <= LEAST_JACOBIAN {
                let [s, a, b] = triangle.from_apex();
                return Err(mesh_error(format!(
                    "triangle {t} of {} with the apex {} and the arc from {} to {} folds: at a quadrature point its \
                     Jacobian is {least:.3e} of the chord triangle's, which must exceed {LEAST_JACOBIAN}; use smaller \
                     elements along the curve, or move the apex away from it",
                    self.body(t),
                    at(s),
                    at(a),
                    at(b)
                )));
            }
        }
        Ok(())
    }
}

/// Smallest Jacobian of a curved element, as a share of its chord triangle's.
const LEAST_JACOBIAN: f64 = 0.05;
