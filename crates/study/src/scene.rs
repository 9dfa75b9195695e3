//! A scene as the discrete problem wants it: supports, loads and boundary data, and where quadrature has to take care.

use crate::exact::derived;
use crate::study::{ExactScene, PartCondition, Scene, VectorField};
use signorini_contact::problem::{Data, Support};
use signorini_contact::quadrature::Cubature;
use signorini_contact::{Body, Point, Vec2};

impl Scene {
    /// The support of each part, in the order of the mesh's parts.
    pub fn supports(&self) -> Vec<Support> {
        let support = |condition: &PartCondition| match condition {
            PartCondition::Fixed(_) => Support::Fixed,
            PartCondition::Sliding => Support::Sliding,
            PartCondition::Traction(_) => Support::Traction,
            PartCondition::Free => Support::Free,
        };
        self.parts.iter().map(|p| support(&p.condition)).collect()
    }

    /// Where quadrature is graded and cut. With `fixed` nothing is graded: one rule for every triangle.
    pub fn cubature(&self, depth: u32, fixed: bool) -> Cubature {
        let Some(exact) = self.exact.as_ref().filter(|_| !fixed) else {
            return Cubature { depth, ..Default::default() };
        };
        Cubature { singular: exact.solution.singular_points(), breaks: exact.solution.break_lines(), depth }
    }
}

impl Data for Scene {
    fn has_body_force(&self, body: Body) -> bool {
        self.exact.is_some() || self.body_force[body.index()].is_some()
    }

    fn body_force(&self, body: Body, x: Point) -> Vec2 {
        let given = self.body_force[body.index()].as_ref().map(|force| force(x, Vec2::zeros()));
        given.or_else(|| self.exact.as_ref().map(|e| e.body_force(body, x))).unwrap_or_else(Vec2::zeros)
    }

    fn traction(&self, part: usize, x: Point, normal: Vec2) -> Vec2 {
        let part = &self.parts[part];
        let derive = || self.exact.as_ref().map_or_else(Vec2::zeros, |e| e.traction(part.body, x, normal));
        match &part.condition {
            PartCondition::Traction(given) => value_or(given.as_ref(), x, normal, derive),
            _ => Vec2::zeros(),
        }
    }

    fn displacement(&self, part: usize, x: Point) -> Vec2 {
        let part = &self.parts[part];
        let trace = || self.exact.as_ref().map_or_else(Vec2::zeros, |e| e.solution.value(part.body, x));
        match &part.condition {
            PartCondition::Fixed(given) => value_or(given.as_ref(), x, Vec2::zeros(), trace),
            _ => Vec2::zeros(),
        }
    }
}

fn value_or(given: Option<&VectorField>, x: Point, normal: Vec2, otherwise: impl Fn() -> Vec2) -> Vec2 {
    given.map_or_else(otherwise, |field| field(x, normal))
}

impl ExactScene {
    /// `F = −div τ(u)` in the exact solution's own materials.
    pub fn body_force(&self, body: Body, x: Point) -> Vec2 {
        derived::body_force(self.solution.as_ref(), &self.materials[body.index()], body, x)
    }

    /// `τ(u) n`.
    pub fn traction(&self, body: Body, x: Point, normal: Vec2) -> Vec2 {
        derived::traction(self.solution.as_ref(), &self.materials[body.index()], body, x, normal)
    }

    /// `T_n = n·τ(u')n` for the outward normal `n` of `Ω'`; not positive where the bodies press.
    pub fn contact_stress(&self, x: Point, normal: Vec2) -> f64 {
        derived::contact_stress(self.solution.as_ref(), &self.materials[0], x, normal)
    }

    /// `[u]_n = n·(u' − u'')`; negative where the bodies are apart.
    pub fn jump(&self, x: Point, normal: Vec2) -> f64 {
        derived::jump(self.solution.as_ref(), x, normal)
    }
}
