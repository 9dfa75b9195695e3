//! The sliding body and the line that is tied in part: closed forms on the zone and on the floor, Green's formula, and what the
//! verification allows on a bilateral part and nowhere else.

use super::*;
use crate::exact::derived::{body_force_of, contact_stress, jump, stress, traction};
use crate::exact::verify::{Condition, Verification, VerifyError, verify, verify_tied};
use signorini_contact::quadrature::GAUSS_8;
use signorini_contact::{Body, Vec2};

const SLOPE: f64 = 0.3;

/// `y = 0.3 x`, bilateral up to the abscissa `tied`.
fn slanted(tied: f64) -> ContactLine {
    ContactLine::polyline([0.0, tied, 1.0].map(|x| Point::new(x, SLOPE * x)))
}

fn checked(tied: f64, pieces: &[usize]) -> Result<Verification, VerifyError> {
    verify_tied(&*made("bilateral", &[], PAIRS[0]), &materials(PAIRS[0]), &slanted(tied), pieces)
}

#[test]
fn tension_is_allowed_on_the_bilateral_part_alone_and_an_opening_nowhere_on_it() {
    for lame in PAIRS {
        let exact = made("bilateral", &[], lame);
        let v = verify_tied(&*exact, &materials(lame), &slanted(0.25), &[0]).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(v.points, 2 * 257);
        assert!(v.tension < 1e-14 && v.opening < 1e-14 && v.reaction < 1e-12 && v.tangential < 1e-12, "{v:?}");
    }
    // tension ends at s = 0.2, that is x = 0.1916; the bodies part beyond x = √(3/8) = 0.6124
    assert!(checked(0.2, &[0]).is_ok() && checked(0.6, &[0]).is_ok());
    let error = checked(0.18, &[0]).unwrap_err();
    assert!(error.condition == Condition::NoTension && error.at.x < 0.1916, "{error}");
    let error = checked(0.7, &[0]).unwrap_err();
    assert!(error.condition == Condition::NoOpening && error.at.x > 0.6124, "{error}");
    assert!(error.to_string().contains("|n·(u' − u'')| on a bilateral part"), "{error}");
    assert_eq!(checked(0.25, &[]).unwrap_err().condition, Condition::NoTension);
    assert_eq!(checked(0.25, &[1]).unwrap_err().condition, Condition::NoOpening);
}

#[test]
fn the_slanted_line_has_its_stated_stress_and_gap() {
    let stretch = 1.09f64.sqrt();
    let n = Vec2::new(SLOPE, -1.0) / stretch;
    let end = 0.375f64.sqrt() * stretch;
    for lame in PAIRS {
        let exact = made("bilateral", &[], lame);
        for i in 0..101 {
            let x = (f64::from(i) + 0.37) / 101.0;
            let (at, s) = (Point::new(x, SLOPE * x), x * stretch);
            let stated = -30.0 * positive(end - s, 2.0) * (s - 0.2);
            let t = contact_stress(&*exact, &materials(lame)[0], at, n);
            assert!((t - stated).abs() < 1e-12, "{x}: {t} {stated}");
            assert!((-jump(&*exact, at, n) - positive(s - end, 3.0)).abs() < 1e-14);
        }
    }
}

/// `u_2 = 0` and `τ_12 = 0` on the floor; nothing moves at the top.
#[test]
fn both_stand_on_a_smooth_floor() {
    for (name, top) in [("slide", 1.0), ("bilateral", 1.5)] {
        let exact = made(name, &[], PAIRS[2]);
        for i in 0..=20 {
            let x = f64::from(i) / 20.0;
            let floor = Point::new(x, -1.0);
            assert_eq!(exact.value(Body::Second, floor).y, 0.0, "{name}");
            let t = traction(&*exact, &materials(PAIRS[2])[1], Body::Second, floor, Vec2::new(0.0, -1.0));
            assert!(t.x.abs() < 1e-14, "{name} at {x}: {t:?}");
            assert!(exact.value(Body::First, Point::new(x, top)).norm() < 1e-16);
        }
    }
}

