//! The splitting against what it consists of, the residuals of the two inequalities, and its must-fail twins.

use super::*;
use crate::family::build_level;
use crate::reference::exact::Pair;
use crate::sample;
use crate::study::{Case, Scene};
use signorini_contact::mesh::Mesh;
use signorini_contact::problem::{Discrete, Problem, Solution};
use signorini_contact::solver::Settings;
use signorini_contact::solver::solve;

/// A solved level of a shipped study with an exact solution.
struct Setting {
    case: Case,
    mesh: Mesh,
    interpolant: Vec<Vec2>,
    pair: Pair,
    discrete: Discrete,
    solution: Solution,
}

impl Setting {
    fn new(study: &str, case: &str, cells: usize) -> Self {
        let case = sample::case(study, case);
        let scene = case.scene().unwrap();
        let mesh = build_level(&case.family, &scene.domain(), &[cells], 0).unwrap().hierarchy.finest().clone();
        let exact = scene.exact.as_ref().unwrap();
        let at = |(x, body): (&Vec2, &_)| exact.solution.value(*body, *x);
        let interpolant: Vec<Vec2> = mesh.points.iter().zip(&mesh.node_bodies).map(at).collect();
        let pair = Pair::new(scene, exact, &mesh, &interpolant, false).unwrap();
        let (supports, cubature) = (scene.supports(), scene.cubature(1, false));
        let problem =
            Problem { mesh: &mesh, materials: scene.materials, supports: &supports, data: scene, cubature: &cubature };
        let discrete = problem.discretise_with(pair.fine.load.clone()).unwrap();
        let raw = solve(&discrete.qp, &Settings::default());
        let solution = discrete.recover(&mesh, &scene.materials, raw);
        Self { mesh, interpolant, pair, discrete, solution, case }
    }

    fn scene(&self) -> &Scene {
        self.case.scene().unwrap()
    }

    fn forms(&self) -> Forms<'_> {
        let [_, fine] = self.pair.forms(&self.mesh, &self.scene().materials, &self.interpolant);
        fine
    }

    fn random(&self) -> Random<'_> {
        let centre = &self.solution.raw.x;
        Random { discrete: &self.discrete, mesh: &self.mesh, materials: &self.scene().materials, centre }
    }

    /// `A(e,e)`.
    fn square(&self) -> f64 {
        let d: Vec<Vec2> = self.interpolant.iter().zip(&self.solution.displacement).map(|(a, b)| a - b).collect();
        self.pair.error(&self.mesh, &self.scene().materials, &d).fine.energy
    }

    fn sides(&self, estimate: Estimate, v: Option<&[Vec2]>, v_h: &[Vec2]) -> Sides {
        Sides::new(estimate, &self.forms(), &self.solution.displacement, v, v_h, self.square())
    }

    /// `A(u, v−u) − f(v−u)` by Green's formula, from the contact stress and the reactions.
    fn residual_of_u(&self, v: &[Vec2]) -> f64 {
        self.pair.fine.contact_work(v) + self.pair.fine.reaction_work(v)
    }

    /// `A(u_h, v_h−u_h) − f(v_h−u_h) = −Σ λ_c (x_c(v_h) − x_c(u_h))`, from the multipliers.
    fn residual_of_u_h(&self, x_h: &[f64]) -> f64 {
        let raw = &self.solution.raw;
        let change =
            |(b, force): (&signorini_contact::qp::Bound, &f64)| -force * (x_h[b.dof as usize] - raw.x[b.dof as usize]);
        self.discrete.qp.bounds.iter().zip(&raw.multipliers).map(change).sum()
    }
}

const SCENES: [(&str, &str, f64); 3] = [
    ("theorem-3-1-smooth", "structured", 1e-9),
    ("theorem-3-3", "structured", 1e-8),
    ("theorem-3-4", "convex-structured", 1e-7),
];

#[test]
fn the_slack_is_the_sum_of_the_residuals_of_the_two_inequalities() {
    for (study, case, tolerance) in SCENES {
        let s = Setting::new(study, case, 6);
        let scale = s.pair.fine.solution.energy;
        for k in 0..3 {
            let distance = [0.01, 0.1, 1.0][k as usize] * scale.sqrt();
            let x_h = s.random().components(11, k, distance);
            let v_h = s.discrete.basis.displacement(&x_h);
            let v = opened(&s.discrete, &s.mesh, s.random().components(12, k, distance)).unwrap();
            let of_u_h = s.residual_of_u_h(&x_h);
            let with_u = s.sides(Estimate::General, None, &v_h);
            assert!((with_u.slack() - of_u_h).abs() < 1e-11 * scale, "{study}: {} {of_u_h}", with_u.slack());
            let both = s.sides(Estimate::General, Some(&v), &v_h);
            let expected = of_u_h + s.residual_of_u(&v);
            assert!((both.slack() - expected).abs() < tolerance * scale, "{study}: {} {expected}", both.slack());
            assert!(of_u_h >= -1e-12 * scale && s.residual_of_u(&v) >= -tolerance * scale);
            // Remark 1.3 gives away ½A(u_h − v_h, u_h − v_h)
            let halved = s.sides(Estimate::Halved, Some(&v), &v_h);
            let d: Vec<Vec2> = s.solution.displacement.iter().zip(&v_h).map(|(a, b)| a - b).collect();
            let given_away = 0.5 * s.forms().product(&d, &d);
            assert!((halved.slack() - both.slack() - given_away).abs() < 1e-9 * (scale + given_away), "{study}");
        }
    }
}

