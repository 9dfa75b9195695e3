//! Exponents against published values, closed equations and a second algorithm.

mod determinant;

use super::{Face, Mode, Wedge, exponents, singularity};
use crate::material::{Material, Plane};
use Face::{Clamped, Contact, Free, Sliding};
use determinant::{determinant, polish, zeros};
use nalgebra::Complex;

fn isotropic(young: f64, poisson: f64) -> Material {
    Material::isotropic(young, poisson, Plane::Strain).unwrap()
}

fn wedge(degrees: f64, faces: [Face; 2]) -> Wedge {
    Wedge { material: isotropic(1.0, 0.3), from: 0.0, to: degrees.to_radians(), faces }
}

fn smallest(wedges: &[Wedge]) -> Complex<f64> {
    singularity(wedges).unwrap().exponent.expect("a singular corner")
}

/// A punch on a block that reaches farther: contact along `θ = 0`.
fn punch(upper: f64, lower: f64, materials: [Material; 2], outer: [Face; 2]) -> [Wedge; 2] {
    [
        Wedge { material: materials[0], from: 0.0, to: upper.to_radians(), faces: [Contact, outer[0]] },
        Wedge { material: materials[1], from: -lower.to_radians(), to: 0.0, faces: [outer[1], Contact] },
    ]
}

/// The zero of `f` between `a` and `b`, by bisection.
fn bisect(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    assert!(f(a) * f(b) < 0.0);
    for _ in 0..60 {
        let m = 0.5 * (a + b);
        if f(a) * f(m) <= 0.0 { b = m } else { a = m }
    }
    0.5 * (a + b)
}

#[test]
fn a_crack_has_a_half_and_half_planes_have_nothing() {
    // λ = ½ is double: modes I and II
    let crack = exponents(&[wedge(360.0, [Free, Free])]).unwrap();
    assert!((crack[0].re - 0.5).abs() < 1e-8 && (crack[1].re - 0.5).abs() < 1e-8 && crack[2].re > 0.9, "{crack:?}");
    for faces in [[Free, Free], [Clamped, Clamped], [Sliding, Sliding], [Sliding, Free]] {
        assert_eq!(singularity(&[wedge(90.0, faces)]).unwrap().exponent, None, "{faces:?}");
    }
    assert_eq!(singularity(&[wedge(180.0, [Free, Free])]).unwrap().exponent, None);
}

/// Williams (1952): `sin λω = ± λ sin ω` between free faces, `κ sin λω = ± λ sin ω` between clamped ones.
#[test]
fn williams_notches() {
    for degrees in [200.0_f64, 225.0, 270.0, 300.0, 330.0] {
        let w = degrees.to_radians();
        for (faces, kappa, signs) in [([Free; 2], 1.0, &[-1.0][..]), ([Clamped; 2], 1.8, &[1.0, -1.0])] {
            for sign in signs {
                // 0 < λ < 1: the sine falls from its first maximum to that of λω = 3π/2
                let f = |l: f64| kappa * (l * w).sin() - sign * l * w.sin();
                let root = bisect(f, 0.4, 0.98);
                let all = exponents(&[wedge(degrees, faces)]).unwrap();
                assert!(all.iter().any(|l| (l - Complex::from(root)).norm() < 1e-9), "{degrees}° {root} {all:?}");
            }
        }
    }
    let notch = smallest(&[wedge(270.0, [Free, Free])]);
    assert!((notch.re - 0.544_483_736_8).abs() < 1e-9, "{notch}");
}

/// `sin² λω = ((κ+1)² − 4λ² sin² ω)/(4κ)` between a clamped and a free face, `κ = 1.8`: 0.711 at a right angle.
#[test]
fn between_a_clamped_and_a_free_face() {
    let root = bisect(|l| (l * 90f64.to_radians()).sin().powi(2) - (2.8f64.powi(2) - 4.0 * l * l) / 7.2, 0.5, 0.9);
    let found = smallest(&[wedge(90.0, [Clamped, Free])]);
    assert!((found - Complex::from(root)).norm() < 1e-9 && (root - 0.711).abs() < 5e-4, "{found} {root}");
    // at a full turn sin² 2πλ = (κ+1)²/(4κ) > 1: the crack with one clamped face oscillates, λ = ¼ ± i ln κ/(4π)
    let crack = smallest(&[wedge(360.0, [Clamped, Free])]);
    let known = Complex::new(0.25, 0.5 * 1.8f64.ln() / std::f64::consts::TAU);
    assert!((crack - known).norm() < 1e-6, "{crack} {known}");
}

