//! One triangle by a rule that is refined where it does not resolve the solution.

use super::curved::CurvedPart;
use super::element::{Element, ElementIntegrand, Rule};
use signorini_contact::Vec2;
use signorini_contact::element::CurvedTriangle;
use signorini_contact::quadrature::{Cubature, GAUSS_4, GAUSS_6, GAUSS_8, Patch, quarter};

/// Share of the interpolation error's square that one more refinement of the quadrature may change.
const ACCURACY: f64 = 2.5e-7;

/// Share of the interpolation error, in the energy norm, that the loads may change by under one more refinement.
const LOAD_ACCURACY: f64 = 1e-4;

/// The same where two rules of one piece are compared, and not a piece with its quarters: rules that are not far apart may both
/// miss a force that jumps.
const RULE_LOAD_ACCURACY: f64 = 1e-6;

/// Shares of the loads and of `A(u,u)` to which rules of degree 4 and 5 have to agree if they are to suffice.
const LOAD_ROUNDING: f64 = 1e-11;
const ENERGY_ROUNDING: f64 = 1e-12;

impl ElementIntegrand<'_> {
    /// By one pair of rules, of degrees 5 and 8, whatever they say.
    pub fn plainly(&self, cubature: &Cubature) -> [Element; 2] {
        let mut pair = [Element::default(); 2];
        cubature.pieces(self.corners, &mut |piece| {
            pair[0] += self.over(piece, Rule::Seven);
            pair[1] += self.over(piece, Rule::Sixteen);
        });
        pair
    }

    /// By a rule and a finer one on every piece, degrees 5 and 8. Where the two differ too much, degrees 8 and 10 are tried, and
    /// where these do, pieces are split until degree 10 settles. `share` of the interpolation error is allowed to each piece, and a
    /// quarter of it to each of its quarters. With `smooth`, degrees 4 and 5 are tried first.
    pub fn adaptively(&self, cubature: &Cubature, share: f64, deepest: u32, smooth: bool) -> [Element; 2] {
        let mut pair = [Element::default(); 2];
        cubature.pieces(self.corners, &mut |piece| {
            let seven = self.over(piece, Rule::Seven);
            let six = smooth.then(|| self.over(piece, Rule::Six)).filter(|six| self.is_settled(six, &seven, share));
            if let Some(six) = six {
                pair[0] += six;
                pair[1] += seven;
                return;
            }
            let sixteen = self.over(piece, Rule::Sixteen);
            if !self.is_rough(&seven, &sixteen, share) {
                pair[0] += seven;
                pair[1] += sixteen;
                return;
            }
            let conical = self.over(piece, Rule::Conical);
            if self.rules_agree(&sixteen, &conical, share) {
                pair[0] += sixteen;
                pair[1] += conical;
            } else {
                self.split(piece, &conical, share, deepest, &mut pair);
            }
        });
        pair
    }

    fn split(&self, piece: [Vec2; 3], coarse: &Element, share: f64, deepest: u32, pair: &mut [Element; 2]) {
        let parts = quarter(piece).map(|q| self.over(q, Rule::Conical));
        let mut fine = Element::default();
        parts.iter().for_each(|p| fine += *p);
        if deepest > 0 && self.is_rough(coarse, &fine, share) {
            for (quarter, part) in quarter(piece).into_iter().zip(&parts) {
                self.split(quarter, part, 0.25 * share, deepest - 1, pair);
            }
        } else {
            pair[0] += *coarse;
            pair[1] += fine;
        }
    }

    /// The same for a triangle with a curved side, patch by patch, by products of Gauss rules of 4, 6 and 8 points, of which two
    /// neighbours have to agree; where none do, patches are split. With `deepest = 0` it is 8 points, on the patch and its quarters.
    pub fn adaptively_curved(&self, cubature: &Cubature, share: f64, deepest: u32) -> [CurvedPart; 2] {
        let mut pair = [CurvedPart::default(); 2];
        if let Some(triangle) = &self.curved {
            cubature.patches(triangle, &mut |patch| {
                let over = |rule| self.over_patch(triangle, patch, rule);
                let rules: &[&[(f64, f64)]] = if deepest == 0 { &[] } else { &[&GAUSS_6, &GAUSS_8] };
                let mut coarse = over(if deepest == 0 { &GAUSS_8 } else { &GAUSS_4 });
                for rule in rules {
                    let fine = over(rule);
                    if self.rules_agree(&coarse.element, &fine.element, share) {
                        pair[0] += coarse;
                        pair[1] += fine;
                        return;
                    }
                    coarse = fine;
                }
                self.split_curved(triangle, patch, &coarse, share, deepest, &mut pair);
            });
        }
        pair
    }

    fn split_curved(
        &self,
        triangle: &CurvedTriangle,
        patch: Patch,
        coarse: &CurvedPart,
        share: f64,
        deepest: u32,
        pair: &mut [CurvedPart; 2],
    ) {
        let parts = patch.quarter().map(|q| self.over_patch(triangle, q, &GAUSS_8));
        let mut fine = CurvedPart::default();
        parts.iter().for_each(|p| fine += *p);
        if deepest > 0 && self.is_rough(&coarse.element, &fine.element, share) {
            for (quarter, part) in patch.quarter().into_iter().zip(&parts) {
                self.split_curved(triangle, quarter, part, 0.25 * share, deepest - 1, pair);
            }
        } else {
            pair[0] += *coarse;
            pair[1] += fine;
        }
    }

    /// Whether degrees 4 and 5 agree in the interpolation error as it is asked of any two rules, and to next to rounding in the
    /// loads and in `½A(u,u) − f(u)`: their own difference is no safe bound, since on symmetric meshes that of degree 4 cancels.
    fn is_settled(&self, coarse: &Element, fine: &Element, share: f64) -> bool {
        let energy = |e: &Element| 0.5 * e.solution.energy - e.work;
        let size: f64 = fine.load.iter().map(|f| f.norm_squared()).sum();
        load_change(coarse, fine) <= LOAD_ROUNDING * LOAD_ROUNDING * size
            && (energy(coarse) - energy(fine)).abs() <= ENERGY_ROUNDING * fine.solution.energy
            && !self.is_rough(coarse, fine, share)
    }

    /// Whether the finer rule still changed the interpolation error or the loads by more than their shares.
    fn is_rough(&self, coarse: &Element, fine: &Element, share: f64) -> bool {
        !self.is_within(coarse, fine, share, LOAD_ACCURACY)
    }

    /// Whether two rules on one piece agree in the interpolation error and, closely, in the loads.
    fn rules_agree(&self, coarse: &Element, fine: &Element, share: f64) -> bool {
        self.is_within(coarse, fine, share, RULE_LOAD_ACCURACY)
    }

    fn is_within(&self, coarse: &Element, fine: &Element, share: f64, load_accuracy: f64) -> bool {
        let whole = fine.interpolation.energy + share;
        let change = (coarse.interpolation.energy - fine.interpolation.energy).abs();
        let load = load_change(coarse, fine) / self.material().matrix()[0][0];
        change <= ACCURACY * whole && load <= load_accuracy * load_accuracy * whole
    }
}

/// The square of the change of the loads.
fn load_change(coarse: &Element, fine: &Element) -> f64 {
    coarse.load.iter().zip(&fine.load).map(|(b, f)| (b - f).norm_squared()).sum()
}
