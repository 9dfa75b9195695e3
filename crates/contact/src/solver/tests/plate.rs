//! A square elastic plate on right triangles, held or free, its lower side over an obstacle.

use super::agreement::{assert_optimal, condensed, interior};
use super::examples::{distance, from_blocks};
use crate::qp::{Bound, BoundQp, algebraic_error, energy};
use crate::solver::{Method, Settings, Status, solve};
use crate::sparse::BlockMatrix;
use std::collections::BTreeMap;

/// A plate of `n × n` nodes.
pub struct Plate {
    /// Clamped on its left side, pressed towards the obstacle on the side across from it. Component 1 of a node is its
    /// displacement towards the obstacle.
    pub qp: BoundQp,
    /// The stiffness with no support at all.
    pub free: BlockMatrix,
}

/// The plate, with gap `0.2 + (s − 0.6)²` at the distance `s` from the left side.
pub fn plate(n: usize) -> Plate {
    let blocks = stiffness(n);
    let free = from_blocks(n * n, &blocks);
    let mut clamped = blocks.clone();
    for ((a, b), block) in &mut clamped {
        if a % n == 0 || b % n == 0 {
            *block = if a == b { [1.0, 0.0, 0.0, 1.0] } else { [0.0; 4] };
        }
    }
    let step = 1.0 / (n - 1) as f64;
    let mut load = vec![0.0; 2 * n * n];
    for i in 1..n {
        load[2 * (n * (n - 1) + i) + 1] = 0.3 * step;
        load[2 * (n * (n - 1) + i)] = 0.05 * step;
    }
    let bound = |i: usize| Bound { dof: 2 * i as u32 + 1, upper: 0.2 + (i as f64 * step - 0.6).powi(2) };
    let qp = BoundQp {
        matrix: from_blocks(n * n, &clamped),
        load,
        bounds: (1..n).map(bound).collect(),
        ..Default::default()
    };
    Plate { qp, free }
}

/// Plane stress, `E = 1`, `ν = 0.3`, unit square.
fn stiffness(n: usize) -> BTreeMap<(usize, usize), [f64; 4]> {
    let mut blocks = BTreeMap::new();
    for j in 0..n - 1 {
        for i in 0..n - 1 {
            let a = j * n + i;
            add_triangle(&mut blocks, [a, a + 1, a + n + 1], [[-1.0, 0.0], [1.0, -1.0], [0.0, 1.0]]);
            add_triangle(&mut blocks, [a, a + n + 1, a + n], [[0.0, -1.0], [1.0, 0.0], [-1.0, 1.0]]);
        }
    }
    blocks
}

/// Adds `½ h² ∫ τ:ε`, from the gradients times `h`: the mesh size cancels.
fn add_triangle(blocks: &mut BTreeMap<(usize, usize), [f64; 4]>, nodes: [usize; 3], gradient: [[f64; 2]; 3]) {
    let nu = 0.3;
    let (lambda, mu) = (nu / (1.0 - nu * nu), 0.5 / (1.0 + nu));
    for (p, &a) in nodes.iter().enumerate() {
        for (q, &b) in nodes.iter().enumerate() {
            let block = blocks.entry((a, b)).or_insert([0.0; 4]);
            let (g, h) = (gradient[p], gradient[q]);
            let dot = g[0] * h[0] + g[1] * h[1];
            for k in 0..4 {
                let (c, d) = (k / 2, k % 2);
                let isotropic = if c == d { mu * dot } else { 0.0 };
                block[k] += 0.5 * (lambda * g[c] * h[d] + mu * g[d] * h[c] + isotropic);
            }
        }
    }
}

#[test]
fn two_thousand_unknowns() {
    let qp = plate(32).qp;
    assert_eq!(qp.matrix.dimension(), 2048);
    let solution = condensed(&qp);
    assert_optimal(&qp, &solution);
    assert_eq!(solution.factorizations, 1);
    assert!(solution.iterations <= 9, "{:?}", solution.history);
    let active = solution.multipliers.iter().filter(|l| **l > 0.0).count();
    assert!(active > 3 && active < 28, "contact with a switch point, {active} active");
    assert_eq!(solution.history.last(), Some(&active));
    let second = interior(&qp);
    assert_optimal(&qp, &second);
    assert!(distance(&second.x, &solution.x) < 1e-11);
    assert!(distance(&second.multipliers, &solution.multipliers) < 1e-11);
}

#[test]
fn a_loose_interior_point_shows_in_the_algebraic_error() {
    let qp = plate(16).qp;
    let truth = condensed(&qp);
    let norm = |x: &[f64]| {
        let e: Vec<f64> = x.iter().zip(&truth.x).map(|(a, b)| a - b).collect();
        let zero_load = BoundQp { load: vec![0.0; e.len()], ..qp.clone() };
        (2.0 * energy(&zero_load, &e)).sqrt()
    };
    let size = (2.0 * energy(&qp, &truth.x).abs()).sqrt();
    for (tolerance, least, most) in [(1e-2, 1e-4, 0.3), (1e-4, 1e-6, 1e-2), (1e-11, 0.0, 1e-5)] {
        let settings = Settings { method: Method::InteriorPoint, tolerance, crossover: false, ..Settings::default() };
        let loose = solve(&qp, &settings);
        assert!(matches!(loose.status, Status::Converged { .. }), "{:?}", loose.status);
        let error = norm(&loose.x) / size;
        let estimate = algebraic_error(&qp, &loose.x, &loose.multipliers) / size;
        assert!(error > least && error < most, "tolerance {tolerance}: error {error}");
        assert!(estimate > 0.5 * error, "tolerance {tolerance}: {estimate} for {error}");
        assert!(estimate < 10.0 * error, "tolerance {tolerance}: {estimate} for {error}");
    }
    let exact = algebraic_error(&qp, &truth.x, &truth.multipliers) / size;
    assert!(exact < 1e-13, "{exact}");
}
