//! The limit of the energies of nested levels, and with it a bound of the error that needs no reference.
//!
//! ```text
//! K_{2h} ⊂ K_h ⊂ K   ⇒   L(u) ≤ L(u_h) ≤ L(u_{2h}),      A(u−u_h, u−u_h) = 2 (L(u_h) − L(u)) − 2 ∫_{Γ_K} T_n [u_h]_n ds
//! ```
//!
//! The integral is not negative for `u_h ∈ K`, so twice the energy gap bounds the square of the error. `L(u)` is replaced by
//! the limit `L*` of `L* + C h^p` through three levels; `p/2` is a rate of its own.

use crate::rate::{self, Point};
use crate::record::{Extrapolation, Level};

/// Exponents `p` outside are no convergence of an energy with linear elements.
const EXPONENTS: [f64; 2] = [0.05, 8.0];

/// The limit of the energies, beside the energy of the reference, if there is one; `None` unless every discrete set is part of `K`
/// and of that of the next level.
pub fn of(levels: &[Level]) -> Option<Extrapolation> {
    let chained = levels.iter().all(|l| l.inside == Some(true)) && levels.iter().skip(1).all(|l| l.nested);
    let finest = levels.last().filter(|_| chained)?;
    extrapolate(levels, finest.errors.energy_gap.map(|gap| finest.energy - gap))
}

/// Extrapolates from four levels or more; `None` where fewer are solved, or where the finest three do not fall like a power.
fn extrapolate(levels: &[Level], reference: Option<f64>) -> Option<Extrapolation> {
    let solved: Vec<(f64, f64)> = levels.iter().filter(|l| l.solver.solved).map(|l| (l.h, l.energy)).collect();
    let &[a, b, c, d] = solved.get(solved.len().checked_sub(4)?..)? else { return None };
    let (energy, exponent) = limit([b, c, d])?;
    let others = [[a, b, c], [a, b, d], [a, c, d]].map(|three| limit(three).map(|(l, _)| (l - energy).abs()));
    let uncertainty = others.into_iter().try_fold(0.0, |worst: f64, change| Some(worst.max(change?)))?;
    let bound = |l: &Level| (l.energy > energy).then(|| (2.0 * (l.energy - energy)).sqrt());
    let bounds: Vec<Option<f64>> = levels.iter().map(bound).collect();
    let points: Vec<Point> = levels
        .iter()
        .zip(&bounds)
        .filter_map(|(l, b)| Some(Point { level: l.level, h: l.h, dofs: l.dofs, error: (*b)? }))
        .collect();
    Some(Extrapolation {
        energy,
        uncertainty,
        rate: 0.5 * exponent,
        bounds,
        fitted: rate::fit(&points).ok(),
        reference_above: reference.map(|r| r - energy),
    })
}

/// `L*` and `p` of the curve `L* + C h^p` through three points `(h, L)`, coarsest first.
fn limit([(h1, l1), (h2, l2), (h3, l3)]: [(f64, f64); 3]) -> Option<(f64, f64)> {
    let (coarse, fine) = (l1 - l2, l2 - l3);
    if !(coarse > 0.0 && fine > 0.0) {
        return None;
    }
    // (L_1 − L_2)/(L_2 − L_3) = (h_1^p − h_2^p)/(h_2^p − h_3^p), which grows with p
    let excess = |p: f64| (h1.powf(p) - h2.powf(p)) / (h2.powf(p) - h3.powf(p)) - coarse / fine;
    let [mut low, mut high] = EXPONENTS;
    if excess(low) > 0.0 || excess(high) < 0.0 {
        return None;
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if excess(middle) > 0.0 { high = middle } else { low = middle }
    }
    let p = 0.5 * (low + high);
    // L* = L_3 − (L_2 − L_3) h_3^p / (h_2^p − h_3^p)
    Some((l3 - fine * h3.powf(p) / (h2.powf(p) - h3.powf(p)), p))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    fn levels(energy: impl Fn(f64) -> f64) -> Vec<Level> {
        let mut levels = sample::levels(5, |h| h);
        levels.iter_mut().for_each(|l| l.energy = energy(l.h));
        levels
    }

    #[test]
    fn a_power_is_extrapolated_to_its_limit() {
        let found = extrapolate(&levels(|h| -2.0 + 0.3 * h.powf(1.42)), Some(-2.0 + 1e-3)).unwrap();
        assert!((found.energy + 2.0).abs() < 1e-11 && found.uncertainty < 1e-11, "{found:?}");
        assert!((found.rate - 0.71).abs() < 1e-9 && (found.reference_above.unwrap() - 1e-3).abs() < 1e-10);
        let fitted = found.fitted.unwrap();
        assert!((fitted.slope - 0.71).abs() < 1e-7, "{fitted:?}");
        // √(2 · 0.3 h^1.42)
        let h = 0.125_f64;
        assert!((found.bounds[0].unwrap() - (0.6 * h.powf(1.42)).sqrt()).abs() < 1e-9);
    }

    /// A second power makes the triples differ: the true limit lies within a few times their spread.
    #[test]
    fn the_spread_of_the_triples_tells_how_far_the_limit_may_be_off() {
        let found = extrapolate(&levels(|h| -2.0 + 0.3 * h.powf(1.42) + 0.2 * h * h), None).unwrap();
        let off = (found.energy + 2.0).abs();
        assert!(off > 1e-6 && off < 3.0 * found.uncertainty && off > 0.1 * found.uncertainty, "{off} {found:?}");
    }

    #[test]
    fn only_a_chain_of_sets_has_a_limit() {
        let mut chain = levels(|h| -2.0 + 0.3 * h);
        chain.iter_mut().for_each(|l| (l.nested, l.inside) = (l.level > 0, Some(true)));
        assert!(of(&chain).is_some());
        let mut outside = chain.clone();
        outside[1].inside = Some(false);
        assert_eq!(of(&outside), None);
        chain[2].nested = false;
        assert_eq!(of(&chain), None);
    }

    #[test]
    fn what_is_no_convergence_has_no_limit() {
        assert_eq!(extrapolate(&levels(|h| -2.0 - 0.3 * h), None), None);
        assert_eq!(extrapolate(&levels(|h| 1.0 / h), None), None);
        assert_eq!(extrapolate(&levels(|h| -2.0 + h)[..3], None), None);
        // differences that fall by less than a hundredth
        assert_eq!(extrapolate(&levels(|h| h.powf(0.01)), None), None);
    }
}
