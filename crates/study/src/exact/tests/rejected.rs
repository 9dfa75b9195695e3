//! Broken solutions, each of which must be refused for its own reason.

use super::derivatives::{P_AS_TEXT, expressions};
use super::*;
use crate::exact::verify::{Condition, VerifyError, verify};
use crate::exact::{Expressions, Field, Jet, Jet2};
use crate::expr::Real;
use signorini_contact::{Body, Vec2, geometry::Segment};

fn refused(exact: &dyn Exact) -> VerifyError {
    verify(exact, &materials(PAIRS[0]), &line()).expect_err("this solution is broken")
}

/// P with one piece of its text replaced in every component.
fn changed(from: &str, to: &str) -> Expressions {
    let texts = P_AS_TEXT.map(|b| b.map(|t| t.replace(from, to)));
    expressions([[&texts[0][0], &texts[0][1]], [&texts[1][0], &texts[1][1]]])
}

#[test]
fn p_as_text_is_accepted() {
    let exact = changed("", "");
    verify(&exact, &materials(PAIRS[0]), &line()).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn a_gap_of_the_wrong_sign_penetrates() {
    let flipped = changed("0.6*pos", "-0.6*pos");
    let error = refused(&flipped);
    assert_eq!(error.condition, Condition::NoPenetration);
    assert!(error.at.x > 0.4 && error.value > error.bound);
    let shown = error.to_string();
    assert!(shown.starts_with("at x = (") && shown.contains("n·(u' − u'')") && shown.contains("hint:"), "{shown}");
}

#[test]
fn tension_friction_and_unequal_stresses_are_told_apart() {
    let tension = changed("-6*pos", "6*pos");
    assert_eq!(refused(&tension).condition, Condition::NoTension);

    let friction = changed("- y*(-sin(2*x)/10 +", "- y*(-sin(2*x)/10 + 0.01 +");
    let error = refused(&friction);
    assert_eq!((error.condition, error.body), (Condition::NoFriction, Some(Body::First)));
    assert!(error.to_string().contains("T_t of Ω' = 1.000e-2"), "{error}");

    let lame = changed("/7)", "/6.9)");
    assert_eq!(refused(&lame).condition, Condition::Reaction);

    // A pressure that reaches into the open part.
    let overlap = changed("pos(s-x)^2", "pos(s+0.1-x)^2");
    assert_eq!(refused(&overlap).condition, Condition::Complementarity);
}

#[test]
fn the_wrong_materials_are_noticed() {
    let p = made("P", &[], PAIRS[0]);
    let error = verify(&*p, &materials(PAIRS[2]), &line()).unwrap_err();
    assert_eq!(error.condition, Condition::Reaction);
}

#[test]
fn a_corner_patch_on_the_wrong_polyline_is_refused() {
    let second = made("corner-patch-2", &[], PAIRS[0]);
    let error = verify(&*second, &materials(PAIRS[0]), &corner(1)).unwrap_err();
    assert!(matches!(error.condition, Condition::NoPenetration | Condition::NoFriction), "{error}");
}

#[test]
fn values_that_are_not_numbers_are_refused() {
    let nan = changed("sin(2*x)/10 - y", "sqrt(x-0.5) - y");
    let error = refused(&nan);
    assert_eq!(error.condition, Condition::Finite);
    assert!(error.value.is_nan());
}

/// P whose reported derivatives are spoilt.
struct Spoilt {
    gradient: f64,
    hessian: f64,
}

impl Exact for Spoilt {
    fn value(&self, body: Body, x: Point) -> Vec2 {
        made("P", &[], PAIRS[0]).value(body, x)
    }

    fn jet(&self, body: Body, x: Point) -> Jet {
        let mut jet = made("P", &[], PAIRS[0]).jet(body, x);
        // Off the contact line only, where no contact condition sees it.
        jet.gradient[0][0] *= 1.0 + self.gradient * x.y.abs();
        jet
    }

    fn jet2(&self, body: Body, x: Point) -> Jet2 {
        let mut jet = made("P", &[], PAIRS[0]).jet2(body, x);
        jet.hessian[1][0][1] += self.hessian * x.y.abs();
        jet
    }

    fn singular_points(&self) -> Vec<Point> {
        Vec::new()
    }

    fn break_lines(&self) -> Vec<Segment> {
        Vec::new()
    }

    fn switch_points(&self) -> Vec<Point> {
        Vec::new()
    }
}

#[test]
fn derivatives_that_do_not_belong_to_the_displacement_are_refused() {
    let spoilt = |gradient, hessian| refused(&Spoilt { gradient, hessian });
    assert_eq!(spoilt(0.1, 0.0).condition, Condition::Gradient);
    assert_eq!(spoilt(0.0, 0.1).condition, Condition::Hessian);
    let sound = Spoilt { gradient: 0.0, hessian: 0.0 };
    verify(&sound, &materials(PAIRS[0]), &line()).unwrap_or_else(|e| panic!("{e}"));
}

/// A singular point in the middle of the line, undeclared or declared.
struct Blowing {
    declared: bool,
}

impl Field for Blowing {
    fn eval<D: Real>(&self, _: Body, x: D, y: D) -> [D; 2] {
        let zero = D::from(0.0);
        let r2 = (x - 0.5) * (x - 0.5) + y * y;
        [zero, crate::expr::power(r2, -0.25) * y * y]
    }

    fn singular_points(&self) -> Vec<Point> {
        if self.declared { vec![Point::new(0.5, 0.0)] } else { Vec::new() }
    }
}

#[test]
fn only_a_declared_singular_point_is_left_out() {
    // 257 midpoints: the middle one is x = 0.5 exactly.
    assert_eq!(refused(&Blowing { declared: false }).condition, Condition::Finite);
    let declared = Blowing { declared: true };
    let v = verify(&declared, &materials(PAIRS[0]), &line()).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(v.points, 256);
}
