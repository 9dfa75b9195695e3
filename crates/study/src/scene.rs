//! A scene as the discrete problem wants it: supports, loads and boundary data, and where quadrature has to take care.

use crate::exact::derived;
use crate::family::Domain;
use crate::study::{ExactScene, PartCondition, Scene, VectorField};
use signorini_contact::geometry::LinePoint;
use signorini_contact::problem::{Data, Support};
use signorini_contact::quadrature::Cubature;
use signorini_contact::{Body, Point, Vec2};

impl Scene {
    /// What is meshed.
    pub fn domain(&self) -> Domain<'_> {
        Domain {
            shapes: &self.bodies,
            outlines: self.part_outlines(),
            contact: &self.contact,
            initial_gap: self.initial_gap.as_ref(),
            discretisation: self.discretisation,
        }
    }

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
        Cubature {
            singular: exact.solution.singular_points(),
            breaks: exact.solution.break_lines(),
            depth,
            ..Default::default()
        }
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

    /// `T_n`, or across a gap `T_ξ` per unit of `η`, at a point of the contact zone; not positive where the bodies press.
    pub fn contact_stress(&self, point: &LinePoint) -> f64 {
        derived::contact_stress_at(self.solution.as_ref(), &self.materials[0], point)
    }

    /// `n·(u' − u'') − ε`; negative where the bodies are apart.
    pub fn opening(&self, point: &LinePoint) -> f64 {
        derived::jump_at(self.solution.as_ref(), point) - point.gap
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;
    use signorini_contact::geometry::right_normal;

    /// `τ(u)n` from differences of the displacement.
    fn traction_by_differences(exact: &ExactScene, body: Body, x: Point, n: Vec2) -> Vec2 {
        let step = 1e-6;
        let along = |e: Vec2| {
            (exact.solution.value(body, x + step * e) - exact.solution.value(body, x - step * e)) / (2.0 * step)
        };
        let (dx, dy) = (along(Vec2::x()), along(Vec2::y()));
        let material = &exact.materials[body.index()];
        let s = material.stress(signorini_contact::material::strain([[dx.x, dy.x], [dx.y, dy.y]]));
        Vec2::new(s[0] * n.x + s[2] * n.y, s[2] * n.x + s[1] * n.y)
    }

    #[test]
    fn data_that_a_study_leaves_out_come_from_the_exact_solution() {
        let scene = sample::case("theorem-3-1-smooth", "structured").scene().unwrap().clone();
        let exact = scene.exact.as_ref().unwrap();
        let supports = scene.supports();
        assert!(supports.contains(&Support::Fixed) && supports.contains(&Support::Traction));
        for (k, part) in scene.parts.iter().enumerate() {
            let (a, b) = (part.along.corners[0], part.along.corners[1]);
            let (x, n) = (0.7 * a + 0.3 * b, right_normal(a, b));
            let u = exact.solution.value(part.body, x);
            match supports[k] {
                Support::Fixed => assert_eq!((scene.displacement(k, x), scene.traction(k, x, n)), (u, Vec2::zeros())),
                _ => {
                    let expected = traction_by_differences(exact, part.body, x, n);
                    assert!((scene.traction(k, x, n) - expected).norm() < 1e-8, "{}: {expected}", part.name);
                    assert_eq!(scene.displacement(k, x), Vec2::zeros());
                }
            }
        }
        assert!(Body::BOTH.into_iter().all(|body| scene.has_body_force(body)));
    }

    #[test]
    fn data_that_a_study_states_are_taken_as_they_are() {
        let scene = sample::case("two-squares", "two-squares").scene().unwrap().clone();
        let top = scene.parts.iter().position(|p| p.name == "top").unwrap();
        let load = scene.traction(top, Point::new(0.0, 1.0), Vec2::y());
        assert!((load - Vec2::new(0.0, -0.1)).norm() < 1e-15);
        assert!(Body::BOTH.into_iter().all(|body| !scene.has_body_force(body)));
        assert_eq!(scene.body_force(Body::First, Point::zeros()), Vec2::zeros());
    }

    #[test]
    fn fixed_quadrature_knows_no_singular_point() {
        let scene = sample::case("theorem-3-1-natural", "structured").scene().unwrap().clone();
        let (graded, fixed) = (scene.cubature(1, false), scene.cubature(1, true));
        assert!(!graded.singular.is_empty() && fixed.singular.is_empty() && fixed.breaks.is_empty());
        assert_eq!((graded.depth, fixed.depth), (1, 1));
    }
}