/// Between rails `λ = |kπ/ω ± 1|`; a rail is a plane of symmetry of the doubled wedge.
#[test]
fn between_rails() {
    for (degrees, known) in [(270.0, 1.0 / 3.0), (120.0, 0.5), (200.0, 0.1), (160.0, 0.125)] {
        let found = smallest(&[wedge(degrees, [Sliding, Sliding])]);
        assert!((found - Complex::from(known)).norm() < 1e-8, "{degrees}° {found}");
    }
    let [half, whole] = [wedge(135.0, [Sliding, Free]), wedge(270.0, [Free, Free])].map(|w| smallest(&[w]));
    assert!((half - whole).norm() < 1e-9);
}

/// Dundurs and Lee (1972): the edge of a square punch on a half plane of the same material, without friction.
#[test]
fn the_edge_of_a_punch() {
    let same = [isotropic(1.0, 0.3); 2];
    let found = smallest(&punch(90.0, 180.0, same, [Free, Free]));
    assert!((found.re - 0.774).abs() < 5e-4 && found.im == 0.0, "{found}");
    // on a rigid base the punch stands on a rail, and a rigid punch makes a rail with a right angle beside it: ½
    let rigid_base = smallest_or_one(&punch(90.0, 180.0, [isotropic(1.0, 0.3), isotropic(1e9, 0.3)], [Free, Free]));
    assert!((rigid_base - 1.0).abs() < 1e-4, "{rigid_base}");
    let rigid_punch = smallest(&punch(90.0, 180.0, [isotropic(1e9, 0.3), isotropic(1.0, 0.3)], [Free, Free]));
    assert!((rigid_punch.re - 0.5).abs() < 1e-4, "{rigid_punch}");
}

fn smallest_or_one(wedges: &[Wedge]) -> f64 {
    singularity(wedges).unwrap().exponent.map_or(1.0, |l| l.re)
}

/// One wedge and two, every pair of faces, equal and different materials.
fn zoo() -> Vec<Vec<Wedge>> {
    let mut zoo = Vec::new();
    for degrees in [63.0, 90.0, 141.0, 270.0, 311.0] {
        for faces in [[Clamped, Free], [Free, Free], [Clamped, Clamped], [Clamped, Sliding], [Free, Sliding]] {
            zoo.push(vec![wedge(degrees, faces)]);
        }
    }
    for materials in [[isotropic(1.0, 0.3); 2], [isotropic(1.0, 0.3), isotropic(3.0, 0.2)]] {
        for outer in [[Free, Free], [Clamped, Free], [Free, Clamped], [Sliding, Free]] {
            zoo.push(punch(90.0, 180.0, materials, outer).to_vec());
            zoo.push(punch(120.0, 75.0, materials, outer).to_vec());
        }
        // the vertex of a kinked zone: both faces of both wedges are in contact
        let kink = [0.0, 100f64.to_radians(), 360f64.to_radians()];
        let whole = |k: usize| Wedge { material: materials[k], from: kink[k], to: kink[k + 1], faces: [Contact; 2] };
        zoo.push(vec![whole(0), whole(1)]);
    }
    zoo
}

/// Each exponent below 1 is a zero of the determinant, and the determinant has no other there.
#[test]
fn the_determinant_has_the_same_zeros() {
    for wedges in zoo() {
        let found = exponents(&wedges).unwrap();
        let inside = |l: &&Complex<f64>| l.re > 0.0313 && l.re < 0.9837 && l.im < 1.5;
        let mut count = 0;
        for lambda in found.iter().filter(inside) {
            let root = polish(&wedges, *lambda);
            assert!((root - lambda).norm() < 1e-7, "{wedges:?}: {lambda} {root}");
            count += if lambda.im > 1e-9 { 2 } else { 1 };
        }
        let all = zeros(&wedges, Complex::new(0.0313, -1.5), Complex::new(0.9837, 1.5));
        assert_eq!(all, count, "{wedges:?}: {found:?}");
    }
}

