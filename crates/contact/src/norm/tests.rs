//! Norms of fields whose integrals are known.

use super::*;
use crate::element::CurvedElement;
use crate::mesh::Locator;
use crate::mesh::blocks::Pattern;
use crate::mesh::tests::{quarter_disc, squares};

fn mesh() -> Mesh {
    squares(3, Pattern::CrissCross).build().unwrap()
}

fn materials() -> [Material; 2] {
    [Material::lame(1.5, 1.0).unwrap(), Material::lame(3.0, 2.0).unwrap()]
}

fn nodal(mesh: &Mesh, u: impl Fn(Body, Point) -> Vec2) -> Vec<Vec2> {
    mesh.points.iter().zip(&mesh.node_bodies).map(|(x, body)| u(*body, *x)).collect()
}

fn close(squares: &Squares, strain: [f64; 2], energy: f64, gradient: f64, l2: f64) {
    let pairs = squares.strain.into_iter().zip(strain);
    let rest = [(squares.energy, energy), (squares.gradient, gradient), (squares.l2, l2)];
    for (found, expected) in pairs.chain(rest) {
        assert!((found - expected).abs() < 1e-13 * expected.max(1.0), "{found} {expected}: {squares:?}");
    }
}

#[test]
fn a_linear_field_has_the_norms_of_its_formula() {
    // u' = (x, 0): ε_11 = 1, A = λ + 2μ = 3.5.  u'' = (y, 0): ε_12 = ½, |ε|² = ½, A = 4 μ ε_12² = 2.
    let mesh = mesh();
    let u = |body, x: Point| Vec2::new(if body == Body::First { x.x } else { x.y }, 0.0);
    let squares = of_linear(&mesh, &materials(), &nodal(&mesh, u));
    close(&squares, [1.0, 0.5], 5.5, 2.0, 2.0 / 3.0);
    assert!((squares.h1_norm() - (8.0f64 / 3.0).sqrt()).abs() < 1e-14);
    assert!((squares.strain_seminorm() - 1.5f64.sqrt()).abs() < 1e-14);
}

#[test]
fn rotations_have_no_strain_but_a_gradient() {
    let mesh = mesh();
    let squares = of_linear(&mesh, &materials(), &nodal(&mesh, |_, x| Vec2::new(-x.y, x.x)));
    close(&squares, [0.0, 0.0], 0.0, 4.0, 4.0 / 3.0);
}

#[test]
fn differences_of_polynomials_are_integrated_exactly() {
    // u = (x², 0), v = 0: ε_11 = 2x, ∫4x² = 4/3 on each square, A = 4/3 (λ + 2μ), ∫x⁴ = 1/5.
    // v = (x, 0) leaves x² − x: ∫(2x − 1)² = 1/3, ∫(x² − x)² = 1/30.
    let mesh = mesh();
    let u = |_: Body, x: Point| (Vec2::new(x.x * x.x, 0.0), [[2.0 * x.x, 0.0], [0.0; 2]]);
    let fields = [nodal(&mesh, |_, _| Vec2::zeros()), nodal(&mesh, |_, x| Vec2::new(x.x, 0.0))];
    let [whole, rest] = of_differences(&mesh, &materials(), &u, [&fields[0], &fields[1]], &Cubature::default());
    close(&whole, [4.0 / 3.0; 2], 14.0, 8.0 / 3.0, 0.4);
    close(&rest, [1.0 / 3.0; 2], 3.5, 2.0 / 3.0, 1.0 / 15.0);
}

#[test]
fn a_linear_field_differs_from_another_by_its_norm_on_both_ways() {
    let mesh = mesh();
    let v = nodal(&mesh, |body, x| Vec2::new((3.0 * x.x + x.y).sin(), body.index() as f64 - x.x * x.y));
    let none = |_: Body, _: Point| (Vec2::zeros(), [[0.0; 2]; 2]);
    let [by_points] = of_differences(&mesh, &materials(), &none, [&v], &Cubature::default());
    let by_mass = of_linear(&mesh, &materials(), &v);
    close(&by_points, by_mass.strain, by_mass.energy, by_mass.gradient, by_mass.l2);
}

fn wave(body: Body, x: Point) -> Vec2 {
    Vec2::new((3.0 * x.x + x.y).sin(), body.index() as f64 - x.x * x.y)
}

#[test]
fn across_nested_meshes_the_difference_is_integrated_exactly() {
    let [coarse, fine] = [3, 6].map(|n| squares(n, Pattern::Structured).build().unwrap());
    let (w, v) = (nodal(&coarse, wave), nodal(&fine, |b, x| 0.9 * wave(b, x)));
    let locator = Locator::new(&coarse);
    let [[across]] = of_located(&fine, &materials(), &locator, [(&v, &w)], [0]);
    // the coarse field lies in the fine space: its interpolant there is the field itself
    let lifted = interpolate(&fine, &locator, &w);
    let difference: Vec<Vec2> = v.iter().zip(&lifted).map(|(v, w)| v - w).collect();
    let direct = of_linear(&fine, &materials(), &difference);
    close(&across, direct.strain, direct.energy, direct.gradient, direct.l2);
}

/// Against zero the norm of a coarse field is its own, whatever mesh it is summed on.
#[test]
fn a_field_has_the_same_norms_on_every_mesh_of_the_same_bodies() {
    for element in [CurvedElement::Physical, CurvedElement::Isoparametric { skew: 0.0 }] {
        let (coarse, fine) = (quarter_disc(3, element), quarter_disc(10, element));
        let (w, zero) = (nodal(&coarse, wave), vec![Vec2::zeros(); fine.points.len()]);
        let (locator, own) = (Locator::new(&coarse), of_linear(&coarse, &materials(), &w));
        let off = |depth: u32| {
            let [[across]] = of_located(&fine, &materials(), &locator, [(&zero, &w)], [depth]);
            assert!((across.l2 / own.l2 - 1.0).abs() < 1e-4, "{element:?}: {across:?} {own:?}");
            (across.energy / own.energy - 1.0).abs()
        };
        assert!(off(0) < 1e-3 && off(1) < 5e-4 && off(3) < 1e-4, "{element:?}: {} {} {}", off(0), off(1), off(3));
    }
}

/// The interpolant at the fine nodes rounds off the kinks along the coarse sides and is no stand-in for the field.
#[test]
fn the_interpolant_on_a_finer_mesh_that_is_not_nested_has_less_strain() {
    let (coarse, fine) = (quarter_disc(5, CurvedElement::Physical), quarter_disc(12, CurvedElement::Physical));
    // a field of kinks alone
    let w: Vec<Vec2> =
        (0..coarse.points.len()).map(|i| Vec2::new((7.0 * i as f64).sin(), (5.0 * i as f64).cos())).collect();
    let (locator, zero) = (Locator::new(&coarse), vec![Vec2::zeros(); fine.points.len()]);
    let [[itself]] = of_located(&fine, &materials(), &locator, [(&zero, &w)], [1]);
    let lifted = interpolate(&fine, &locator, &w);
    let interpolant = of_linear(&fine, &materials(), &lifted);
    let share = interpolant.energy_norm() / itself.energy_norm();
    assert!((0.5..0.95).contains(&share), "{share}");
    // what the interpolant lost is what stands between the two
    let [[lost]] = of_located(&fine, &materials(), &locator, [(&lifted, &w)], [1]);
    assert!(lost.energy_norm() > 0.3 * itself.energy_norm(), "{lost:?}");
}