#[test]
fn the_slide_is_p_on_the_contact_line_and_has_a_stated_mean_on_the_floor() {
    let p = made("P", &[], PAIRS[1]);
    for slide in [0.0, 0.7] {
        let exact = made("slide", &[("slide", slide)], PAIRS[1]);
        verify(&*exact, &materials(PAIRS[1]), &line()).unwrap_or_else(|e| panic!("{e}"));
        let cells = (0..16).flat_map(|k| GAUSS_8.map(|(t, w)| ((f64::from(k) + t) / 16.0, w / 16.0)));
        let mean: f64 = cells.map(|(x, w)| w * exact.value(Body::Second, Point::new(x, -1.0)).x).sum();
        assert!((mean - slide).abs() < 1e-15, "{mean}");
        for x in [0.1, 0.4, 0.9] {
            let at = Point::new(x, 0.0);
            for body in Body::BOTH {
                let [a, b] = [&p, &exact].map(|u| u.jet(body, at));
                let slid = if body == Body::Second { slide } else { 0.0 };
                assert!((b.value - a.value - Vec2::new(slid, 0.0)).norm() < 1e-15);
                let apart = a.gradient.iter().flatten().zip(b.gradient.iter().flatten());
                assert!(apart.into_iter().all(|(a, b)| (a - b).abs() < 1e-14));
            }
        }
    }
    assert!(built_in("slide", &parameters(&[("slide", 11.0)]), PAIRS[0]).is_err());
}

/// `∫_ω τ:ε(φ) − F·φ dx = ∮ τν·φ ds` on rectangles beside the line, in the coordinates along and across it, with the stated `p`
/// on the line itself: it ties the second derivatives to the first, and the sign of `p` to both bodies.
#[test]
fn greens_formula_holds_with_the_stated_stress_on_the_line() {
    let s_end = 0.375f64.sqrt() * 1.09f64.sqrt();
    let of_slanted = |s: f64| -30.0 * positive(s_end - s, 2.0) * (s - 0.2);
    let of_slide = |s: f64| -6.0 * positive(1.0 / 6.0f64.sqrt() - s, 2.0);
    let forms: [(&str, f64, f64, &dyn Fn(f64) -> f64); 2] =
        [("bilateral", SLOPE, s_end, &of_slanted), ("slide", 0.0, 1.0 / 6.0f64.sqrt(), &of_slide)];
    for (name, slope, switch, p) in forms {
        let exact = made(name, &[], PAIRS[2]);
        for (body, side) in [(Body::First, 1.0), (Body::Second, -1.0)] {
            for along in [[0.06, switch], [switch, 0.95]] {
                let (inside, around, size) = green(&*exact, slope, body, along, [0.0, 0.3 * side], p);
                assert!((inside - around).abs() < 1e-9 * size, "{name} {body} {along:?}: {inside} {around}");
            }
        }
    }
}

/// `φ = (1 + x − y², 2y + x y)` and its gradient.
fn field(x: Point) -> (Vec2, [[f64; 2]; 2]) {
    (Vec2::new(1.0 + x.x - x.y * x.y, 2.0 * x.y + x.x * x.y), [[1.0, -2.0 * x.y], [x.y, 2.0 + x.x]])
}

/// Both sides of the formula on `{ along × across }`, and `∫ |τ:ε(φ)|`.
fn green(
    exact: &dyn Exact,
    slope: f64,
    body: Body,
    [a, b]: [f64; 2],
    [on_line, deep]: [f64; 2],
    p: &dyn Fn(f64) -> f64,
) -> (f64, f64, f64) {
    let t = Vec2::new(1.0, slope).normalize();
    let across = Vec2::new(-t.y, t.x);
    let at = |s: f64, d: f64| s * t + d * across;
    let material = materials(PAIRS[2])[body.index()];
    let rule = |from: f64, to: f64| -> Vec<(f64, f64)> {
        let panel =
            |k: u32| GAUSS_8.map(|(x, w)| (from + (f64::from(k) + x) / 8.0 * (to - from), w * (to - from).abs() / 8.0));
        (0..8).flat_map(panel).collect()
    };
    let (mut inside, mut size) = (0.0, 0.0);
    for (s, ws) in rule(a, b) {
        for (d, wd) in rule(on_line, deep) {
            let x = at(s, d);
            let (phi, g) = field(x);
            let tau = stress(exact, &material, body, x);
            let inner = tau[0] * g[0][0] + tau[1] * g[1][1] + tau[2] * (g[0][1] + g[1][0]);
            inside += ws * wd * (inner - body_force_of(&exact.jet2(body, x), &material).dot(&phi));
            size += ws * wd * inner.abs();
        }
    }
    let side = (deep - on_line).signum();
    let pull = |x: Point, n: Vec2| traction(exact, &material, body, x, n).dot(&field(x).0);
    let mut around = 0.0;
    for (s, w) in rule(a, b) {
        // outward normal −side·across: τν = −side p across
        around += w * (-side * p(s) * across).dot(&field(at(s, on_line)).0);
        around += w * pull(at(s, deep), side * across);
    }
    for (d, w) in rule(on_line, deep) {
        around += w * (pull(at(a, d), -t) + pull(at(b, d), t));
    }
    (inside, around, size)
}
