//! Whatever holds the two nodes of a pair, its constraints are kept, or dropped by the rule.

use super::*;
use crate::zone::Constraint;

fn pair(normals: &[Vec2]) -> ContactPair {
    let constraint = |n: &Vec2| Constraint { normal: n.normalize(), gap: 0.25, mass: 1.0, side: 0 };
    ContactPair { first: 0, second: 1, constraints: normals.iter().map(constraint).collect() }
}

fn held(free: &[Vec2], offset: Vec2) -> NodeSupport {
    NodeSupport { free: free.iter().map(|f| f.normalize()).collect(), offset }
}

/// Random-looking numbers that need no generator.
fn sample(n: usize) -> Vec<f64> {
    (0..n).map(|i| (12.9898 * (i as f64 + 1.0)).sin()).collect()
}

/// Whatever the supports: displacements respect them, `coordinates` inverts `displacement`, and each bounded component
/// is `n·d` measured from the fixed jump.
fn check(pair: &ContactPair, supports: [NodeSupport; 2], bounds: usize, free: usize) {
    let mut basis = Basis::new(&supports);
    let tied = basis.tie(0, pair, [&supports[0], &supports[1]]).unwrap();
    assert_eq!(tied.len(), bounds);
    assert_eq!(basis.fixed.iter().filter(|f| !**f).count(), free);
    let mut x = sample(4);
    x.iter_mut().zip(&basis.fixed).for_each(|(x, f)| *x = if *f { 0.0 } else { *x });
    let u = basis.displacement(&x);
    let v: Vec<Vec2> = u.iter().zip(&basis.offset).map(|(u, o)| u - o).collect();
    for (v, s) in v.iter().zip(&supports) {
        let in_span: Vec2 = s.free.iter().map(|f| *f * f.dot(v)).sum();
        assert!((v - in_span).norm() < 1e-14, "{v:?} leaves the free directions {:?}", s.free);
    }
    for (a, b) in basis.coordinates(&v).iter().zip(&x) {
        assert!((a - b).abs() < 1e-13);
    }
    for (bound, origin) in &tied {
        let c = &pair.constraints[origin.constraint];
        let slack = c.gap - c.normal.dot(&(u[0] - u[1]));
        assert!((bound.upper - x[bound.dof as usize] - slack).abs() < 1e-13, "the bound is the constraint");
    }
    // Tᵀ is the adjoint of T.
    let r = [Vec2::new(0.3, -0.8), Vec2::new(0.6, 0.2)];
    let left: f64 = basis.force(&r).iter().zip(&x).map(|(a, b)| a * b).sum();
    let right: f64 = r.iter().zip(&v).map(|(r, v)| r.dot(v)).sum();
    assert!((left - right).abs() < 1e-14);
}

#[test]
fn every_combination_of_supports_keeps_its_constraints() {
    let free = NodeSupport::unsupported;
    let (n, m) = (Vec2::new(0.0, -1.0), Vec2::new(1.0, -1.0));
    let clamped = || held(&[], Vec2::new(0.01, 0.02));
    check(&pair(&[n]), [free(), free()], 1, 4);
    check(&pair(&[n, m]), [free(), free()], 2, 4);
    check(&pair(&[n]), [free(), clamped()], 1, 2);
    check(&pair(&[n, m]), [clamped(), free()], 2, 2);
    check(&pair(&[n]), [held(&[Vec2::y()], Vec2::zeros()), free()], 1, 3);
    check(&pair(&[n]), [held(&[Vec2::y()], Vec2::zeros()), held(&[Vec2::y()], Vec2::zeros())], 1, 2);
    check(&pair(&[n]), [held(&[Vec2::y()], Vec2::zeros()), clamped()], 1, 1);
    check(&pair(&[n]), [held(&[Vec2::x()], Vec2::zeros()), free()], 1, 3);
    check(
        &pair(&[n, m]),
        [held(&[Vec2::new(1.0, 2.0)], Vec2::zeros()), held(&[Vec2::new(2.0, -1.0)], Vec2::zeros())],
        2,
        2,
    );
    check(&pair(&[n, m]), [held(&[Vec2::y()], Vec2::zeros()), clamped()], 1, 1);
}

#[test]
fn a_constraint_that_the_supports_decide_is_dropped_and_checked() {
    let n = Vec2::new(0.0, -1.0);
    let along = |offset: f64| held(&[Vec2::x()], Vec2::new(0.0, offset));
    check(&pair(&[n]), [along(0.0), along(0.0)], 0, 2);
    // n·(u'−u'') = −(−0.3) = 0.3 > gap 0.25: penetration that nothing can undo.
    let supports = [along(-0.3), along(0.0)];
    let refused = Basis::new(&supports).tie(0, &pair(&[n]), [&supports[0], &supports[1]]);
    assert!(matches!(refused, Err(Error::Boundary(m)) if m.contains("penetrate")));
}

#[test]
fn two_bounds_on_one_component_from_both_sides_are_refused() {
    let supports = [held(&[Vec2::x()], Vec2::zeros()), held(&[], Vec2::zeros())];
    let wedge = pair(&[Vec2::new(1.0, -1.0), Vec2::new(-1.0, -1.0)]);
    assert!(Basis::new(&supports).tie(0, &wedge, [&supports[0], &supports[1]]).is_err());
}

#[test]
fn the_ordinary_pair_has_the_unknowns_of_the_text() {
    let n = Vec2::new(0.6, -0.8);
    let supports = [NodeSupport::unsupported(), NodeSupport::unsupported()];
    let mut basis = Basis::new(&supports);
    basis.tie(0, &pair(&[n]), [&supports[0], &supports[1]]).unwrap();
    let (a, b) = (Vec2::new(0.4, 0.1), Vec2::new(-0.2, 0.5));
    let x = basis.coordinates(&[a, b]);
    let expected = [n.dot(&(a - b)), tangent_of(n).dot(&(a - b)), b.x, b.y];
    assert!(x.iter().zip(expected).all(|(x, e)| (x - e).abs() < 1e-15), "{x:?}");
}