#[test]
fn with_v_the_discrete_solution_two_terms_vanish() {
    let s = Setting::new("theorem-3-1-smooth", "structured", 6);
    let (u_h, v_h) = (&s.solution.displacement, &s.interpolant);
    let general = s.sides(Estimate::General, Some(u_h), v_h);
    let contained = s.sides(Estimate::Contained, Some(u_h), v_h);
    assert!(general.terms[1].abs() < 1e-15 && general.terms[3].abs() < 1e-15);
    assert_eq!((contained.terms[1], contained.terms[3]), (0.0, 0.0));
    assert!((general.slack() - contained.slack()).abs() < 1e-15);
}

/// `δ` of a record, generous.
const DELTA: f64 = 1e-9;

#[test]
fn fields_outside_their_sets_break_it() {
    let s = Setting::new("theorem-3-1-smooth", "structured", 8);
    let u_h = &s.solution.displacement;
    let holds = |v: Option<&[Vec2]>, v_h: &[Vec2]| {
        s.sides(Estimate::General, v, v_h).record(Estimate::General, ["v", "v_h"], DELTA).holds
    };
    // the bodies overlap by 1e-4 wherever they pressed
    let penetrating = |share: f64| {
        let mut x = s.solution.raw.x.clone();
        s.discrete.qp.bounds.iter().for_each(|b| x[b.dof as usize] += share);
        s.discrete.basis.displacement(&x)
    };
    assert_eq!(holds(None, &penetrating(1e-4)), Some(false));
    assert_eq!(holds(Some(&penetrating(1e-4)), u_h), Some(false));
    // and 1e-4 apart
    assert_eq!(holds(None, &penetrating(-1e-4)), Some(true));
    assert_eq!(holds(Some(&penetrating(-1e-4)), u_h), Some(true));
}

#[test]
fn a_swapped_sign_of_any_term_breaks_it_somewhere() {
    let s = Setting::new("theorem-3-1-smooth", "structured", 8);
    // without a gap K_h is a cone: multiples of u_h are admissible, and move every term away from zero
    let times = |factor: f64| -> Vec<Vec2> { s.solution.displacement.iter().map(|u| factor * u).collect() };
    let factors = [0.8, 1.2].map(times);
    let pairs: Vec<Sides> = factors
        .iter()
        .flat_map(|v| factors.iter().map(move |v_h| (v, v_h)))
        .map(|(v, v_h)| s.sides(Estimate::General, Some(v), v_h))
        .collect();
    assert!(pairs.iter().all(|p| p.slack() > -DELTA));
    for term in 0..5 {
        let swapped = |p: &Sides| {
            let mut terms = p.terms;
            terms[term] = -terms[term];
            Sides { terms, ..*p }.slack()
        };
        assert!(pairs.iter().any(|p| swapped(p) < -10.0 * DELTA), "term {term}");
    }
}

#[test]
fn random_fields_are_admissible_and_opened_ones_overlap_nowhere() {
    for (study, case, _) in SCENES {
        let s = Setting::new(study, case, 6);
        let random = s.random();
        let x = random.components(5, 1, 0.3);
        assert!(s.discrete.qp.bounds.iter().all(|b| x[b.dof as usize] <= b.upper), "{study}");
        assert!(s.discrete.basis.fixed.iter().zip(&x).all(|(fixed, x)| !fixed || *x == 0.0), "{study}");
        assert!(random.components(5, 1, 0.3) == x && random.components(6, 1, 0.3) != x);
        let opened = opened(&s.discrete, &s.mesh, x).unwrap();
        assert_eq!(fields::overlap(&s.mesh, &opened), 0.0, "{study}");
    }
    // nodal constraints alone are not enough across a convex gap
    let s = Setting::new("theorem-3-4", "convex-structured", 6);
    assert!(fields::overlap(&s.mesh, &s.solution.displacement) > 1e-4);
}

#[test]
fn of_many_random_pairs_the_worst_is_kept() {
    let entry = |v: &str, right: f64, delta: f64| {
        Sides { terms: [right, 0.0, 0.0, 0.0, 0.0], left: 1.0 }.record(Estimate::General, [v, "v_h"], delta)
    };
    let kept = worst_of_each_kind(vec![
        entry("a", 3.0, 0.0),
        entry("b", 2.0, 0.0),
        entry("a", 1.5, 0.0),
        entry("a", 0.9, 0.5),
        entry("a", 2.0, 0.0),
        entry("b", 0.95, 0.01),
        entry("b", 0.5, 1.0),
    ]);
    let seen: Vec<_> = kept.iter().map(|s| (s.v.as_str(), s.right, s.tried, s.holds)).collect();
    // open and broken ones go before those that hold, whatever their slack
    assert_eq!(seen, [("a", 0.9, 4, Some(true)), ("b", 0.95, 3, None)]);
    let broken = entry("a", 0.5, 0.01);
    assert_eq!(broken.holds, Some(false));
    assert_eq!(entry("a", f64::NAN, 1.0).holds, Some(false));
    assert_eq!(worst_of_each_kind(vec![entry("a", 0.95, 0.01), broken])[0].right, 0.5);
}
