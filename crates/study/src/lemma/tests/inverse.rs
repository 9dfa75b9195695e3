//! The inverse inequality: the quadrature of the seminorm, and the constants in closed form.

use crate::lemma::inverse::{Intervals, Norms, slobodeckij};

fn intervals(norms: Norms) -> Intervals {
    Intervals { whole: [0.2, 1.7], norms, seed: 1 }
}

#[test]
fn the_double_integral_is_right_for_more_than_linear_functions() {
    for length in [2.0, 0.3, 1e-3] {
        // (x² − y²)/(x − y) = x + y, and ∫∫ (x+y)² over (0, L)² = 7/6 L⁴
        let (found, known) = (slobodeckij([0.0, length], |x| x * x), 7.0 / 6.0 * length.powi(4));
        assert!((found / known - 1.0).abs() < 1e-12, "{length}: {found} {known}");
    }
    // ∫∫ (x² + xy + y²)² over (0, 1)² = 2/5 + 2 (1/4) + 3/9
    let cubic = slobodeckij([0.0, 1.0], |x| x * x * x);
    assert!((cubic - (0.4 + 0.5 + 1.0 / 3.0)).abs() < 1e-13, "{cubic}");
}

/// `|p|²_1 (b−a)` of `x²` on `(0, L)` is `4/3 L⁴`, and `|p|²_{1/2}` is `7/6 L⁴`: only linear functions have the ratio 1.
#[test]
fn the_equality_is_one_of_linear_functions_alone() {
    let ratio = 4.0 / 3.0 / slobodeckij([0.0, 1.0], |x| x * x);
    assert!((ratio - 8.0 / 7.0).abs() < 1e-12);
}

#[test]
fn the_seminorms_are_equal_to_rounding() {
    for n in [1, 7, 64, 300] {
        let i = intervals(Norms::Seminorms);
        let off = i.constant(&i.points(n)) - 1.0;
        assert!(off.abs() < 1e-11 && off != 0.0, "{n}: {off:e}");
    }
}

#[test]
fn full_norms_have_the_constants_of_the_closed_forms() {
    // In 1 and x − m everything is diagonal: L·1/(L² (1 + L/12))·L and (1 + L²/12)/(1 + L/12); constants give L.
    let right = |l: f64| (1.0 / (1.0 + l / 12.0)).sqrt();
    let both = |l: f64| l.max((1.0 + l * l / 12.0) / (1.0 + l / 12.0)).sqrt();
    for whole in [[0.2, 1.7], [-1.0, 4.0], [3.0, 3.01]] {
        for n in [1, 3, 40] {
            let points = Intervals { whole, ..intervals(Norms::Full) }.points(n);
            let largest = |f: &dyn Fn(f64) -> f64| points.windows(2).map(|w| f(w[1] - w[0])).fold(0.0, f64::max);
            for (norms, known) in [(Norms::FullRight, largest(&right)), (Norms::Full, largest(&both))] {
                let found = intervals(norms).constant(&points);
                assert!((found / known - 1.0).abs() < 1e-9, "{whole:?} {n} {norms:?}: {found} {known}");
            }
        }
    }
}

#[test]
fn pieces_are_irregular_and_fill_the_interval() {
    let points = intervals(Norms::Full).points(50);
    let lengths: Vec<f64> = points.windows(2).map(|w| w[1] - w[0]).collect();
    assert_eq!((points[0], points[50]), (0.2, 1.7));
    let [low, high] = [lengths.iter().copied().fold(1.0, f64::min), lengths.iter().copied().fold(0.0, f64::max)];
    assert!(low > 0.49 * 0.03 && high < 1.51 * 0.03 && high > 1.5 * low, "{low} {high}");
}
