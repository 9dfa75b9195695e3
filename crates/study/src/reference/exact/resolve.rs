//! One triangle by rules that follow one another until they agree, on pieces that are split where they do not.

use super::curved::CurvedPart;
use super::element::{Element, ElementIntegrand, Rule};
use signorini_contact::Vec2;
use signorini_contact::element::CurvedTriangle;
use signorini_contact::quadrature::{Cubature, GAUSS_6, GAUSS_8, Patch, quarter};

/// Share of the interpolation error's square that one more refinement of the quadrature may change.
const ACCURACY: f64 = 2.5e-7;

/// Share of the interpolation error, in the energy norm, that the loads may change by under one more refinement.
const LOAD_ACCURACY: f64 = 1e-4;

/// Share of the interpolation error's square by which `½A(u,u) − f(u)` may change from degree 4 to 5: where these two rules
/// are all that is asked, so smooth elements do not spoil the error that is computed from energies.
const ENERGY_ACCURACY: f64 = 1e-6;

/// The rules in the order in which they are tried: degrees 4, 5, 8, 10 and 14. Two that follow one another and agree end it.
const CHAIN: [Rule; 5] = [Rule::Six, Rule::Seven, Rule::Sixteen, Rule::Conical, Rule::ConicalSixtyFour];

/// The first rule for a part of a piece that had to be split.
const AFTER_SPLIT: usize = 2;

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

    /// By a rule and a finer one on every piece: the first two of the chain that agree. Pieces on which none do are split.
    /// `share` of the interpolation error is allowed to each piece, and a quarter of it to each of its quarters.
    pub fn adaptively(&self, cubature: &Cubature, share: f64, deepest: u32) -> [Element; 2] {
        let mut pair = [Element::default(); 2];
        cubature.pieces(self.corners, &mut |piece| self.resolve(piece, 0, share, deepest, &mut pair));
        pair
    }

    fn resolve(&self, piece: [Vec2; 3], first: usize, share: f64, deepest: u32, pair: &mut [Element; 2]) {
        let [mut coarse, mut fine] = [first, first + 1].map(|k| self.over(piece, CHAIN[k]));
        let mut agreed = !self.is_rough(&coarse, &fine, share)
            && (first > 0 || energy_change(&coarse, &fine) <= ENERGY_ACCURACY * (fine.interpolation.energy + share));
        for rule in &CHAIN[first + 2..] {
            if agreed {
                break;
            }
            coarse = fine;
            fine = self.over(piece, *rule);
            agreed = !self.is_rough(&coarse, &fine, share);
        }
        if agreed || deepest == 0 {
            pair[0] += coarse;
            pair[1] += fine;
        } else {
            let part = |q| self.resolve(q, AFTER_SPLIT, 0.25 * share, deepest - 1, pair);
            quarter(piece).into_iter().for_each(part);
        }
    }

    /// The same for a triangle with a curved side, patch by patch, by products of Gauss rules.
    pub fn adaptively_curved(&self, cubature: &Cubature, share: f64, deepest: u32) -> [CurvedPart; 2] {
        let mut pair = [CurvedPart::default(); 2];
        if let Some(triangle) = &self.curved {
            cubature.patches(triangle, &mut |patch| self.resolve_curved(triangle, patch, share, deepest, &mut pair));
        }
        pair
    }

    fn resolve_curved(
        &self,
        triangle: &CurvedTriangle,
        patch: Patch,
        share: f64,
        deepest: u32,
        pair: &mut [CurvedPart; 2],
    ) {
        let coarse = self.over_patch(triangle, patch, &GAUSS_6);
        let fine = self.over_patch(triangle, patch, &GAUSS_8);
        if deepest > 0 && self.is_rough(&coarse.element, &fine.element, share) {
            let part = |q| self.resolve_curved(triangle, q, 0.25 * share, deepest - 1, pair);
            patch.quarter().into_iter().for_each(part);
        } else {
            pair[0] += coarse;
            pair[1] += fine;
        }
    }

    /// Whether the finer rule still changed the interpolation error or the loads by more than their shares.
    fn is_rough(&self, coarse: &Element, fine: &Element, share: f64) -> bool {
        let whole = fine.interpolation.energy + share;
        let change = (coarse.interpolation.energy - fine.interpolation.energy).abs();
        let load: f64 = coarse.load.iter().zip(&fine.load).map(|(b, f)| (b - f).norm_squared()).sum();
        change > ACCURACY * whole || load / self.material().matrix()[0][0] > LOAD_ACCURACY * LOAD_ACCURACY * whole
    }
}

/// Change of `½A(u,u) − f(u)` from one rule to the other.
fn energy_change(coarse: &Element, fine: &Element) -> f64 {
    let energy = |e: &Element| 0.5 * e.solution.energy - e.work;
    (energy(coarse) - energy(fine)).abs()
}