/// The determinant is no constant: away from the exponents it does not vanish.
#[test]
fn the_determinant_does_not_vanish_elsewhere() {
    let notch = [wedge(270.0, [Free, Free])];
    let at = |l: f64| determinant(&notch, Complex::from(l)).norm();
    assert!(at(0.544_483_736_8) < 1e-9 && at(0.7) > 1e-2, "{} {}", at(0.544_483_736_8), at(0.7));
}

/// Exponents do not depend on how the corner lies in the plane, also for a law that does not know of directions but is given
/// as a matrix; an orthotropic law does turn with the axes.
#[test]
fn turning_the_corner() {
    let of = |material: Material, turn: f64| {
        let to = turn + 270f64.to_radians();
        smallest(&[Wedge { material, from: turn, to, faces: [Free, Free] }]).re
    };
    let matrix = Material::general(*isotropic(1.0, 0.3).matrix()).unwrap();
    assert!((of(matrix, 0.7) - 0.544_483_736_8).abs() < 1e-8);
    let wood = Material::orthotropic([10.0, 1.0, 1.0], [0.3, 0.03, 0.3], 0.6, Plane::Strain).unwrap();
    let (zero, quarter, eighth) = (of(wood, 0.0), of(wood, std::f64::consts::PI), of(wood, 0.6));
    assert!((zero - quarter).abs() < 1e-9 && (zero - eighth).abs() > 1e-3, "{zero} {quarter} {eighth}");
}

/// A wedge in a groove, both of the same material and symmetric about the `y`-axis: the modes are even or odd, and an odd one
/// presses on one flank as much as it pulls on the other.
#[test]
fn a_mode_that_pulls_on_one_flank_is_passed_over() {
    let flank = 0.5f64.atan();
    let (right, left) = (flank, std::f64::consts::PI - flank);
    let both = |material: Material| {
        [
            Wedge { material, from: right, to: left, faces: [Contact; 2] },
            Wedge { material, from: left, to: right + std::f64::consts::TAU, faces: [Contact; 2] },
        ]
    };
    let whole = both(isotropic(1.0, 0.3));
    let found = singularity(&whole).unwrap();
    let odd = found.pulling.expect("an odd mode");
    // even modes are those of one half with rails on the axis; odd ones have u_θ ≠ 0 there and u_r = 0
    let half = std::f64::consts::FRAC_PI_2;
    let even = [
        Wedge { faces: [Contact, Sliding], to: half, ..whole[0] },
        Wedge { faces: [Sliding, Contact], from: -half, to: right, ..whole[1] },
    ];
    let of_half = exponents(&even).unwrap();
    assert!((odd.re - 0.3379).abs() < 1e-4, "{odd}");
    assert!(of_half.iter().all(|l| (l - odd).norm() > 1e-3), "{of_half:?}");
    match found.exponent {
        Some(l) => assert!(of_half.iter().any(|e| (e - l).norm() < 1e-8), "{l} {of_half:?}"),
        None => assert!(of_half.iter().all(|e| e.re > 0.999_99), "{of_half:?}"),
    }
}

#[test]
fn pressures_of_one_sign_may_press_and_oscillating_ones_may_not() {
    let mode = |im: f64, pressures: Option<Vec<f64>>| Mode { exponent: Complex::new(0.5, im), pressures };
    assert!(mode(0.0, Some(vec![-1.0, -2.0])).may_press(2) && mode(0.0, Some(vec![1.0, 0.0])).may_press(2));
    assert!(mode(0.0, Some(vec![1.0, 1e-9])).may_press(2) && mode(0.0, None).may_press(2));
    assert!(!mode(0.0, Some(vec![1.0, -0.1])).may_press(2) && !mode(0.1, None).may_press(1));
    assert!(mode(0.1, None).may_press(0));
}

#[test]
fn what_is_no_corner_is_refused() {
    let text = |wedges: &[Wedge]| exponents(wedges).unwrap_err().to_string();
    assert!(text(&[wedge(400.0, [Free, Free])]).contains("400"));
    assert!(text(&[wedge(90.0, [Contact, Free])]).contains("no other wedge meets"));
}
