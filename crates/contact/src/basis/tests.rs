//! Whatever holds the two nodes of a pair, its constraints are kept, or dropped by the rule.

use super::*;
use crate::zone::{Constraint, ConstraintKind};

fn pair(normals: &[Vec2]) -> ContactPair {
    let constraint =
        |n: &Vec2| Constraint { normal: n.normalize(), gap: 0.25, mass: 1.0, side: 0, kind: Default::default() };
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
    let mut basis = Basis::new(&supports.iter().cloned().collect());
    let tied = basis.tie(0, pair, [&supports[0], &supports[1]]).unwrap();
    assert_eq!(tied.len(), bounds);
    assert_eq!(basis.fixed.iter().filter(|f| !**f).count(), free);
    let mut x = sample(4);
    x.iter_mut().zip(&basis.fixed).for_each(|(x, f)| *x = if *f { 0.0 } else { *x });
    let u = basis.displacement(&x);
    let v: Vec<Vec2> = u.iter().enumerate().map(|(i, u)| u - basis.offset(i)).collect();
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
    let refused = Basis::new(&supports.iter().cloned().collect()).tie(0, &pair(&[n]), [&supports[0], &supports[1]]);
    assert!(matches!(refused, Err(Error::Boundary(m)) if m.contains("penetrate")));
}

#[test]
fn two_bounds_on_one_component_from_both_sides_are_refused() {
    let supports = [held(&[Vec2::x()], Vec2::zeros()), held(&[], Vec2::zeros())];
    let wedge = pair(&[Vec2::new(1.0, -1.0), Vec2::new(-1.0, -1.0)]);
    assert!(Basis::new(&supports.iter().cloned().collect()).tie(0, &wedge, [&supports[0], &supports[1]]).is_err());
}

#[test]
fn the_ordinary_pair_has_the_unknowns_of_the_text() {
    let n = Vec2::new(0.6, -0.8);
    let supports = [NodeSupport::unsupported(), NodeSupport::unsupported()];
    let mut basis = Basis::new(&supports.iter().cloned().collect());
    basis.tie(0, &pair(&[n]), [&supports[0], &supports[1]]).unwrap();
    let (a, b) = (Vec2::new(0.4, 0.1), Vec2::new(-0.2, 0.5));
    let x = basis.coordinates(&[a, b]);
    let expected = [n.dot(&(a - b)), tangent_of(n).dot(&(a - b)), b.x, b.y];
    assert!(x.iter().zip(expected).all(|(x, e)| (x - e).abs() < 1e-15), "{x:?}");
}

fn bilateral(pair: ContactPair, which: &[usize]) -> ContactPair {
    let mut pair = pair;
    which.iter().for_each(|&k| pair.constraints[k].kind = ConstraintKind::Bilateral);
    pair
}

#[test]
fn a_bilateral_constraint_is_met_by_every_displacement() {
    let free = NodeSupport::unsupported;
    let (n, m) = (Vec2::new(0.6, -0.8), Vec2::new(1.0, -1.0));
    let slides = || held(&[Vec2::y()], Vec2::zeros());
    let clamped = || held(&[], Vec2::new(0.01, 0.02));
    let both = pair(&[n, m]);
    // pair, supports, free components, bounds left, bilateral ones that a component stands for
    let cases: [(ContactPair, [NodeSupport; 2], [usize; 3]); 6] = [
        (bilateral(pair(&[n]), &[0]), [free(), free()], [3, 0, 1]),
        (bilateral(both.clone(), &[1]), [free(), free()], [3, 1, 1]),
        (bilateral(both.clone(), &[0, 1]), [free(), free()], [2, 0, 2]),
        (bilateral(pair(&[n]), &[0]), [free(), clamped()], [1, 0, 1]),
        (bilateral(pair(&[n]), &[0]), [slides(), slides()], [1, 0, 1]),
        (bilateral(both, &[0]), [clamped(), free()], [1, 1, 1]),
    ];
    for (pair, supports, [unknowns, bounds, tied]) in cases {
        let mut basis = Basis::new(&supports.iter().cloned().collect());
        let left = basis.tie(7, &pair, [&supports[0], &supports[1]]).unwrap();
        assert_eq!((left.len(), basis.held.len()), (bounds, tied));
        assert_eq!(basis.fixed.iter().filter(|f| !**f).count(), unknowns);
        let mut x = sample(4);
        x.iter_mut().zip(&basis.fixed).for_each(|(x, f)| *x = if *f { 0.0 } else { *x });
        let u = basis.displacement(&x);
        for h in &basis.held {
            let c = &pair.constraints[h.origin.constraint];
            assert_eq!((h.origin.pair, c.kind), (7, ConstraintKind::Bilateral));
            assert!((c.normal.dot(&(u[0] - u[1])) - c.gap).abs() < 1e-14, "{:?}", pair.constraints);
            assert!(basis.fixed[h.dof as usize]);
        }
        for (bound, origin) in &left {
            let c = &pair.constraints[origin.constraint];
            let slack = c.gap - c.normal.dot(&(u[0] - u[1]));
            assert!(
                (bound.upper - x[bound.dof as usize] - slack).abs() < 1e-13,
                "the other constraint is a bound still"
            );
        }
    }
}

