//! Extreme rays of a pointed polyhedral cone by the double description method.
//!
//! T. S. Motzkin, H. Raiffa, G. L. Thompson, R. M. Thrall, *The double description method* (1953): rows are taken up one by
//! one; a row cuts off the rays on its wrong side and puts new ones where it crosses the edges between the two sides.

use nalgebra::{DMatrix, DVector};

/// `|r·q|` below this counts as zero, for rows and rays of length 1.
const TIGHT: f64 = 1e-9;

/// The extreme rays, of length 1, of `{ q ∈ ℝ^d : r·q ≤ 0 for every row r }`. The rows must span `ℝ^d`, so that the cone holds
/// no line; rows of length zero say nothing. `O(rows · rays² · d³)` at worst, in practice few rays live at a time.
pub(super) fn extreme_rays(d: usize, rows: &[DVector<f64>]) -> Vec<DVector<f64>> {
    let rows: Vec<DVector<f64>> = rows.iter().filter(|r| r.norm() > TIGHT).map(|r| r.normalize()).collect();
    let Some((mut taken, mut rays)) = first_rays(d, &rows) else {
        return Vec::new();
    };
    for (i, row) in rows.iter().enumerate() {
        if !taken.contains(&i) {
            rays = cut(d, row, rays, &rows, &taken);
            taken.push(i);
        }
    }
    rays
}

/// `d` independent rows and the rays of the cone that they alone bound: `A q_j = −e_j`.
fn first_rays(d: usize, rows: &[DVector<f64>]) -> Option<(Vec<usize>, Vec<DVector<f64>>)> {
    let mut chosen: Vec<usize> = Vec::with_capacity(d);
    let mut basis: Vec<DVector<f64>> = Vec::with_capacity(d);
    // The row that departs most from the span of the chosen ones, d times.
    for _ in 0..d {
        let rest = |r: &DVector<f64>| basis.iter().fold(r.clone(), |rest, b| &rest - b * b.dot(&rest));
        let lengths = rows.iter().enumerate().map(|(i, r)| (i, rest(r)));
        let (i, best) = lengths.max_by(|a, b| a.1.norm().total_cmp(&b.1.norm()))?;
        if best.norm() < TIGHT {
            return None;
        }
        chosen.push(i);
        basis.push(best.normalize());
    }
    let a = DMatrix::from_fn(d, d, |i, j| rows[chosen[i]][j]);
    let inverse = a.try_inverse()?;
    let rays = (0..d).map(|j| -inverse.column(j).normalize()).collect();
    Some((chosen, rays))
}

/// The rays after one more row.
fn cut(
    d: usize,
    row: &DVector<f64>,
    rays: Vec<DVector<f64>>,
    rows: &[DVector<f64>],
    taken: &[usize],
) -> Vec<DVector<f64>> {
    let values: Vec<f64> = rays.iter().map(|q| row.dot(q)).collect();
    let mut kept: Vec<DVector<f64>> = Vec::with_capacity(rays.len());
    for (p, &over) in values.iter().enumerate().filter(|(_, v)| **v > TIGHT) {
        for (n, &under) in values.iter().enumerate().filter(|(_, v)| **v < -TIGHT) {
            if are_adjacent(d, &rays[p], &rays[n], rows, taken) {
                // r·q = 0 on the edge between the two
                kept.push((&rays[n] * over - &rays[p] * under).normalize());
            }
        }
    }
    kept.extend(rays.into_iter().zip(&values).filter(|(_, v)| **v <= TIGHT).map(|(q, _)| q));
    kept
}

/// Two rays span an edge when the rows that are tight on both have the rank `d − 2`.
fn are_adjacent(d: usize, p: &DVector<f64>, q: &DVector<f64>, rows: &[DVector<f64>], taken: &[usize]) -> bool {
    if d < 2 {
        return false;
    }
    let tight = |i: &&usize| rows[**i].dot(p).abs() <= TIGHT && rows[**i].dot(q).abs() <= TIGHT;
    let common: Vec<&DVector<f64>> = taken.iter().filter(tight).map(|&i| &rows[i]).collect();
    let gram = common.iter().fold(DMatrix::zeros(d, d), |g, r| g + *r * r.transpose());
    gram.rank(TIGHT) >= d - 2
}

#[cfg(test)]
mod tests {
    use super::*;

    fn v(x: &[f64]) -> DVector<f64> {
        DVector::from_row_slice(x)
    }

    /// Whether both lists hold the same directions.
    fn same(found: &[DVector<f64>], wanted: &[DVector<f64>]) -> bool {
        let close = |a: &DVector<f64>, b: &DVector<f64>| (a.normalize() - b.normalize()).norm() < 1e-8;
        found.len() == wanted.len() && wanted.iter().all(|w| found.iter().any(|f| close(f, w)))
    }

    #[test]
    fn a_half_line_and_a_point() {
        assert!(same(&extreme_rays(1, &[v(&[2.0]), v(&[0.5])]), &[v(&[-1.0])]));
        assert!(extreme_rays(1, &[v(&[1.0]), v(&[-1.0])]).is_empty());
    }

    #[test]
    fn a_square_pyramid_has_four_edges_however_often_its_sides_are_listed() {
        let sides = [[1.0, 0.0, -1.0], [-1.0, 0.0, -1.0], [0.0, 1.0, -1.0], [0.0, -1.0, -1.0]];
        let rows: Vec<_> = sides.iter().chain(&sides).chain(&[[0.0, 0.0, -1.0]]).map(|r| v(r)).collect();
        let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0], [-1.0, -1.0, 1.0]];
        assert!(same(&extreme_rays(3, &rows), &corners.map(|c| v(&c))));
    }

    #[test]
    fn a_round_cone_has_one_ray_for_each_of_its_many_sides() {
        let angle = |i: u32| f64::from(i) * std::f64::consts::TAU / 500.0;
        let rows: Vec<_> = (0..500).map(|i| v(&[angle(i).cos(), angle(i).sin(), -1.0])).collect();
        let rays = extreme_rays(3, &rows);
        assert_eq!(rays.len(), 500);
        for q in &rays {
            assert!(rows.iter().all(|r| r.dot(q) <= 1e-9));
            assert_eq!(rows.iter().filter(|r| r.dot(q).abs() < 1e-9).count(), 2);
        }
    }

    /// Against the definition: every ray lies on `d − 1` independent rows and satisfies all.
    #[test]
    fn in_four_dimensions_the_rays_are_those_of_all_triples_of_rows() {
        let rows: Vec<_> = (0..9u32)
            .map(|i| {
                let x = f64::from(i);
                v(&[(1.3 * x).sin(), (2.1 * x + 1.0).cos(), (0.7 * x + 2.0).sin(), -1.2])
            })
            .collect();
        let mut wanted: Vec<DVector<f64>> = Vec::new();
        for i in 0..9 {
            for j in 0..i {
                for k in 0..j {
                    let m = DMatrix::from_fn(4, 4, |r, c| if r < 3 { rows[[i, j, k][r]][c] } else { 0.0 });
                    let null = m.svd(false, true).v_t.unwrap().row(3).transpose();
                    for q in [null.clone(), -null] {
                        if rows.iter().all(|r| r.dot(&q) <= 1e-10) {
                            wanted.push(q);
                        }
                    }
                }
            }
        }
        assert!(wanted.len() > 4 && same(&extreme_rays(4, &rows), &wanted), "{}", wanted.len());
    }
}
