//! The condition that picks one solution where a body may slide (Remark 3.7).
//!
//! `p(v) = ∫_Γ v_t ds = 0` on a straight part `Γ` of the boundary of one body, `t` its direction. It stands in the place of
//! the condition that the program chooses by itself.

use super::Discrete;
use crate::Error;
use crate::geometry::{Point, Segment, Vec2};
use crate::mesh::{Body, Mesh};
use crate::rigid::MEAN_IS_ZERO;

/// Share of the length of `Γ` within which sides cover it and places lie on it.
const COVERED: f64 = 1e-8;
/// `|p(y)|` below this times `∫_Γ |y|` does not see the motion `y`.
const BLIND: f64 = 1e-8;

/// `p(v) = ∫_Γ v_t ds = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlideCondition {
    /// The body whose boundary holds `Γ`.
    pub body: Body,
    /// `Γ`, from node to node; `t` is its direction.
    pub along: Segment,
}

impl SlideCondition {
    /// `∂p/∂v` at every node: `p(v) = Σ w_i·v_i`, exact for fields of the finite element space.
    ///
    /// # Errors
    /// [`Error::Boundary`] if the sides of the body on `Γ` do not cover it.
    pub fn weights(&self, mesh: &Mesh) -> Result<Vec<Vec2>, Error> {
        let t = (self.along.b - self.along.a).normalize();
        let mut weights = vec![Vec2::zeros(); mesh.points.len()];
        let mut covered = 0.0;
        for nodes in self.sides(mesh) {
            let [a, b] = nodes.map(|i| mesh.points[i as usize]);
            // ∫ v_t ds = ½ |s| t·(v_a + v_b) on a side s
            let length = (b - a).norm();
            nodes.iter().for_each(|&i| weights[i as usize] += 0.5 * length * t);
            covered += length;
        }
        let length = self.along.length();
        if (covered - length).abs() <= COVERED * length {
            return Ok(weights);
        }
        let Segment { a, b } = self.along;
        Err(Error::Boundary(format!(
            "the condition p(v) = ∫ v_t ds on ({}, {}) to ({}, {}): sides of {} cover a length of {covered} of it, not {length}; \
             let it run along the boundary of that body from node to node",
            a.x, a.y, b.x, b.y, self.body
        )))
    }

    /// The straight sides of the body on `Γ`.
    fn sides<'a>(&'a self, mesh: &'a Mesh) -> impl Iterator<Item = [u32; 2]> + 'a {
        let named = mesh.sides.iter().filter(|s| mesh.parts[usize::from(s.part)].body == self.body).map(|s| s.nodes);
        let contact = mesh.contact.iter().map(|s| [s.first, s.second][self.body.index()]);
        let on = |x: Point| self.along.distance(x) <= COVERED * self.along.length();
        named.chain(contact).filter(move |nodes| nodes.iter().all(|&i| on(mesh.points[i as usize])))
    }
}

impl Discrete {
    /// Puts `p(v) = 0` in the place of the condition that the program chose for the one motion that is free both ways.
    ///
    /// # Errors
    /// [`Error::Boundary`] if not exactly one motion is free both ways, if `p` does not see it, or if `Γ` is not covered.
    pub fn fix_slide(&mut self, mesh: &Mesh, condition: &SlideCondition) -> Result<(), Error> {
        let motions = self.qp.kernel.len();
        if motions != 1 {
            return Err(Error::Boundary(format!(
                "the condition p(v) = 0 fixes one motion that is free in both directions, and here there are {motions}; \
                 {}",
                if motions == 0 { "leave it out" } else { "support the bodies so that only the slide remains" }
            )));
        }
        let weights = condition.weights(mesh)?;
        let row = self.basis.force(&weights);
        let motion = &self.qp.kernel[0];
        let seen: f64 = row.iter().zip(motion).map(|(p, y)| p * y).sum();
        let size: f64 = row.iter().zip(motion).map(|(p, y)| (p * y).abs()).sum();
        if seen.abs() <= BLIND * size.max(f64::MIN_POSITIVE) {
            return Err(Error::Boundary(format!(
                "the condition p(v) = ∫ v_t ds vanishes on the motion that it should fix ({}); choose a part of the boundary of \
                 the body that slides, along the slide",
                self.warnings.last().map_or("", String::as_str)
            )));
        }
        self.qp.conditions =
            vec![row.iter().enumerate().filter(|(_, p)| **p != 0.0).map(|(i, p)| (i as u32, *p)).collect()];
        if let Some(remark) = self.warnings.last_mut() {
            let Segment { a, b } = condition.along;
            let ours = format!(
                "p(v) = ∫ v_t ds over ({}, {}) to ({}, {}) of {} is set to zero",
                a.x, a.y, b.x, b.y, condition.body
            );
            *remark = remark.replace(MEAN_IS_ZERO, &ours);
        }
        Ok(())
    }
}