/// What a constraint's own force does to its component, and to no other.
#[test]
fn the_force_of_a_bilateral_constraint_acts_on_its_component_alone() {
    let supports = [NodeSupport::unsupported(), NodeSupport::unsupported()];
    let pair = bilateral(pair(&[Vec2::new(0.6, -0.8), Vec2::new(1.0, 0.3)]), &[0]);
    let mut basis = Basis::new(&supports.iter().cloned().collect());
    let left = basis.tie(0, &pair, [&supports[0], &supports[1]]).unwrap();
    let n = pair.constraints[0].normal;
    let full = basis.full_force(&[2.5 * n, -2.5 * n]);
    let held = basis.held[0].dof as usize;
    assert!((full[held] - 2.5).abs() < 1e-14, "{full:?}");
    assert!(full.iter().enumerate().all(|(i, f)| i == held || f.abs() < 1e-14), "{full:?}");
    assert!(left[0].0.dof as usize != held && basis.force(&[2.5 * n, -2.5 * n]).iter().all(|f| f.abs() < 1e-14));
}

#[test]
fn supports_that_part_a_bilateral_pair_are_refused() {
    let n = Vec2::new(0.0, -1.0);
    let clamped = |y: f64| held(&[], Vec2::new(0.0, y));
    let tie = |pair: &ContactPair, a: f64, b: f64| {
        let supports = [clamped(a), clamped(b)];
        Basis::new(&supports.iter().cloned().collect())
            .tie(0, pair, [&supports[0], &supports[1]])
            .map(|_| ())
            .map_err(|e| e.to_string())
    };
    let mut touching = pair(&[n]);
    touching.constraints[0].gap = 0.0;
    // u' above u'': open, which only the unilateral pair allows
    assert_eq!(tie(&touching, 0.3, 0.1), Ok(()));
    let refused = tie(&bilateral(touching.clone(), &[0]), 0.3, 0.1).unwrap_err();
    assert!(refused.contains("part by 2.000e-1") && refused.contains("bilateral"), "{refused}");
    assert_eq!(tie(&bilateral(touching, &[0]), 0.1, 0.1), Ok(()));
    // an opposite flank that the bilateral one decides
    let mut wedge = bilateral(pair(&[Vec2::x(), -Vec2::x()]), &[0]);
    wedge.constraints.iter_mut().for_each(|c| c.gap = 0.0);
    let supports = [NodeSupport::unsupported(), NodeSupport::unsupported()];
    let mut basis = Basis::new(&supports.iter().cloned().collect());
    assert_eq!(basis.tie(0, &wedge, [&supports[0], &supports[1]]).unwrap().len(), 0);
    assert_eq!(basis.held.len(), 1);
}

/// A pair, a wall and a plain node: blocks that make displacements of unknowns, and blocks that take them back.
#[test]
fn inverse_slots_take_back_what_slots_do() {
    let supports = [
        held(&[Vec2::new(1.0, 2.0)], Vec2::zeros()),
        NodeSupport::unsupported(),
        held(&[Vec2::new(2.0, 1.0)], Vec2::zeros()),
        NodeSupport::unsupported(),
    ];
    let mut basis = Basis::new(&supports.iter().cloned().collect());
    basis.tie(0, &pair(&[Vec2::new(1.0, -2.0)]), [&supports[0], &supports[1]]).unwrap();
    assert_eq!([0, 1, 2, 3].map(|node| basis.is_plain(node)), [false, false, false, true]);
    let x: Vec<f64> = sample(8).iter().zip(&basis.fixed).map(|(x, f)| if *f { 0.0 } else { *x }).collect();
    let u = basis.displacement(&x);
    for slot in 0..4 {
        let (nodes, n) = basis.inverse_slots(slot);
        let back = nodes[..n].iter().fold(Vec2::zeros(), |sum, (node, [a, b, c, d])| {
            let u = u[*node as usize];
            sum + Vec2::new(a * u.x + b * u.y, c * u.x + d * u.y)
        });
        for k in 0..2 {
            let i = 2 * slot + k;
            assert!(basis.fixed[i] || (back[k] - x[i]).abs() < 1e-14, "component {i}");
        }
    }
}

#[test]
fn a_basis_on_fewer_nodes_is_the_same_there() {
    let clamped = held(&[], Vec2::new(0.01, 0.02));
    let supports = [NodeSupport::unsupported(), held(&[Vec2::new(1.0, 2.0)], Vec2::zeros()), clamped.clone(), clamped];
    let mut basis = Basis::new(&supports.iter().cloned().collect());
    basis.tie(0, &pair(&[Vec2::new(0.0, -1.0)]), [&supports[0], &supports[1]]).unwrap();
    let coarse = basis.on_first(3);
    assert_eq!((coarse.nodes(), coarse.fixed.as_slice()), (3, &basis.fixed[..6]));
    let x = sample(8);
    assert_eq!(coarse.displacement(&x[..6]), basis.displacement(&x)[..3]);
    assert_eq!(coarse.offsets().unwrap()[2], Vec2::new(0.01, 0.02));
    // Without the pair nothing is left of it.
    let one = basis.on_first(0);
    assert_eq!((one.nodes(), one.pairs().count(), one.offsets()), (0, 0, None));
}

#[test]
fn nodes_without_an_entry_are_free() {
    let mut supports = NodeSupports::new(5);
    supports.of_mut(3).free.pop();
    assert_eq!(supports.held().map(|(node, _)| node).collect::<Vec<_>>(), [3]);
    assert_eq!(supports.of(2), &NodeSupport::unsupported());
    assert_eq!(Basis::new(&supports).fixed, [0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map(|i| i == 7));
}
